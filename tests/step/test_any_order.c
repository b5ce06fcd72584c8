// A state is the same whatever the order of its rows and contacts: taken up with grains and
// contacts shuffled, it goes on with the same bits.
#include "support/bed.h"
#include "support/bits.h"
#include "support/shuffled.h"

#define STEPS 3000

static void rows_and_contacts_may_stand_in_any_order(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene whole;
        bed_init(&whole, (bed_kind)kind, 4);
        scene_start(&whole);
        scene_run(&whole, STEPS);
        assert_true(clod_step_export(&whole.step, &whole.step.status));
        scene other;
        bed_init(&other, (bed_kind)kind, 4);
        scene_start(&other);
        scene_run(&other, 2 * STEPS);
        assert_true(clod_step_export(&other.step, &other.step.status));
        for (uint64_t seed = 1; seed <= 3; seed++) {
            scene now = whole;
            now.laws.law = now.law;
            now.state = shuffled(&whole.state, seed);
            assert_true(memcmp(now.state.grains.id, whole.state.grains.id,
                               whole.state.grains.count * sizeof(uint64_t)) != 0);
            scene_start_with(&now, (clod_step_options){.threads = (int)seed});
            assert_true(clod_step_export(&now.step, &now.step.status));
            check_same_bits(&whole.state, &now.state); // back in order
            assert_memory_equal(now.state.build_position, whole.state.build_position,
                                whole.state.grains.count * sizeof *whole.state.build_position);
            scene_run(&now, STEPS);
            assert_true(clod_step_export(&now.step, &now.step.status));
            check_same_bits(&other.state, &now.state);
            scene_end(&now);
        }
        scene_end(&other);
        scene_end(&whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_and_contacts_may_stand_in_any_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
