// A rank that has no grain any more, and gets some again, has the bits of one process.
#include "step/crew_part.h"

#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

#define LOOKS 100
#define STEPS 20 ///< between two looks

/** A flock, and the rank that steps it. */
typedef struct flock {
    clod_step_options options;
    scene *into; ///< of rank 0
    int fewest[RANKS_MOST],
        again[RANKS_MOST]; ///< own grains of a rank: least, and most after that
} flock;

/** Grains close together fly round a periodic box, and knock against each other. */
static void make_flock(scene *s)
{
    const clod_case_contact ore = contact_ore();
    dice roll = {5};
    scene_init(s, 1e-5, &ore);
    s->state.domain.periodic[0] = true;
    s->state.domain.min[0] = -0.06;
    s->state.domain.max[0] = 0.06;
    for (int k = 0; k < 5 * 4 * 4; k++) {
        const size_t g = scene_grain(s, 0.0062 * (k % 5), 0.0062 * (k / 5 % 4),
                                     0.0062 * (k / 20), dice_real(&roll, 2.6e-3, 3.1e-3));
        scene_move(s, g, 10.0 + dice_real(&roll, -0.5, 0.5), dice_real(&roll, -0.5, 0.5),
                   dice_real(&roll, -0.5, 0.5));
    }
}

/** How many grains each rank has had since the last rebuild. */
static void count_own(flock *self, int ranks)
{
    clod_status status = {0};
    scene *s = self->into;
    int count[RANKS_MOST] = {0};
    assert_true(clod_step_see(&s->step, &status));
    for (size_t g = 0; g < s->state.grains.count; g++) {
        count[clod_partition_owner(&s->step.crew->spread.partition,
                                   s->state.build_position[g])]++;
    }
    for (int r = 0; r < ranks; r++) {
        self->again[r] = count[r] > self->again[r] ? count[r] : self->again[r];
        if (count[r] < self->fewest[r]) {
            self->fewest[r] = count[r];
            self->again[r] = 0;
        }
    }
}

static void fly(flock *self, int ranks)
{
    scene *s = self->into;
    make_flock(s);
    scene_start_with(s, self->options);
    for (int k = 0; k < LOOKS; k++) {
        scene_run(s, STEPS);
        if (ranks > 1) {
            count_own(self, ranks);
        }
    }
    assert_true(clod_step_export(&s->step, &(clod_status){0}));
}

static void fly_rank(clod_ranks *ranks, void *context)
{
    flock *self = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    self->options.ranks = ranks;
    fly(self, ranks->size);
    clod_crew_end(&self->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** The planes stay where they were at first, and the flock flies past each of them. */
static void ranks_that_become_empty_fill_again(void **state)
{
    (void)state;
    static const int RANKS[] = {2, 3, 4, 7};
    scene one;
    flock alone = {.options = {.threads = 1}, .into = &one};
    fly(&alone, 1);
    assert_true(one.state.contact_count > 10);
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k += sanitized() ? 2 : 1) {
        scene several;
        flock how = {.options = {.threads = 1, .balance.threshold = 1e9}, .into = &several};
        for (int r = 0; r < RANKS[k]; r++) {
            how.fewest[r] = (int)one.state.grains.count;
        }
        ranks_run(RANKS[k], fly_rank, &how);
        for (int r = 0; r < RANKS[k]; r++) {
            assert_int_equal(how.fewest[r], 0);
            assert_true(how.again[r] > 0);
        }
        check_same_bits(&one.state, &several.state);
        scene_end(&several);
    }
    scene_end(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranks_that_become_empty_fill_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
