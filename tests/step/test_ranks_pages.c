// While ranks step, no array of the whole bed's grains and contacts takes memory on rank 0.
#include "step/crew_state.h"

#include "base/memory.h"

#include "support/check.h"

#define ROWS 600000 ///< so many that the smallest array is given back

/** Put a number into the middle of an array, which is in memory then. */
static unsigned char *use(void *array, size_t size)
{
    unsigned char *middle = (unsigned char *)array + ROWS / 2 * size;
    *middle = 7;
    return middle;
}

/** A state with all columns that grains can have. */
static void make_state(clod_state *state)
{
    clod_status status = {0};
    *state = (clod_state){0};
    assert_true(clod_grains_reserve(&state->grains, ROWS, &status));
    assert_true(clod_grains_keep_before(&state->grains, &status));
    assert_true(clod_grains_keep_clumps(&state->grains, &status));
    assert_true(clod_state_reserve_build(state));
    state->contacts = clod_memory_alloc(ROWS, sizeof *state->contacts);
    assert_non_null(state->contacts);
    state->contact_capacity = ROWS;
}

static void no_array_of_the_whole_bed_stays(void **unused)
{
    (void)unused;
    clod_state state;
    make_state(&state);
    const clod_grains *grains = &state.grains;
    unsigned char *used[] = {
        use(grains->position, sizeof *grains->position),
        use(grains->velocity, sizeof *grains->velocity),
        use(grains->angular_velocity, sizeof *grains->angular_velocity),
        use(grains->load, sizeof *grains->load),
        use(grains->before, sizeof *grains->before),
        use(grains->id, sizeof *grains->id),
        use(grains->birth, sizeof *grains->birth),
        use(grains->material, sizeof *grains->material),
        use(grains->clump, sizeof *grains->clump),
        use(state.build_position, sizeof *state.build_position),
        use(state.contacts, sizeof *state.contacts),
    };
    clod_crew_state_forget(&state);
    for (size_t k = 0; k < sizeof used / sizeof *used; k++) {
#if defined(__linux__)
        assert_int_equal(*used[k], 0); // a fresh page
#endif
        *used[k] = 7; // there is room still
    }
    clod_state_fini(&state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_array_of_the_whole_bed_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
