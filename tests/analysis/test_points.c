// Files of shear points: what is read, and the exact message for everything that is wrong.

#include "locus_helpers.h"

static const clod_locus_defaults NONE = {NULL, NULL};

static size_t parse_good(const char *text, const clod_locus_defaults *defaults,
                         clod_locus_point **points)
{
    static clod_status status;
    size_t count;
    if (!clod_locus_parse("p.csv", text, strlen(text), defaults, points, &count, &status)) {
        fail_msg("%s", status.text);
    }
    return count;
}

static void expect_error(const char *text, const clod_locus_defaults *defaults,
                         const char *message)
{
    static clod_status status;
    clod_locus_point *points;
    size_t count;
    assert_false(
        clod_locus_parse("p.csv", text, strlen(text), defaults, &points, &count, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_null(points);
    assert_string_equal(status.text, message);
}

static void all_columns_are_read(void **state)
{
    (void)state;
    clod_locus_point *points;
    const size_t count = parse_good(
        "# ring shear, ore 5 %\n"
        "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3],"
        "tau_pre_error [Pa],tau_sh_error [Pa],rho_b_error [g/cm3],rho_inside [g/cm3]\n"
        "3,54.8,52.1,10.96,18.5,1650,120,150,0.012,1.7\n"
        "\n"
        "4, 54.8 ,5.2e1,21.92,27,,,,,\n",
        &NONE, &points);
    assert_int_equal(count, 2);
    assert_int_equal(points[0].seed, 3);
    assert_near(points[0].sigma_p, 54800.0, 1e-15);
    assert_near(points[0].tau_p, 52100.0, 1e-15);
    assert_near(points[0].sigma_s, 10960.0, 1e-15);
    assert_near(points[0].tau_s, 18500.0, 1e-15);
    assert_near(points[0].rho_b, 1650.0, 1e-15);
    assert_near(points[0].tau_p_error, 120.0, 1e-15);
    assert_near(points[0].tau_s_error, 150.0, 1e-15);
    assert_near(points[0].rho_b_error, 12.0, 1e-15);
    assert_near(points[0].rho_inside, 1700.0, 1e-15);
    assert_int_equal(points[1].seed, 4);
    assert_near(points[1].tau_p, 52000.0, 1e-15);
    assert_true(points[1].rho_b == 0.0 && points[1].rho_inside == 0.0 &&
                points[1].tau_s_error == 0.0);
    clod_locus_free(points);
}

// 1 lbf = 0.45359237 kg * 9.80665 m/s2, 1 ft = 0.3048 m: 1 psf = 47.88025898033584 Pa
static void units_are_converted(void **state)
{
    (void)state;
    clod_locus_point *points;
    size_t count = parse_good("sigma_p (psf);tau_p [lbf/ft^2];sigma [Pa];tau [mbar]\r\n"
                              "200;150;4788;30\r\n",
                              &NONE, &points);
    assert_int_equal(count, 1);
    assert_near(points[0].sigma_p, 200.0 * 47.88025898033584, 1e-12);
    assert_near(points[0].tau_p, 150.0 * 47.88025898033584, 1e-12);
    assert_near(points[0].sigma_s, 4788.0, 1e-15);
    assert_near(points[0].tau_s, 3000.0, 1e-12);
    clod_locus_free(points);
    count = parse_good(
        "\xEF\xBB\xBF\"sigma_pre [kPa]\"\ttau_pre [kPa]\tsigma_s [kPa]\ttau_s [kPa]\n"
        "10\t8.5\t\"2\"\t3.4",
        &NONE, &points);
    assert_int_equal(count, 1);
    assert_near(points[0].sigma_s, 2000.0, 1e-15);
    clod_locus_free(points);
}

static void rows_without_preshear_take_the_given_one(void **state)
{
    (void)state;
    clod_locus_point *points;
    const clod_locus_defaults both = {"10 kPa", "8500 Pa"};
    size_t count = parse_good("sigma [kPa],tau [kPa]\n2,3.4\n4,4.8\n", &both, &points);
    assert_int_equal(count, 2);
    assert_near(points[1].sigma_p, 10e3, 1e-15);
    assert_near(points[1].tau_p, 8500.0, 1e-15);
    clod_locus_free(points);
    count =
        parse_good("sigma_pre [kPa],tau_pre [kPa],sigma [kPa],tau [kPa]\n20,,2,3.4\n,9,4,4.8\n",
                   &both, &points);
    assert_near(points[0].sigma_p, 20e3, 1e-15);
    assert_near(points[0].tau_p, 8500.0, 1e-15);
    assert_near(points[1].sigma_p, 10e3, 1e-15);
    assert_near(points[1].tau_p, 9000.0, 1e-15);
    clod_locus_free(points);
}

static void many_rows_are_kept(void **state)
{
    (void)state;
    static char text[40000] = "sigma_pre [Pa],tau_pre [Pa],sigma [Pa],tau [Pa]\n";
    for (int i = 0; i < 1000; i++) {
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "10000,8500,%d,%d\n", i, 2 * i);
    }
    clod_locus_point *points;
    assert_int_equal(parse_good(text, &NONE, &points), 1000);
    assert_near(points[777].tau_s, 1554.0, 0.0);
    clod_locus_free(points);
}

#define HEAD "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"

static void wrong_headers(void **state)
{
    (void)state;
    expect_error("", &NONE, "p.csv: there is no header in it.");
    expect_error("# nothing\n\n", &NONE, "p.csv: there is no header in it.");
    expect_error(HEAD, &NONE, "p.csv: there is no shear point in it.");
    expect_error("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa]\n", &NONE,
                 "p.csv:1: the header has no column tau_sh. It may look like: sigma_pre "
                 "[kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]");
    expect_error("# lab\nsigma_sh [kPa],tau_sh\n", &NONE,
                 "p.csv:2: column tau_sh has no unit; write it behind the name, for instance "
                 "tau_sh [kPa].");
    expect_error(
        "sigma_sh [kPa],tau_sh [mm]\n", &NONE,
        "p.csv:1: column tau_sh [mm]: 1 mm is not a pressure; use a unit such as kPa.");
    expect_error(
        "sigma_sh [kpa],tau_sh [kPa]\n", &NONE,
        "p.csv:1: column sigma_sh [kpa]: unit \"kpa\" is not known; did you mean kPa?");
    expect_error("seed [s],sigma_sh [kPa],tau_sh [kPa]\n", &NONE,
                 "p.csv:1: column seed is a number without unit, not in \"s\".");
    expect_error("sigma_sh [kPa],tau_sh [kPa],tau_s [kPa]\n", &NONE,
                 "p.csv:1: column tau_sh is there twice; keep one.");
    expect_error(
        "sigma_sh [kPa],tau_sh [kPa],sigma_prae [kPa]\n", &NONE,
        "p.csv:1: there is no column \"sigma_prae\"; did you mean sigma_pre? Known are "
        "sigma_sh (or sigma_s, sigma), tau_sh (or tau_s, tau), sigma_pre (or sigma_p), "
        "tau_pre (or tau_p), seed, rho_b (or rho), tau_pre_error, tau_sh_error, rho_b_error, rho_inside.");
    expect_error("sigma_sh [kPa],tau_sh [kPa]\n2,3\n", &NONE,
                 "p.csv:1: the header has no column sigma_pre and no value for all rows was "
                 "given; add the column, or give --sigma-pre.");
    const clod_locus_defaults sigma = {"10 kPa", NULL};
    expect_error(
        "sigma_sh [kPa],tau_sh [kPa]\n2,3\n", &sigma,
        "p.csv:1: the header has no column tau_pre and no value for all rows was given; "
        "add the column, or give --tau-pre.");
}

static void wrong_rows(void **state)
{
    (void)state;
    expect_error(HEAD "10,8.5,2\n", &NONE, "p.csv:2: 3 cells, but the header has 4 columns.");
    expect_error(HEAD "10,8.5,2,3.4,5\n", &NONE,
                 "p.csv:2: 5 cells, but the header has 4 columns.");
    expect_error(HEAD "10,8.5,2,3.4\n10,8.5,abc,3.4\n", &NONE,
                 "p.csv:3: column sigma_sh: \"abc\" is not a number; units stand in the header "
                 "only.");
    expect_error(
        HEAD "10,8.5,2 kPa,3.4\n", &NONE,
        "p.csv:2: column sigma_sh: \"2 kPa\" is not a number; units stand in the header "
        "only.");
    expect_error("sigma_pre [kPa];tau_pre [kPa];sigma_sh [kPa];tau_sh [kPa]\n10;8,5;2;3\n",
                 &NONE, "p.csv:2: column tau_pre: \"8,5\" has a decimal comma; write a point.");
    expect_error(HEAD "10,8.5,2,-3.4\n", &NONE,
                 "p.csv:2: column tau_sh: \"-3.4\" must be 0 or more.");
    expect_error(HEAD "10,0,2,3.4\n", &NONE, "p.csv:2: column tau_pre: \"0\" must be above 0.");
    expect_error(HEAD "10,8.5,,3.4\n", &NONE,
                 "p.csv:2: column sigma_sh: \"\" is empty; every row needs it, or delete the "
                 "row.");
    expect_error(HEAD ",8.5,2,3.4\n", &NONE,
                 "p.csv:2: column sigma_pre: \"\" is empty; fill it in, or give --sigma-pre.");
    expect_error(HEAD "10,,2,3.4\n", &NONE,
                 "p.csv:2: column tau_pre: \"\" is empty; fill it in, or give --tau-pre.");
    // merged cells: no one value is that of the empty ones
    expect_error(
        HEAD "10,8.5,2,3.4\n,,4,4.8\n20,17,4,6.8\n", &NONE,
        "p.csv:3: column sigma_pre: \"\" is empty; fill it in. (Of merged cells a file has the "
        "first alone.)");
    expect_error(
        HEAD "10,8.5,2,3.4\n10,,4,4.8\n20,17,4,6.8\n", &NONE,
        "p.csv:3: column tau_pre: \"\" is empty; fill it in. (Of merged cells a file has the "
        "first alone.)");
    expect_error(HEAD "10,8.5,2,3.4\n,8.5,4,4.8\n10,8.5,6,6.2\n", &NONE,
                 "p.csv:3: column sigma_pre: \"\" is empty; fill it in, or give --sigma-pre.");
    expect_error(HEAD "10,nan,2,3.4\n", &NONE,
                 "p.csv:2: column tau_pre: \"nan\" is not a number; units stand in the header "
                 "only.");
    expect_error("seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                 "1.5,10,8.5,2,3.4\n",
                 &NONE, "p.csv:2: column seed: \"1.5\" is not a whole number, 0 or more.");
    expect_error("rho_b [kg/m3]," HEAD "-1,10,8.5,2,3.4\n", &NONE,
                 "p.csv:2: column rho_b: \"-1\" must be above 0.");
}

// As a spreadsheet writes a column that once had something in it.
static void empty_columns_at_the_end_are_none(void **state)
{
    (void)state;
    clod_locus_point *points;
    assert_int_equal(parse_good("sigma_pre [kPa];tau_pre [kPa];sigma_sh [kPa];tau_sh [kPa];;\n"
                                "10;8.5;2;3.4;;\n10;8.5;4;4.8\n10;8.5;6;6.2; ;\r\n",
                                &NONE, &points),
                     3);
    assert_near(points[2].tau_s, 6200.0, 1e-15);
    clod_locus_free(points);
    assert_int_equal(parse_good(HEAD "10,8.5,2,3.4,\n", &NONE, &points), 1);
    clod_locus_free(points);
    expect_error("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],\n10,8.5,2,3.4,5\n",
                 &NONE, "p.csv:2: 5 cells, but the header has 4 columns.");
    // the last column is one, although it is empty here
    assert_int_equal(
        parse_good("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b "
                   "[kg/m3]\n10,8.5,2,3.4,\n",
                   &NONE, &points),
        1);
    clod_locus_free(points);
    expect_error(
        "sigma_pre [kPa],,tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,,8.5,2,3.4\n", &NONE,
        "p.csv:1: column 2 of the header has no name; give it one, or remove the column.");
}

#define DENSE "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"

static void wrong_densities(void **state)
{
    (void)state;
    expect_error(DENSE "10,8.5,2,3.4,1600\n10,8.5,4,4.8,1.6\n", &NONE,
                 "p.csv:3: column rho_b: 1.6 kg/m3 is outside 10 to 15000 kg/m3; is its unit "
                 "another one, [g/cm3]?");
    expect_error("rho_inside [kg/m3]," HEAD "16000,10,8.5,2,3.4\n", &NONE,
                 "p.csv:2: column rho_inside: 16000 kg/m3 is outside 10 to 15000 kg/m3; is its "
                 "unit another one, [g/cm3]?");
    expect_error(DENSE "20,17,4,6.8,700\n10,8.5,2,3.4,1600\n10.1,8.5,4,4.8,160\n", &NONE,
                 "p.csv:4: column rho_b: 160 kg/m3, but line 3 has 1600 kg/m3 at the same "
                 "preshear stress, 10.100 kPa: one consolidation has one bulk density. Correct "
                 "the one that is wrong, or leave it empty.");
    expect_error("seed," DENSE "1,10,8.5,2,3.4,790\n2,10,8.5,4,4.8,1600\n", &NONE,
                 "p.csv:3: column rho_b: 1600 kg/m3, but line 2 has 790 kg/m3 at the same "
                 "preshear stress, 10.000 kPa: one consolidation has one bulk density. Correct "
                 "the one that is wrong, or leave it empty.");
}

// A factor of 2, 3 % between the preshear stresses, and an empty cell; a simulation's densities.
static void densities_that_may_be(void **state)
{
    (void)state;
    clod_locus_point *points;
    assert_int_equal(parse_good(DENSE "10,8.5,2,3.4,800\n10,8.5,4,4.8,1600\n10,8.5,6,6,\n"
                                      "10.3,8.5,2,3.4,1700\n",
                                &NONE, &points),
                     4);
    clod_locus_free(points);
    assert_int_equal(parse_good("seed,rho_inside [kg/m3]," DENSE
                                "1,1221.93149,2.4,2.1,0.6,0.9,1103.06991\n"
                                "2,1321.37515,2.4,2.1,0.6,0.9,1141.61821\n"
                                "3,,2.4,2.1,0.6,0.9,1141.61821\n",
                                &NONE, &points),
                     3);
    assert_near(points[1].rho_inside, 1321.37515, 1e-15);
    clod_locus_free(points);
}

// As laboratories number their points and remark on them; whatever stands there.
static void remarks_are_not_read(void **state)
{
    (void)state;
    clod_locus_point *points;
    assert_int_equal(parse_good("Point,No.,Remarks," HEAD "1,a,\"moist\",10,8.5,2,3.4\n"
                                "2,b,,10,8.4,4,4.4\n",
                                &NONE, &points),
                     2);
    assert_near(points[1].tau_p, 8.4e3, 1e-15);
    assert_near(points[1].tau_s, 4.4e3, 1e-15);
    clod_locus_free(points);
}

static void wrong_defaults(void **state)
{
    (void)state;
    const clod_locus_defaults bare = {"10", NULL};
    const clod_locus_defaults words = {"much", NULL};
    const clod_locus_defaults zero = {"10 kPa", "0 kPa"};
    expect_error(HEAD, &bare,
                 "sigma_pre for all rows, \"10\": 10 needs a unit of pressure, for instance 10 "
                 "kPa.");
    expect_error(HEAD, &words,
                 "sigma_pre for all rows, \"much\": is not a number with a unit, such as 54.8 "
                 "kPa.");
    expect_error(HEAD, &zero, "tau_pre for all rows, \"0 kPa\": must be above 0.");
}

// A column that is full wins over the option: told, for the user expects the reverse.
static void defaults_that_no_row_needs(void **state)
{
    (void)state;
    const clod_locus_defaults sigma = {"10 kPa", NULL};
    const clod_locus_defaults tau = {NULL, "8 kPa"};
    expect_error(HEAD "9,8.5,2,3.4\n9,8.5,4,4.4\n", &sigma,
                 "p.csv: column sigma_pre has a value in every row, so --sigma-pre=\"10 kPa\" "
                 "would change nothing; leave the option out, or remove the column.");
    expect_error(HEAD "9,8.5,2,3.4\n9,8.5,4,4.4\n", &tau,
                 "p.csv: column tau_pre has a value in every row, so --tau-pre=\"8 kPa\" would "
                 "change nothing; leave the option out, or remove the column.");
    clod_locus_point *points;
    assert_int_equal(parse_good(HEAD "9,8.5,2,3.4\n,8.5,4,4.4\n", &sigma, &points), 2);
    assert_near(points[0].sigma_p, 9e3, 1e-15);
    assert_near(points[1].sigma_p, 10e3, 1e-15);
    clod_locus_free(points);
}

static void one_is_no_plural(void **state)
{
    (void)state;
    expect_error(HEAD "10\n", &NONE, "p.csv:2: 1 cell, but the header has 4 columns.");
}

static void wrong_files(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point *points;
    size_t count;
    assert_false(clod_locus_parse("p.csv", "a\0b", 3, &NONE, &points, &count, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, "p.csv: this is no text file; save the table as CSV.");
    assert_false(clod_locus_read("no/such/file.csv", &NONE, &points, &count, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text,
                        "no/such/file.csv: cannot be opened: No such file or directory");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_columns_are_read),
        cmocka_unit_test(units_are_converted),
        cmocka_unit_test(rows_without_preshear_take_the_given_one),
        cmocka_unit_test(many_rows_are_kept),
        cmocka_unit_test(wrong_headers),
        cmocka_unit_test(wrong_rows),
        cmocka_unit_test(empty_columns_at_the_end_are_none),
        cmocka_unit_test(wrong_densities),
        cmocka_unit_test(densities_that_may_be),
        cmocka_unit_test(remarks_are_not_read),
        cmocka_unit_test(wrong_defaults),
        cmocka_unit_test(defaults_that_no_row_needs),
        cmocka_unit_test(one_is_no_plural),
        cmocka_unit_test(wrong_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
