// The largest eigenvalue of matrices whose eigenvalues are known: diagonal ones, and the chain
// with 2 on the diagonal and -1 beside it, 4 sin^2(k pi/(2 (n + 1))) (Golub & Van Loan, sec. 4.8).

#include "base/lanczos.h"

#include <math.h>

#include "support/check.h"

#define MOST 2000
/** 400 products resolve the end of a band to that of a chain of 400: 4 - 4 sin^2(...). */
#define CHAIN_ERROR (4.0 * (M_PI / 802.0) * (M_PI / 802.0))

typedef struct matrix {
    size_t size;
    double diagonal[MOST];
    double beside;
} matrix;

static void multiply(const void *context, const double *x, double *y)
{
    const matrix *a = context;
    for (size_t k = 0; k < a->size; k++) {
        const double left = k > 0 ? x[k - 1] : 0.0;
        const double right = k + 1 < a->size ? x[k + 1] : 0.0;
        y[k] = a->diagonal[k] * x[k] + a->beside * (left + right);
    }
}

static double largest(const matrix *a)
{
    clod_lanczos lanczos;
    assert_true(clod_lanczos_init(&lanczos, a->size));
    for (size_t k = 0; k < a->size; k++) {
        lanczos.start[k] = 1.0 + 0.5 * sin(7.0 * (double)k); // a part of every vector
    }
    const double found = clod_lanczos_largest(&lanczos, a, multiply);
    clod_lanczos_fini(&lanczos);
    return found;
}

static void a_chain_has_its_closed_form(void **state)
{
    (void)state;
    static const size_t SIZES[] = {1, 2, 3, 10, 100, 2000};
    for (size_t s = 0; s < sizeof SIZES / sizeof *SIZES; s++) {
        matrix a = {.size = SIZES[s], .beside = -1.0};
        for (size_t k = 0; k < a.size; k++) {
            a.diagonal[k] = 2.0;
        }
        const double n = (double)a.size;
        const double root = 2.0 * sin(0.5 * M_PI * n / (n + 1.0));
        check_close(largest(&a), root * root, CHAIN_ERROR);
    }
}

/** One value far above a thousand others, and one barely above: as in a bed with a strong contact. */
static void the_largest_of_a_diagonal_is_found(void **state)
{
    (void)state;
    static const double ABOVE[] = {10.0, 1.01};
    for (int c = 0; c < 2; c++) {
        matrix a = {.size = 1000};
        for (size_t k = 0; k < a.size; k++) {
            a.diagonal[k] = (double)k / 1000.0;
        }
        a.diagonal[417] = ABOVE[c];
        check_relative(largest(&a), ABOVE[c], 1e-6);
    }
}

static void scale_does_not_count(void **state)
{
    (void)state;
    static const double SCALES[] = {1e-20, 1.0, 1e20};
    for (int c = 0; c < 3; c++) {
        matrix a = {.size = 30, .beside = 0.5 * SCALES[c]};
        for (size_t k = 0; k < a.size; k++) {
            a.diagonal[k] = SCALES[c];
        }
        const double wanted = 1.0 + cos(M_PI / 31.0);
        check_close(largest(&a) / SCALES[c], wanted, 1e-6);
    }
}

static void nothing_gives_zero_and_no_number_none(void **state)
{
    (void)state;
    matrix a = {.size = 5};
    assert_true(largest(&a) == 0.0);
    a.diagonal[2] = NAN;
    assert_true(isnan(largest(&a)));
    a.size = 0;
    assert_true(largest(&a) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_chain_has_its_closed_form),
        cmocka_unit_test(the_largest_of_a_diagonal_is_found),
        cmocka_unit_test(scale_does_not_count),
        cmocka_unit_test(nothing_gives_zero_and_no_number_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
