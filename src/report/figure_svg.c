#include "report/figure_svg.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "report/figure_map.h"
#include "report/figure_scale.h"
#include "report/html.h"

#define WIDE 720.0   ///< of curves at equal scale: across the page
#define NARROW 480.0 ///< of others: two stand side by side, on paper too, and can be read
#define LEFT 72.0
#define RIGHT 18.0
#define BAR 92.0 ///< right of a map: its colour bar
#define TOP 16.0
#define BELOW 52.0 ///< the plot: ticks and the name of the axis
#define ROW 20.0   ///< of the legend
#define LETTER 6.8 ///< mean width of one
#define KEY 46.0   ///< of a curve in the legend: its line, and gaps

/** Where things are in the drawing. */
typedef struct frame {
    clod_figure_scale x, y;
    double right, bottom; ///< of the plot
    double width, height; ///< of all
} frame;

#define EDGE "#000000" ///< of points on a curve

static bool is_read(const clod_figure_curve *curve)
{
    return curve->style == CLOD_FIGURE_READ || curve->style == CLOD_FIGURE_VAGUE;
}

static bool is_hollow(const clod_figure_curve *curve)
{
    return curve->style == CLOD_FIGURE_HOLLOW || curve->style == CLOD_FIGURE_VAGUE;
}

static const char *colour_of(int colour)
{
    return colour < 0 ? CLOD_FIGURE_GREY_COLOUR : CLOD_FIGURE_COLOUR[colour];
}

static double at_x(const frame *self, double value)
{
    return LEFT + (self->right - LEFT) * clod_figure_scale_at(&self->x, value);
}

static double at_y(const frame *self, double value)
{
    return self->bottom - (self->bottom - TOP) * clod_figure_scale_at(&self->y, value);
}

static void put_text(FILE *out, double x, double y, const char *more, const char *text)
{
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\"%s>", x, y, more);
    clod_html_text(out, text);
    fputs("</text>\n", out);
}

/** @param room  length of the axis; a name that is longer has smaller letters */
static void put_axis_name(FILE *out, const clod_figure_axis *axis, double x, double y,
                          double room, const char *more)
{
    char text[96], size[160];
    snprintf(text, sizeof text, axis->unit[0] != '\0' ? "%s [%s]" : "%s", axis->text,
             axis->unit);
    const double length = LETTER * (double)clod_text_characters(text);
    if (length > room) {
        snprintf(size, sizeof size, "%s font-size=\"%.1f\"", more, 13.0 * room / length);
    } else {
        snprintf(size, sizeof size, "%s", more);
    }
    put_text(out, x, y, size, text);
}

/** Begin with the bottom of the plot for x, with its left edge for y: a line across, but for maps. */
static void put_ticks(FILE *out, const frame *self, bool across)
{
    const int right = clod_figure_scale_stride(&self->x, self->right - LEFT, 36.0);
    const int up = clod_figure_scale_stride(&self->y, self->bottom - TOP, 16.0);
    for (int k = 0; k < clod_figure_scale_ticks(&self->x); k += right) {
        char text[32];
        const double x = at_x(self, clod_figure_scale_tick(&self->x, k, text));
        fprintf(out, "<path d=\"M%.1f %.1fV%.1f\" stroke=\"%s\"/>\n", x, self->bottom,
                across ? TOP : self->bottom + 4.0, across ? "#e3e6ea" : "#1d2733");
        put_text(out, x, self->bottom + 18.0, " text-anchor=\"middle\"", text);
    }
    for (int k = 0; k < clod_figure_scale_ticks(&self->y); k += up) {
        char text[32];
        const double y = at_y(self, clod_figure_scale_tick(&self->y, k, text));
        fprintf(out, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"%s\"/>\n", LEFT, y,
                across ? self->right : LEFT - 4.0, across ? "#e3e6ea" : "#1d2733");
        put_text(out, LEFT - 8.0, y + 4.5, " text-anchor=\"end\"", text);
    }
}

/** Draw the error of each point as a bar. */
static void put_errors(FILE *out, const frame *self, const clod_figure_curve *curve,
                       const clod_figure *of)
{
    for (size_t i = 0; curve->error != NULL && i < curve->count; i++) {
        if (isfinite(curve->error[i]) && isfinite(curve->y[i])) {
            const double x = at_x(self, curve->x[i] * of->x.factor);
            fprintf(out, "<path d=\"M%.1f %.1fV%.1f\" stroke=\"%s\" stroke-width=\"1.5\"/>\n",
                    x, at_y(self, (curve->y[i] - curve->error[i]) * of->y.factor),
                    at_y(self, (curve->y[i] + curve->error[i]) * of->y.factor),
                    is_read(curve) ? EDGE : colour_of(curve->colour));
        }
    }
}

/** One point, at a place of the drawing. */
static void put_mark(FILE *out, const clod_figure_curve *curve, double x, double y)
{
    static const char *const SHAPES[CLOD_FIGURE_ROUNDS] = {
        "", "m-4 -4h8v8h-8z", "m0 -5.5l5.5 5.5l-5.5 5.5l-5.5 -5.5z", "m0 -5.5l5 9h-10z"};
    const char *colour = colour_of(curve->colour);
    if (curve->style == CLOD_FIGURE_DOTS) {
        fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.8\" fill=\"%s\"/>\n", x, y, colour);
        return;
    }
    if (curve->round == 0) {
        fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\"", x, y);
    } else {
        fprintf(out, "<path d=\"M%.1f %.1f%s\"", x, y, SHAPES[curve->round]);
    }
    fprintf(out, " fill=\"%s\" stroke=\"%s\" stroke-width=\"2\"/>\n",
            is_hollow(curve) ? "#ffffff" : colour,
            curve->style == CLOD_FIGURE_READ ? EDGE : colour);
}

static void put_marks(FILE *out, const frame *self, const clod_figure_curve *curve,
                      const clod_figure *of)
{
    put_errors(out, self, curve, of);
    for (size_t i = 0; i < curve->count; i++) {
        if (isfinite(curve->x[i]) && isfinite(curve->y[i])) {
            put_mark(out, curve, at_x(self, curve->x[i] * of->x.factor),
                     at_y(self, curve->y[i] * of->y.factor));
        }
    }
}

/** The attribute of a curve's dashes. */
static const char *dashes(const clod_figure_curve *curve, char text[64])
{
    const char *found = clod_figure_dashes(curve);
    snprintf(text, 64, found[0] != '\0' ? " stroke-dasharray=\"%s\"" : "%s", found);
    return text;
}

/** @param edge  only the light edge of arrows */
static void put_line(FILE *out, const frame *self, const clod_figure_curve *curve,
                     const clod_figure *of, bool edge)
{
    char dash[64];
    fprintf(out,
            "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%s\" stroke-linejoin=\"round\"%s "
            "d=\"",
            edge ? "#ffffff" : colour_of(curve->colour),
            edge                                 ? "3.6"
            : curve->style == CLOD_FIGURE_ARROWS ? "1.2"
            : curve->style == CLOD_FIGURE_THIN   ? "0.9"
                                                 : "1.8",
            dashes(curve, dash));
    bool down = false; // the pen
    for (size_t i = 0; i < curve->count; i++) {
        const bool there = isfinite(curve->x[i]) && isfinite(curve->y[i]);
        if (there) {
            fprintf(out, "%c%.1f %.1f", down ? 'L' : 'M',
                    at_x(self, curve->x[i] * of->x.factor),
                    at_y(self, curve->y[i] * of->y.factor));
        }
        down = there;
    }
    fputs("\"/>\n", out);
}

static bool is_marks(clod_figure_style style)
{
    return style == CLOD_FIGURE_POINTS || style == CLOD_FIGURE_HOLLOW ||
           style == CLOD_FIGURE_DOTS || style == CLOD_FIGURE_READ || style == CLOD_FIGURE_VAGUE;
}

/** One row of the legend after the other; NULL: only how many rows there are. */
static int put_legend(FILE *out, const frame *self, const clod_figure *of)
{
    double x = LEFT;
    int row = 0;
    for (size_t c = 0; c < of->count; c++) {
        const clod_figure_curve *curve = &of->curves[c];
        char name[CLOD_FIGURE_NAME];
        const size_t letters = (size_t)((self->width - LEFT - KEY) / LETTER); // of a row
        clod_text_fit(name, sizeof name, letters, curve->name, strlen(curve->name));
        const double wide = KEY + LETTER * (double)clod_text_characters(name);
        if (curve->name[0] == '\0') {
            continue;
        }
        if (x > LEFT && x + wide > self->width) {
            x = LEFT;
            row++;
        }
        if (out != NULL) {
            char dash[64];
            const double y = self->bottom + BELOW + ROW * row;
            fprintf(out, "<path d=\"M%.1f %.1fh24\" stroke=\"%s\" stroke-width=\"%s\"%s/>\n", x,
                    y, colour_of(curve->colour), is_marks(curve->style) ? "0" : "2",
                    dashes(curve, dash));
            if (is_marks(curve->style)) {
                put_mark(out, curve, x + 12.0, y);
            }
            put_text(out, x + 30.0, y + 4.5, "", name);
        }
        x += wide;
    }
    char alike[256];
    if (clod_figure_alike(of, alike)) {
        row++;
        if (out != NULL) {
            put_text(out, LEFT, self->bottom + BELOW + ROW * row + 4.5, "", alike);
        }
    }
    return x > LEFT || row > 0 ? row + 1 : 0;
}

/** Ranges of the axes and size of the plot. */
static void lay_out(frame *self, const clod_figure *of)
{
    self->width = of->equal && of->map.number == NULL ? WIDE : NARROW;
    self->right = self->width - (of->map.number != NULL ? BAR : RIGHT);
    double height = 250.0;
    clod_figure_scale_make(&self->x, of, false);
    clod_figure_scale_make(&self->y, of, true);
    if (of->equal) {
        height =
            (self->right - LEFT) * (self->y.max - self->y.min) / (self->x.max - self->x.min);
        if (height > 460.0) {
            self->right = LEFT + (self->right - LEFT) * 460.0 / height;
            height = 460.0;
        }
    }
    self->bottom = TOP + height;
    self->height = self->bottom + BELOW + ROW * put_legend(NULL, self, of);
}

static void put_curves(FILE *out, const frame *self, const clod_figure *of)
{
    fprintf(
        out,
        "<clipPath id=\"clip-%s\"><rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>"
        "</clipPath>\n<g clip-path=\"url(#clip-%s)\">\n",
        of->name, LEFT - 6.0, TOP - 6.0, self->right - LEFT + 12.0, self->bottom - TOP + 12.0,
        of->name);
    for (size_t c = 0; c < of->count; c++) {
        if (is_marks(of->curves[c].style)) {
            put_marks(out, self, &of->curves[c], of);
        } else {
            if (of->curves[c].style == CLOD_FIGURE_ARROWS) {
                put_line(out, self, &of->curves[c], of, true);
            }
            put_line(out, self, &of->curves[c], of, false);
            put_errors(out, self, &of->curves[c], of);
        }
    }
    fputs("</g>\n", out);
}

/** The map of a figure that has one, and its colour bar. */
static void put_map(FILE *out, const frame *self, const clod_figure *of)
{
    if (of->map.number != NULL) {
        const clod_figure_map_place place = {
            .left = LEFT, .right = self->right, .top = TOP, .bottom = self->bottom};
        clod_figure_map_svg(out, &of->map, &place);
        clod_figure_map_bar(out, of->name, &of->map, &place);
        char turned[96];
        const double middle = 0.5 * (TOP + self->bottom), x = self->right + BAR - 12.0;
        snprintf(turned, sizeof turned,
                 " text-anchor=\"middle\" transform=\"rotate(-90 %.1f %.1f)\"", x, middle);
        put_axis_name(out, &of->map.value, x, middle, self->bottom, turned);
    }
}

void clod_figure_svg(FILE *out, const clod_figure *figure)
{
    frame self;
    char turned[96];
    lay_out(&self, figure);
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#1d2733\">\n"
            "<title>",
            self.width, self.height);
    clod_html_text(out, figure->title);
    fputs("</title>\n", out);
    put_map(out, &self, figure);
    put_ticks(out, &self, figure->map.number == NULL);
    put_curves(out, &self, figure);
    fprintf(out, "<path d=\"M%.1f %.1fV%.1fH%.1f", LEFT, TOP, self.bottom, self.right);
    if (figure->map.number != NULL) { // its blank cells have the colour of the paper
        fprintf(out, "V%.1fZ", TOP);
    }
    fputs("\" fill=\"none\" stroke=\"#1d2733\"/>\n", out);
    put_axis_name(out, &figure->x, 0.5 * (LEFT + self.right), self.bottom + 38.0,
                  self.width - LEFT, " text-anchor=\"middle\"");
    const double middle = 0.5 * (TOP + self.bottom);
    snprintf(turned, sizeof turned, " text-anchor=\"middle\" transform=\"rotate(-90 16 %.1f)\"",
             middle);
    put_axis_name(out, &figure->y, 16.0, middle, self.bottom + TOP, turned);
    put_legend(out, &self, figure);
    fputs("</svg>\n", out);
}
