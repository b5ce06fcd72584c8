#include "picture/colour_map.h"

#include <math.h>
#include <string.h>

#define FINE 4096 ///< steps in which the length of a path is measured

/** A place on a path: lightness 0 ... 1, distance from grey, hue [degrees]. */
typedef struct anchor {
    double lightness, chroma, hue;
} anchor;

static const struct {
    const char *name;
    anchor at[3]; ///< start, middle, end
} MAPS[] = {
    // dark and light ends leave room for shades on a white page; hues turn one way
    {"sea", {{0.42, 0.19, 275.0}, {0.70, 0.13, 190.0}, {0.93, 0.18, 105.0}}},
    {"ember", {{0.36, 0.14, 300.0}, {0.62, 0.19, 385.0}, {0.91, 0.15, 455.0}}},
    {"balance", {{0.45, 0.15, 255.0}, {0.92, 0.00, 255.0}, {0.45, 0.17, 27.0}}},
    {"grey", {{0.30, 0.00, 0.0}, {0.60, 0.00, 0.0}, {0.92, 0.00, 0.0}}},
};

#define MAP_COUNT (sizeof MAPS / sizeof MAPS[0])

/** OKLab to linear sRGB. */
static void to_linear(const double lab[3], double rgb[3])
{
    const double l = lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2];
    const double m = lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2];
    const double s = lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2];
    const double l3 = l * l * l;
    const double m3 = m * m * m;
    const double s3 = s * s * s;
    rgb[0] = 4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3;
    rgb[1] = -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3;
    rgb[2] = -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3;
}

/** Linear light to a number of sRGB (IEC 61966-2-1). */
static double encode(double light)
{
    const double in = fmin(fmax(light, 0.0), 1.0);
    return in <= 0.0031308 ? 12.92 * in : 1.055 * pow(in, 1.0 / 2.4) - 0.055;
}

static bool can_be_shown(const double lab[3])
{
    double rgb[3];
    to_linear(lab, rgb);
    for (int c = 0; c < 3; c++) {
        if (rgb[c] < -1e-6 || rgb[c] > 1.0 + 1e-6) {
            return false;
        }
    }
    return true;
}

/** OKLab of a lightness, chroma and hue, greyer where a screen cannot show it. */
static void to_lab(anchor at, double lab[3])
{
    const double hue = at.hue * M_PI / 180.0;
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < 30; k++) {
        const double part = k == 0 ? 1.0 : 0.5 * (low + high);
        lab[0] = at.lightness;
        lab[1] = part * at.chroma * cos(hue);
        lab[2] = part * at.chroma * sin(hue);
        if (can_be_shown(lab)) {
            low = part;
        } else {
            high = part;
        }
        if (low == 1.0) {
            return;
        }
    }
    lab[1] = low * at.chroma * cos(hue);
    lab[2] = low * at.chroma * sin(hue);
}

/** A parabola through three numbers, at s = 0, 1/2 and 1. */
static double bend(double start, double middle, double end, double s)
{
    return (1.0 - s) * (1.0 - 2.0 * s) * start + 4.0 * s * (1.0 - s) * middle +
           s * (2.0 * s - 1.0) * end;
}

/** The path at s in 0 ... 1: hues turn, but through grey it goes straight. */
static void follow(const anchor at[3], double s, double lab[3])
{
    if (at[1].chroma > 0.0) {
        to_lab((anchor){bend(at[0].lightness, at[1].lightness, at[2].lightness, s),
                        bend(at[0].chroma, at[1].chroma, at[2].chroma, s),
                        bend(at[0].hue, at[1].hue, at[2].hue, s)},
               lab);
        return;
    }
    double ends[3][3];
    for (int k = 0; k < 3; k++) {
        to_lab(at[k], ends[k]);
    }
    for (int c = 0; c < 3; c++) {
        lab[c] = bend(ends[0][c], ends[1][c], ends[2][c], s);
    }
}

/** Equal lengths of the path, not of its parameter. */
static void fill(clod_colour_map *self, const anchor at[3])
{
    double length[FINE + 1] = {0.0};
    double before[3];
    follow(at, 0.0, before);
    for (int k = 1; k <= FINE; k++) {
        double now[3];
        follow(at, (double)k / FINE, now);
        length[k] = length[k - 1] + sqrt((now[0] - before[0]) * (now[0] - before[0]) +
                                         (now[1] - before[1]) * (now[1] - before[1]) +
                                         (now[2] - before[2]) * (now[2] - before[2]));
        memcpy(before, now, sizeof before);
    }
    int k = 0;
    for (int c = 0; c < CLOD_COLOUR_MAP_SIZE; c++) {
        const double wanted = length[FINE] * c / (CLOD_COLOUR_MAP_SIZE - 1);
        while (k < FINE - 1 && length[k + 1] < wanted) {
            k++;
        }
        const double step = length[k + 1] - length[k];
        const double part = step > 0.0 ? fmin((wanted - length[k]) / step, 1.0) : 0.0;
        double lab[3], rgb[3];
        follow(at, (k + part) / FINE, lab);
        to_linear(lab, rgb);
        for (int i = 0; i < 3; i++) {
            self->colour[c][i] = encode(rgb[i]);
        }
    }
}

bool clod_colour_map_make(clod_colour_map *self, const char *name, clod_status *status)
{
    for (size_t k = 0; k < MAP_COUNT; k++) {
        if (strcmp(MAPS[k].name, name) == 0) {
            fill(self, MAPS[k].at);
            return true;
        }
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "--map %s: there is no colour map of this name. Maps: sea, ember, "
                            "balance, grey.",
                            name);
}

int clod_colour_map_index(double value, double min, double max)
{
    const double part = max > min ? (value - min) / (max - min) : 0.5;
    const double place = fmin(fmax(part, 0.0), 1.0) * CLOD_COLOUR_MAP_SIZE;
    return place < CLOD_COLOUR_MAP_SIZE ? (int)place : CLOD_COLOUR_MAP_SIZE - 1;
}

void clod_colour_map_kind(size_t k, double colour[3])
{
    // hues by the golden angle: neighbours are far apart, and no two are the same
    const double turn = 137.50776405003785;
    double lab[3], rgb[3];
    to_lab((anchor){k % 2 == 0 ? 0.62 : 0.76, 0.13, fmod(255.0 + turn * (double)k, 360.0)},
           lab);
    to_linear(lab, rgb);
    for (int i = 0; i < 3; i++) {
        colour[i] = encode(rgb[i]);
    }
}
