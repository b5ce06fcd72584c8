// Sums of eight columns in fixed point: the same bits for any order and any grouping, within
// what the format promises of the exact sum (parallel/exact.h), and not a number out of range.

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "parallel/exact.h"
#include "parallel/fixed.h"
#include "support/check.h"

enum { COUNT = 3000, COLUMNS = CLOD_FIXED_COLUMNS };

static double uniform(uint64_t item, uint64_t draw)
{
    return clod_random_uniform(23, CLOD_RANDOM_TEST, item, draw);
}

/** Magnitudes from 10^-18 to 10^11, either sign: a column of each width. */
static double any_number(uint64_t item, int column)
{
    const double decades = 4.0 * (double)column;
    const double exponent = -18.0 + decades * uniform(item, 2 * (uint64_t)column);
    const double sign = uniform(item, 99 + (uint64_t)column) < 0.5 ? -1.0 : 1.0;
    return sign * pow(10.0, exponent) * (1.0 + uniform(item, 2 * (uint64_t)column + 1));
}

static void make_rows(double (*row)[COLUMNS])
{
    for (uint64_t n = 0; n < COUNT; n++) {
        for (int c = 0; c < COLUMNS; c++) {
            row[n][c] = any_number(n, c);
        }
    }
}

static void check_same(const double a[COLUMNS], const double b[COLUMNS])
{
    if (memcmp(a, b, COLUMNS * sizeof *a) != 0) {
        for (int c = 0; c < COLUMNS; c++) {
            print_error("column %d: %a and %a\n", c, a[c], b[c]);
        }
        fail();
    }
}

static void value_of(const double (*row)[COLUMNS], const int *order, int count,
                     double value[COLUMNS])
{
    clod_fixed sum = {0};
    for (int n = 0; n < count; n++) {
        clod_fixed_add(&sum, row[order[n]]);
    }
    clod_fixed_value(&sum, value);
}

/** Another order of the rows each time. */
static void shuffle(int *order, int count, uint64_t round)
{
    for (int n = 0; n < count; n++) {
        order[n] = n;
    }
    for (int n = count - 1; n > 0; n--) {
        const int other = (int)(uniform(round, (uint64_t)n) * (double)(n + 1));
        const int kept = order[n];
        order[n] = order[other];
        order[other] = kept;
    }
}

static void order_does_not_matter(void **state)
{
    (void)state;
    static double row[COUNT][COLUMNS];
    static int order[COUNT];
    make_rows(row);
    double first[COLUMNS], again[COLUMNS];
    shuffle(order, COUNT, 1);
    value_of((const double(*)[COLUMNS])row, order, COUNT, first);
    for (uint64_t round = 2; round < 30; round++) {
        shuffle(order, COUNT, round);
        value_of((const double(*)[COLUMNS])row, order, COUNT, again);
        check_same(first, again);
    }
}

/** Groups of any sizes, carried or not, merged in any order. */
static void grouping_does_not_matter(void **state)
{
    (void)state;
    static double row[COUNT][COLUMNS];
    static int order[COUNT];
    make_rows(row);
    double whole[COLUMNS], value[COLUMNS];
    shuffle(order, COUNT, 1);
    value_of((const double(*)[COLUMNS])row, order, COUNT, whole);
    for (uint64_t round = 0; round < 30; round++) {
        enum { GROUPS = 7 };
        clod_fixed part[GROUPS] = {0};
        for (uint64_t n = 0; n < COUNT; n++) {
            const int g = (int)(uniform(n, 1000 + round) * GROUPS);
            clod_fixed_add(&part[g], row[n]);
            if (uniform(n, 2000 + round) < 0.01) {
                clod_fixed_carry(&part[g]);
            }
        }
        clod_fixed sum = {0};
        for (int k = 0; k < GROUPS; k++) {
            clod_fixed *next = &part[(k + (int)round) % GROUPS];
            clod_fixed_carry(next);
            clod_fixed_merge(&sum, next);
        }
        clod_fixed_value(&sum, value);
        check_same(whole, value);
    }
}

static void value_is_the_exact_sum(void **state)
{
    (void)state;
    static double row[COUNT][COLUMNS];
    make_rows(row);
    clod_fixed sum = {0};
    clod_exact exact[COLUMNS] = {0};
    double value[COLUMNS];
    for (int n = 0; n < COUNT; n++) {
        clod_fixed_add(&sum, row[n]);
        for (int c = 0; c < COLUMNS; c++) {
            clod_exact_add(&exact[c], row[n][c]);
        }
        clod_fixed_value(&sum, value);
        for (int c = 0; c < COLUMNS; c++) {
            const double expected = clod_exact_value(&exact[c]);
            const double ulp = nextafter(fabs(expected), INFINITY) - fabs(expected);
            check_close(value[c], expected, 2.0 * ulp + (n + 1) * 0x1p-81);
        }
    }
}

/** Numbers and their opposites leave nothing, whatever came between; a small one stays whole.
 */
static void what_cancels_leaves_nothing(void **state)
{
    (void)state;
    static double row[COUNT][COLUMNS];
    make_rows(row);
    clod_fixed sum = {0};
    double value[COLUMNS], opposite[COLUMNS];
    for (int n = 0; n < COUNT; n++) {
        clod_fixed_add(&sum, row[n]);
    }
    double small[COLUMNS];
    for (int c = 0; c < COLUMNS; c++) {
        small[c] = ldexp(1.0 + c, -70);
    }
    clod_fixed_add(&sum, small);
    for (int n = 0; n < COUNT; n++) {
        for (int c = 0; c < COLUMNS; c++) {
            opposite[c] = -row[n][c];
        }
        clod_fixed_add(&sum, opposite);
    }
    clod_fixed_value(&sum, value);
    check_same(value, small);
}

/** As many addends of the largest size as are allowed between two carries are still exact. */
static void largest_addends_fit(void **state)
{
    (void)state;
    double row[COLUMNS], value[COLUMNS];
    clod_fixed sum = {0};
    static const double LARGEST[3] = {0x1p38 - 1.0, 0.5 - 0x1p-41, 0x1p-41 - 0x1p-80};
    for (int c = 0; c < COLUMNS; c++) { // for each limb what is most in it
        row[c] = (c % 2 == 0 ? 1.0 : -1.0) * LARGEST[c % 3];
    }
    for (int round = 0; round < 3; round++) {
        for (int n = 0; n < CLOD_FIXED_ADDENDS; n++) {
            clod_fixed_add(&sum, row);
        }
        clod_fixed_carry(&sum);
        for (int c = 0; c < COLUMNS; c++) {
            row[c] = -row[c]; // the first is taken away again, then it is there once more
        }
    }
    clod_fixed_value(&sum, value);
    for (int c = 0; c < COLUMNS; c++) {
        assert_true(value[c] == CLOD_FIXED_ADDENDS * -row[c]);
    }
}

static void beyond_the_range_is_not_a_number(void **state)
{
    (void)state;
    const double wrong[] = {INFINITY, -INFINITY, NAN, 0x1p52, -0x1p60, 1e300};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        clod_fixed sum = {0};
        double value[COLUMNS];
        clod_fixed_add(&sum, (double[COLUMNS]){1.0, wrong[k], 2.0});
        clod_fixed_value(&sum, value);
        assert_true(value[0] == 1.0 && isnan(value[1]) && value[2] == 2.0 && value[3] == 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_does_not_matter),
        cmocka_unit_test(grouping_does_not_matter),
        cmocka_unit_test(value_is_the_exact_sum),
        cmocka_unit_test(what_cancels_leaves_nothing),
        cmocka_unit_test(largest_addends_fit),
        cmocka_unit_test(beyond_the_range_is_not_a_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
