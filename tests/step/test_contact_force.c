// Forces that are told again between steps are those that the step has added up.

#include "support/bed.h"
#include "support/contact_forces.h"

#define STEPS 3000

static void forces_are_those_of_the_step(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        bed_init(&s, (bed_kind)kind, 11);
        for (int32_t w = 0; w < s.state.walls.count; w++) { // a servo has its velocity for the
            s.state.walls.wall[w].load = CLOD_LOAD_NONE;    // next step already
        }
        scene_start_with(&s, (clod_step_options){.threads = 2});
        scene_run(&s, STEPS);
        contact_forces_undo_kick(&s.state);
        const contact_forces_count seen = contact_forces_compare(&s.step, false);
        const contact_forces_count turned = contact_forces_compare(&s.step, true);
        assert_true(seen.pairs > 0 && seen.pairs == turned.pairs);
        assert_true((seen.walls > 0) == (kind != BED_CLUSTER) && seen.walls == turned.walls);
        scene_end(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_those_of_the_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
