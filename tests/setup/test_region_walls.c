/**
 * Walls that reach into the regions of grains. Expected by hand: the smallest grain has a diameter of 10 mm, so a
 * region counts from 10 mm within its sides; a box of 100 mm about the origin to 40 mm from it.
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "setup/region_walls.h"
#include "setup/walls.h"
#include "support/case_of.h"

#define BOX                                                                                    \
    "region: {box: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 50 mm]}}, count: 3"
#define RING                                                                                   \
    "region: {annulus: {center: [0 mm, 0 mm, -50 mm], inner_radius: 20 mm, outer_radius: 50 "  \
    "mm, height: 100 mm}}, count: 3"
// grains come 1 mm in a millisecond: the last 11 mm below the face hold the smallest
#define FACE                                                                                   \
    "region: {disc: {center: [0 mm, 0 mm, 80 mm], normal: [0, 0, -1], radius: 30 mm}}, "       \
    "velocity: [0 m/s, 0 m/s, -1 m/s], inlet: {mass_flow: 1 kg/s}"
#define SLOT                                                                                   \
    "region: {rectangle: {center: [0 mm, 0 mm, 80 mm], edge_1: [60 mm, 0 mm, 0 mm], edge_2: "  \
    "[0 mm, -20.2 mm, 0 mm]}}, velocity: [0 m/s, 0 m/s, -1 m/s], inlet: {mass_flow: 0.1 kg/s}"

static char folder[] = "/tmp/clod-region-XXXXXX";
static char told[2048];

static void tell(void *context, const char *text)
{
    (void)context;
    snprintf(told + strlen(told), sizeof told - strlen(told), "%s\n", text);
}

typedef struct subject {
    clod_case *from;
    clod_walls walls;
} subject;

/** A group of grains and the shapes of the wall "w". */
static subject make(const char *group, const char *shapes, const char *more)
{
    char path[64], text[2048];
    clod_status status = {CLOD_OK, ""};
    snprintf(path, sizeof path, "%s/case.yaml", folder);
    snprintf(
        text, sizeof text,
        "materials: {ore: {density: 2500 kg/m3}}\n"
        "contacts: {default: {law: hooke, k1: 1e5 N/m}}\n"
        "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
        "time: {design_stress: 1 kPa}\n"
        "grains: [{material: ore, radius: {distribution: uniform, min: 5 mm, max: 6 mm}, %s}]\n"
        "walls: {w: {material: ore, shapes: [{%s}]%s}}\n"
        "stages: [{name: run, duration: 1 ms}]\n",
        group, shapes, more);
    subject self = {.from = case_at(path, text, NULL, 0)};
    if (!clod_setup_walls(self.from, &self.walls, &status)) {
        fail_msg("%s", status.text);
    }
    return self;
}

static void drop(subject *self)
{
    clod_walls_fini(&self->walls);
    clod_case_destroy(&self->from);
}

/** What is told of them; NULL: nothing. */
static void expect(const char *group, const char *shapes, const char *words)
{
    subject self = make(group, shapes, "");
    told[0] = '\0';
    clod_setup_regions_doubts(self.from, &self.walls, true, tell, NULL);
    if (words == NULL ? told[0] != '\0' : strstr(told, words) == NULL) {
        fail_msg("%s beside %s: %s lacks %s", shapes, group, told, words == NULL ? "" : words);
    }
    drop(&self);
}

static void planes(void **state)
{
    (void)state;
    expect(BOX, "plane: {point: [0 m, 0 m, -41 mm], normal: [0, 0, 1]}", NULL);
    expect(
        BOX, "plane: {point: [0 m, 0 m, -39 mm], normal: [0, 0, 1]}",
        ":5:81: grains.0.region: walls.w.shapes.0 reaches through it, at (0, 0, -0.039) m: no grain comes "
        "behind this plane. Move or shorten the region, or the wall\n");
    // the edge at x = y = 40 mm is 56.57 mm away along (1, 1, 0); 57 mm and 56 mm are 40.305 and 39.598 mm in x
    expect(BOX, "plane: {point: [40.305 mm, 40.305 mm, 0 m], normal: [-1, -1, 0]}", NULL);
    expect(BOX, "plane: {point: [39.598 mm, 39.598 mm, 0 m], normal: [-1, -1, 0]}", "behind");
    // the ring has no edge: 40 mm along every level direction
    expect(RING, "plane: {point: [29 mm, 29 mm, 0 m], normal: [-1, -1, 0]}", NULL);
    expect(RING, "plane: {point: [28 mm, 28 mm, 0 m], normal: [-1, -1, 0]}", "behind");
}

static void solids(void **state)
{
    (void)state;
    expect(BOX, "box: {center: [60 mm, 0 m, 0 m], size: [38 mm, 5 mm, 5 mm]}", NULL);
    expect(BOX, "box: {center: [60 mm, 0 m, 0 m], size: [42 mm, 5 mm, 5 mm]}",
           "no grain comes in this solid");
    expect(BOX, "box: {center: [0 m, 0 m, 0 m], size: [1 mm, 1 mm, 1 mm]}",
           "solid"); // all around it
    expect(RING, "box: {center: [0 m, 0 m, 0 m], size: [42 mm, 42 mm, 5 mm]}", NULL); // 29.7 mm
    expect(RING, "box: {center: [0 m, 0 m, 0 m], size: [43 mm, 43 mm, 5 mm]}",
           "solid"); // 30.4 mm
    // flat before the ring: the middle of its face is nearest
    expect(RING, "box: {center: [60 mm, 0 m, 0 m], size: [38 mm, 90 mm, 5 mm]}", NULL);
    expect(RING, "box: {center: [60 mm, 0 m, 0 m], size: [42 mm, 90 mm, 5 mm]}", "solid");
    expect(
        BOX,
        "bar: {from: [-200 mm, 0 m, 0 m], to: [-39 mm, 0 m, 0 m], width: 2 mm, height: 2 mm, "
        "up: [0, 0, 1]}",
        "solid");
}

static void discs(void **state)
{
    (void)state;
    expect(BOX, "disc: {center: [0 m, 0 m, 41 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
    expect(BOX, "disc: {center: [0 m, 0 m, 39 mm], normal: [0, 0, 1], radius: 20 mm}",
           "grains come on both sides of it");
    expect(RING, "disc: {center: [0 m, 0 m, 0 m], normal: [0, 0, 1], radius: 29 mm}", NULL);
    expect(RING, "disc: {center: [0 m, 0 m, 0 m], normal: [0, 0, 1], radius: 31 mm}",
           "both sides");
    expect(
        RING,
        "annulus: {center: [0 m, 0 m, 0 m], normal: [0, 0, 1], inner_radius: 41 mm, outer_radius: "
        "60 mm}",
        NULL);
    expect(BOX, "disc: {center: [0 m, 0 m, 0 m], normal: [1, 0, 0], radius: 200 mm}",
           "both sides");
    // grains come on the inner side of a shell alone
    expect(
        BOX,
        "cylinder: {foot: [0 m, 0 m, -30 mm], axis: [0, 0, 1], radius: 20 mm, length: 60 mm, side: "
        "inside}",
        NULL);
}

/** A facet across the corner: x + y + z = 121 mm misses the cube of 40 mm, 119 mm does not; all its bounds are
 *  within the other's either way. */
static void facets(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "%s/sheet.obj", folder);
    for (int c = 119; c <= 121; c += 2) {
        FILE *out = fopen(path, "w");
        assert_non_null(out);
        fprintf(out,
                "o far\nv 900 0 0\nv 901 0 0\nv 900 1 0\nf 1 2 3\n"
                "o lip\nv %d 0 0\nv 0 %d 0\nv 0 0 %d\nf 4 5 6\n",
                c, c, c);
        fclose(out);
        expect(
            BOX,
            "plane: {point: [0 m, 0 m, -1 m], normal: [0, 0, 1]}}, {mesh: {file: sheet.obj, unit: 1 mm}",
            c == 119 ? "walls.w.shapes.1, part lip reaches through it, at (0.03967, 0.03967, "
                       "0.03967) m: grains come on both sides"
                     : NULL);
    }
    remove(path);
}

/** 5 mm before the face is within reach; at the face, 20 mm before it and 5 mm beside it are not. */
static void faces(void **state)
{
    (void)state;
    expect(FACE, "disc: {center: [0 m, 0 m, 75 mm], normal: [0, 0, 1], radius: 20 mm}",
           "both sides");
    expect(FACE, "disc: {center: [0 m, 0 m, 80 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
    expect(FACE, "disc: {center: [0 m, 0 m, 60 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
    expect(FACE, "disc: {center: [45 mm, 0 m, 75 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
    expect(FACE, "disc: {center: [35 mm, 0 m, 75 mm], normal: [0, 0, 1], radius: 20 mm}",
           "both sides");
    // of a slot of 60 mm x 20.2 mm what counts is 40 mm x 0.2 mm
    expect(SLOT, "disc: {center: [39 mm, 0 m, 75 mm], normal: [0, 0, 1], radius: 20 mm}",
           "both sides");
    expect(SLOT, "disc: {center: [41 mm, 0 m, 75 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
    expect(SLOT, "disc: {center: [0 m, 21 mm, 75 mm], normal: [0, 0, 1], radius: 20 mm}", NULL);
}

/** A region that is thinner than two grains has no two sides. */
static void thin_regions_are_not_cut(void **state)
{
    (void)state;
    expect("region: {box: {min: [-50 mm, -50 mm, -9 mm], max: [50 mm, 50 mm, 9 mm]}}, count: 3",
           "disc: {center: [0 m, 0 m, 0 m], normal: [0, 0, 1], radius: 20 mm}", NULL);
}

/** A run from another's grains puts none, so only inlets count. */
static void packings_can_be_left_out(void **state)
{
    (void)state;
    const char *const groups[] = {BOX, FACE};
    for (int k = 0; k < 2; k++) {
        subject self =
            make(groups[k],
                 "disc: {center: [0 m, 0 m, 75 mm], normal: [1, 0, 0], radius: 100 mm}", "");
        told[0] = '\0';
        clod_setup_regions_doubts(self.from, &self.walls, false, tell, NULL);
        assert_int_equal(told[0] != '\0', k == 1);
        drop(&self);
    }
}

static void reach(const char *group, const char *shapes, const char *more, const char *words)
{
    clod_status status = {CLOD_OK, ""};
    subject self = make(group, shapes, more);
    const bool reached = clod_setup_regions_reached(self.from, &self.walls, &status);
    assert_int_equal(reached, words == NULL);
    assert_true(reached || (status.code == CLOD_USAGE && strstr(status.text, words) != NULL));
    drop(&self);
}

static void regions_that_nothing_can_reach(void **state)
{
    (void)state;
    reach(
        BOX, "plane: {point: [0 m, 0 m, 51 mm], normal: [0, 0, 1]}", "",
        "grains.0.region: all of it lies behind the plane walls.w.shapes.0, where no grain can be. Move "
        "the region, or turn the normal of the plane to it");
    reach(BOX, "plane: {point: [0 m, 0 m, 49 mm], normal: [0, 0, 1]}", "", NULL);
    reach(
        BOX,
        "plane: {point: [0 m, 0 m, -1 m], normal: [0, 0, 1]}}, {box: {center: [0 m, 0 m, 0 m], size: [102 mm, 102 "
        "mm, 102 mm]}",
        "",
        "grains.0.region: all of it lies in the solid walls.w.shapes.1, where no grain can be. Move the "
        "region or the wall");
    reach(BOX, "box: {center: [0 m, 0 m, 0 m], size: [102 mm, 102 mm, 98 mm]}", "", NULL);
    // the ring in a box that its corners would not be in: turned by 45 degrees, 102 mm wide
    reach(
        RING,
        "bar: {from: [-51 mm, -51 mm, 0 m], to: [51 mm, 51 mm, 0 m], width: 102 mm, height: 102 mm, up: [0, 0, 1]}",
        "", "in the solid");
    reach(
        RING,
        "bar: {from: [-51 mm, -51 mm, 0 m], to: [51 mm, 51 mm, 0 m], width: 98 mm, height: 102 mm, up: [0, 0, 1]}",
        "", NULL);
    // an inlet may open when the wall has gone; grains that are put are put at once
    reach(FACE, "plane: {point: [0 m, 0 m, 90 mm], normal: [0, 0, 1]}", "", "behind the plane");
    reach(FACE, "plane: {point: [0 m, 0 m, 90 mm], normal: [0, 0, 1]}",
          ", velocity: [0 m/s, 0 m/s, -1 m/s]", NULL);
    reach(BOX, "plane: {point: [0 m, 0 m, 90 mm], normal: [0, 0, 1]}",
          ", velocity: [0 m/s, 0 m/s, -1 m/s]", "behind the plane");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes),
        cmocka_unit_test(solids),
        cmocka_unit_test(discs),
        cmocka_unit_test(facets),
        cmocka_unit_test(faces),
        cmocka_unit_test(thin_regions_are_not_cut),
        cmocka_unit_test(packings_can_be_left_out),
        cmocka_unit_test(regions_that_nothing_can_reach),
    };
    if (mkdtemp(folder) == NULL) {
        return EXIT_FAILURE;
    }
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
