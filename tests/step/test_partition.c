// The cut of a bed for ranks: everyone has his share, and knows whose grains matter to whom.
#include "step/partition.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/check.h"
#include "support/dice.h"

#define GRAINS 4000

static double place[GRAINS][3];

/** Grains in a bed of 1 x 2 x 0.5 m, most of them at one end. */
static void make_bed(void)
{
    dice roll = {5};
    for (int g = 0; g < GRAINS; g++) {
        const double x = dice_real(&roll, 0.0, 1.0);
        place[g][0] = x * x * x;
        place[g][1] = dice_real(&roll, 0.0, 2.0);
        place[g][2] = dice_real(&roll, 0.0, 0.5);
    }
}

static const double MIN[3] = {0.0, 0.0, 0.0}, MAX[3] = {1.0, 2.0, 0.5};

/** Cut a bed whose sides are `size` times as long, in a grid of that length. */
static void cut(clod_partition *self, int grains, const double size[3])
{
    double max[3];
    for (int a = 0; a < 3; a++) {
        max[a] = size[a] * MAX[a];
    }
    clod_partition_begin(self, MIN, max);
    for (int g = 0; g < grains; g++) {
        const double at[3] = {size[0] * place[g][0], size[1] * place[g][1],
                              size[2] * place[g][2]};
        clod_partition_add(self, at, 1.0);
    }
    clod_partition_cut(self);
    clod_partition_bound(self, MIN, max);
}

static clod_partition partition_of(int ranks, int grains)
{
    static const double SAME[3] = {1.0, 1.0, 1.0};
    clod_status status = {0};
    clod_partition self;
    assert_true(clod_partition_init(&self, ranks, &status));
    cut(&self, grains, SAME);
    return self;
}

static void every_rank_has_its_share(void **state)
{
    (void)state;
    static const int RANKS[] = {1, 2, 3, 4, 7, 16};
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        clod_partition self = partition_of(RANKS[k], GRAINS);
        int count[16] = {0};
        for (int g = 0; g < GRAINS; g++) {
            count[clod_partition_owner(&self, place[g])]++;
        }
        for (int r = 0; r < RANKS[k]; r++) {
            // of 4000 / 16 grains sqrt(250) are 6 %; they are denser on one side of a block
            check_relative((double)count[r], (double)GRAINS / RANKS[k], 0.15);
        }
        clod_partition_fini(&self);
    }
}

/** Grains that have another owner in a bed of about 2 x 2 x 2 m when it has become a little shorter
 *  along x and longer along y, which is its longest side now; `again`: in a partition of its own. */
static int moved_grains(bool again)
{
    static const double BEFORE[3] = {2.02, 1.0, 4.0}, AFTER[3] = {2.0, 1.02, 4.0};
    clod_partition self = partition_of(8, 0); // not cut, for lack of grains
    int owner[GRAINS], moved = 0;
    cut(&self, GRAINS, BEFORE);
    for (int g = 0; g < GRAINS; g++) {
        const double at[3] = {2.02 * place[g][0], place[g][1], 4.0 * place[g][2]};
        owner[g] = clod_partition_owner(&self, at);
    }
    if (again) {
        clod_partition_fini(&self);
        self = partition_of(8, 0);
    }
    cut(&self, GRAINS, AFTER);
    for (int g = 0; g < GRAINS; g++) {
        const double at[3] = {2.0 * place[g][0], 1.02 * place[g][1], 4.0 * place[g][2]};
        moved += clod_partition_owner(&self, at) != owner[g];
    }
    clod_partition_fini(&self);
    return moved;
}

static void few_grains_move_when_a_bed_is_cut_anew(void **state)
{
    (void)state;
    assert_true(moved_grains(false) < GRAINS / 50);
    assert_true(moved_grains(true) > GRAINS / 4); // along other axes
}

/** Bed of even weight, of 1 x 1.4 x 1.9 m, never cut before. By hand: across z, 1.9 m, then each half,
 *  1 x 1.4 x 0.95 m, across y. Along x a rank would have 5.0 m2 of surface, not 4.63. */
static void each_piece_of_a_first_cut_is_cut_across_its_longest_side(void **state)
{
    (void)state;
    static const double END[3] = {1.0, 1.4, 1.9};
    clod_partition self = partition_of(4, 0);
    clod_partition_begin(&self, MIN, END);
    const size_t blocks = clod_partition_blocks(&self);
    for (size_t b = 0; b < blocks; b++) {
        self.weight[b] = 1.0F;
    }
    clod_partition_cut(&self);
    static const clod_partition_plane EXPECTED[4] = {{0}, {1, 0.7}, {2, 0.95}, {1, 0.7}};
    for (int r = 1; r < 4; r++) {
        assert_int_equal(self.plane[r].axis, EXPECTED[r].axis);
        check_relative(self.plane[r].at, EXPECTED[r].at, 1e-12);
    }
    clod_partition_fini(&self);
}

/** Calls `look` for one place somewhere in each cell of a lattice within a cone, 1 m high and as wide at
 *  each side of its axis. */
static int heap(void (*look)(void *context, const double place[3]), void *context)
{
    enum { STEPS = 80 };
    dice roll = {7};
    int count = 0;
    for (int k = 0; k < STEPS; k++) {
        for (int j = -STEPS; j < STEPS; j++) {
            for (int i = -STEPS; i < STEPS; i++) {
                const double at[3] = {(i + dice_real(&roll, 0.0, 1.0)) / STEPS,
                                      (j + dice_real(&roll, 0.0, 1.0)) / STEPS,
                                      (k + dice_real(&roll, 0.0, 1.0)) / STEPS};
                if (hypot(at[0], at[1]) <= 1.0 - at[2]) {
                    look(context, at);
                    count++;
                }
            }
        }
    }
    return count;
}

static void weigh_place(void *context, const double at[3])
{
    clod_partition_add(context, at, 1.0);
}

#define MANY 4096 // ranks

typedef struct shares {
    const clod_partition *of;
    int count[MANY];
} shares;

static void count_place(void *context, const double at[3])
{
    shares *self = context;
    self->count[clod_partition_owner(self->of, at)]++;
}

/** A heap fills a quarter of its box, on slopes that cut through blocks. With 16 384 of them, four for each
 *  rank, one has 1.37 of its share. */
static void a_heap_is_cut_evenly_for_many_ranks(void **state)
{
    (void)state;
    static const double LOW[3] = {-1.0, -1.0, 0.0}, HIGH[3] = {1.0, 1.0, 1.0};
    static shares got;
    clod_status status = {0};
    clod_partition self;
    assert_true(clod_partition_init(&self, MANY, &status));
    clod_partition_begin(&self, LOW, HIGH);
    const int count = heap(weigh_place, &self);
    clod_partition_cut(&self);
    got.of = &self;
    heap(count_place, &got);
    int most = 0;
    for (int r = 0; r < MANY; r++) {
        most = got.count[r] > most ? got.count[r] : most;
    }
    assert_true((double)most * MANY / count < 1.25);
    clod_partition_fini(&self);
}

/** Grains of the lower half along y weigh three times as much: it needs three ranks of four. */
static void weights_are_shared_not_grains(void **state)
{
    (void)state;
    clod_partition self = partition_of(4, 0);
    clod_partition_begin(&self, MIN, MAX);
    for (int g = 0; g < GRAINS; g++) {
        clod_partition_add(&self, place[g], place[g][1] < 1.0 ? 3.0 : 1.0);
    }
    clod_partition_cut(&self);
    double weight[4] = {0.0};
    for (int g = 0; g < GRAINS; g++) {
        weight[clod_partition_owner(&self, place[g])] += place[g][1] < 1.0 ? 3.0 : 1.0;
    }
    for (int r = 0; r < 4; r++) {
        check_relative(weight[r], 2.0 * GRAINS / 4.0, 0.05);
    }
    clod_partition_fini(&self);
}

/** Distance along one axis from a place to an interval, with images a period away; by hand. */
static double distance(double x, double low, double high, double period)
{
    double least = INFINITY;
    for (int image = -1; image <= 1; image++) {
        const double at = x + image * period;
        least = fmin(least, fmax(fmax(low - at, at - high), 0.0));
    }
    return least;
}

/** Box of a rank: what is on its side of all planes that divide it from others. */
static void box_of(const clod_partition *self, int rank, double low[3], double high[3])
{
    memcpy(low, MIN, sizeof MIN);
    memcpy(high, MAX, sizeof MAX);
    for (int first = 0, last = self->ranks; last - first > 1;) {
        const int middle = first + (last - first) / 2, axis = self->plane[middle].axis;
        if (rank < middle) {
            high[axis] = fmin(high[axis], self->plane[middle].at);
            last = middle;
        } else {
            low[axis] = fmax(low[axis], self->plane[middle].at);
            first = middle;
        }
    }
}

/** Whether a place is within `reach` of a box of a rank, by hand. */
static bool is_reached(const clod_partition *self, const clod_domain *domain, int rank,
                       const double at[3], double reach)
{
    double low[3], high[3];
    bool reached = true;
    box_of(self, rank, low, high);
    for (int a = 0; a < 3; a++) {
        const double period = domain->periodic[a] ? domain->max[a] : 1e9;
        reached = reached && distance(at[a], low[a], high[a], period) <= reach;
    }
    return reached;
}

static void what_is_near_a_box_reaches_it(void **state)
{
    (void)state;
    static const int RANKS[] = {1, 2, 3, 7, 16};
    const clod_domain domain = {.max = {1.0, 2.0, 0.5}, .periodic = {true, true, false}};
    const double reach = 0.06;
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        clod_partition self = partition_of(RANKS[k], GRAINS);
        int all = 0;
        for (int g = 0; g < GRAINS; g++) {
            int rank[16];
            const int count = clod_partition_reach(&self, &domain, place[g], reach, rank);
            int next = 0;
            bool owned = false;
            for (int r = 0; r < RANKS[k]; r++) {
                if (is_reached(&self, &domain, r, place[g], reach)) {
                    assert_true(next < count);
                    assert_int_equal(rank[next++], r);
                    owned = owned || clod_partition_owner(&self, place[g]) == r;
                }
            }
            assert_int_equal(next, count);
            assert_true(owned);
            all += count;
        }
        assert_true(all <= 4 * GRAINS && (RANKS[k] == 1 || all > GRAINS + 100));
        clod_partition_fini(&self);
    }
}

static void nothing_reaches_a_bed_without_grains(void **state)
{
    (void)state;
    const clod_domain domain = {.max = {1.0, 2.0, 0.5}, .periodic = {true, true, false}};
    const double none[3] = {INFINITY, INFINITY, INFINITY};
    const double neither[3] = {-INFINITY, -INFINITY, -INFINITY};
    clod_partition self = partition_of(7, GRAINS);
    int rank[7];
    clod_partition_bound(&self, none, neither);
    assert_int_equal(clod_partition_reach(&self, &domain, place[0], 0.06, rank), 0);
    clod_partition_fini(&self);
}

static void grains_that_lie_apart_have_two_ranks(void **state)
{
    (void)state;
    const clod_domain domain = {.max = {1.0, 2.0, 0.5}};
    clod_partition self = partition_of(16, 2);
    for (int g = 0; g < 2; g++) {
        int rank[16];
        const int owner = clod_partition_owner(&self, place[g]);
        const int count = clod_partition_reach(&self, &domain, place[g], 1e-9, rank);
        bool found = false;
        for (int k = 0; k < count; k++) {
            found = found || rank[k] == owner;
        }
        assert_true(found);
    }
    assert_true(clod_partition_owner(&self, place[0]) != clod_partition_owner(&self, place[1]));
    clod_partition_fini(&self);
}

/** Ranks with 2^30 grains each in one block of the lower half, and as many in the upper one: as
 *  if 8 of them had told their numbers. */
static void blocks_of_more_grains_than_an_int_counts_are_cut(void **state)
{
    (void)state;
    clod_partition self = partition_of(2, 0);
    const size_t blocks = clod_partition_blocks(&self);
    float *other = calloc(blocks, sizeof *other);
    other[0] = other[blocks - 1] = 0x1p30F;
    for (int r = 0; r < 8; r++) {
        clod_partition_merge(self.weight, other, blocks);
    }
    assert_true(self.weight[0] == 0x1p33F);
    clod_partition_cut(&self);
    const double low[3] = {0.0, 0.0, 0.0}, high[3] = {1.0, 2.0, 0.5};
    assert_int_equal(clod_partition_owner(&self, low), 0);
    assert_int_equal(clod_partition_owner(&self, high), 1);
    free(other);
    clod_partition_fini(&self);
}

int main(void)
{
    make_bed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_rank_has_its_share),
        cmocka_unit_test(few_grains_move_when_a_bed_is_cut_anew),
        cmocka_unit_test(each_piece_of_a_first_cut_is_cut_across_its_longest_side),
        cmocka_unit_test(a_heap_is_cut_evenly_for_many_ranks),
        cmocka_unit_test(weights_are_shared_not_grains),
        cmocka_unit_test(what_is_near_a_box_reaches_it),
        cmocka_unit_test(nothing_reaches_a_bed_without_grains),
        cmocka_unit_test(grains_that_lie_apart_have_two_ranks),
        cmocka_unit_test(blocks_of_more_grains_than_an_int_counts_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
