// Tables of wall friction and of bulk density, read with their units; and which of them a table is.

#include <string.h>

#include "clod/measured.h"
#include "support/check.h"

static void expect_error(const char *text, const char *wanted)
{
    clod_wall_locus_point *points;
    size_t count;
    clod_status status = {0};
    assert_false(
        clod_wall_locus_parse("wall.csv", text, strlen(text), &points, &count, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_null(points);
    if (strstr(status.text, wanted) == NULL) {
        fail_msg("\"%s\" is not in \"%s\"", wanted, status.text);
    }
}

static void units_and_order_are_those_of_the_header(void **state)
{
    static const char TEXT[] = "# liner: steel\ntau_w [kPa];sigma_w [psi];tau_w_error [Pa]\n"
                               "1.5;1;20\n0.8;0.5;\n";
    clod_wall_locus_point *points;
    size_t count;
    clod_status status = {0};
    (void)state;
    assert_true(
        clod_wall_locus_parse("wall.csv", TEXT, strlen(TEXT), &points, &count, &status));
    assert_int_equal(count, 2);
    check_relative(points[0].sigma, 6894.757293168, 1e-9); // 1 lbf/in2
    check_close(points[0].tau, 1500.0, 1e-9);
    check_close(points[0].tau_error, 20.0, 1e-12);
    assert_true(points[1].tau_error == 0.0);
    clod_locus_free(points);
}

/** tau_w = sigma_w tan(phi_x), its error sigma_w/cos^2(phi_x) times that of the angle: 4 kPa at 45 deg, 1 deg: 8 kPa pi/180. */
static void angles_stand_for_shear_stresses(void **state)
{
    static const char TEXT[] = "Sigma_w [kPa],phi_x [deg],phi_x_error [deg]\n4,45,1\n2,30,\n";
    clod_wall_locus_point *points;
    size_t count;
    clod_status status = {0};
    (void)state;
    assert_false(clod_wall_locus_parse("wall.csv", TEXT, strlen(TEXT), &points, &count,
                                       &status)); // a capital letter is told
    assert_true(strstr(status.text, "did you mean sigma_w") != NULL);
    char text[sizeof TEXT];
    memcpy(text, TEXT, sizeof TEXT);
    text[0] = 's';
    assert_true(
        clod_wall_locus_parse("wall.csv", text, strlen(text), &points, &count, &status));
    assert_int_equal(count, 2);
    assert_true(points[0].of_angle);
    check_close(points[0].tau, 4000.0, 1e-9);
    check_close(points[0].tau_error, 8000.0 * M_PI / 180.0, 1e-9);
    check_close(points[1].tau, 2000.0 / sqrt(3.0), 1e-9);
    assert_true(points[1].tau_error == 0.0);
    clod_locus_free(points);
    expect_error("sigma_w [kPa],phi_x [deg]\n4,85\n", "wall.csv:2: column phi_x");
    expect_error("sigma_w [kPa],phi_x\n4,25\n", "phi_x");
    expect_error("phi_x [deg],tau_x [kPa]\n25,1\n", "sigma_w");
    expect_error("sigma_w [kPa],tau_w [kPa],place\n4,1,2\n",
                 "phi_x_error, wall_stress, steady"); // all columns that are taken are told
    // with shear stresses the angle beside them is checked, atan(1/4) = 14.04 deg, and may be left out of a row
    static const char BOTH[] = "sigma_w [kPa],tau_w [kPa],phi_x [deg]\n4,1,14.9\n4,1,\n";
    assert_true(
        clod_wall_locus_parse("wall.csv", BOTH, strlen(BOTH), &points, &count, &status));
    check_close(points[0].tau, 1000.0, 1e-9);
    clod_locus_free(points);
    expect_error("sigma_w [kPa],tau_w [kPa],phi_x [deg]\n4,1,14\n4,1,15.1\n",
                 "wall.csv:3: phi_x = 15.1 deg, but tau_w = 1000 Pa at sigma_w = 4000 Pa is an "
                 "angle of 14.0 deg");
}

/** As wall_friction.csv of a run has them; without the columns all is steady. */
static void rows_say_whether_shear_was_steady(void **state)
{
    static const char TEXT[] =
        "sigma_w [Pa],tau_w [Pa],wall_stress [Pa],displacement [m],steady [1]\n"
        "9000,2500,10000,0.02,1\n4500,1200,5000,0.02,0\n";
    clod_wall_locus_point *points;
    size_t count;
    clod_status status = {0};
    (void)state;
    assert_true(
        clod_wall_locus_parse("wall.csv", TEXT, strlen(TEXT), &points, &count, &status));
    assert_int_equal(count, 2);
    assert_true(!points[0].unsteady && points[1].unsteady);
    assert_true(points[0].wall_stress == 10e3 && points[1].wall_stress == 5e3);
    clod_locus_free(points);
    static const char PLAIN[] = "sigma_w [Pa],tau_w [Pa]\n9000,2500\n";
    assert_true(
        clod_wall_locus_parse("wall.csv", PLAIN, strlen(PLAIN), &points, &count, &status));
    assert_true(!points[0].unsteady && points[0].wall_stress == 0.0);
    clod_locus_free(points);
}

static void what_is_wrong_is_said_with_its_place(void **state)
{
    (void)state;
    expect_error("sigma_w [kPa]\n10\n", "wall.csv:1: the header has no column tau_w");
    expect_error("sigma_w [kPa],tau_w [kPa],force [N]\n10,3,1\n", "force");
    expect_error("sigma_w [mm],tau_w [kPa]\n10,3\n", "mm");
    expect_error("sigma_w [kPa],tau_w [kPa]\n10,3\n0,2\n", "wall.csv:3: column sigma_w: \"0\"");
    expect_error("sigma_w [kPa],tau_w [kPa],steady\n10,3,2\n",
                 "wall.csv:2: column steady: 2 must be 1, shear was steady, or 0");
    expect_error("sigma_w [kPa],tau_w [kPa]\n10,-3\n", "wall.csv:2: column tau_w: \"-3\"");
    expect_error("sigma_w [kPa],tau_w [Pa]\n10,x\n", "is not a number");
    expect_error("sigma_w [kPa],tau_w [kPa]\n", "there is no wall yield locus point in it");
}

/** atan(60) = 89.05 deg: kPa beside Pa. */
static void an_impossible_angle_is_an_error(void **state)
{
    (void)state;
    expect_error("sigma_w [Pa],tau_w [kPa]\n50,3\n",
                 "wall.csv:2: tau_w = 3000 Pa at sigma_w = 50 Pa is a wall friction angle of "
                 "89.0 deg; no wall has more than 80 deg");
}

static void a_table_is_what_its_header_says(void **state)
{
    static const struct {
        const char *text;
        clod_measured_kind kind;
    } TABLES[] = {
        {"sigma_w [kPa],tau_w [kPa]\n", CLOD_MEASURED_WALL},
        {"\xEF\xBB\xBF# a comment\n\n\"tau_w [kPa]\"\n", CLOD_MEASURED_WALL},
        {"sigma_1 [kPa];rho_b [kg/m3]\n", CLOD_MEASURED_DENSITY},
        {"rho[g/cm3]\tsigma_1[kPa]", CLOD_MEASURED_DENSITY},
        {"sigma_1 [kPa],f_c [kPa],rho_b [kg/m3]\n", CLOD_MEASURED_SHEAR},
        {"sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n",
         CLOD_MEASURED_SHEAR},
        {"sigma_wall [kPa],tau_wall [kPa]\n", CLOD_MEASURED_SHEAR},
        {"# sigma_w\nsigma_sh [kPa]\n", CLOD_MEASURED_SHEAR},
        {"", CLOD_MEASURED_SHEAR},
    };
    (void)state;
    for (size_t k = 0; k < sizeof TABLES / sizeof *TABLES; k++) {
        assert_int_equal(clod_measured_kind_of(TABLES[k].text, strlen(TABLES[k].text)),
                         TABLES[k].kind);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_and_order_are_those_of_the_header),
        cmocka_unit_test(angles_stand_for_shear_stresses),
        cmocka_unit_test(rows_say_whether_shear_was_steady),
        cmocka_unit_test(what_is_wrong_is_said_with_its_place),
        cmocka_unit_test(an_impossible_angle_is_an_error),
        cmocka_unit_test(a_table_is_what_its_header_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
