// A spring carried into today's tangent plane: its length, where the series of the root is good
// and where it is not, and contacts whose springs and forces are next to nothing.

#include "support/dice.h"
#include "support/law_probe.h"

#include "base/vec3.h"

#define DEGREE (M_PI / 180.0)

static clod_vec3 any_direction(dice *roll)
{
    double a[3];
    dice_direction(roll, a);
    return (clod_vec3){a[0], a[1], a[2]};
}

static vreal3 real3(clod_vec3 a)
{
    return (vreal3){a.x, a.y, a.z};
}

static double length3(vreal3 a)
{
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

/** Tilt the tangent plane and turn the pair about its normal [rad]; the spring after. */
static vreal3 carry(vreal3 spring, clod_vec3 normal, clod_vec3 axis, double tilt, double turn)
{
    const clod_law_frame frame = {real3(clod_vec3_rotate(normal, axis, tilt)), turn};
    const vreal3 turned = clod_law_spring_turn(&frame, spring);
    const vreal3 after = clod_law_spring_restore(turned, vreal3_dot(spring, spring),
                                                 1.0 / clod_law_spring_square(turned), 1.0);
    check_close(vreal3_dot(after, frame.normal), 0.0, 4e-16 * length3(spring));
    return after;
}

/** Worst relative change of length when the plane tilts and turns by at most so much [rad]. */
static double worst_length(double angle)
{
    dice roll = {11};
    double worst = 0.0;
    for (int k = 0; k < 20000; k++) {
        const clod_vec3 n = any_direction(&roll);
        const clod_vec3 axis = clod_vec3_unit(clod_vec3_cross(n, any_direction(&roll)));
        clod_vec3 s = clod_vec3_unit(clod_vec3_cross(n, any_direction(&roll)));
        if (k % 2 == 0) { // across the axis: the tilt shortens all of it
            s = clod_vec3_cross(axis, n);
        }
        const double length = pow(10.0, dice_real(&roll, -30.0, -3.0));
        const double tilt = k % 3 == 0   ? 0.0
                            : k % 5 == 0 ? angle
                                         : angle * dice_real(&roll, -1, 1);
        const double turn = k % 3 == 1   ? 0.0
                            : k % 5 == 0 ? angle
                                         : angle * dice_real(&roll, -1, 1);
        const vreal3 spring = real3(clod_vec3_scale(s, length));
        const vreal3 after = carry(spring, n, axis, tilt, turn);
        worst = fmax(worst, fabs(length3(after) / length3(spring) - 1.0));
    }
    return worst;
}

/**
 * Expected: no change. What the series leaves out is 7/256 e^5, with e = tan^2 of the tilt:
 * 7.4e-17 for 2 degrees, 8e-10 for 10; beside it some ten roundings.
 */
static void a_turned_spring_keeps_its_length(void **state)
{
    (void)state;
    check_at_most(worst_length(2.0 * DEGREE), 1.2e-15);
    check_at_most(worst_length(10.0 * DEGREE), 1e-9);
}

/** e stops at 1: 1 + 1/2 - 1/8 + 1/16 - 5/128 = 1.3984375 of the projection cos(tilt). */
static void beyond_45_degrees_a_spring_stays_shortened(void **state)
{
    (void)state;
    const clod_vec3 n = {0.0, 0.0, 1.0}, axis = {0.0, 1.0, 0.0};
    const vreal3 spring = {3e-6, 0.0, 0.0};
    for (int degrees = 46; degrees < 90; degrees++) {
        const double tilt = degrees * DEGREE;
        const vreal3 after = carry(spring, n, axis, tilt, 0.0);
        check_relative(length3(after), 3e-6 * 1.3984375 * cos(tilt), 1e-12);
        check_at_most(length3(after), 0.98 * 3e-6);
    }
}

/** A tilt alone, of any size, never makes a spring longer: the series ends below its root. */
static void no_tilt_makes_a_spring_longer(void **state)
{
    (void)state;
    const clod_vec3 n = {0.0, 0.0, 1.0}, axis = {0.0, 1.0, 0.0};
    for (int k = 0; k <= 900; k++) {
        const vreal3 after = carry((vreal3){3e-6, 0.0, 0.0}, n, axis, 0.1 * k * DEGREE, 0.0);
        check_at_most(length3(after), 3e-6 * (1.0 + 1e-15));
    }
}

static void check_finite(const law_probe *probe, clod_law_result r)
{
    const double all[] = {r.force.x,
                          r.force.y,
                          r.force.z,
                          r.lever.x,
                          r.lever.y,
                          r.lever.z,
                          r.roll.x,
                          r.roll.y,
                          r.roll.z,
                          probe->history.plastic[0],
                          probe->history.tangent[0]};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        assert_true(isfinite(all[k]));
    }
    for (int c = 0; c < 3; c++) {
        assert_true(isfinite(probe->history.spring[c][0]));
        assert_true(isfinite(probe->history.roll[c][0]));
    }
}

static clod_case_contact any_contact(dice *roll)
{
    clod_case_contact contact = contact_ore();
    contact.rolling = dice_pick(roll, 4);
    contact.rolling_damping = 0.3;
    contact.coulomb = dice_pick(roll, 3);
    contact.restitution = dice_pick(roll, 2) == 0 ? 1.0 : 0.3;
    contact.exponent = dice_pick(roll, 2) == 0 ? 1.0 : 1.5;
    contact.tangential =
        dice_pick(roll, 4) == 0 ? CLOD_TANGENTIAL_LITERAL : CLOD_TANGENTIAL_TANGENT;
    return contact;
}

/** Springs, speeds and overlaps of nothing or next to it, with limits or without. */
static void next_to_nothing_is_finite(void **state)
{
    (void)state;
    static const double SMALL[] = {0.0, 1e-50, 1e-40, 1e-160, 1e-310, 4.94e-324, 1e-6};
    static const double OVERLAP[] = {0.0, 4.3e-19, 1e-12, 3e-6};
    static const double FRICTION[] = {0.0, 1e-300, 1e-30, 0.35};
    dice roll = {12};
    for (int k = 0; k < 40000; k++) {
        clod_case_contact contact = any_contact(&roll);
        contact.friction = FRICTION[dice_pick(&roll, 4)];
        contact.rolling_friction = FRICTION[dice_pick(&roll, 4)];
        law_probe probe = probe_make(&contact);
        probe.history.tangent[0] = dice_pick(&roll, 2) == 0 ? 0.0 : 1e6;
        for (int c = 1; c < 3; c++) {
            probe.history.spring[c][0] = SMALL[dice_pick(&roll, 7)];
            probe.history.roll[c][0] = SMALL[dice_pick(&roll, 7)];
        }
        clod_law_motion m = probe_motion(OVERLAP[dice_pick(&roll, 4)]);
        m.velocity.y = SMALL[dice_pick(&roll, 7)];
        m.spin_i.z = SMALL[dice_pick(&roll, 7)];
        m.spin_j.x = SMALL[dice_pick(&roll, 7)];
        for (int s = 0; s < 3; s++) {
            check_finite(&probe, probe_step(&probe, &m, 1e-6));
        }
    }
}

/** Limits of zero leave no friction and no rolling resistance: less than the root of 1e-80. */
static void without_friction_no_force_is_left(void **state)
{
    (void)state;
    dice roll = {13};
    for (int k = 0; k < 5000; k++) {
        clod_case_contact contact = any_contact(&roll);
        contact.friction = contact.rolling_friction = 0.0;
        law_probe probe = probe_make(&contact);
        for (int s = 0; s < 4; s++) {
            clod_law_motion m = probe_motion(3e-6);
            m.velocity.y =
                dice_real(&roll, -1.0, 1.0) * pow(10.0, dice_real(&roll, -60.0, 1.0));
            m.spin_i.z = dice_real(&roll, -1.0, 1.0) * pow(10.0, dice_real(&roll, -60.0, 1.0));
            const clod_law_result r = probe_step(&probe, &m, 1e-6);
            check_at_most(length3((vreal3){0.0, r.force.y, r.force.z}), 1e-40);
            check_at_most(length3(r.roll), 1e-40);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_turned_spring_keeps_its_length),
        cmocka_unit_test(beyond_45_degrees_a_spring_stays_shortened),
        cmocka_unit_test(no_tilt_makes_a_spring_longer),
        cmocka_unit_test(next_to_nothing_is_finite),
        cmocka_unit_test(without_friction_no_force_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
