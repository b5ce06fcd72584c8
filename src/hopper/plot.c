#include "hopper/plot.h"

#include <math.h>

#include "base/xml.h"

#define TICKS 6.0
#define INK "#222222"
#define FONT "font-family=\"sans-serif\" fill=\"" INK "\""

double clod_plot_round_up(double x)
{
    const double power = pow(10.0, floor(log10(x)));
    static const double STEPS[] = {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
    for (size_t k = 0; k < sizeof STEPS / sizeof STEPS[0]; k++) {
        if (STEPS[k] * power >= x * (1.0 - 1e-9)) {
            return STEPS[k] * power;
        }
    }
    return 10.0 * power;
}

/** Distance of ticks: 1, 2 or 5 times a power of ten. */
static double tick_of(double most)
{
    const double rough = most / TICKS;
    const double power = pow(10.0, floor(log10(rough)));
    const double step = rough / power;
    return (step > 5.0 ? 10.0 : step > 2.0 ? 5.0 : step > 1.0 ? 2.0 : 1.0) * power;
}

static double x_of(const clod_plot *self, double x)
{
    return self->left + self->width * x / self->most_x;
}

static double y_of(const clod_plot *self, double y)
{
    return self->top + self->height * (1.0 - y / self->most_y);
}

static void put_words(FILE *out, double x, double y, const char *more, const char *text)
{
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" " FONT " %s>", x, y, more);
    clod_xml_text(out, text);
    fputs("</text>\n", out);
}

void clod_plot_begin(FILE *out, int width, int height, const char *title)
{
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
            "viewBox=\"0 0 %d %d\">\n<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
            width, height, width, height, width, height);
    put_words(out, 0.5 * width, 24.0, "font-size=\"16\" text-anchor=\"middle\"", title);
}

void clod_plot_end(FILE *out)
{
    fputs("</svg>\n", out);
}

static void put_segment(FILE *out, double x1, double y1, double x2, double y2,
                        const char *colour)
{
    fprintf(out, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1,
            y1, x2, y2, colour);
}

static void put_ticks(const clod_plot *self)
{
    char text[32];
    const double bottom = self->top + self->height;
    const double x_step = tick_of(self->most_x);
    for (int k = 0; k * x_step <= self->most_x * (1.0 + 1e-9); k++) {
        const double x = x_of(self, k * x_step);
        put_segment(self->out, x, bottom, x, bottom + 5.0, INK);
        snprintf(text, sizeof text, "%.6g", k * x_step);
        put_words(self->out, x, bottom + 19.0, "font-size=\"12\" text-anchor=\"middle\"", text);
    }
    const double y_step = tick_of(self->most_y);
    for (int k = 0; k * y_step <= self->most_y * (1.0 + 1e-9); k++) {
        const double y = y_of(self, k * y_step);
        put_segment(self->out, self->left - 5.0, y, self->left, y, INK);
        snprintf(text, sizeof text, "%.6g", k * y_step);
        put_words(self->out, self->left - 8.0, y + 4.0, "font-size=\"12\" text-anchor=\"end\"",
                  text);
    }
}

void clod_plot_axes(const clod_plot *self, const char *x, const char *y)
{
    fprintf(self->out,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" "
            "stroke=\"" INK "\"/>\n",
            self->left, self->top, self->width, self->height);
    put_ticks(self);
    put_words(self->out, self->left + 0.5 * self->width, self->top + self->height + 40.0,
              "font-size=\"14\" text-anchor=\"middle\"", x);
    const double at_x = self->left - 44.0;
    const double at_y = self->top + 0.5 * self->height;
    char turned[128];
    snprintf(turned, sizeof turned,
             "font-size=\"14\" text-anchor=\"middle\" transform=\"rotate(-90 %.1f %.1f)\"",
             at_x, at_y);
    put_words(self->out, at_x, at_y, turned, y);
}

/** The part of a piece of line within the panel; false: none. */
static bool cut(const clod_plot *self, clod_plot_point *a, clod_plot_point *b)
{
    const double from[] = {a->x, a->y, self->most_x - a->x, self->most_y - a->y};
    const double to[] = {b->x, b->y, self->most_x - b->x, self->most_y - b->y};
    double begin = 0.0;
    double end = 1.0;
    for (int side = 0; side < 4; side++) { // inside where from + t (to - from) >= 0
        if (from[side] < 0.0 && to[side] < 0.0) {
            return false;
        }
        const double t = from[side] / (from[side] - to[side]);
        begin = from[side] < 0.0 ? fmax(begin, t) : begin;
        end = to[side] < 0.0 ? fmin(end, t) : end;
    }
    const clod_plot_point first = *a;
    const clod_plot_point way = {b->x - a->x, b->y - a->y};
    *a = (clod_plot_point){first.x + begin * way.x, first.y + begin * way.y};
    *b = (clod_plot_point){first.x + end * way.x, first.y + end * way.y};
    return begin < end;
}

void clod_plot_line(const clod_plot *self, const clod_plot_point *point, size_t count,
                    const clod_plot_pen *pen)
{
    fputs("<path d=\"", self->out);
    for (size_t i = 1; i < count; i++) {
        clod_plot_point a = point[i - 1];
        clod_plot_point b = point[i];
        if (cut(self, &a, &b)) {
            fprintf(self->out, "M%.1f %.1fL%.1f %.1f", x_of(self, a.x), y_of(self, a.y),
                    x_of(self, b.x), y_of(self, b.y));
        }
    }
    fprintf(self->out, "\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>\n",
            pen->colour, pen->width, pen->dashed ? " stroke-dasharray=\"6 4\"" : "");
}

void clod_plot_mark(const clod_plot *self, clod_plot_point at, clod_plot_point low,
                    clod_plot_point high, const char *colour)
{
    if (!(at.x <= self->most_x && at.y <= self->most_y)) {
        return;
    }
    const double x = x_of(self, at.x);
    const double y = y_of(self, at.y);
    const double right = x_of(self, fmin(self->most_x, high.x));
    const double above = y_of(self, fmin(self->most_y, high.y));
    if (high.x > low.x && low.x < self->most_x) {
        put_segment(self->out, x_of(self, fmax(0.0, low.x)), y, right, y, colour);
    }
    if (high.y > low.y && low.y < self->most_y) {
        put_segment(self->out, x, y_of(self, fmax(0.0, low.y)), x, above, colour);
    }
    fprintf(self->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", x, y, colour);
}

void clod_plot_note(const clod_plot *self, const char *text)
{
    put_words(self->out, self->left + self->width - 10.0, self->top + self->height - 10.0,
              "font-size=\"12\" text-anchor=\"end\"", text);
}

void clod_plot_legend(const clod_plot *self, int row, const clod_plot_pen *pen,
                      const char *text)
{
    const double y = self->top + 18.0 + 18.0 * row;
    const double x = self->left + 12.0;
    fprintf(self->out,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
            "stroke-width=\"%.1f\"%s/>\n",
            x, y, x + 26.0, y, pen->colour, pen->width,
            pen->dashed ? " stroke-dasharray=\"6 4\"" : "");
    put_words(self->out, x + 33.0, y + 4.0, "font-size=\"12\"", text);
}
