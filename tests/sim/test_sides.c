// Grains that are a little beyond a periodic side, as they are between two neighbour lists: what
// asks whether a grain is in a region counts each once, where it is in the domain.

#include <string.h>

#include "base/memory.h"
#include "measure/gauge_pass.h"
#include "measure/repose.h"
#include "sim/mixing.h"
#include "support/check.h"
#include "support/dice.h"

#define GRAINS 250
#define BEYOND 1e-3 ///< m
#define RADIUS 2e-3 ///< m

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};
static const clod_domain DOMAIN = {
    .min = {0.01, -0.03, 0.0}, .max = {0.05, 0.01, 0.1}, .periodic = {true, true, false}};
static const clod_outlet WHOLE = {.low = {0.01, -0.03, 0.0}, .high = {0.05, 0.01, 0.1}};

static void add(clod_state *state, const double at[3])
{
    const double position[4] = {at[0], at[1], at[2], RADIUS};
    assert_true(clod_grains_add(&state->grains, position, NONE, NONE, 2500.0, 0,
                                state->grains.count + 1, &status));
}

/** Grains anywhere in the domain; those within 1 mm of a periodic side are told as their image
 *  beyond the other. `mean` has the mean of their places. */
static void make(clod_state *state, double mean[3])
{
    *state = (clod_state){.dt = 1e-3, .domain = DOMAIN};
    dice roll = {5};
    int beyond = 0;
    memset(mean, 0, 3 * sizeof *mean);
    for (int g = 0; g < GRAINS; g++) {
        double at[3];
        for (int a = 0; a < 3; a++) {
            const double low = DOMAIN.min[a], high = DOMAIN.max[a];
            at[a] = dice_real(&roll, low, high);
            mean[a] += at[a] / GRAINS;
            if (a < 2 && at[a] < low + BEYOND) {
                at[a] += high - low;
                beyond++;
            } else if (a < 2 && at[a] >= high - BEYOND) {
                at[a] -= high - low;
                beyond++;
            }
        }
        add(state, at);
    }
    assert_true(beyond > 10);
}

static void gauges_count_all(void **unused)
{
    (void)unused;
    clod_state state;
    double mean[3], sums[CLOD_GAUGE_SUMS], v[CLOD_GAUGE_VALUES];
    make(&state, mean);
    const clod_gauge gauge = clod_gauge_of(&WHOLE, NONE, NONE, NONE);
    const clod_gauge_part part = {.gauge = gauge, .sums = sums};
    const clod_survey survey = clod_survey_of(&state, NULL);
    assert_true(clod_gauge_pass(&part, 1, &survey, &status));
    clod_gauge_values(&gauge, sums, v);
    check_close(v[CLOD_GAUGE_OF_GRAINS], GRAINS, 0.0);
    for (int a = 0; a < 3; a++) {
        check_close(v[CLOD_GAUGE_OF_CENTER + a], mean[a], 1e-15);
    }
    clod_state_fini(&state);
}

/** Number of grains in cells that are as large as the region, and in four quarters of it. */
static void mixing_counts_all(void **unused)
{
    (void)unused;
    clod_state state;
    double mean[3];
    make(&state, mean);
    for (int cells = 1; cells <= 4; cells *= 4) {
        char name[] = "all";
        clod_case_mixing asked = {.name = name,
                                  .region = {.kind = CLOD_REGION_BOX,
                                             .min = {0.01, -0.03, 0.0},
                                             .max = {0.05, 0.01, 0.02}},
                                  .cell = cells == 1 ? 0.04 : 0.02,
                                  .above = 1e-3};
        const clod_case from = {.mixings = &asked, .mixing_count = 1};
        const clod_survey survey = clod_survey_of(&state, NULL);
        const clod_free_moment now = {.from = &from, .state = &state, .survey = &survey};
        void *memory = clod_memory_alloc(1, CLOD_MEASURE_MIXING.size(&from));
        double row[5];
        int expected = 0;
        for (int g = 0; g < GRAINS; g++) {
            expected += state.grains.position[g][2] <= 0.02;
        }
        assert_true(CLOD_MEASURE_MIXING.look(memory, &now, &status));
        CLOD_MEASURE_MIXING.row(memory, &now, row);
        check_close(row[4] * cells, expected, 1e-12);
        clod_memory_free(memory);
    }
    clod_state_fini(&state);
}

/** The centre of mass has all grains, and a grain beyond a corner makes the surface in the one
 *  across. */
static void repose_counts_all(void **unused)
{
    (void)unused;
    clod_state state;
    double mean[3], center[2];
    make(&state, mean);
    const clod_survey survey = clod_survey_of(&state, NULL);
    assert_true(clod_repose_center(&WHOLE, &survey, center, &status));
    check_close(center[0], mean[0], 1e-15);
    check_close(center[1], mean[1], 1e-15);
    clod_state_fini(&state);
    state = (clod_state){.dt = 1e-3, .domain = DOMAIN};
    add(&state, (const double[]){0.0505, -0.0305, 0.05});
    clod_repose_angle found;
    const clod_repose slope = {
        .region = WHOLE, .cell = 0.04, .slope = true, .direction = {1.0, 0.0}, .to = 1.0};
    assert_true(clod_repose_find(&slope, &survey, &found, &status));
    check_close(found.height, 0.05 + RADIUS, 1e-15);
    clod_state_fini(&state);
}

/** Places are in [min, max), rounding or not. */
static void places_are_half_open(void **unused)
{
    (void)unused;
    const double min = DOMAIN.min[0], max = DOMAIN.max[0];
    check_close(clod_domain_within(&DOMAIN, 0, min), min, 0.0);
    const double behind = clod_domain_within(&DOMAIN, 0, max);
    assert_true(behind >= min && behind < min + 1e-17); // of a period that is rounded
    check_close(clod_domain_within(&DOMAIN, 0, nextafter(max, 0.0)), nextafter(max, 0.0), 0.0);
    const double below = clod_domain_within(&DOMAIN, 0, nextafter(min, 0.0));
    assert_true(below == min || (below < max && below > max - 1e-15));
    check_close(clod_domain_within(&DOMAIN, 0, 0.02 + 0.12), 0.02, 1e-16);
    check_close(clod_domain_within(&DOMAIN, 2, 0.5), 0.5, 0.0); // an open side
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gauges_count_all),
        cmocka_unit_test(mixing_counts_all),
        cmocka_unit_test(repose_counts_all),
        cmocka_unit_test(places_are_half_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
