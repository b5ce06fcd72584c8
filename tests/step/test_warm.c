// A warm step allocates nothing, rebuilds included.

#include "support/bed.h"

/** An elastic gas, so that the number of contacts does not grow: two laws, walls at rest. */
static void gas_init(scene *s, bed_kind kind)
{
    bed_init(s, kind, 3);
    const clod_case_contact hooke = contact_elastic(1.0, 1e5);
    const clod_case_contact soft = contact_elastic(1.5, 1e7);
    for (int l = 0; l < SCENE_LAWS; l++) {
        s->law[l] = clod_law_make(l % 2 == 0 ? &hooke : &soft, &ORE, &ORE);
    }
    for (int w = 0; w < s->state.walls.count; w++) {
        clod_wall *wall = &s->state.walls.wall[w];
        wall->spin = 0.0;
        wall->velocity = (clod_vec3){0.0, 0.0, 0.0};
        wall->load = CLOD_LOAD_NONE;
    }
}

static void warm_steps_allocate_nothing(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        for (int threads = 1; threads <= 2; threads++) {
            clod_status status = {0};
            scene s;
            gas_init(&s, (bed_kind)kind);
            scene_start_with(&s, (clod_step_options){.threads = threads});
            scene_run(&s, 8000);
            assert_true(clod_step_export(&s.step, &status));
            const int64_t rebuilds = s.step.rebuilds;
            const int64_t refreshes = s.step.refreshes;
            const uint64_t before = clod_memory_count();
            scene_run(&s, 2000);
            assert_true(clod_step_export(&s.step, &status));
            assert_int_equal(clod_memory_count() - before, 0);
            assert_true(s.step.rebuilds > rebuilds + 3); // all paths were taken
            assert_true(s.step.refreshes > refreshes + 10);
            scene_end(&s);
        }
    }
}

/** The count that the test above trusts: setting up allocates, a fresh step too. */
static void cold_steps_do_allocate(void **state)
{
    (void)state;
    scene s;
    uint64_t before = clod_memory_count();
    bed_init(&s, BED_SLIT, 3);
    assert_true(clod_memory_count() > before);
    before = clod_memory_count();
    scene_start(&s);
    assert_true(clod_memory_count() > before);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(warm_steps_allocate_nothing),
        cmocka_unit_test(cold_steps_do_allocate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
