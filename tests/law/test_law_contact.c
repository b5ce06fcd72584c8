// One contact, whole: forces, torques and history of every choice of law along random motions,
// against the reference of support/law_reference.h; symmetry and balance.

#include "support/dice.h"
#include "support/law_probe.h"
#include "support/law_reference.h"

static const clod_case_material SOFT = {
    .density = 1000.0, .youngs_modulus = 2e9, .poissons_ratio = 0.21};

static clod_case_contact random_contact(dice *roll)
{
    clod_case_contact c = contact_ore();
    const double exponent[] = {1.0, 1.2, 1.5, 2.0};
    c.law = dice_pick(roll, 5);
    c.exponent = exponent[dice_pick(roll, 4)];
    c.k1 = 4e8 * pow(1e6, c.exponent - 1.5); // forces of the same size for every exponent
    c.k2 = c.k1 * dice_real(roll, 1.0, 6.0);
    c.k_adh = c.k1 * dice_real(roll, 0.0, 1.5);
    if (c.law == CLOD_LAW_HOOKE) { // the loader gives hooke n = 1 and no k2
        c.exponent = 1.0;
        c.k1 = c.k2 = 4e5;
    } else if (c.law == CLOD_LAW_LUDING) { // n = 1 and k1 < k2 too; d* of some micrometres
        c.exponent = 1.0;
        c.k1 = 4e5;
        c.k2 = c.k1 * dice_real(roll, 1.5, 6.0);
        c.k_adh = c.k1 * dice_real(roll, 0.0, 1.5);
        c.plasticity_depth = dice_real(roll, 2e-4, 2e-3);
    } else if (c.law == CLOD_LAW_EEPA) {
        c.pull_off_force = dice_real(roll, 0.0, 0.5);
        if (dice_pick(roll, 2) == 0) { // the loader lets surface energy stand without k_adh
            c.surface_energy = dice_real(roll, 0.0, 3000.0);
            c.k_adh = 0.0;
        }
    }
    c.restitution = dice_real(roll, 0.2, 1.0);
    c.friction = dice_real(roll, 0.0, 0.9);
    c.coulomb = dice_pick(roll, 3);
    c.tangential = ref_elastic(&c) ? CLOD_TANGENTIAL_TANGENT : dice_pick(roll, 2);
    c.tangential_ratio = dice_real(roll, 0.2, 1.2);
    c.rolling = dice_pick(roll, 4);
    c.rolling_friction = dice_real(roll, 0.0, 0.6);
    c.rolling_damping = dice_real(roll, 0.0, 1.0);
    return c;
}

/** A walk of the pair: everything changes a little from step to step. */
static void wander(dice *roll, ref_motion *m)
{
    double n[3], v[3];
    dice_direction(roll, n);
    quad length = 0.0L;
    for (int c = 0; c < 3; c++) {
        m->normal[c] += 0.02L * n[c];
    }
    length = sqrtl(ref_dot(m->normal, m->normal));
    for (int c = 0; c < 3; c++) {
        m->normal[c] = (double)(m->normal[c] / length);
    }
    length = sqrtl(ref_dot(m->normal, m->normal));
    dice_direction(roll, v);
    for (int c = 0; c < 3; c++) {
        m->velocity[c] = 0.8 * (double)m->velocity[c] + 0.02 * v[c];
        m->spin_i[c] = 0.8 * (double)m->spin_i[c] + dice_real(roll, -5.0, 5.0);
        m->spin_j[c] = 0.8 * (double)m->spin_j[c] + dice_real(roll, -5.0, 5.0);
    }
    m->overlap = (double)m->overlap + dice_real(roll, -1e-6, 1.05e-6);
}

static vreal3 narrow(const quad a[3])
{
    return (vreal3){(double)a[0], (double)a[1], (double)a[2]};
}

static clod_law_motion as_motion(const ref_motion *m)
{
    return (clod_law_motion){.overlap = (double)m->overlap,
                             .normal = narrow(m->normal),
                             .velocity = narrow(m->velocity),
                             .spin_i = narrow(m->spin_i),
                             .spin_j = narrow(m->spin_j),
                             .arm_i = (double)m->arm_i,
                             .arm_j = (double)m->arm_j,
                             .m_star = (double)m->m_star,
                             .r_star = (double)m->r_star,
                             .roll_inertia = (double)m->roll_inertia};
}

/** The normal as both see it is a unit vector to double precision only: make it both's. */
static ref_motion random_motion(dice *roll)
{
    ref_motion m;
    memset(&m, 0, sizeof m);
    m.normal[0] = 1.0L;
    m.arm_i = dice_real(roll, 1e-3, 4e-3);
    m.arm_j = dice_pick(roll, 4) == 0 ? 0.0 : dice_real(roll, 1e-3, 4e-3); // 0: a wall
    m.m_star = dice_real(roll, 1e-4, 1e-3);
    m.r_star = dice_real(roll, 1e-3, 3e-3);
    m.roll_inertia = dice_real(roll, 1e-9, 1e-8);
    return m;
}

static void check_vector(vreal3 found, const quad expected[3], double tolerance)
{
    check_close(found.x, (double)expected[0], tolerance);
    check_close(found.y, (double)expected[1], tolerance);
    check_close(found.z, (double)expected[2], tolerance);
}

static void every_choice_follows_the_reference(void **state)
{
    (void)state;
    dice roll = {7};
    int slides = 0, sticks = 0, opens = 0;
    for (int path = 0; path < 600; path++) {
        const clod_case_contact c = random_contact(&roll);
        law_probe probe = {.law = clod_law_make(&c, &ORE, &SOFT)};
        ref_memory memory;
        memset(&memory, 0, sizeof memory);
        ref_motion m = random_motion(&roll);
        double fraction = 1.0;
        for (int s = 0; s < 120; s++) {
            wander(&roll, &m);
            if (s == 50) {
                fraction = dice_real(&roll, 0.0, 1.0);
                clod_law_set_adhesion(&probe.law, fraction);
            }
            const clod_law_motion motion = as_motion(&m);
            const clod_law_result r = probe_step(&probe, &motion, 1e-6);
            const ref_result e = ref_contact(&c, &ORE, &SOFT, fraction, &m, 1e-6L, &memory);
            opens += m.overlap <= 0.0L;
            m.overlap = m.overlap > 0.0L ? m.overlap : 0.0L;
            const double scale = 10.0 * fmax(1.0, (double)fabsl(e.f_hys));
            check_vector(r.force, e.force, 1e-11 * scale);
            check_vector(vreal3_axpy(r.roll, -motion.arm_i, r.lever), e.torque_i,
                         1e-13 * scale);
            check_vector(vreal3_axpy(vreal3_scale(r.roll, -1.0), -motion.arm_j, r.lever),
                         e.torque_j, 1e-13 * scale);
            const double f_t = sqrt((double)ref_dot(e.f_t, e.f_t));
            slides += f_t > 0.0 && f_t >= 0.999999 * (double)e.limit;
            sticks += f_t > 0.0 && f_t < 0.999999 * (double)e.limit;
        }
    }
    assert_true(slides > 5000 && sticks > 5000 && opens > 500); // the paths reach everything
}

static clod_law_motion random_pair(dice *roll)
{
    ref_motion m = random_motion(roll);
    for (int s = 0; s < 30; s++) {
        wander(roll, &m);
    }
    m.overlap = dice_real(roll, 1e-6, 5e-6);
    return as_motion(&m);
}

/** i and j the other way round: the mirrored contact, with mirrored springs, bit for bit. */
static void reversed_order_gives_the_mirrored_force(void **state)
{
    (void)state;
    dice roll = {11};
    for (int pair = 0; pair < 200; pair++) {
        const clod_case_contact c = random_contact(&roll);
        law_probe one = probe_make(&c);
        law_probe two = one;
        for (int s = 0; s < 20; s++) {
            const clod_law_motion m = random_pair(&roll);
            clod_law_motion w = m;
            w.normal = vreal3_scale(m.normal, -1.0);
            w.velocity = vreal3_scale(m.velocity, -1.0);
            w.spin_i = m.spin_j;
            w.spin_j = m.spin_i;
            w.arm_i = m.arm_j;
            w.arm_j = m.arm_i;
            const clod_law_result a = probe_step(&one, &m, 1e-6);
            const clod_law_result b = probe_step(&two, &w, 1e-6);
            const double scale = 1e-9 * fabs(a.force.x);
            check_close(a.force.x, -b.force.x, scale);
            check_close(a.force.y, -b.force.y, scale);
            check_close(a.force.z, -b.force.z, scale);
            check_close(a.lever.x, b.lever.x,
                        scale); // n and F_t both turn: their product stays
            check_close(a.roll.y, -b.roll.y, 1e-3 * scale);
            check_close(one.history.spring[1][0], -two.history.spring[1][0], 1e-18);
            check_close(one.history.roll[2][0], -two.history.roll[2][0], 1e-15);
        }
    }
}

/**
 * Torques balance the moment of the forces: T_i + T_j + (x_i - x_j) x F = 0 about any point,
 * with x_i - x_j = (arm_i + arm_j) n.
 */
static void angular_momentum_of_the_pair_stays(void **state)
{
    (void)state;
    dice roll = {13};
    for (int pair = 0; pair < 500; pair++) {
        const clod_case_contact c = random_contact(&roll);
        law_probe probe = probe_make(&c);
        const clod_law_motion m = random_pair(&roll);
        const clod_law_result r = probe_step(&probe, &m, 1e-6);
        const vreal3 on_i = vreal3_axpy(r.roll, -m.arm_i, r.lever);
        const vreal3 on_j = vreal3_axpy(vreal3_scale(r.roll, -1.0), -m.arm_j, r.lever);
        const vreal3 moment = vreal3_scale(vreal3_cross(m.normal, r.force), m.arm_i + m.arm_j);
        const vreal3 sum = vreal3_add(vreal3_add(on_i, on_j), moment);
        const double scale = 1e-15 * sqrt(vreal3_dot(r.force, r.force));
        check_close(sum.x, 0.0, scale);
        check_close(sum.y, 0.0, scale);
        check_close(sum.z, 0.0, scale);
    }
}

/** Grains that do not touch: exactly nothing, whatever the history holds. */
static void an_open_contact_does_nothing(void **state)
{
    (void)state;
    dice roll = {17};
    for (int pair = 0; pair < 300; pair++) {
        const clod_case_contact c = random_contact(&roll);
        law_probe probe = probe_make(&c);
        clod_law_motion m = random_pair(&roll);
        probe_step(&probe, &m, 1e-6);
        m.overlap = pair % 2 == 0 ? 0.0 : -1e-7;
        const clod_law_result r = probe_step(&probe, &m, 1e-6);
        assert_false(r.closed);
        const double all[] = {r.force.x, r.force.y, r.force.z, r.lever.x, r.lever.y,
                              r.lever.z, r.roll.x,  r.roll.y,  r.roll.z};
        for (int k = 0; k < 9; k++) {
            check_close(all[k], 0.0, 0.0);
        }
        const clod_history none = {0};
        assert_memory_equal(&probe.history, &none, sizeof none);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_choice_follows_the_reference),
        cmocka_unit_test(reversed_order_gives_the_mirrored_force),
        cmocka_unit_test(angular_momentum_of_the_pair_stays),
        cmocka_unit_test(an_open_contact_does_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
