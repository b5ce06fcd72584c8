#include "picture/page.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "output/file.h"

#define FONT "sans-serif"
#define LETTERS 40.0  ///< heights of letters in the height of a page
#define BAR_WIDTH 1.1 ///< in heights of letters, as are all lengths below
#define TICK 0.35
#define MARGIN 1.0
#define HEAD 3.6 ///< room for title and time

static void set_font(const clod_page *self, double size, bool bold)
{
    cairo_select_font_face(self->cairo, FONT, CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(self->cairo, size);
}

static double text_width(const clod_page *self, const char *text, double size, bool bold)
{
    cairo_text_extents_t extents;
    set_font(self, size, bold);
    cairo_text_extents(self->cairo, text, &extents);
    return extents.x_advance;
}

/** Text with its baseline at y; smaller when it is wider than there is room. */
static void put_text(const clod_page *self, double x, double y, double room, const char *text,
                     bool bold)
{
    const double width = text_width(self, text, self->font, bold);
    set_font(self, width > room ? self->font * room / width : self->font, bold);
    cairo_move_to(self->cairo, x, y);
    cairo_show_text(self->cairo, text);
}

static void set_grey(const clod_page *self, double grey)
{
    cairo_set_source_rgb(self->cairo, grey, grey, grey);
}

/** Width that a bar with its numbers takes, without margins. */
static double bar_width(const clod_page *self, const clod_page_bar *bar)
{
    double numbers = 0.0;
    for (size_t k = 0; k < bar->axis.tick_count && bar->kinds == 0; k++) {
        numbers = fmax(numbers, text_width(self, bar->axis.text[k], self->font, false));
    }
    for (size_t k = 0; k < bar->kinds; k++) {
        numbers = fmax(numbers, text_width(self, bar->name[k], self->font, false));
    }
    return fmax(text_width(self, bar->axis.title, self->font, false),
                numbers + (BAR_WIDTH + 2.0 * TICK) * self->font);
}

static void divide(clod_page *self, const clod_page_bar *bar, size_t bar_count)
{
    double wide = 0.0;
    for (size_t k = 0; k < bar_count; k++) {
        wide = fmax(wide, bar_width(self, &bar[k]));
    }
    const double margin = MARGIN * self->font;
    const int top = (int)(HEAD * self->font);
    wide = fmin(wide, 0.25 * self->width);
    const int right = bar_count > 0 ? (int)(self->width - wide - margin) : self->width;
    self->bars = (clod_page_box){right, top, self->width - right - (int)margin,
                                 self->height - top - (int)margin};
    for (int p = 0; p < self->panels; p++) {
        const int from = right * p / self->panels;
        const int to = right * (p + 1) / self->panels;
        self->panel[p] = (clod_page_box){from, top, to - from, self->height - top};
    }
}

bool clod_page_begin(clod_page *self, int width, int height, int panels,
                     const clod_page_bar *bar, size_t bar_count, clod_status *status)
{
    *self = (clod_page){.width = width, .height = height, .panels = panels};
    self->font = fmin(height / LETTERS, width / (1.3 * LETTERS));
    self->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    self->cairo = cairo_create(self->surface);
    if (cairo_status(self->cairo) != CAIRO_STATUS_SUCCESS) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of %d by %d.",
                                width, height);
    }
    set_grey(self, 1.0);
    cairo_paint(self->cairo);
    divide(self, bar, bar_count);
    return true;
}

void clod_page_put_image(clod_page *self, int panel, const uint8_t *image, const char *title,
                         const char *under)
{
    const clod_page_box *box = &self->panel[panel];
    cairo_surface_flush(self->surface);
    unsigned char *pixels = cairo_image_surface_get_data(self->surface);
    const int stride = cairo_image_surface_get_stride(self->surface);
    for (int y = 0; y < box->height; y++) {
        for (int x = 0; x < box->width; x++) {
            const uint8_t *from = image + 3 * ((size_t)y * (size_t)box->width + (size_t)x);
            const uint32_t pixel =
                (uint32_t)from[0] << 16 | (uint32_t)from[1] << 8 | (uint32_t)from[2];
            memcpy(pixels + (size_t)(box->y + y) * (size_t)stride + 4 * (size_t)(box->x + x),
                   &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(self->surface);
    const double margin = MARGIN * self->font;
    const double room =
        self->panels == 1 ? self->width - 2.0 * margin : box->width - 1.5 * margin;
    set_grey(self, 0.1);
    put_text(self, box->x + margin, 1.7 * self->font, room, title, true);
    set_grey(self, 0.35);
    put_text(self, box->x + margin, 3.1 * self->font, room, under, false);
}

/** An axis of space from the corner of a panel, as long as it looks. */
static void put_axis(const clod_page *self, const clod_camera *camera, double x, double y,
                     int axis)
{
    static const char *const NAMES[] = {"x", "y", "z"};
    const clod_vec3 unit = {axis == 0, axis == 1, axis == 2};
    const double long_one = 1.8 * self->font;
    const double right = long_one * clod_vec3_dot(unit, camera->right);
    const double down = -long_one * clod_vec3_dot(unit, camera->up);
    const double length = hypot(right, down);
    if (length < 0.2 * long_one) {
        return; // towards the eye
    }
    const double small = 0.75 * self->font;
    cairo_move_to(self->cairo, x, y);
    cairo_line_to(self->cairo, x + right, y + down);
    cairo_stroke(self->cairo);
    set_font(self, small, false);
    const double out = 1.0 + 0.5 * small / length;
    cairo_move_to(self->cairo, x + out * right - 0.3 * small, y + out * down + 0.3 * small);
    cairo_show_text(self->cairo, NAMES[axis]);
}

void clod_page_put_scale(clod_page *self, int panel, const clod_camera *camera, clod_vec3 point)
{
    const clod_page_box *box = &self->panel[panel];
    double x, y;
    const double depth = clod_camera_project(camera, point, &x, &y);
    const double font = self->font;
    const double low = self->height - 1.3 * font;
    const double left = box->x + MARGIN * font;
    cairo_set_line_width(self->cairo, 0.1 * font);
    set_grey(self, 0.2);
    for (int axis = 0; axis < 3; axis++) {
        put_axis(self, camera, left + 1.5 * font, low - 0.9 * font, axis);
    }
    if (!(depth > 0.0)) {
        return;
    }
    const double metre = box->width / (2.0 * camera->half_width * depth); // in pixels
    const double length = clod_axis_round_down(0.18 * box->width / metre);
    const double start = left + 5.0 * font;
    const double end = start + length * metre;
    char text[32];
    cairo_move_to(self->cairo, start, low - TICK * font);
    cairo_line_to(self->cairo, start, low);
    cairo_line_to(self->cairo, end, low);
    cairo_line_to(self->cairo, end, low - TICK * font);
    cairo_stroke(self->cairo);
    clod_axis_length_text(length, text);
    const double width = text_width(self, text, font, false);
    put_text(self, 0.5 * (start + end - width), low - 0.5 * font, width + 1.0, text, false);
}

/** A triangle at an end of a bar: there are values beyond. */
static void put_end(const clod_page *self, const double colour[3], double x, double y,
                    double width, double height)
{
    cairo_set_source_rgb(self->cairo, colour[0], colour[1], colour[2]);
    cairo_move_to(self->cairo, x, y);
    cairo_line_to(self->cairo, x + width, y);
    cairo_line_to(self->cairo, x + 0.5 * width, y + height);
    cairo_fill(self->cairo);
}

static void put_kinds(const clod_page *self, const clod_page_bar *bar, double x, double y)
{
    const double font = self->font;
    for (size_t k = 0; k < bar->kinds; k++) {
        const double *colour = bar->colour[k];
        const double top = y + 1.6 * font * (double)k;
        cairo_set_source_rgb(self->cairo, colour[0], colour[1], colour[2]);
        cairo_rectangle(self->cairo, x, top, BAR_WIDTH * font, BAR_WIDTH * font);
        cairo_fill(self->cairo);
        set_grey(self, 0.1);
        put_text(self, x + (BAR_WIDTH + TICK) * font, top + 0.9 * font,
                 self->bars.width - (BAR_WIDTH + TICK) * font, bar->name[k], false);
    }
}

static void put_bar(const clod_page *self, const clod_page_bar *bar, double x, double y,
                    double height)
{
    const double font = self->font;
    const double width = BAR_WIDTH * font;
    const int rows = (int)height;
    for (int r = 0; r < rows; r++) {
        const double *c = bar->map.colour[(rows - 1 - r) * CLOD_COLOUR_MAP_SIZE / rows];
        cairo_set_source_rgb(self->cairo, c[0], c[1], c[2]);
        cairo_rectangle(self->cairo, floor(x), floor(y) + r, floor(width), 1.0);
        cairo_fill(self->cairo);
    }
    if (bar->above) {
        put_end(self, bar->map.colour[CLOD_COLOUR_MAP_SIZE - 1], floor(x), floor(y),
                floor(width), -0.8 * font);
    }
    if (bar->below) {
        put_end(self, bar->map.colour[0], floor(x), floor(y) + rows, floor(width), 0.8 * font);
    }
    cairo_set_line_width(self->cairo, 0.06 * font);
    for (size_t k = 0; k < bar->axis.tick_count; k++) {
        const double part =
            (bar->axis.tick[k] - bar->axis.min) / (bar->axis.max - bar->axis.min);
        const double at = y + height * (1.0 - part);
        set_grey(self, 0.1);
        cairo_move_to(self->cairo, x + width, at);
        cairo_line_to(self->cairo, x + width + TICK * font, at);
        cairo_stroke(self->cairo);
        put_text(self, x + width + 2.0 * TICK * font, at + 0.35 * font,
                 self->bars.width - width - 2.0 * TICK * font, bar->axis.text[k], false);
    }
}

void clod_page_put_bars(clod_page *self, const clod_page_bar *bar, size_t bar_count)
{
    const clod_page_box *box = &self->bars;
    const double each = (double)box->height / (double)(bar_count > 0 ? bar_count : 1);
    for (size_t k = 0; k < bar_count; k++) {
        const double y = box->y + each * (double)k;
        set_grey(self, 0.1);
        put_text(self, box->x, y + self->font, box->width, bar[k].axis.title, false);
        if (bar[k].kinds > 0) {
            put_kinds(self, &bar[k], box->x, y + 2.0 * self->font);
        } else {
            const double height = fmin(each - 4.5 * self->font, 22.0 * self->font);
            put_bar(self, &bar[k], box->x, y + 2.6 * self->font, height);
        }
    }
}

/** Bytes of a PNG as cairo makes them. */
typedef struct png {
    unsigned char *bytes; ///< owned
    size_t size, capacity;
} png;

static cairo_status_t take_bytes(void *context, const unsigned char *bytes, unsigned size)
{
    png *self = context;
    if (self->size + size > self->capacity) {
        const size_t more = 2 * (self->size + size);
        unsigned char *grown = clod_memory_grow(self->bytes, self->capacity, more, 1);
        if (grown == NULL) {
            return CAIRO_STATUS_NO_MEMORY;
        }
        self->bytes = grown;
        self->capacity = more;
    }
    memcpy(self->bytes + self->size, bytes, size);
    self->size += size;
    return CAIRO_STATUS_SUCCESS;
}

bool clod_page_write(clod_page *self, const char *path, clod_status *status)
{
    png file = {0};
    cairo_surface_flush(self->surface);
    const cairo_status_t made =
        cairo_surface_write_to_png_stream(self->surface, take_bytes, &file);
    const bool good =
        made == CAIRO_STATUS_SUCCESS
            ? clod_file_replace(path, NULL, 0, file.bytes, file.size, status)
            : clod_status_fail(status, CLOD_FAILED, "%s: cairo cannot make the PNG: %s.", path,
                               cairo_status_to_string(made));
    clod_memory_free(file.bytes);
    return good;
}

void clod_page_fini(clod_page *self)
{
    if (self->cairo != NULL) {
        cairo_destroy(self->cairo);
        cairo_surface_destroy(self->surface);
    }
    *self = (clod_page){0};
}
