// Curves that are thinned, ranges and ticks, and what of it stands in the SVG.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/figure.h"
#include "report/figure_scale.h"
#include "report/figure_svg.h"

#define MANY 100000

/** A spike of one row, a dip of one row and both ends survive; x keeps rising. */
static void thinning_keeps_every_extreme(void **state)
{
    (void)state;
    double *x = clod_memory_alloc(MANY, sizeof *x);
    double *y = clod_memory_alloc(MANY, sizeof *y);
    assert_non_null(x);
    assert_non_null(y);
    for (int k = 0; k < MANY; k++) {
        x[k] = k;
        y[k] = sin(1e-3 * k);
    }
    y[54321] = 9.0;
    y[77777] = -8.0;
    y[12345] = (double)NAN;
    clod_figure figure;
    clod_figure_init(&figure, "a name", "A title");
    clod_figure_add(&figure, "curve", CLOD_FIGURE_LINE, 0, MANY, x, y, NULL);
    assert_false(figure.lost);
    const clod_figure_curve *curve = &figure.curves[0];
    assert_in_range(curve->count, CLOD_FIGURE_MOST / 2, CLOD_FIGURE_MOST);
    assert_true(curve->x[0] == 0.0 && curve->x[curve->count - 1] == MANY - 1);
    bool spike = false;
    bool dip = false;
    for (size_t i = 0; i < curve->count; i++) {
        assert_true(i == 0 || curve->x[i] > curve->x[i - 1]);
        assert_true(isnan(curve->y[i]) || curve->y[i] == y[(int)curve->x[i]]);
        spike = spike || (curve->x[i] == 54321.0 && curve->y[i] == 9.0);
        dip = dip || (curve->x[i] == 77777.0 && curve->y[i] == -8.0);
    }
    assert_true(spike && dip);
    clod_figure_fini(&figure);
    clod_memory_free(x);
    clod_memory_free(y);
}

static void names_of_files_are_plain(void **state)
{
    (void)state;
    clod_figure figure;
    clod_figure_init(&figure, "../a b_c.9", "title");
    assert_string_equal(figure.name, "---a-b-c-9");
    clod_figure_fini(&figure);
}

/** Ticks by hand: 0 to 7.3 in steps of 1; -0.03 to 0.11 in steps of 0.02. */
static void ticks_are_round_and_hold_all_values(void **state)
{
    (void)state;
    static const struct {
        double y[2];
        double min, max, step;
        const char *last;
    } CASES[] = {{{0.0, 7.3}, 0.0, 8.0, 1.0, "8"},
                 {{-0.03, 0.11}, -0.04, 0.12, 0.02, "0.12"},
                 {{120.0, 980.0}, 0.0, 1000.0, 200.0, "1000"}};
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        const double x[2] = {0.0, 1.0};
        clod_figure figure;
        clod_figure_scale scale;
        char text[32];
        clod_figure_init(&figure, "f", "f");
        clod_figure_add(&figure, "", CLOD_FIGURE_LINE, 0, 2, x, CASES[k].y, NULL);
        clod_figure_scale_make(&scale, &figure, true);
        assert_true(fabs(scale.min - CASES[k].min) < 1e-12);
        assert_true(fabs(scale.max - CASES[k].max) < 1e-12);
        assert_true(fabs(scale.step - CASES[k].step) < 1e-12);
        const int last = clod_figure_scale_ticks(&scale) - 1;
        assert_true(fabs(clod_figure_scale_tick(&scale, last, text) - CASES[k].max) < 1e-12);
        assert_string_equal(text, CASES[k].last);
        clod_figure_fini(&figure);
    }
}

/** Length of one unit in a figure of equal scales, along x and along y, read off the SVG. */
static void equal_scales_are_equal(void **state)
{
    (void)state;
    const double x[3] = {0.0, 10.0, 20.0};
    const double y[3] = {0.0, 10.0, 0.0};
    clod_figure figure;
    clod_text text;
    clod_figure_init(&figure, "equal", "A <title> & more");
    figure.equal = true;
    clod_figure_add(&figure, "points \"p\"", CLOD_FIGURE_POINTS, 1, 3, x, y, NULL);
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    clod_figure_svg(out, &figure);
    char *svg = clod_text_close(&text);
    assert_non_null(strstr(svg, "<title>A &lt;title&gt; &amp; more</title>"));
    assert_non_null(strstr(svg, "points &quot;p&quot;"));
    double cx[3], cy[3];
    const char *at = svg;
    for (int k = 0; k < 3; k++) {
        at = strstr(at, "<circle cx=\"");
        assert_non_null(at);
        char *end;
        cx[k] = strtod(at + strlen("<circle cx=\""), &end);
        cy[k] = strtod(strstr(end, "cy=\"") + strlen("cy=\""), NULL);
        at = end;
    }
    assert_true(fabs((cx[2] - cx[0]) / 20.0 - (cy[0] - cy[1]) / 10.0) < 0.02); // 0.1 of a pixel
    assert_true(cx[1] - cx[0] > 100.0);
    clod_memory_free(svg);
    clod_figure_fini(&figure);
}

static void a_circle_has_its_radius(void **state)
{
    (void)state;
    clod_figure figure;
    clod_figure_init(&figure, "c", "c");
    clod_figure_circle(&figure, "", CLOD_FIGURE_LINE, 0, 3.0, 2.0);
    clod_figure_circle(&figure, "", CLOD_FIGURE_LINE, 0, (double)NAN, 2.0);
    clod_figure_circle(&figure, "", CLOD_FIGURE_LINE, 0, 1.0, 0.0);
    assert_int_equal(figure.count, 1);
    const clod_figure_curve *curve = &figure.curves[0];
    assert_true(curve->x[0] == 1.0 && curve->y[0] == 0.0);
    assert_true(curve->x[curve->count - 1] == 5.0 && curve->y[curve->count - 1] == 0.0);
    double highest = 0.0;
    for (size_t i = 0; i < curve->count; i++) {
        assert_true(fabs(hypot(curve->x[i] - 3.0, curve->y[i]) - 2.0) < 1e-14);
        highest = fmax(highest, curve->y[i]);
    }
    assert_true(highest > 1.999);
    clod_figure_fini(&figure);
}

/** Behind the last colour the colours come again, with other dashes and other marks. */
static void a_second_round_looks_different(void **state)
{
    (void)state;
    const double x[2] = {0.0, 1.0};
    clod_figure figure;
    clod_text text;
    clod_figure_init(&figure, "r", "r");
    clod_figure_add(&figure, "", CLOD_FIGURE_LINE, CLOD_FIGURE_COLOURS + 1, 2, x, x, NULL);
    clod_figure_add(&figure, "", CLOD_FIGURE_POINTS, CLOD_FIGURE_COLOURS + 1, 2, x, x, NULL);
    clod_figure_add(&figure, "", CLOD_FIGURE_LINE, CLOD_FIGURE_GREY, 2, x, x, NULL);
    assert_int_equal(figure.curves[0].colour, 1);
    assert_int_equal(figure.curves[0].round, 1);
    assert_int_equal(figure.curves[2].colour, CLOD_FIGURE_GREY);
    assert_int_equal(figure.curves[2].round, 0);
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    clod_figure_svg(out, &figure);
    char *svg = clod_text_close(&text);
    assert_non_null(strstr(svg, "stroke-dasharray=\"7 3 2 3\""));
    assert_null(strstr(svg, "<circle"));
    assert_non_null(strstr(svg, "m-4 -4h8v8h-8z\" fill=\"#d55e00\""));
    clod_memory_free(svg);
    clod_figure_fini(&figure);
}

/** Points on a curve of their own colour are seen by a black edge; one that is vague is empty. */
static void marks_on_a_curve_stand_out(void **state)
{
    (void)state;
    const double x[2] = {0.0, 1.0}, error[2] = {0.1, 0.1};
    clod_figure figure;
    clod_figure_init(&figure, "marks", "marks");
    clod_figure_add(&figure, "", CLOD_FIGURE_READ, 0, 2, x, x, error);
    clod_figure_add(&figure, "", CLOD_FIGURE_VAGUE, 1, 2, x, x, NULL);
    clod_figure_add(&figure, "", CLOD_FIGURE_THIN, 2, 2, x, x, NULL);
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    clod_figure_svg(out, &figure);
    char *svg = clod_text_close(&text);
    assert_non_null(strstr(svg, " fill=\"#0072b2\" stroke=\"#000000\""));
    assert_non_null(strstr(svg, " stroke=\"#000000\" stroke-width=\"1.5\"/>"));
    assert_non_null(strstr(svg, " fill=\"#ffffff\" stroke=\"#d55e00\""));
    assert_non_null(strstr(svg, " stroke=\"#009e73\" stroke-width=\"0.9\""));
    clod_memory_free(svg);
    clod_figure_fini(&figure);
}

/** Lines that a page has side by side: whatever their round, with no colour at all. */
static void dashes_of_all_rounds_differ(void **state)
{
    (void)state;
    static const clod_figure_style STYLES[] = {CLOD_FIGURE_LINE, CLOD_FIGURE_DASHED,
                                               CLOD_FIGURE_DOTTED};
    const char *seen[3 * CLOD_FIGURE_ROUNDS];
    size_t count = 0;
    for (size_t s = 0; s < 3; s++) {
        for (int round = 0; round < CLOD_FIGURE_ROUNDS; round++) {
            const clod_figure_curve curve = {.style = STYLES[s], .round = round};
            seen[count] = clod_figure_dashes(&curve);
            for (size_t k = 0; k < count; k++) {
                assert_string_not_equal(seen[k], seen[count]);
            }
            count++;
        }
    }
    const clod_figure_curve marks = {.style = CLOD_FIGURE_HOLLOW, .round = 1};
    assert_string_equal(clod_figure_dashes(&marks), "");
}

/** 7 colours in 4 rounds: the 29th curve looks like the first, and the legend says so. */
static void curves_that_look_alike_are_told(void **state)
{
    (void)state;
    const double x[2] = {0.0, 1.0};
    clod_figure figure;
    char text[256];
    clod_figure_init(&figure, "many", "many");
    for (int k = 0; k < 28; k++) {
        clod_figure_add(&figure, "one of the first", CLOD_FIGURE_LINE, k, 2, x, x, NULL);
    }
    clod_figure_add(&figure, "grey", CLOD_FIGURE_LINE, CLOD_FIGURE_GREY, 2, x, x, NULL);
    assert_false(clod_figure_alike(&figure, text));
    clod_figure_add(&figure, "run <29>", CLOD_FIGURE_LINE, 28, 2, x, x, NULL);
    clod_figure_add(&figure, "run 30", CLOD_FIGURE_LINE, 29, 2, x, x, NULL);
    assert_true(clod_figure_alike(&figure, text));
    assert_ptr_equal(strstr(text, "From run <29> on, "), text);
    clod_text svg;
    FILE *out = clod_text_open(&svg);
    clod_figure_svg(out, &figure);
    char *drawn = clod_text_close(&svg);
    assert_non_null(strstr(drawn, "From run &lt;29&gt; on, curves look like earlier ones."));
    clod_memory_free(drawn);
    clod_figure_fini(&figure);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thinning_keeps_every_extreme),
        cmocka_unit_test(names_of_files_are_plain),
        cmocka_unit_test(ticks_are_round_and_hold_all_values),
        cmocka_unit_test(equal_scales_are_equal),
        cmocka_unit_test(a_circle_has_its_radius),
        cmocka_unit_test(a_second_round_looks_different),
        cmocka_unit_test(marks_on_a_curve_stand_out),
        cmocka_unit_test(dashes_of_all_rounds_differ),
        cmocka_unit_test(curves_that_look_alike_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
