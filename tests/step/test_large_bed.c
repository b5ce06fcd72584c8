// A bed whose arrays are large enough to be given back to the system in part (base/memory.h):
// the lists made anew in every way, by one thread and by three, and nothing is lost. Its layers
// are so large that they are cut into strips.

#include "step/layers.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define SIDE 48
#define SPACING 0.00598 ///< m, of grains of 3 mm
#define STEPS 4
#define LARGEST 0.012 ///< m, radius of one grain above: layers are thick, and cut into strips

/** A block of grains that touch, of three materials, on a floor, pushed at random. */
static void large_init(scene *self)
{
    const clod_case_contact ore = contact_ore();
    dice roll = {11};
    scene_init(self, 1e-7, &ore);
    bed_laws(self);
    self->state.gravity[2] = -9.81;
    scene_wall(self, "floor", shape_floor(0.0));
    clod_status status = {0};
    assert_true(clod_grains_reserve(&self->state.grains, SIDE * SIDE * SIDE + 1, &status));
    for (int n = 0; n < SIDE * SIDE * SIDE; n++) {
        const size_t g = scene_grain(self, SPACING * (n % SIDE), SPACING * (n / SIDE % SIDE),
                                     0.00299 + SPACING * (n / SIDE / SIDE), 0.003);
        self->state.grains.material[g] = (uint16_t)(n % 3);
        scene_move(self, g, dice_real(&roll, -0.2, 0.2), dice_real(&roll, -0.2, 0.2),
                   dice_real(&roll, -0.2, 0.2));
    }
    const double middle = 0.5 * SPACING * SIDE;
    scene_grain(self, middle, middle, SPACING * SIDE + LARGEST, LARGEST);
    const double(*place)[4] = (const double(*)[4])self->state.grains.position;
    assert_true(clod_layers_of(place, self->state.grains.count).strips > 1.0);
}

/** Everything of one bed, without a list made anew but where the sums' order changes. */
static void run_plain(scene *self)
{
    large_init(self);
    scene_start_with(self, (clod_step_options){.threads = 1});
    scene_run(self, 3 * STEPS);
    self->state.build_motion = INFINITY;
    scene_run(self, 2 * STEPS);
    assert_int_equal(self->step.refreshes, 0);
    assert_int_equal(self->step.rebuilds, 1);
}

/** The same with histories brought out and taken back, and the near list made anew. */
static void run_with_lists(scene *self, int threads)
{
    clod_status status = {0};
    large_init(self);
    scene_start_with(self, (clod_step_options){.threads = threads});
    scene_run(self, STEPS);
    const clod_energies before = clod_step_energies(&self->step);
    assert_true(clod_step_export(&self->step, &status));
    assert_true(clod_step_export(&self->step, &status)); // once is enough
    assert_true(self->state.contact_count > 2 * self->state.grains.count);
    assert_true(self->state.wall_contact_count > SIDE * SIDE / 2);
    assert_true(self->state.contact_count * sizeof(clod_contact) > 2 * CLOD_MEMORY_LARGE);
    const clod_energies after = clod_step_energies(&self->step);
    assert_memory_equal(&before, &after, sizeof before);
    scene_run(self, STEPS);
    assert_true(clod_step_export(&self->step, &status));
    scene_run(self, STEPS);
    self->state.build_motion = INFINITY;
    scene_run(self, STEPS);
    self->step.near.wall_skin = -1.0; // one is used up
    scene_run(self, STEPS);
    assert_int_equal(self->step.refreshes, 1);
    assert_int_equal(self->step.rebuilds, 1);
}

static void nothing_is_lost_when_lists_are_made_anew(void **state)
{
    (void)state;
    const int threads[] = {1, 3};
    scene plain;
    run_plain(&plain);
    assert_true(clod_step_export(&plain.step, &plain.step.status));
    for (int k = sanitized() ? 1 : 0; k < 2; k++) {
        scene again;
        run_with_lists(&again, threads[k]);
        assert_true(clod_step_export(&again.step, &again.step.status));
        check_same_bits(&plain.state, &again.state);
        scene_end(&again);
    }
    scene_end(&plain);
}

/** Grains come: their arrays grow, and those of the last rebuild are still as they were. */
static void memory_of_others_stays_when_grains_come(void **state)
{
    (void)state;
    const clod_new_grain above = {
        .id = 1000000, .position = {0.0, 0.0, 0.5, 0.003}, .density = 2500.0};
    scene bed;
    large_init(&bed);
    scene_start_with(&bed, (clod_step_options){.threads = 1});
    scene_run(&bed, 1);
    const size_t room = bed.state.grains.capacity;
    clod_changes_add_grain(&bed.state.changes, &above);
    scene_run(&bed, 2); // clod_memory_give_back asserts that it stays within an array
    assert_true(bed.state.grains.capacity > room);
    assert_int_equal(bed.step.rebuilds, 1);
    scene_end(&bed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_lost_when_lists_are_made_anew),
        cmocka_unit_test(memory_of_others_stays_when_grains_come),
    };
    if (looks_for_races()) {
        cmocka_set_test_filter("nothing_is_lost*"); // others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
