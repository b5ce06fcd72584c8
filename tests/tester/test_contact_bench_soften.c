// contacts.soften on the contact bench: the overlaps of a softened contact are soften^(1/n) times
// those of the stiffness as given, its forces the same (docs/theory/softening.md). By hand.

#include "support/bench_path.h"

static path hard, soft;

/** Both benches in one; the second one softened. */
static void drive_both(const char *law, const char *legs, const char *soft_legs,
                       const char *change)
{
    drive_case(parse(law, legs), &hard);
    drive_case(parse_changed(law, soft_legs, change), &soft);
    assert_int_equal(hard.count, soft.count);
}

#define ORE "k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5, k_adh: 3.56e8 N/m^1.5, restitution: 1"

// 8^(2/3) = 4. Values of docs/theory/mepa.md: 2.468172 N, -1.285924 N at 2.354201 um.
static void mepa_has_its_forces_at_larger_overlaps(void **state)
{
    (void)state;
    drive_both("law: mepa, " ORE,
               TWO "    - {overlap: 3 um, steps: 4}\n    - {overlap: 1.8 um, steps: 1000}\n"
                   "    - {overlap: 2.1 um, steps: 2}\n    - {overlap: 3.3 um, steps: 5}\n",
               TWO "    - {overlap: 12 um, steps: 4}\n    - {overlap: 7.2 um, steps: 1000}\n"
                   "    - {overlap: 8.4 um, steps: 2}\n    - {overlap: 13.2 um, steps: 5}\n",
               "contacts.soften=8");
    for (size_t r = 0; r < hard.count; r++) {
        near(soft.row[r].overlap, 4.0 * hard.row[r].overlap, 1e-12);
        near(soft.row[r].force, hard.row[r].force, 1e-9);
        near(soft.row[r].plastic, 4.0 * hard.row[r].plastic, 1e-9);
        assert_int_equal(soft.row[r].branch, hard.row[r].branch);
    }
    near(soft.row[3].force, 2.468172, 1e-6);
    near(soft.summary.f_min, -1.285924, 5e-3); // a corner between two rows
    near(soft.summary.d_min, 4.0 * 2.354201e-6, 1e-3);
    const double ratio = 3.56 / 4.75 * (23.7 - 4.75) / (23.7 + 3.56);
    near(soft.summary.pull_off_force, ratio, 1e-12);
    near(soft.summary.pull_off_overlap, hard.summary.pull_off_overlap, 1e-12);
    near(soft.summary.restitution_law, hard.summary.restitution_law, 1e-12);
    near(soft.summary.restitution_both, hard.summary.restitution_both, 1e-12);
}

// n = 1: overlaps times 100. d_max 1 um, k1 4.75e5: 0.475 N, pull 0.24747616 N (check value / 1000).
static void linear_contacts_too(void **state)
{
    (void)state;
    drive_both("law: mepa, exponent: 1, k1: 4.75e5 N/m, k2: 2.37e6 N/m, k_adh: 3.56e5 N/m",
               TWO "    - {overlap: 1 um, steps: 2}\n    - {overlap: 0.6 um, steps: 1000}\n",
               TWO "    - {overlap: 100 um, steps: 2}\n    - {overlap: 60 um, steps: 1000}\n",
               "contacts.soften=100");
    near(soft.row[1].force, 0.475, 1e-12);
    near(soft.summary.f_min, -0.24747616, 5e-3);
    near(soft.summary.pull_off_force, hard.summary.pull_off_force, 1e-12);
    drive_both("law: hooke, k1: 2e5 N/m", TWO "    - {overlap: 3 um, steps: 3}\n",
               TWO "    - {overlap: 30 um, steps: 3}\n", "contacts.soften=10");
    near(soft.row[2].force, 0.6, 1e-12);
}

// hertz: both moduli over 8, so four times the overlap. k_t = 4 G*/E* dk, and dk is 4^(1/2)/8 of
// what it was: four times the slip gives the same force.
static void hertz_and_friction(void **state)
{
    (void)state;
    drive_both("law: hertz, friction: 10",
               TWO "    - {overlap: 3 um, steps: 3}\n"
                   "    - {overlap: 3 um, slip: [0.5 um, 0 um], steps: 4}\n",
               TWO "    - {overlap: 12 um, steps: 3}\n"
                   "    - {overlap: 12 um, slip: [2 um, 0 um], steps: 4}\n",
               "contacts.soften=8");
    for (size_t r = 0; r < hard.count; r++) {
        near(soft.row[r].force, hard.row[r].force, 1e-12);
        near(soft.row[r].friction[0], hard.row[r].friction[0], 1e-5); // a weak dash-pot
    }
    assert_true(hard.row[6].friction[0] < -0.1);
}

// luding's plastic range is a length that stays: beyond d* = 2 um softened forces are those of a
// law with k1 and k2 over 10. By hand: 0.2 N + 4e5 N/m 1 um at 3 um.
static void ludings_depth_stays(void **state)
{
    (void)state;
    drive_both(
        "law: luding, k1: 1e6 N/m, k2: 4e6 N/m, k_adh: 1e6 N/m, plasticity_depth: 3.75e-4",
        TWO "    - {overlap: 3 um, steps: 2}\n", TWO "    - {overlap: 3 um, steps: 2}\n",
        "contacts.soften=10");
    near(hard.row[1].force, 6.0, 1e-9);
    near(soft.row[1].force, 0.6, 1e-9);
}

// eepa's pulls are not divided: f0 = 10 mN on top of k1 d at any softening; the pull of the patch,
// 1.5 pi gamma sqrt(2 R* dp), is 0.5 N at dp = 3 um, and after the same press, at 300 um, 5 N
// (k2 dp/2, its limit, is 6 N in both).
static void pulls_of_eepa_are_not_divided(void **state)
{
    (void)state;
    char law[256];
    snprintf(law, sizeof law,
             "law: eepa, exponent: 1, k1: 1e6 N/m, k2: 4e6 N/m, pull_off_force: 10 mN, "
             "surface_energy: %.17g J/m2",
             0.5 / (1.5 * M_PI * sqrt(2.0 * 2e-3 * 3e-6)));
    drive_both(law, TWO "    - {overlap: 4 um, steps: 1}\n",
               TWO "    - {overlap: 400 um, steps: 1}\n", "contacts.soften=100");
    near(hard.row[0].force, 4.0 - 0.01, 1e-9);
    near(soft.row[0].force, 4.0 - 0.01, 1e-9);
    near(hard.summary.pull_off_force, 0.51 / 3.99, 1e-9);
    near(soft.summary.pull_off_force, 5.01 / 3.99, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mepa_has_its_forces_at_larger_overlaps),
        cmocka_unit_test(linear_contacts_too),
        cmocka_unit_test(hertz_and_friction),
        cmocka_unit_test(ludings_depth_stays),
        cmocka_unit_test(pulls_of_eepa_are_not_divided),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
