#include "measure/lucy.h"

#include <math.h>

/** Length of a line in widths below which it is a point: its kernel differs by less than that. */
#define POINT 1e-9
/** Squared distance from a line in squared widths below which it is on the line. */
#define ON_LINE 1e-30

static double peak(double width)
{
    return 105.0 / (16.0 * M_PI * width * width * width);
}

double clod_lucy(double width, double square)
{
    const double q = sqrt(square) / width;
    if (!(q < 1.0)) {
        return 0.0;
    }
    const double rest = 1.0 - q;
    return peak(width) * (1.0 + 3.0 * q) * (rest * rest * rest);
}

clod_lucy_line clod_lucy_line_of(const double from[3], const double to[3])
{
    clod_lucy_line line = {.length = 0.0};
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        line.from[a] = from[a];
        line.direction[a] = to[a] - from[a];
        square += line.direction[a] * line.direction[a];
    }
    line.length = sqrt(square);
    for (int a = 0; a < 3 && line.length > 0.0; a++) {
        line.direction[a] /= line.length;
    }
    return line;
}

/**
 * Integral of 1 - 6 q^2 - 3 q^4 over t from 0, and of 8 q^3 without its logarithm: q^2 = p^2 + t^2,
 * all in widths.
 */
static double primitive(double p2, double t)
{
    const double t2 = t * t, q2 = p2 + t2, q = sqrt(q2);
    const double square = p2 + t2 / 3.0;
    const double fourth = p2 * p2 + t2 * (2.0 / 3.0 * p2 + 0.2 * t2);
    const double cube = q * (0.25 * q2 + 0.375 * p2);
    return t * (1.0 - 6.0 * square + 8.0 * cube - 3.0 * fourth);
}

/** ln of (t + q) at the end over that at the begin, without cancellation; p2 > 0. */
static double logarithm(double p2, double begin, double end)
{
    const double first = sqrt(p2 + begin * begin), last = sqrt(p2 + end * end);
    if (end <= 0.0) {
        return log((first - begin) / (last - end));
    }
    return begin >= 0.0 ? log((end + last) / (begin + first))
                        : log((end + last) * (first - begin) / p2);
}

double clod_lucy_along(double width, const clod_lucy_line *line, const double at[3])
{
    const double length = line->length / width;
    double foot = 0.0, p2 = 0.0;
    for (int a = 0; a < 3; a++) {
        foot += (at[a] - line->from[a]) * line->direction[a];
    }
    for (int a = 0; a < 3; a++) {
        const double off = (at[a] - line->from[a] - foot * line->direction[a]) / width;
        p2 += off * off;
    }
    if (!(p2 < 1.0)) {
        return 0.0;
    }
    foot /= width;
    if (length < POINT) {
        return clod_lucy(width, (p2 + foot * foot) * width * width);
    }
    const double half = sqrt(1.0 - p2);
    const double begin = fmax(-foot, -half), end = fmin(length - foot, half);
    if (!(begin < end)) {
        return 0.0;
    }
    double sum = primitive(p2, end) - primitive(p2, begin);
    if (p2 > ON_LINE) {
        sum += 8.0 * 0.375 * p2 * p2 * logarithm(p2, begin, end);
    }
    return peak(width) * fmax(0.0, sum) / length;
}
