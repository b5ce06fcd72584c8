// Wall contacts go through passes (src/step/kernel_batch.h); here each set's passes against the
// law in one piece, clod_law_contact, contact by contact and bit by bit.

#include "geometry/wall_rows.h"
#include "law/law_contact.h"
#include "step/kernel.h"
#include "support/bed.h"

#define CONTACTS 33 ///< a whole batch and one more
#define BLOCKS ((CONTACTS + CLOD_LANES - 1) / CLOD_LANES)
#define ROWS (BLOCKS * CLOD_LANES)
#define RADIUS 3e-3
#define DT 1e-6
#define ROUNDS 40

/** Grains beside a plane at z = 0 about which they come and go; row 0 of all is the plane's. */
typedef struct bench {
    _Alignas(64) double place[ROWS][4];
    _Alignas(64) double motion[ROWS][4];
    _Alignas(64) double turning[ROWS][4];
    _Alignas(64) double load[ROWS][8];
    clod_fixed sum[ROWS];
    _Alignas(64) double shape[CLOD_SHAPE_ROWS][4];
    _Alignas(64) clod_wall_block block[BLOCKS];
    clod_history expected[BLOCKS];
    clod_kernel_view view;
} bench;

static void bench_init(bench *self, dice *roll)
{
    *self = (bench){.shape = {{0.0, 0.0, 0.0, CLOD_WALL_PLANE}, {1.0}, {0.0, 0.0, 1.0, 0.0}}};
    for (int g = 0; g < ROWS; g++) {
        const double mass = dice_real(roll, 1e-4, 3e-4);
        self->place[g][3] = RADIUS;
        self->motion[g][3] = mass;
        self->turning[g][3] = 1.0 / (0.4 * mass * RADIUS * RADIUS);
        clod_wall_block *block = &self->block[g / CLOD_LANES];
        block->i[g % CLOD_LANES] = g;
        block->sum[g % CLOD_LANES] = g; // a sum for each contact
    }
    self->view = (clod_kernel_view){.overlap_limit = CLOD_STEP_OVERLAP,
                                    .position = (const double(*)[4])self->place,
                                    .velocity = (const double(*)[4])self->motion,
                                    .angular_velocity = (const double(*)[4])self->turning,
                                    .load = self->load,
                                    .wall_sum = self->sum,
                                    .shape = (const double(*)[4])self->shape,
                                    .dt = DT};
}

/** Grains anywhere near the plane, open or closed, with any motion. */
static void stir(bench *self, dice *roll)
{
    for (int g = 0; g < ROWS; g++) {
        self->place[g][0] = dice_real(roll, -0.1, 0.1);
        self->place[g][1] = dice_real(roll, -0.1, 0.1);
        self->place[g][2] = RADIUS - dice_real(roll, -1e-5, 5e-5);
        for (int a = 0; a < 3; a++) {
            self->motion[g][a] = dice_real(roll, -0.5, 0.5);
            self->turning[g][a] = dice_real(roll, -50.0, 50.0);
        }
    }
    memset(self->load, 0, sizeof self->load);
    memset(self->sum, 0, sizeof self->sum);
}

/** The motion of a grain against the plane at rest. */
static clod_law_motion motion_of(const bench *self, int g)
{
    const double *p = self->place[g], *v = self->motion[g], *w = self->turning[g];
    return (clod_law_motion){.overlap = p[3] - p[2],
                             .normal = {0.0, 0.0, 1.0},
                             .velocity = {v[0], v[1], v[2]},
                             .spin_i = {w[0], w[1], w[2]},
                             .spin_j = {0.0, 0.0, 0.0},
                             .arm_i = p[2],
                             .arm_j = 0.0,
                             .m_star = v[3],
                             .r_star = p[3],
                             .roll_inertia = 1.0 / w[3] + v[3] * p[3] * p[3]};
}

/** One contact by the law in one piece, against what the passes have left. */
static int check_contact(bench *self, const clod_law *law, int g)
{
    clod_history *history = &self->expected[g / CLOD_LANES];
    const int lane = g % CLOD_LANES;
    const clod_law_motion motion = motion_of(self, g);
    clod_law_memory memory = clod_law_memory_load(history, lane);
    const clod_law_result r = clod_law_contact(law, &motion, DT, &memory);
    clod_law_memory_store(history, lane, r.closed, memory);
    const vreal3 turn = vreal3_axpy(r.roll, -motion.arm_i, r.lever);
    const double load[8] = {r.force.x, r.force.y, r.force.z, 0.0, turn.x, turn.y, turn.z, 0.0};
    for (int c = 0; c < 8; c++) {
        assert_true(self->load[g][c] == load[c]);
    }
    double wall_sum[CLOD_FIXED_COLUMNS];
    clod_fixed_value(&self->sum[g], wall_sum);
    check_close(wall_sum[CLOD_WALL_SUM_FORCE], -r.force.x, 0x1p-81);
    check_close(wall_sum[CLOD_WALL_SUM_FORCE + 1], -r.force.y, 0x1p-81);
    check_close(wall_sum[CLOD_WALL_SUM_FORCE + 2], -r.force.z, 0x1p-81);
    assert_true(wall_sum[CLOD_WALL_SUM_BELT_POWER] == 0.0); // the plane is at rest
    const clod_history *got = &self->block[g / CLOD_LANES].history;
    assert_true(got->plastic[lane] == history->plastic[lane]);
    assert_true(got->tangent[lane] == history->tangent[lane]);
    for (int a = 0; a < 3; a++) {
        assert_true(got->spring[a][lane] == history->spring[a][lane]);
        assert_true(got->roll[a][lane] == history->roll[a][lane]);
    }
    return motion.overlap > 0.0;
}

static void wall_passes_are_the_law(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    scene laws;
    const clod_case_contact ore = contact_ore();
    scene_init(&laws, DT, &ore);
    bed_laws(&laws); // six laws, one of them known to the kernels
    for (int k = 0; k < 4 * SCENE_LAWS; k++) {
        const clod_kernel *kernel = clod_kernel_choose(SETS[k / SCENE_LAWS]);
        const clod_law *law = &laws.law[k % SCENE_LAWS];
        if (kernel == NULL) {
            continue;
        }
        dice roll = {5};
        static bench b;
        bench_init(&b, &roll);
        int closed = 0;
        for (int round = 0; round < ROUNDS; round++) {
            stir(&b, &roll);
            assert_false(kernel->wall(&b.view, law, CLOD_FORM_PLANE, b.block, NULL, CONTACTS));
            for (int g = 0; g < CONTACTS; g++) {
                closed += check_contact(&b, law, g);
            }
        }
        assert_in_range(closed, CONTACTS * ROUNDS / 2, CONTACTS * ROUNDS * 19 / 20); // both
    }
    scene_end(&laws);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wall_passes_are_the_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
