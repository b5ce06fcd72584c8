// Angles that no solid has are refused with file, lines, value and range; those of a run are not.

#include "locus_helpers.h"

#include "analysis/angles.h"
#include "analysis/study_file.h"
#include "output/temp_folder.h"

#define HEAD "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
#define RANGE                                                                                  \
    " deg; it must be 1 to 80 deg. Spheres without friction have 6 deg, and no solid is "      \
    "beyond 80 deg. Have "
#define EXCHANGED " been exchanged, or has one another unit?"

static const double SIGMA[] = {3e3, 4.5e3, 6e3, 7.5e3};

/** Whether points of lines 2 to 5 of a.csv are taken; the status is that of the last call. */
static bool taken(const clod_locus_point *from, clod_status *status)
{
    clod_locus_point points[4];
    for (size_t i = 0; i < 4; i++) {
        points[i] = from[i];
        points[i].row = 2 + i;
    }
    *status = (clod_status){0};
    clod_locus_study *study = clod_study_of_points("a.csv", points, 4, status);
    const bool good = study != NULL;
    clod_locus_study_destroy(&study);
    return good;
}

static void both_ends_of_the_range(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[4];
    points_on_line(3.9e3, 1.01 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    assert_true(taken(points, &status));
    points_on_line(3.9e3, 0.99 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    assert_false(taken(points, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(
        status.text, "a.csv:2, 3, 4, 5: the yield locus at a preshear stress of 10.000 kPa has "
                     "phi_lin = 0.99" RANGE "sigma_sh and tau_sh" EXCHANGED);
    for (int above = 0; above < 2; above++) {
        points_on_line(0.0, (above ? 80.01 : 79.99) * DEG, 10e3, 56e3, SIGMA, 4, points);
        assert_int_equal(taken(points, &status), !above);
    }
    assert_non_null(strstr(status.text, "phi_lin = 80.01" RANGE));
    for (int above = 0; above < 2; above++) {
        points_on_line(1e3, 35.0 * DEG, 10e3, 10e3 * tan((above ? 80.01 : 79.99) * DEG), SIGMA,
                       4, points);
        assert_int_equal(taken(points, &status), !above);
    }
    assert_non_null(strstr(status.text, "phi_sf = 80.01" RANGE "sigma_pre and tau_pre"));
}

// atan(-0.5) = -26.57 deg.
static void a_falling_line(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[4];
    points_on_line(6e3, -26.56505 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    assert_false(taken(points, &status));
    assert_non_null(strstr(status.text, "phi_lin = -26.57" RANGE));
}

// Each seed is a locus: a wrong one is not hidden in a mean of 18 deg. The order of lines is that
// of the points, and of two files each has its own.
static void seeds_and_files(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[8];
    points_on_line(1e3, 35.0 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    points_on_line(4e3, 0.5 * DEG, 10e3, 7.6e3, SIGMA, 4, points + 4);
    for (size_t i = 0; i < 8; i++) {
        points[i].seed = i < 4 ? 3 : 7;
        points[i].row = i < 6 ? 11 + i : i - 4;
    }
    clod_locus_study *study = clod_locus_study_create(points, 8, &status);
    assert_non_null(study);
    assert_within(study->groups[0].locus.phi_lin.value, 17.0 * DEG, 19.0 * DEG);
    const clod_angles_source sources[] = {{"a.csv", 6}, {"b.csv", 8}};
    assert_false(clod_angles_check(study, points, sources, 2, &status));
    const char *told =
        "a.csv:15, 16; b.csv:2, 3: the yield locus at a preshear stress of 10.000 "
        "kPa, seed 7 has phi_lin = 0.50";
    assert_memory_equal(status.text, told, strlen(told));
    clod_locus_study_destroy(&study);
}

// A thousand lines do not fit: the list ends with dots, the sentence is whole.
static void a_long_list_of_lines_is_cut(void **state)
{
    (void)state;
    static clod_status status;
    static clod_locus_point points[1000];
    for (size_t i = 0; i < 1000; i++) {
        points_on_line(4e3, 0.5 * DEG, 10e3, 7.6e3, &SIGMA[i % 4], 1, &points[i]);
        points[i].row = 2 + i;
    }
    assert_null(clod_study_of_points("a.csv", points, 1000, &status));
    assert_non_null(strstr(status.text, "a.csv:2, 3, 4, 5, "));
    assert_non_null(strstr(status.text, ", ...: the yield locus at a preshear"));
    assert_non_null(strstr(status.text, EXCHANGED));
}

// 1 % above its own preshear stress is forgiven; the line is that of the point.
static void a_point_above_its_preshear(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[4];
    points_on_line(1e3, 35.0 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    points[2].sigma_s = 10.09e3;
    assert_true(taken(points, &status));
    points[2].sigma_s = 10.11e3;
    assert_false(taken(points, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_int_equal(
        strncmp(status.text, "a.csv:4: shear at 10.110 kPa after a preshear at 10.000 kPa", 58),
        0);
    points[2].sigma_p = 10.02e3; // its own, and those of the locus together
    assert_true(taken(points, &status));
}

// A comment and an empty line count as lines of the file.
static void a_file_is_refused_and_a_run_is_not(void **state)
{
    static clod_status status;
    char path[PATH_MAX];
    FILE *out = fopen(temp_path(path, state, "points.csv"), "w");
    assert_non_null(out);
    fputs("# made up\n" HEAD "10,7.6,3,5\n\n10,7.6,5,4\n10,7.6,7,3\n", out);
    assert_int_equal(fclose(out), 0);
    assert_null(clod_study_of_file(path, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "points.csv:3, 5, 6: the yield locus at"));
    char lock[PATH_MAX];
    FILE *made =
        fopen(temp_path(lock, state, ".clod-lock"), "w"); // makes it the folder of a run
    assert_non_null(made);
    assert_int_equal(fclose(made), 0);
    clod_locus_study *own = clod_study_of_file(path, &status);
    assert_non_null(own);
    clod_locus_study_destroy(&own);
    out = fopen(path, "w"); // so with a point above its preshear
    assert_non_null(out);
    fputs(HEAD "10,7.6,3,3.1\n10,7.6,5,4.5\n10,7.6,12,9.4\n", out);
    assert_int_equal(fclose(out), 0);
    own = clod_study_of_file(path, &status);
    assert_non_null(own);
    assert_true(has_warning(&own->groups[0].locus, "it consolidates anew"));
    clod_locus_study_destroy(&own);
    out = fopen(path, "w");
    assert_non_null(out);
    fputs(HEAD "10,7.6,3,5\n10,7.6,5,4\n10,7.6,7,3\n", out);
    assert_int_equal(fclose(out), 0);
    char lab[PATH_MAX]; // another table there is a measured one
    assert_int_equal(rename(path, temp_path(lab, state, "lab.csv")), 0);
    assert_null(clod_study_of_file(lab, &status));
    assert_int_equal(rename(lab, path), 0);
    clod_locus_study *study = clod_study_of_run(path, &status);
    assert_non_null(study);
    assert_true(has_warning(&study->groups[0].locus, "The line falls (phi_lin = -26.57 deg)"));
    clod_locus_study_destroy(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_ends_of_the_range),
        cmocka_unit_test(a_falling_line),
        cmocka_unit_test(seeds_and_files),
        cmocka_unit_test(a_long_list_of_lines_is_cut),
        cmocka_unit_test(a_point_above_its_preshear),
        cmocka_unit_test_setup_teardown(a_file_is_refused_and_a_run_is_not, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
