// A solid at one stress: what its wall feels there, by hand.

#include "hopper/solid_made.h"

/**
 * phi_e 40, phi_w 20: 2 beta = 20 + asin(0.342020/0.642788) = 52.147 deg, cos 0.61364;
 * sigma_w = sigma_1 (1 + 0.642788 x 0.61364)/1.642788 = 0.84883 sigma_1. Five digits.
 */
static void the_wall_feels_part_of_the_major_stress(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 40.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 10.0, 3.0);
    const clod_solid_state at = clod_solid_at(&of.solid, 4000.0);
    check_relative(at.sigma_w, 0.84883 * 4000.0, 2e-5);
    check_close(at.phi_w, 20.0 * DEGREE, 1e-9);
    check_close(at.strength, 1800.0, 1e-9);
    check_close(at.rho, 1500.0, 0.0);
}

/** A wall with adhesion, 200 Pa + 0.3 sigma_w: rough at small stresses, where nothing slides. */
static void adhesion_holds_the_solid_at_small_stresses(void **state)
{
    (void)state;
    static made of;
    static clod_curve_point wall[] = {{.x = 1000.0, .y = 500.0}, {.x = 5000.0, .y = 1700.0}};
    make_solid(&of, 40.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 10.0, 3.0);
    of.solid.wall = (clod_curve){.way = CLOD_CURVE_EXTENDED, .points = wall, .count = 2};
    check_close(clod_solid_wall_angle(&of.solid, 2000.0), atan(800.0 / 2000.0), 1e-12);
    const clod_solid_state at = clod_solid_at(&of.solid, 4000.0);
    check_close(tan(at.phi_w) * at.sigma_w, 200.0 + 0.3 * at.sigma_w, 1e-5);
    const double s = sin(40.0 * DEGREE);
    const double twice = at.phi_w + asin(sin(at.phi_w) / s);
    check_relative(at.sigma_w, 4000.0 * (1.0 + s * cos(twice)) / (1.0 + s), 1e-9);
    check_close(clod_solid_at(&of.solid, 300.0).phi_w, M_PI_2, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_wall_feels_part_of_the_major_stress),
        cmocka_unit_test(adhesion_holds_the_solid_at_small_stresses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
