// Lucy's polynomial and its mean over a line, beside sums over many small pieces.

#include "measure/lucy.h"

#include "support/check.h"

#define WIDTH 0.7
#define PIECES 200000

/** r of a point off the middle. */
static double kernel(double r)
{
    return clod_lucy(WIDTH, r * r);
}

static void its_integral_is_one(void **state)
{
    (void)state;
    double whole = 0.0, square = 0.0;
    for (int k = 0; k < PIECES; k++) { // shells of equal thickness, from their middles
        const double r = (k + 0.5) / PIECES * WIDTH, shell = 4.0 * M_PI * r * r;
        whole += shell * kernel(r) * WIDTH / PIECES;
        square += shell * r * r * kernel(r) * WIDTH / PIECES;
    }
    check_close(whole, 1.0, 1e-9);
    check_close(square, 0.25 * WIDTH * WIDTH, 1e-9); // by hand: <r^2> = w^2/4
}

static void it_ends_smoothly_at_its_width(void **state)
{
    (void)state;
    const double peak = 105.0 / (16.0 * M_PI * WIDTH * WIDTH * WIDTH);
    check_close(kernel(0.0), peak, 1e-12);
    check_close(kernel(0.5 * WIDTH), peak * 2.5 / 8.0, 1e-12); // (1 + 3/2) (1/2)^3
    check_close(kernel(WIDTH), 0.0, 0.0);
    check_close(kernel(2.0 * WIDTH), 0.0, 0.0);
    assert_true(kernel(0.999 * WIDTH) < 5e-9 * peak); // with the cube of the way to the end
    assert_true(kernel(0.999 * WIDTH) > 3e-9 * peak);
}

/** Mean of the kernel over a line by a sum over small pieces. */
static double along(const double from[3], const double to[3], const double at[3])
{
    double sum = 0.0;
    for (int k = 0; k < PIECES; k++) {
        const double s = (k + 0.5) / PIECES;
        double square = 0.0;
        for (int a = 0; a < 3; a++) {
            const double off = at[a] - from[a] - s * (to[a] - from[a]);
            square += off * off;
        }
        sum += clod_lucy(WIDTH, square) / PIECES;
    }
    return sum;
}

static void a_line_has_the_mean_of_its_points(void **state)
{
    (void)state;
    static const double LINES[][2][3] = {
        {{0.1, -0.2, 0.3}, {0.4, 0.3, -0.1}},   // within, beside the point
        {{-2.0, 0.1, 0.0}, {3.0, 0.1, 0.05}},   // through all of the kernel
        {{0.2, 0.0, 0.0}, {1.5, 0.0, 0.0}},     // its prolongation meets the point
        {{-0.3, 0.0, 0.0}, {0.2, 0.0, 0.0}},    // through the point
        {{-0.5, 1e-9, 0.0}, {0.4, 1e-9, 0.0}},  // next to it
        {{-0.5, 0.69, 0.0}, {0.4, 0.69, 0.0}},  // at the end of the kernel
        {{0.3, 0.3, 0.3}, {0.3001, 0.3, 0.3}},  // very short
        {{0.65, 0.0, 0.0}, {0.6999, 0.0, 0.0}}, // outermost
    };
    static const double AT[3] = {0.0, 0.0, 0.0};
    const double peak = kernel(0.0);
    for (size_t k = 0; k < sizeof LINES / sizeof *LINES; k++) {
        const double *from = LINES[k][0], *to = LINES[k][1];
        const clod_lucy_line line = clod_lucy_line_of(from, to);
        const clod_lucy_line back = clod_lucy_line_of(to, from);
        const double expected = along(from, to, AT);
        check_close(clod_lucy_along(WIDTH, &line, AT), expected, 1e-9 * peak);
        check_close(clod_lucy_along(WIDTH, &back, AT), expected, 1e-9 * peak);
    }
}

static void lines_out_of_reach_and_without_length(void **state)
{
    (void)state;
    const double at[3] = {0.0, 0.0, 0.0}, far[3] = {0.8, 0.0, 0.0}, by[3] = {0.8, 3.0, 0.0};
    const double p[3] = {0.2, 0.1, 0.0};
    const clod_lucy_line beyond = clod_lucy_line_of(far, by), none = clod_lucy_line_of(p, p);
    check_close(clod_lucy_along(WIDTH, &beyond, at), 0.0, 0.0);
    check_close(clod_lucy_along(WIDTH, &none, at), clod_lucy(WIDTH, 0.05), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(its_integral_is_one),
        cmocka_unit_test(it_ends_smoothly_at_its_width),
        cmocka_unit_test(a_line_has_the_mean_of_its_points),
        cmocka_unit_test(lines_out_of_reach_and_without_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
