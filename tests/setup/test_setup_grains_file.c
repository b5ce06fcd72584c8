// Grains from CSV files: columns, units, and where errors are said to be.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "setup/grains_file.h"
#include "support/check.h"

static clod_case_material materials[2] = {{.name = "ore", .density = 2500.0},
                                          {.name = "steel", .density = 7800.0}};

/** What came of reading a text as a file. */
typedef struct reading {
    clod_grains grains;
    uint64_t next_id;
    clod_status status;
    bool good;
} reading;

static reading read_bytes(const char *text, size_t length, char *material)
{
    reading r = {.next_id = 1};
    char path[] = P_tmpdir "/clod-grains-XXXXXX";
    const int file = mkstemp(path);
    assert_true(file >= 0);
    assert_true(write(file, text, length) == (ssize_t)length);
    close(file);
    const clod_case from = {.materials = materials, .material_count = 2};
    const clod_case_grains group = {.material = material, .file = path};
    r.good = clod_grains_file_read(&from, &group, &r.next_id, &r.grains, &r.status);
    remove(path);
    return r;
}

static reading read_text(const char *text, char *material)
{
    return read_bytes(text, strlen(text), material);
}

/** The text is refused and the message ends as expected after the file's name. */
static void check_refused(const char *text, char *material, const char *expected)
{
    reading r = read_text(text, material);
    assert_false(r.good);
    assert_int_equal(r.status.code, CLOD_USAGE);
    const char *colon = strchr(r.status.text, ':');
    assert_non_null(colon);
    assert_string_equal(colon + 1, expected);
    clod_grains_fini(&r.grains);
}

static void si_units_are_taken_as_they_are(void **state)
{
    (void)state;
    reading r = read_text("id,x [m],y [m],z [m],r [m],vx [m/s],vy [m/s],vz [m/s]\n"
                          "7,0.1,0.2,0.3,0.004,1,2,3\n"
                          "5,0.4,0.5,0.6,0.005,-1,-2,-3\n",
                          "ore");
    assert_true(r.good);
    assert_int_equal(r.grains.count, 2);
    assert_int_equal(r.grains.id[0], 7);
    assert_int_equal(r.grains.id[1], 5);
    assert_int_equal(r.next_id, 8);
    const double place[4] = {0.4, 0.5, 0.6, 0.005};
    assert_memory_equal(r.grains.position[1], place, sizeof place);
    assert_true(r.grains.velocity[1][0] == -1.0 && r.grains.velocity[1][2] == -3.0);
    check_relative(r.grains.velocity[0][3], 2500.0 * 4.0 / 3.0 * M_PI * 6.4e-8, 1e-14);
    clod_grains_fini(&r.grains);
}

static void columns_in_any_order_with_units_and_materials(void **state)
{
    (void)state;
    reading r = read_text("# packed by hand\r\n"
                          "material, radius [mm] ,z [cm],y [mm],x [m],wz [rpm],vx [mm/s]\r\n"
                          "\r\n"
                          "steel, 2 ,3,4,5,60,7\r\n"
                          " ore,2,3,4,5,60,7",
                          NULL);
    assert_true(r.good);
    assert_int_equal(r.grains.count, 2);
    assert_int_equal(r.grains.material[0], 1);
    assert_int_equal(r.grains.material[1], 0);
    assert_int_equal(r.grains.id[0], 1);
    assert_int_equal(r.grains.id[1], 2);
    check_close(r.grains.position[0][0], 5.0, 1e-15);
    check_close(r.grains.position[0][1], 4e-3, 1e-17);
    check_close(r.grains.position[0][2], 3e-2, 1e-17);
    check_close(r.grains.position[0][3], 2e-3, 1e-17);
    check_close(r.grains.velocity[0][0], 7e-3, 1e-17);
    check_close(r.grains.angular_velocity[0][2], 2.0 * M_PI,
                1e-14); // 60 rpm is one turn per second
    clod_grains_fini(&r.grains);
}

static void errors_say_line_and_column(void **state)
{
    (void)state;
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,3\n", "ore",
                  "2:1: 3 values, but the header has 4 columns");
    check_refused("x [m],y [m],z [m],radius [m]\n\n1,2,abc,4\n", "ore",
                  "3:5: \"abc\": a number is expected; units belong into the header: x [mm]");
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,3 mm,4\n", "ore",
                  "2:5: \"3 mm\": a number is expected; units belong into the header: x [mm]");
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,nan,4\n", "ore",
                  "2:5: \"nan\": a number is expected; units belong into the header: x [mm]");
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,,4\n", "ore",
                  "2:5: \"\": a number is expected");
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,3,-4\n", "ore",
                  "2:7: \"-4\": a radius must be from 1 nm to 10 m");
    check_refused("x [m],y [m],z [m],radius [m]\n1,2,3,1e-300\n", "ore",
                  "2:7: \"1e-300\": a radius must be from 1 nm to 10 m");
    check_refused("x [m],y [m],z [m],radius [m]\n1,1e300,3,1\n", "ore",
                  "2:3: \"1e300\": a position must be within 10 km of the origin");
    check_refused("x [m],y [m],z [m],radius [m],id\n1,2,3,4,1.5\n", "ore",
                  "2:9: \"1.5\": an id must be a whole number, 0 or more");
    check_refused("x [m],y [m],z [m],radius [m],material\n1,2,3,4,iron\n", "ore",
                  "2:9: \"iron\": no material of the case has this name");
}

static void wrong_headers_are_refused(void **state)
{
    (void)state;
    check_refused("", "ore",
                  "1:1: the file is empty; its first line names the columns and their units: "
                  "id, x [mm], y [mm], z [mm], radius [mm]");
    check_refused("x [m],y [m],radius [m]\n", "ore", "1:1: there is no column \"z\"");
    check_refused("x [m],y [m],z [m],radius [m],x [m]\n", "ore",
                  "1:30: \"x [m]\": this column is there twice");
    check_refused("x [m],y [m],z [m],radius [m]\n", NULL,
                  "1:1: there is no column \"material\", and the group of grains names no "
                  "material either");
    check_refused("x [m],y [m],z [m],radius [m],mass\n", "ore",
                  "1:30: \"mass\": unknown column; there are x, y, z, radius (or r), and "
                  "optional id, vx, vy, vz, wx, wy, wz, material");
    check_refused(
        "x [mm,y,z,radius\n", "ore",
        "1:1: \"x [mm\": the unit's bracket is not closed; write for instance x [mm]");
    check_refused("x [m],y [m],z [m],radius [m],id [m]\n", "ore",
                  "1:30: \"id [m]\": this column takes no such unit");
}

// Numbers meant in mm must not be read as m in silence.
static void quantity_without_unit_is_refused(void **state)
{
    (void)state;
    check_refused(
        "id,x,y [mm],z [mm],radius [mm]\n1,1,2,3,4\n", "ore",
        "1:4: \"x\": the unit is missing; write x [mm], or whichever unit the numbers "
        "have");
    check_refused(
        "# made by hand\nx [m],y [m],z [m], r \n", "ore",
        "2:20: \"r\": the unit is missing; write r [mm], or whichever unit the numbers "
        "have");
    check_refused("x [m],y [m],z [m],r [m],vy\n", "ore",
                  "1:25: \"vy\": the unit is missing; write vy [m/s], or whichever unit the "
                  "numbers have");
    check_refused("x [m],y [m],z [m],r [m],wz\n", "ore",
                  "1:25: \"wz\": the unit is missing; write wz [rad/s], or whichever unit the "
                  "numbers have");
}

static void wrong_unit_is_refused(void **state)
{
    (void)state;
    reading r = read_text("x [kg],y [m],z [m],radius [m]\n", "ore");
    assert_false(r.good);
    assert_non_null(strstr(r.status.text, ":1:1: \"x [kg]\": "));
    clod_grains_fini(&r.grains);
}

static void missing_file_is_named(void **state)
{
    (void)state;
    const clod_case from = {.materials = materials, .material_count = 2};
    const clod_case_grains group = {.material = "ore", .file = "no/such/file.csv"};
    clod_grains grains = {0};
    clod_status status = {0};
    uint64_t next_id = 1;
    assert_false(clod_grains_file_read(&from, &group, &next_id, &grains, &status));
    assert_string_equal(status.text,
                        "no/such/file.csv: cannot be opened: No such file or directory");
}

// A file larger than one read, its last line without an end.
static void long_file_is_read_whole(void **state)
{
    (void)state;
    enum { ROWS = 20000 };
    char *text = malloc(64 * ROWS);
    size_t length = (size_t)sprintf(text, "x [m],y [m],z [m],r [m]\n");
    for (int k = 0; k < ROWS; k++) {
        length +=
            (size_t)sprintf(text + length, "%d,0,0,1%s", k % 10000, k + 1 < ROWS ? "\n" : "");
    }
    reading r = read_bytes(text, length, "ore");
    assert_true(r.good);
    assert_int_equal(r.grains.count, ROWS);
    assert_true(r.grains.position[ROWS - 1][0] == 9999.0);
    clod_grains_fini(&r.grains);
    free(text);
}

// A 0 byte ends the text for strlen; the rest must not be dropped in silence.
static void zero_byte_is_refused(void **state)
{
    (void)state;
    const char text[] = "x [m],y [m],z [m],r [m]\n1,2,3,4\n\0001,2,3,4\n";
    reading r = read_bytes(text, sizeof text - 1, "ore");
    assert_false(r.good);
    assert_non_null(strstr(r.status.text, ": it is no text file"));
    clod_grains_fini(&r.grains);
}

// Spreadsheets put a byte order mark before the header; columns are counted without it.
static void byte_order_mark_is_skipped(void **state)
{
    (void)state;
    reading r = read_text("\xEF\xBB\xBFx [m],y [m],z [m],r [m]\n1,2,3,4\n", "ore");
    assert_true(r.good);
    assert_int_equal(r.grains.count, 1);
    assert_true(r.grains.position[0][0] == 1.0);
    clod_grains_fini(&r.grains);
    check_refused("\xEF\xBB\xBFx [kg],y [m],z [m],r [m]\n", "ore",
                  "1:1: \"x [kg]\": 1 kg is not a length; use a unit such as mm");
    check_refused("x [m],y [m],z [m],r [m]\n1\n", "ore",
                  "2:1: 1 value, but the header has 4 columns");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(si_units_are_taken_as_they_are),
        cmocka_unit_test(columns_in_any_order_with_units_and_materials),
        cmocka_unit_test(errors_say_line_and_column),
        cmocka_unit_test(wrong_headers_are_refused),
        cmocka_unit_test(quantity_without_unit_is_refused),
        cmocka_unit_test(wrong_unit_is_refused),
        cmocka_unit_test(missing_file_is_named),
        cmocka_unit_test(long_file_is_read_whole),
        cmocka_unit_test(zero_byte_is_refused),
        cmocka_unit_test(byte_order_mark_is_skipped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
