// Steps of several simulations at the same time, each with threads of its own: as the points of
// a shear test run.

#include "parallel/threads.h"
#include "support/bed.h"
#include "support/bits.h"

#define BEDS 4
#define WORKERS 2
#define THREADS 2
#define STEPS 1500

/** A job must not fail a test itself: that is the main thread's business. */
typedef struct bed_job {
    scene scene;
    bool advanced;
    clod_status status;
} bed_job;

static void advance(void *context, int number)
{
    bed_job *self = (bed_job *)context + number;
    self->advanced = clod_step_advance(&self->scene.step, STEPS, &self->status) &&
                     clod_step_export(&self->scene.step, &self->status);
}

/** Beds of two seeds, twice each, all begun but not yet advanced. */
static void begin(bed_job *beds, int threads)
{
    for (int k = 0; k < BEDS; k++) {
        beds[k].advanced = false;
        bed_init(&beds[k].scene, BED_DRUM, 1 + (uint64_t)k % 2);
        scene_start_with(&beds[k].scene, (clod_step_options){.threads = threads});
    }
}

/** A team that is not given falls back to one thread: each job must have had its own two. */
static void jobs_have_threads_and_bits_of_their_own(void **state)
{
    (void)state;
    static bed_job alone[BEDS], together[BEDS];
    begin(alone, 1);
    for (int k = 0; k < BEDS; k++) {
        advance(alone, k);
    }
    begin(together, THREADS);
    clod_threads_run(BEDS, WORKERS, advance, together);
    for (int k = 0; k < BEDS; k++) {
        assert_true(alone[k].advanced);
        assert_true(together[k].advanced);
        assert_int_equal(together[k].scene.step.threads, THREADS);
        check_same_bits(&alone[k].scene.state, &together[k].scene.state);
        // worth comparing: grains touch, and beds of two seeds differ
        assert_true(alone[k].scene.state.contact_count > 50);
        assert_false(bits_same_grains(&alone[k].scene.state.grains,
                                      &together[(k + 1) % BEDS].scene.state.grains));
    }
    for (int k = 0; k < BEDS; k++) {
        scene_end(&alone[k].scene);
        scene_end(&together[k].scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jobs_have_threads_and_bits_of_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
