// Which pairs can touch while a near list holds, by every instruction set, against the nearest of
// the two ends of the time and the place where the courses are nearest, in plain C.

#include <math.h>

#include "step/kernel.h"
#include "support/check.h"
#include "support/dice.h"

enum { ROWS = 40, PAIRS = 64, ROUNDS = 400 };
static const double PERIOD = 0.02; // m, along y

/** Grains of up to 1 mm in a box of 6 mm by 20 mm by 6 mm, at up to 2 m/s, and what the kernel reads of them. */
typedef struct cloud {
    _Alignas(64) double position[ROWS][4];
    float course[ROWS][4];
    int32_t i[PAIRS], j[PAIRS];
    clod_kernel_courses courses;
} cloud;

static void make_cloud(cloud *self, dice *roll, double horizon)
{
    for (int g = 0; g < ROWS; g++) {
        const bool stays = g % 5 == 0;
        for (int a = 0; a < 3; a++) {
            self->position[g][a] = dice_real(roll, 0.0, a == 1 ? PERIOD : 0.006);
            self->course[g][a] = stays ? 0.0F : (float)dice_real(roll, -1.0, 1.0);
        }
        self->position[g][3] = dice_real(roll, 0.5e-3, 1e-3);
        self->course[g][3] = (float)dice_real(roll, 0.0, 1e-3);
    }
    for (int k = 0; k < PAIRS; k++) {
        self->i[k] = dice_pick(roll, ROWS);
        self->j[k] = dice_pick(roll, ROWS);
    }
    self->courses = (clod_kernel_courses){.position = (const double(*)[4])self->position,
                                          .course = (const float(*)[4])self->course,
                                          .horizon = horizon,
                                          .period = {0.0, PERIOD, 0.0},
                                          .inverse_period = {0.0, 1.0 / PERIOD, 0.0}};
}

/** Distance of two grains after a time, with the image that was nearest before it [m]. */
static double distance_at(const cloud *self, int i, int j, double time)
{
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        double s = self->position[i][a] - self->position[j][a];
        if (a == 1) {
            s = fmin(fabs(s), PERIOD - fabs(s)) == fabs(s) ? s : s - copysign(PERIOD, s);
        }
        s += time * ((double)self->course[i][a] - (double)self->course[j][a]);
        square += s * s;
    }
    return sqrt(square);
}

/** Least distance until the list ends, less radii and skins [m]: a parabola's, by thirds. */
static double gap_of(const cloud *self, int i, int j)
{
    double low = 0.0, high = self->courses.horizon;
    for (int k = 0; k < 200; k++) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        if (distance_at(self, i, j, a) < distance_at(self, i, j, b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return distance_at(self, i, j, 0.5 * (low + high)) - self->position[i][3] -
           self->position[j][3] - (double)self->course[i][3] - (double)self->course[j][3];
}

static void check_cloud(const cloud *self, const clod_kernel *kernel, size_t count, int seen[2])
{
    const uint64_t bits = kernel->can_touch(&self->courses, self->i, self->j, count);
    const uint64_t scalar =
        clod_kernel_choose("scalar")->can_touch(&self->courses, self->i, self->j, count);
    assert_true(bits == scalar); // where rounding decides, too
    for (size_t k = 0; k < PAIRS; k++) {
        const double gap = gap_of(self, self->i[k], self->j[k]);
        const bool can = bits >> k & 1;
        if (k >= count) {
            assert_false(can);
        } else if (fabs(gap) > 1e-9) {
            assert_true(can == (gap < 0.0));
            seen[can]++;
        }
    }
}

static void every_set_finds_them(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    static cloud some;
    for (size_t set = 0; set < sizeof SETS / sizeof *SETS; set++) {
        const clod_kernel *kernel = clod_kernel_choose(SETS[set]);
        dice roll = {7};
        int seen[2] = {0, 0};
        for (int round = 0; kernel != NULL && round < ROUNDS; round++) {
            make_cloud(&some, &roll, round % 4 == 0 ? 0.0 : dice_real(&roll, 1e-4, 1e-2));
            check_cloud(&some, kernel, (size_t)(round % (PAIRS + 1)), seen);
        }
        assert_true(kernel == NULL || (seen[0] > 1000 && seen[1] > 1000));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_set_finds_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
