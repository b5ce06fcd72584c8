// Counting grains before any is made: what is asked for, refused with numbers.

#include <string.h>
#include <time.h>

#include "setup/amount.h"
#include "setup/begin.h"
#include "support/check.h"

static clod_sizes one_size(double radius)
{
    clod_sizes sizes;
    clod_status status = {0};
    assert_true(clod_sizes_init_normal(&sizes, radius, 1.0, radius, radius, &status));
    return sizes;
}

/** Grains of 1 mm radius and 1000 kg/m3: 4.18879e-6 kg each. */
static size_t count(double kilograms, clod_status *status)
{
    const clod_sizes sizes = one_size(1e-3);
    const clod_amount amount = {.key = "grains[0].mass",
                                .sizes = &sizes,
                                .volume = kilograms / 1000.0,
                                .density = 1000.0};
    return clod_amount_count(&amount, 1, 1, status);
}

// One grain is the nearest from 2.8 mg (2/3 of it: then it is half too heavy) on.
static void less_than_a_grain_is_refused(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    assert_int_equal(count(2.9e-6, &status), 1);
    assert_int_equal(count(8.4e-6, &status), 2);
    assert_int_equal(count(2.7e-6, &status), 0);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "grains[0].mass: asks for 2.7e-06 kg"));
    assert_non_null(strstr(status.text, "1 grain of 4.19e-06 kg"));
    assert_int_equal(count(1e-9, &status), 0);
}

// A table to 20 times the size of its fines: the second grain with seed 1 or another is much
// heavier than all that is asked for. Whatever the seed: within half of it, or refused.
static void a_grain_much_heavier_than_the_request_is_refused(void **state)
{
    (void)state;
    clod_case_sieve rows[] = {{1e-3, 0.0}, {2e-3, 0.2}, {20e-3, 1.0}};
    const clod_case_grains from = {.sizes = CLOD_SIZE_SIEVE, .sieve = rows, .sieve_count = 3};
    clod_sizes sizes;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_sizes_init(&sizes, &from, &status));
    const clod_amount amount = {
        .key = "grains[0].mass", .sizes = &sizes, .volume = 1e-8, .density = 1000.0};
    int refused = 0;
    for (uint64_t seed = 0; seed < 200; seed++) {
        const size_t grains = clod_amount_count(&amount, seed, 1, &status);
        double volume = 0.0;
        for (uint64_t g = 0; g < grains; g++) {
            const double r = clod_sizes_radius(&sizes, seed, 1 + g);
            volume += 4.0 / 3.0 * M_PI * r * r * r;
        }
        refused += grains == 0;
        assert_true(grains == 0 || fabs(volume - 1e-8) <= 0.5e-8 * (1.0 + 1e-12));
    }
    assert_true(refused > 0 && refused < 200);
    clod_sizes_fini(&sizes);
}

// 1e9 grains of 500 bytes are 500 GB; with more memory than that there is nothing to refuse.
static void more_than_the_memory_is_refused_at_once(void **state)
{
    (void)state;
    const clod_sizes sizes = one_size(1e-6);
    clod_status status = {CLOD_OK, ""};
    const clod_amount by_number = {
        .key = "grains[0].count", .sizes = &sizes, .count = 1000000000000, .density = 1.0};
    const clod_amount by_volume = {
        .key = "ring_shear", .sizes = &sizes, .volume = 1.0, .density = 1.0};
    const clock_t begin = clock();
    assert_int_equal(clod_amount_count(&by_number, 1, 1, &status), 0);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(
        strstr(status.text, "grains[0].count: 1e+12 grains need at least 5e+05 GB"));
    assert_int_equal(clod_amount_count(&by_volume, 1, 1, &status), 0);
    assert_non_null(strstr(status.text, "ring_shear: 2.39e+17 grains need at least"));
    assert_true(clock() - begin < CLOCKS_PER_SEC);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(less_than_a_grain_is_refused),
        cmocka_unit_test(a_grain_much_heavier_than_the_request_is_refused),
        cmocka_unit_test(more_than_the_memory_is_refused_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
