// Sums over a bed are those of its grains and contacts, in whatever rows these stand.

#include "measure/contacts.h"
#include "support/bed.h"
#include "tester/bed.h"

typedef struct sums {
    double kinetic, mass, rms_speed, overlap;
} sums;

static sums sums_of(const clod_state *state)
{
    return (sums){clod_measure_motion_of(state).kinetic_energy, clod_bed_mass(state),
                  clod_bed_rms_speed(state), clod_measure_contacts_of(state).mean_overlap};
}

static void swap_doubles(double *a, double *b, int count)
{
    for (int c = 0; c < count; c++) {
        const double kept = a[c];
        a[c] = b[c];
        b[c] = kept;
    }
}

/** Turn the rows of all grains round, and the contacts of pairs. */
static void reverse_rows(clod_state *state)
{
    const size_t count = state->grains.count;
    for (size_t a = 0; a < count / 2; a++) {
        const size_t b = count - 1 - a;
        swap_doubles(state->grains.position[a], state->grains.position[b], 4);
        swap_doubles(state->grains.velocity[a], state->grains.velocity[b], 4);
        swap_doubles(state->grains.angular_velocity[a], state->grains.angular_velocity[b], 4);
    }
    const size_t pairs = state->contact_count - state->wall_contact_count;
    for (size_t c = 0; c < pairs / 2; c++) {
        const clod_contact kept = state->contacts[c];
        state->contacts[c] = state->contacts[pairs - 1 - c];
        state->contacts[pairs - 1 - c] = kept;
    }
    for (size_t c = 0; c < pairs; c++) {
        state->contacts[c].i = (int32_t)count - 1 - state->contacts[c].i;
        state->contacts[c].j = (int32_t)count - 1 - state->contacts[c].j;
    }
}

static void measures_do_not_see_the_rows(void **state)
{
    (void)state;
    clod_status status;
    scene s;
    bed_init(&s, BED_CLUSTER, 3);
    scene_start(&s);
    scene_run(&s, 3000);
    assert_true(clod_step_export(&s.step, &status));
    const sums before = sums_of(&s.state);
    assert_true(before.kinetic > 0.0 && before.overlap > 0.0);
    reverse_rows(&s.state);
    const sums after = sums_of(&s.state);
    assert_memory_equal(&after, &before, sizeof after);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(measures_do_not_see_the_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
