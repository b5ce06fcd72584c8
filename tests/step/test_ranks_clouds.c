// Random clouds of grains have the bits of one process on any number of ranks: few grains and many
// ranks, sizes 1:10, boxes that are hardly wider than a grain reaches, any sides periodic.
#include "step/crew.h"

#include "support/bits.h"
#include "support/dice.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"
#include "support/scene.h"

#define LEAST 1e-3 ///< m, radius of the smallest grain; the largest has ten times as much

/** A cloud, and the rank that steps it. */
typedef struct cloud {
    uint64_t seed;
    int grains; ///< that it has at most
    bool periodic[3];
    double size[3]; ///< m
    bool floor;
    int steps;
    clod_step_options options;
    scene *into; ///< of rank 0
} cloud;

/** Distance of two places by their nearest images [m]. */
static double distance(const cloud *self, const double *p, const double *q)
{
    double sum = 0.0;
    for (int a = 0; a < 3; a++) {
        double along = fabs(p[a] - q[a]);
        along = self->periodic[a] ? fmin(along, self->size[a] - along) : along;
        sum += along * along;
    }
    return sqrt(sum);
}

static bool is_free(const cloud *self, const scene *s, const double place[4])
{
    bool free = true;
    for (size_t g = 0; g < s->state.grains.count; g++) {
        const double *p = s->state.grains.position[g];
        free = free && distance(self, p, place) > p[3] + place[3];
    }
    return free;
}

/** Where it still has room, large grains first; they fly together. */
static void fill(const cloud *self, scene *s)
{
    dice roll = {self->seed};
    for (int k = 0; k < 30 * self->grains; k++) {
        const double share = (double)(k / 30) / self->grains;
        double place[4] = {0.0, 0.0, 0.0, 10.0 * LEAST * pow(0.1, share)};
        for (int a = 0; a < 3; a++) {
            place[a] = dice_real(&roll, 0.0, self->size[a]);
        }
        if ((self->floor && place[2] < place[3]) || !is_free(self, s, place) ||
            (int)s->state.grains.count > k / 30) {
            continue;
        }
        const size_t g = scene_grain(s, place[0], place[1], place[2], place[3]);
        s->state.grains.id[g] += self->seed % 2 * 5000000000u; // beyond 2^32
        double v[3];
        for (int a = 0; a < 3; a++) {
            v[a] = 15.0 * (0.5 - place[a] / self->size[a]) + dice_real(&roll, -3.0, 3.0);
        }
        scene_move(s, g, v[0], v[1], v[2]);
        scene_turn(s, g, dice_real(&roll, -99.0, 99.0), 0.0, dice_real(&roll, -99.0, 99.0));
    }
}

static void run_cloud(scene *s, const cloud *how)
{
    clod_case_contact ore = contact_ore();
    clod_status status = {0};
    ore.k1 = 1e7;
    ore.k2 = 4e7;
    ore.k_adh = 8e6;
    ore.restitution = 0.5;
    scene_init(s, 2e-6, &ore);
    for (int a = 0; a < 3; a++) {
        s->state.domain.periodic[a] = how->periodic[a];
        if (how->periodic[a]) {
            s->state.domain.min[a] = 0.0;
            s->state.domain.max[a] = how->size[a];
        }
    }
    if (how->floor) {
        scene_wall(s, "floor", shape_floor(0.0));
    }
    if (!clod_grains_reserve(&s->state.grains, 0, &status)) { // there may be none
        fail_msg("%s", status.text);
    }
    fill(how, s);
    scene_start_with(s, how->options);
    scene_run(s, how->steps / 2);
    if (!clod_step_see(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
    scene_run(s, how->steps - how->steps / 2);
    if (!clod_step_export(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static void run_rank(clod_ranks *ranks, void *context)
{
    cloud how = *(const cloud *)context;
    if (ranks->rank == 0) {
        how.options.ranks = ranks;
        run_cloud(how.into, &how);
        clod_crew_end(&how.into->step.crew);
        clod_crew_dismiss(ranks);
    } else {
        clod_crew_serve(ranks);
    }
}

/** What clouds met, so that a test knows that it tried something. */
typedef struct met {
    size_t grains, contacts;
    int64_t rebuilds;
} met;

static void compare(cloud how, int ranks, met *all)
{
    scene one, several;
    how.options.threads = 1;
    how.options.overlap_limit = 0.9; // some are squeezed
    run_cloud(&one, &how);
    how.into = &several;
    ranks_run(ranks, run_rank, &how);
    if (several.step.rebuilds != one.step.rebuilds) {
        fail_msg("cloud %d on %d ranks", (int)how.seed, ranks);
    }
    check_same_bits(&one.state, &several.state);
    all->grains += one.state.grains.count;
    all->contacts += one.state.contact_count;
    all->rebuilds += one.step.rebuilds;
    scene_end(&several);
    scene_end(&one);
}

/** A cloud of the dice. */
static cloud random_cloud(uint64_t seed)
{
    static const int GRAINS[] = {1, 2, 3, 8, 30, 70};
    dice roll = {seed};
    cloud how = {.seed = seed, .grains = GRAINS[dice_pick(&roll, 6)], .steps = 500};
    for (int a = 0; a < 3; a++) {
        how.periodic[a] = dice_pick(&roll, 2) == 0;
        how.size[a] = dice_real(&roll, 0.047, 0.09); // a period is 46 mm at least
    }
    how.floor = !how.periodic[2];
    return how;
}

static void random_clouds_have_the_bits_of_one_rank(void **state)
{
    (void)state;
    met all = {0};
    const uint64_t clouds = sanitized() ? 6 : 30;
    for (uint64_t seed = 1; seed <= clouds; seed++) {
        dice roll = {1000 + seed};
        compare(random_cloud(seed), 2 + dice_pick(&roll, 15), &all);
    }
    assert_true(all.grains > 10 * clouds);
    assert_true(all.contacts > clouds);
    assert_true(all.rebuilds >= 2 * (int64_t)clouds);
}

/** Each of 16 boxes is a fraction of what the largest grain reaches. */
static void sixteen_ranks_thinner_than_a_grain_reaches(void **state)
{
    (void)state;
    met all = {0};
    compare((cloud){.seed = 3,
                    .grains = 60,
                    .periodic = {true, true, true},
                    .size = {0.05, 0.048, 0.047},
                    .steps = 500},
            16, &all);
    assert_true(all.grains > 40 && all.contacts > 40);
    compare((cloud){.seed = 4, .grains = 60, .size = {0.02, 0.02, 0.4}, .steps = 500}, 16,
            &all);
}

/** Grains about the corner of a periodic box, where each meets images across all three sides. */
static void grains_in_a_periodic_corner(void **state)
{
    (void)state;
    met all = {0};
    for (int ranks = 2; ranks <= 8; ranks *= 2) {
        compare((cloud){.seed = 5,
                        .grains = 8,
                        .periodic = {true, true, true},
                        .size = {0.047, 0.047, 0.047},
                        .steps = 500},
                ranks, &all);
    }
    assert_true(all.contacts >= 3);
}

static void one_grain_on_sixteen_ranks(void **state)
{
    (void)state;
    met all = {0};
    cloud how = {
        .seed = 6, .grains = 1, .size = {0.02, 0.02, 0.022}, .floor = true, .steps = 900};
    compare(how, 16, &all);
    how.grains = 0; // and none at all
    compare(how, 16, &all);
    assert_int_equal(all.grains, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_clouds_have_the_bits_of_one_rank),
        cmocka_unit_test(sixteen_ranks_thinner_than_a_grain_reaches),
        cmocka_unit_test(grains_in_a_periodic_corner),
        cmocka_unit_test(one_grain_on_sixteen_ranks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
