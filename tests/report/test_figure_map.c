// Maps of colours: their range, shades, and what of a known gradient stands in the SVG.

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/figure_map.h"
#include "report/figure_scale.h"
#include "report/figure_svg.h"
#include "support/check.h"

/** A figure with a map, 2 mm wide and 1 mm high cells. */
static void make(clod_figure *figure, size_t columns, size_t rows, const double *number)
{
    clod_figure_map map = {.columns = columns,
                           .rows = rows,
                           .low = {-0.003, 0.01},
                           .step = {2e-3, 1e-3},
                           .number = clod_memory_alloc(columns * rows, sizeof *number)};
    assert_non_null(map.number);
    memcpy(map.number, number, columns * rows * sizeof *number);
    clod_figure_init(figure, "m", "m");
    clod_figure_axis_set(&figure->x, "x", "mm", 1e3);
    clod_figure_axis_set(&figure->y, "z", "mm", 1e3);
    clod_figure_axis_set(&map.value, "v", "Pa", 1.0);
    clod_figure_map_set(figure, &map);
    assert_true(figure->equal);
    assert_true(clod_figure_shows(figure));
}

/** Colours begin at 0, or below it; a constant, zeros and a single negative number have a range. */
static void ranges(void **state)
{
    (void)state;
    static const struct {
        double number[2], least, most;
    } CASES[] = {{{2.0, 5.0}, 0.0, 5.0},    {{-1.0, 5.0}, -1.0, 5.0},
                 {{3.0, 3.0}, 0.0, 3.0},    {{0.0, 0.0}, 0.0, 1.0},
                 {{-4.0, -2.0}, -4.0, 0.0}, {{7.0, (double)NAN}, 0.0, 7.0}};
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        clod_figure figure;
        make(&figure, 2, 1, CASES[k].number);
        check_close(figure.map.least, CASES[k].least, 0.0);
        check_close(figure.map.most, CASES[k].most, 0.0);
        clod_figure_fini(&figure);
    }
}

/** Figures that share colours: from the least to the greatest of both; shades by that range, by hand. */
static void shared_ranges(void **state)
{
    (void)state;
    clod_figure figures[2];
    make(&figures[0], 2, 1, (const double[]){1.0, 8.0});
    make(&figures[1], 2, 1, (const double[]){-8.0, (double)NAN});
    clod_figure_map_share(figures, 2);
    for (size_t k = 0; k < 2; k++) {
        check_close(figures[k].map.least, -8.0, 0.0);
        check_close(figures[k].map.most, 8.0, 0.0);
        check_close(clod_figure_map_shade(&figures[k].map, 0.0), 64.0, 0.0);
        clod_figure_fini(&figures[k]);
    }
    make(&figures[0], 2, 1, (const double[]){0.0, 0.0}); // alone 0 to 1
    make(&figures[1], 2, 1, (const double[]){0.0, 0.25});
    clod_figure_map_share(figures, 2);
    check_close(figures[0].map.most, 0.25, 0.0);
    clod_figure_fini(&figures[0]);
    clod_figure_fini(&figures[1]);
}

static void nothing_is_no_figure(void **state)
{
    (void)state;
    clod_figure figure;
    clod_figure_map map = {.columns = 1, .rows = 1, .step = {1.0, 1.0}};
    map.number = clod_memory_alloc(1, sizeof *map.number);
    assert_non_null(map.number);
    map.number[0] = (double)NAN;
    clod_figure_init(&figure, "m", "m");
    clod_figure_map_set(&figure, &map);
    assert_false(clod_figure_shows(&figure));
    clod_figure_fini(&figure);
    clod_figure_init(&figure, "m", "m");
    map.number = NULL;
    clod_figure_map_set(&figure, &map);
    assert_true(figure.lost);
    clod_figure_fini(&figure);
}

/** The ends, by hand: half a shade, 3.5/128 of a step, from "#440154" to "#46327e", and so at the other. */
static void shades(void **state)
{
    (void)state;
    char text[8];
    clod_figure figure;
    make(&figure, 2, 1, (const double[]){0.0, 64.0});
    check_close(clod_figure_map_shade(&figure.map, 0.0), 0.0, 0.0);
    check_close(clod_figure_map_shade(&figure.map, 0.49), 0.0, 0.0); // 128 shades over 64
    check_close(clod_figure_map_shade(&figure.map, 0.51), 1.0, 0.0);
    check_close(clod_figure_map_shade(&figure.map, 64.0), 127.0, 0.0);
    check_close(clod_figure_map_shade(&figure.map, (double)NAN), -1.0, 0.0);
    clod_figure_map_colour(0, text); // 0x54 + 0.0273 * (0x7e - 0x54) = 85.1
    assert_string_equal(text, "#440255");
    clod_figure_map_colour(127, text); // 0x39 + 0.9727 * (0x25 - 0x39) = 37.5
    assert_string_equal(text, "#fae726");
    clod_figure_fini(&figure);
}

/** Axes reach from edge to edge, -3 mm to 5 mm and 10 mm to 13 mm, with ticks inside. */
static void axes_are_the_edges(void **state)
{
    (void)state;
    double number[12] = {1.0};
    clod_figure figure;
    clod_figure_scale scale;
    char text[32];
    make(&figure, 4, 3, number);
    clod_figure_scale_make(&scale, &figure, false);
    check_close(scale.min, -3.0, 1e-12);
    check_close(scale.max, 5.0, 1e-12);
    check_close(clod_figure_scale_ticks(&scale), 4.0, 0.0); // -2 0 2 4
    check_close(clod_figure_scale_tick(&scale, 0, text), -2.0, 1e-12);
    check_close(clod_figure_scale_tick(&scale, 3, text), 4.0, 1e-12);
    check_close(clod_figure_scale_stride(&scale, 400.0, 36.0), 1.0, 0.0);
    check_close(clod_figure_scale_stride(&scale, 40.0, 36.0), 4.0, 0.0); // 10 of a tick
    clod_figure_scale_make(&scale, &figure, true);
    check_close(scale.min, 10.0, 1e-12);
    check_close(scale.max, 13.0, 1e-12);
    clod_figure_fini(&figure);
}

/** The number at a place, which moves behind it and the letter that follows. */
static unsigned long take(const char **at, int base)
{
    char *end;
    const unsigned long number = strtoul(*at, &end, base);
    assert_true(end > *at);
    *at = end + 1;
    return number;
}

/** Add the rectangles of one path, "Mx yhNv1h-Nz", to a grid of red, green and blue, each plus 1. */
static void read_path(const char *path, unsigned long grid[4][4][3])
{
    const char *at = strchr(path, '#') + 1;
    const unsigned long rgb = take(&at, 16);
    at = strstr(path, " d=\"") + 4;
    while (*at == 'M') {
        at++;
        const unsigned long x = take(&at, 10), y = take(&at, 10), count = take(&at, 10);
        for (unsigned long k = x; k < x + count; k++) {
            assert_true(k < 4 && y < 4);
            assert_int_equal(grid[y][k][0], 0); // drawn once
            for (int c = 0; c < 3; c++) {
                grid[y][k][c] = 1 + (rgb >> (16 - 8 * c) & 255);
            }
        }
        at = strchr(at, 'z') + 1;
    }
    assert_true(*at == '"');
}

/** A pressure that falls with height, with a hole: rows have one colour each, lighter below. */
static void a_gradient_in_the_svg(void **state)
{
    (void)state;
    double number[16];
    for (int r = 0; r < 4; r++) { // upwards
        for (int c = 0; c < 4; c++) {
            number[4 * r + c] = 1000.0 * (4 - r);
        }
    }
    number[6] = (double)NAN;
    clod_figure figure;
    clod_text text;
    make(&figure, 4, 4, number);
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    clod_figure_svg(out, &figure);
    char *svg = clod_text_close(&text);
    unsigned long grid[4][4][3] = {0};
    const char *map = strstr(svg, "matrix(");
    assert_non_null(map);
    char *behind;
    const double right = strtod(map + strlen("matrix("), &behind);
    check_relative(-strtod(behind + strlen(" 0 0 "), NULL), 0.5 * right, 1e-3); // 2 mm and 1 mm
    const char *end = strstr(map, "</g>");
    for (const char *at = strstr(map, "<path"); at < end; at = strstr(at + 1, "<path")) {
        read_path(at, grid);
    }
    for (int r = 0; r < 4; r++) {
        for (int c = 0; c < 4; c++) {
            const bool hole = r == 1 && c == 2;
            assert_int_equal(grid[r][c][0] == 0, hole);
            assert_true(hole || memcmp(grid[r][c], grid[r][0], sizeof grid[r][c]) == 0);
            assert_true(r == 0 || hole || grid[r][c][1] < grid[r - 1][0][1]); // less green
        }
    }
    // 1000 of 0 to 4000, shade 32: 32.5/128 * 7 = 1.777 steps along the map, from 46327e to 365c8d
    const unsigned long quarter[3] = {1 + 0x3a, 1 + 0x53, 1 + 0x8a};
    assert_memory_equal(grid[3][0], quarter, sizeof quarter);
    assert_non_null(strstr(svg, "v [Pa]"));
    assert_non_null(strstr(svg, ">4000</text>"));
    clod_memory_free(svg);
    clod_figure_fini(&figure);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges),
        cmocka_unit_test(shared_ranges),
        cmocka_unit_test(nothing_is_no_figure),
        cmocka_unit_test(shades),
        cmocka_unit_test(axes_are_the_edges),
        cmocka_unit_test(a_gradient_in_the_svg),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
