// Measures of a silo, on one that follows Janssen's law to the letter: weight w a metre, height
// h, stress ratio K, wall friction mu, so that lambda = D/(4 mu K).

#include "support/check.h"
#include "verify/saturation.h"
#include "verify/silo.h"

#define SHELLS CLOD_VERIFY_SILO_SHELLS
#define SHELL CLOD_VERIFY_SILO_SHELL
#define W 40.0   ///< N/m
#define K 0.5    ///< stress ratio
#define MU 0.4   ///< wall friction
#define H 0.4125 ///< m: the top shell is filled to 3/4

static const double LAMBDA = CLOD_VERIFY_SILO_DIAMETER / (4.0 * MU * K);

/** W lambda (1 - exp(-depth/lambda)), what stands on a layer [N]. */
static double stands_at(double height)
{
    return W * LAMBDA * (1.0 - exp(-(H - height) / LAMBDA));
}

static clod_verify_silo made_up(void)
{
    clod_verify_silo silo = {.weight = W * H, .floor = stands_at(0.0)};
    for (int s = 0; s < SHELLS; s++) {
        const double top = fmin((s + 1) * SHELL, H);
        silo.above[s] = W * (H - s * SHELL);
        silo.shear[s] = stands_at(top) + W * (top - s * SHELL) - stands_at(s * SHELL);
        silo.normal[s] = silo.shear[s] / MU;
    }
    return silo;
}

static void measures_find_what_the_silo_was_made_with(void **state)
{
    (void)state;
    const clod_verify_silo silo = made_up();
    check_relative(clod_verify_silo_carried(&silo), W * H, 1e-13);
    check_relative(clod_verify_silo_wall_friction(&silo), MU, 1e-13);
    check_relative(clod_verify_silo_line_weight(&silo), W, 1e-13);
    // the mean over a shell stands for its middle: off by (SHELL/lambda)^2/24 of the gradient
    check_relative(clod_verify_silo_stress_ratio(&silo), K, 2e-3);
    const double middle = 4.5 * SHELL;
    check_relative(clod_verify_silo_stands_on(&silo, 4), stands_at(middle), 2e-3);
}

/** The top shell has less than 1/14 of the weight: 13 joints, the last one the floor. */
static void joints_lie_on_the_law(void **state)
{
    (void)state;
    const clod_verify_silo silo = made_up();
    const clod_verify_silo_profile joints = clod_verify_silo_joints(&silo);
    assert_int_equal(joints.count, SHELLS - 1);
    for (size_t j = 0; j < joints.count; j++) {
        const double height = ((double)SHELLS - 2.0 - (double)j) * SHELL;
        check_relative(joints.filled[j], W * (H - height), 1e-13);
        check_relative(joints.apparent[j], stands_at(height), 1e-12);
    }
    check_relative(clod_verify_saturation_fit(joints.filled, joints.apparent, joints.count),
                   W * LAMBDA, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(measures_find_what_the_silo_was_made_with),
        cmocka_unit_test(joints_lie_on_the_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
