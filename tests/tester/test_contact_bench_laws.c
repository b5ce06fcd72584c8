// luding and eepa on the contact bench, by hand: forces, branches, plastic overlap, summary.

#include "support/bench_path.h"

// luding, R* 2 mm: d* = 4/3 3.75e-4 2 2 mm = 2 um, f = 2 N + 4e6 (d - 2 um) beyond. After 3 um:
// d0 = 1.5 um, largest pull 1.2 N at 1.2 um; in 6 uJ; out 1/2 4e6 (1.5^2 - 0.3^2) - 1/2
// 1e6 1.2^2 = 3.6 uJ. At 0.75 um on the way in k2 is 2.125e6, so d0 = 1.125/2.125
// of it.
static void luding_on_the_bench(void **state)
{
    (void)state;
    const path *p = drive("law: luding, k1: 1e6 N/m, k2: 4e6 N/m, k_adh: 1e6 N/m, "
                          "plasticity_depth: 3.75e-4, restitution: 1, friction: 0.35",
                          TWO "    - {overlap: 3 um, steps: 4}\n"
                              "    - {overlap: 1 um, steps: 2}\n");
    static const double FORCE[] = {0.75, 1.5, 3.0, 6.0, 2.0, -1.0};
    static const double ZERO[] = {6.75e-6 / 17.0, 13.5e-6 / 13.0, 1.5e-6, 1.5e-6, 1.5e-6};
    static const clod_contact_branch BRANCH[] = {CLOD_BRANCH_LOADING,   CLOD_BRANCH_LOADING,
                                                 CLOD_BRANCH_UNLOADING, CLOD_BRANCH_UNLOADING,
                                                 CLOD_BRANCH_UNLOADING, CLOD_BRANCH_ADHESIVE};
    for (int r = 0; r < 6; r++) {
        near(p->row[r].force, FORCE[r], 1e-9);
        assert_int_equal(p->row[r].branch, BRANCH[r]);
    }
    for (int r = 0; r < 5; r++) {
        near(p->row[r].plastic, ZERO[r], 1e-9);
    }
    near(p->row[4].limit, 0.35 * (2.0 + 2.0), 1e-9);
    assert_true(p->row[5].limit == 0.0);
    near(p->summary.pull_off_overlap, 0.4, 1e-9);
    near(p->summary.pull_off_force, 0.2, 1e-9);
    near(p->summary.restitution_law, sqrt(0.6), 1e-3);
    near(p->summary.restitution_both, sqrt(0.6), 1e-3);
}

// eepa, n = 1, k1 1e6, k2 4e6, R* 2 mm, 0.5 N for dp = 3 um (d_max 4 um). dp/4 has 0.25 N, at
// 0.75 - 0.0625 um. In 8 uJ. With w = sqrt(dp), b = 0.125 um/sqrt(3 um): out from k2 1/2 4e6 (1
// - 0.125^2) um^2, less the pull along x = w^2 - b w, 4e6 b (2/3 w^3 - 1/2 b w^2) from w = 2 b,
// less 1/2 4e6 (2 b^2)^2 below. With 10 mN on top of all: less than 40 nJ in and out.
static void eepa_on_the_bench(void **state)
{
    (void)state;
    char law[256];
    snprintf(law, sizeof law,
             "law: eepa, exponent: 1, k1: 1e6 N/m, k2: 4e6 N/m, surface_energy: %.17g J/m2, "
             "restitution: 1, friction: 0.35",
             0.5 / (1.5 * M_PI * sqrt(2.0 * 2e-3 * 3e-6)));
    const char *legs = TWO "    - {overlap: 4 um, steps: 4}\n"
                           "    - {overlap: 0.6875 um, steps: 1}\n"
                           "    - {overlap: 0.7 um, steps: 1}\n";
    const path *p = drive(law, legs);
    near(p->row[3].force, 4.0, 1e-9);
    assert_int_equal(p->row[3].branch, CLOD_BRANCH_LOADING);
    near(p->row[4].force, -0.25, 1e-9);
    near(p->row[4].plastic, 0.75e-6, 1e-9);
    assert_int_equal(p->row[4].branch, CLOD_BRANCH_ADHESIVE);
    near(p->row[5].force, -0.2, 1e-9);
    assert_int_equal(p->row[5].branch, CLOD_BRANCH_UNLOADING);
    near(p->summary.pull_off_overlap, 2.875 / 4.0, 1e-9);
    near(p->summary.pull_off_force, 0.5 / 4.0, 1e-9);
    const double w = sqrt(3e-6);
    const double b = 0.125e-6 / w;
    const double pulled = 4e6 * b * (2.0 / 3.0 * w * w * w - 0.5 * b * w * w) -
                          4e6 * b * (16.0 / 3.0 * b * b * b - 2.0 * b * b * b);
    const double out = 2e6 * (1.0 - 0.015625) * 1e-12 - pulled - 8e6 * b * b * b * b;
    near(p->summary.restitution_law, sqrt(out / 8e-6), 1e-3);
    strcat(law, ", pull_off_force: 10 mN");
    p = drive(law, legs);
    near(p->row[4].force, -0.26, 1e-9);
    near(p->summary.restitution_law, sqrt((out - 4e-8) / (8e-6 - 4e-8)), 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(luding_on_the_bench),
        cmocka_unit_test(eepa_on_the_bench),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
