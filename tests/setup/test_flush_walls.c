/**
 * Walls that have a face in common. Expected by hand: grains have a radius of 5 mm, so gaps of less than 0.1 mm are
 * none; sheets are squares of 100 mm of two facets.
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "setup/flush_walls.h"
#include "setup/walls.h"
#include "support/case_of.h"

static char folder[] = "/tmp/clod-flush-XXXXXX";
static char told[4096];
static int count;

static void tell(void *context, const char *text)
{
    (void)context;
    snprintf(told + strlen(told), sizeof told - strlen(told), "%s\n", text);
    count++;
}

/** A file of the folder. */
static FILE *begin_file(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    return out;
}

/** A sheet at z = 0, or a body down to -20 mm, from (x, y) = (0, 0) to 100 mm. */
static void write_files(void)
{
    static const char *const NAMES[3] = {"sheet.obj", "turned.obj", "body.obj"};
    for (int k = 0; k < 3; k++) {
        FILE *out = begin_file(NAMES[k]);
        fprintf(out, "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\n");
        fprintf(out, k == 1 ? "f 1 3 2\nf 1 4 3\n" : "f 1 2 3\nf 1 3 4\n");
        if (k == 2) {
            fprintf(out,
                    "v 0 0 -20\nv 100 0 -20\nv 100 100 -20\nv 0 100 -20\nf 5 7 6\nf 5 8 7\n"
                    "f 1 5 6\nf 1 6 2\nf 2 6 7\nf 2 7 3\nf 3 7 8\nf 3 8 4\nf 4 8 5\nf 4 5 1\n");
        }
        fclose(out);
    }
}

/** What is told of a case with these walls, and with more of it. */
static void look(const char *walls, const char *stage)
{
    char path[64], text[4096];
    clod_status status = {CLOD_OK, ""};
    clod_walls made;
    snprintf(path, sizeof path, "%s/case.yaml", folder);
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: hooke, k1: 1e5 N/m}}\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "time: {design_stress: 1 kPa}\n"
             "grains: [{material: ore, radius: {distribution: uniform, min: 5 mm, max: 6 mm}, "
             "count: 3, region: {box: {min: [0 m, 0 m, 0.5 m], max: [0.1 m, 0.1 m, 0.6 m]}}}]\n"
             "walls: {%s}\n"
             "stages: [{name: run, duration: 1 ms%s}]\n",
             walls, stage);
    clod_case *from = case_at(path, text, NULL, 0);
    if (!clod_setup_walls(from, &made, &status)) {
        fail_msg("%s", status.text);
    }
    told[0] = '\0';
    count = 0;
    clod_setup_flush_doubts(from, &made, 0.0, tell, NULL);
    clod_walls_fini(&made);
    clod_case_destroy(&from);
}

static void expect(const char *walls, const char *words)
{
    look(walls, "");
    if (words == NULL ? count != 0 : count != 1 || strstr(told, words) == NULL) {
        fail_msg("%s: %d told:\n%slacks %s", walls, count, told, words == NULL ? "" : words);
    }
}

#define MESH(file, x, y, z)                                                                    \
    "{mesh: {file: " file ".obj, unit: 1 mm, move: [" x " mm, " y " mm, " z " mm]}}"
#define WALL(name, shapes) name ": {material: ore, shapes: [" shapes "]}, "
#define SHEET WALL("a", MESH("sheet", "0", "0", "0"))
#define B(file, x, y, z) WALL("b", MESH(file, x, y, z))

static void sheets_beside_each_other(void **state)
{
    (void)state;
    // the facet with the corners (100, 0), (200, 0), (200, 100) has an edge's end at the seam, the other its edge:
    // both meet it. The centre of the first: (500/3, 100/3)
    expect(
        SHEET B("sheet", "100", "0", "0"),
        ":6:104: walls.b: 2 of its facets lie in one plane with facets of walls.a, over or right "
        "beside it, the first at (166.7, 33.33, 0) mm: a grain there is pushed by both, so "
        "twice. Make them shapes of one wall, which push once\n");
    expect(SHEET B("sheet", "100.09", "0", "0"), "walls.b: 2 of");
    expect(SHEET B("sheet", "100.11", "0", "0"), NULL);
    expect(SHEET B("turned", "100", "0", "0"), "walls.b: 2 of"); // sheets have no back
    expect(SHEET B("sheet", "100", "0", "0.09"), "walls.b: 2 of");
    expect(SHEET B("sheet", "100", "0", "0.11"), NULL);
    // one wall
    expect(WALL("a", MESH("sheet", "0", "0", "0") ", " MESH("sheet", "100", "0", "0")), NULL);
}

static void sheets_over_each_other(void **state)
{
    (void)state;
    expect(SHEET B("sheet", "30", "20", "0.05"), "walls.b: 2 of");
    expect(SHEET B("sheet", "30", "20", "0.2"), NULL);
    // 0.06 over 100 mm: 0.0 to 0.06 mm at its ends; 0.6 degrees: 1 mm
    expect(SHEET WALL(
               "b",
               "{mesh: {file: sheet.obj, unit: 1 mm, rotate: {axis: [1, 0, 0], angle: 0.034 "
               "deg}}}"),
           "walls.b: 2 of");
    expect(SHEET WALL(
               "b", "{mesh: {file: sheet.obj, unit: 1 mm, rotate: {axis: [1, 0, 0], angle: 0.6 "
                    "deg}}}"),
           NULL);
}

/** They cross, meet at an angle, or stand on each other. */
static void other_neighbours_are_quiet(void **state)
{
    (void)state;
    static const char *const ANGLES[] = {"25", "90", "-90", "150"};
    for (int k = 0; k < 4; k++) {
        char walls[512];
        snprintf(
            walls, sizeof walls,
            SHEET
            "b: {material: ore, shapes: [{mesh: {file: sheet.obj, unit: 1 mm, rotate: {axis: [0, 1, "
            "0], angle: %s deg, point: [50 mm, 0 m, 0 m]}}}]}",
            ANGLES[k]);
        expect(walls, NULL);
    }
}

/** Bodies face to face have nobody between them; their tops in one plane have. */
static void bodies(void **state)
{
    (void)state;
    expect(WALL("a", MESH("body", "0", "0", "0")) B("body", "20", "30", "20"), NULL);
    // top and bottom, and the two sides along y: those over the seam do not count
    expect(WALL("a", MESH("body", "0", "0", "0")) B("body", "100", "0", "0"), "walls.b: 8 of");
    expect(WALL("a", MESH("body", "0", "0", "0")) B("body", "100", "30", "-5"), NULL);
    expect(WALL("a", MESH("body", "0", "0", "0")) B("sheet", "20", "20", "0"), "walls.b: 2 of");
    expect(WALL("a", MESH("body", "0", "0", "0")) B("turned", "20", "20", "0"),
           "walls.b: 2 of");
}

static void planes_and_boxes(void **state)
{
    (void)state;
    const char *const remedy =
        "in one plane with walls.b.shapes.0, over or right beside it, the first at "
        "(66.67, 33.33, 0) mm: a grain there is pushed by both, so twice. Leave the "
        "plane or these facets out\n";
    expect(SHEET WALL("b", "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}"), remedy);
    expect(SHEET WALL("b", "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, -1]}}"), remedy);
    expect(SHEET WALL("b", "{plane: {point: [0 m, 0 m, -0.2 mm], normal: [0, 0, 1]}}"), NULL);
    expect(SHEET WALL("b", "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 1, 0]}}"), NULL);
    // a body that stands on a plane; one that is sunk into it up to its top
    expect(WALL("a", MESH("body", "0", "0", "20"))
               WALL("b", "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}"),
           NULL);
    expect(WALL("a", MESH("body", "0", "0", "0"))
               WALL("b", "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}"),
           "walls.a: 2 of");
    // of its own wall too, since it pushes beside the mesh
    expect(WALL("a", MESH("sheet", "0", "0",
                          "0") ", {plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}"),
           "walls.a: 2 of its facets lie in one plane with walls.a.shapes.1");
    // faces of a box: its top, 20 mm to the right of the sheet, at its edge, beside it
    expect(
        SHEET WALL("b", "{box: {center: [50 mm, 50 mm, -10 mm], size: [30 mm, 30 mm, 20 mm]}}"),
        "walls.a: 2 of its facets lie in one plane with walls.b.shapes.0");
    expect(SHEET WALL("b",
                      "{box: {center: [115 mm, 50 mm, -10 mm], size: [30 mm, 30 mm, 20 mm]}}"),
           "walls.a: 1 of its facets lies in one plane");
    expect(SHEET WALL("b",
                      "{box: {center: [116 mm, 50 mm, -10 mm], size: [30 mm, 30 mm, 20 mm]}}"),
           NULL);
    expect(
        SHEET WALL("b", "{box: {center: [50 mm, 50 mm, -5 mm], size: [30 mm, 30 mm, 20 mm]}}"),
        NULL);
}

#define MOVES(name, more)                                                                      \
    name ": {material: ore, shapes: [" MESH("sheet", "0", "0", "0") "], " more "}, "

/** Only walls that stay beside each other; both may move. */
static void motion(void **state)
{
    (void)state;
    expect(SHEET MOVES("b", "velocity: [1 m/s, 0 m/s, 0 m/s]"), NULL);
    expect(MOVES("a", "velocity: [1 m/s, 0 m/s, 0 m/s]")
               MOVES("b", "velocity: [1 m/s, 0 m/s, 0 m/s]"),
           "walls.b: 2 of");
    expect(MOVES("a", "spin: 1 rad/s, spin_axis: [0, 0, 1]")
               MOVES("b", "spin: 1 rad/s, spin_axis: [0, 0, 1]"),
           "walls.b: 2 of");
    expect(MOVES("a", "spin: 1 rad/s, spin_axis: [0, 0, 1]")
               MOVES("b", "spin: 1 rad/s, spin_axis: [0, 1, 0]"),
           NULL);
    expect(SHEET MOVES("b", "load: {force: 10 N, mass: 1 kg, axis: [0, 0, 1]}"), NULL);
    expect(SHEET MOVES("b", "surface_velocity: [1 m/s, 0 m/s, 0 m/s]"), "walls.b: 2 of");
    look(SHEET B("sheet", "0", "0", "0"), ", walls: {b: {velocity: [1 m/s, 0 m/s, 0 m/s]}}");
    assert_int_equal(count, 0);
}

/** Eight walls in one place are 28 pairs, of which six are told. */
static void many_walls_are_counted(void **state)
{
    (void)state;
    char walls[2048] = "";
    for (int k = 0; k < 8; k++) {
        const size_t used = strlen(walls);
        snprintf(walls + used, sizeof walls - used,
                 "w%d: {material: ore, shapes: [" MESH("sheet", "0", "0", "0") "]}, ", k);
    }
    look(walls, "");
    assert_int_equal(count, 7);
    assert_non_null(strstr(told, "walls: 22 more pairs"));
}

static int begin(void **state)
{
    (void)state;
    if (mkdtemp(folder) == NULL) {
        return 1;
    }
    write_files();
    return 0;
}

static int end(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"sheet.obj", "turned.obj", "body.obj", "case.yaml"};
    for (int k = 0; k < 4; k++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%s", folder, NAMES[k]);
        remove(path);
    }
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sheets_beside_each_other),   cmocka_unit_test(sheets_over_each_other),
        cmocka_unit_test(other_neighbours_are_quiet), cmocka_unit_test(bodies),
        cmocka_unit_test(planes_and_boxes),           cmocka_unit_test(motion),
        cmocka_unit_test(many_walls_are_counted),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
