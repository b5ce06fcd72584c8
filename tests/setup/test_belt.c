// Conveyor belts as meshes: areas, places and normals by elementary geometry.

#include <math.h>
#include <string.h>

#include "base/vec3.h"
#include "setup/belt.h"
#include "support/check.h"

static clod_status status;

static clod_setup_belt made(const clod_case_belt *belt)
{
    const clod_setup_belt self = clod_setup_belt_make(belt, "feed", &status);
    if (self.mesh == NULL) {
        fail_msg("%s", status.text);
    }
    return self;
}

static clod_vec3 corner(const clod_mesh_view *view, size_t facet, int c)
{
    return clod_vec3_of(view->vertices[view->facets[facet][c]]);
}

/** Twice the area of a facet along its normal [m2]. */
static clod_vec3 area_of(const clod_mesh_view *view, size_t facet)
{
    const clod_vec3 a = corner(view, facet, 0);
    return clod_vec3_cross(clod_vec3_sub(corner(view, facet, 1), a),
                           clod_vec3_sub(corner(view, facet, 2), a));
}

/** Area of a part by its name [m2]; there is such a part. */
static double part_area(const clod_setup_belt *self, const char *name)
{
    const clod_mesh_view *view = clod_mesh_look(self->mesh);
    double area = 0.0;
    size_t facets = 0;
    for (size_t f = 0; f < view->facet_count; f++) {
        if (strcmp(view->parts[view->part[f]].name, name) == 0) {
            area += 0.5 * clod_vec3_length(area_of(view, f));
            facets++;
        }
    }
    assert_true(facets > 0);
    return area;
}

/** Nothing to repair: no duplicate, no sliver, nothing crossed; open edges at its rim alone. */
static void check_sound(const clod_setup_belt *self)
{
    clod_mesh_report report;
    assert_true(clod_mesh_examine(self->mesh, 0.0, &report, &status));
    static const clod_mesh_kind NONE[] = {
        CLOD_MESH_DEGENERATE, CLOD_MESH_DUPLICATE,   CLOD_MESH_TURNED,  CLOD_MESH_TWISTED,
        CLOD_MESH_T,          CLOD_MESH_NONMANIFOLD, CLOD_MESH_OVERLAP, CLOD_MESH_CROSSING};
    for (int k = 0; k < 8; k++) {
        assert_int_equal(report.findings[NONE[k]].count, 0);
    }
}

static clod_case_belt_run LEVEL[] = {{.length = 3.0}};
static clod_case_belt_run BENT[] = {{.length = 2.0}, {.length = 1.5, .rise = 0.2}};

static void a_flat_belt_has_the_area_of_its_width(void **state)
{
    (void)state;
    const double wrap = 3.0, radius = 0.3, width = 0.8;
    const clod_case_belt belt = {.heading = {1.0, 0.0, 0.0},
                                 .runs = BENT,
                                 .run_count = 2,
                                 .width = width,
                                 .speed = 2.0,
                                 .pulley = {radius, wrap, 0.7}};
    clod_setup_belt self = made(&belt);
    check_sound(&self);
    const double facets = ceil(wrap / CLOD_BELT_FACET);
    check_close(part_area(&self, "run 1"), 2.0 * width, 1e-6);
    check_close(part_area(&self, "run 2"), 1.5 * width, 1e-6);
    check_close(part_area(&self, "pulley"),
                2.0 * radius * facets * sin(0.5 * wrap / facets) * width, 1e-6);
    check_close(part_area(&self, "return"), 0.7 * width, 1e-6);
    clod_setup_belt_fini(&self);
}

/** The developed width is that of the belt, with wings up or, behind the transition, flat. */
static void a_trough_keeps_the_width(void **state)
{
    (void)state;
    const clod_case_belt belt = {.heading = {1.0, 0.0, 0.0},
                                 .runs = LEVEL,
                                 .run_count = 1,
                                 .width = 1.2,
                                 .idler_angle = 0.7,
                                 .middle_roll = 0.4,
                                 .speed = 2.0};
    clod_setup_belt self = made(&belt);
    check_sound(&self);
    check_close(part_area(&self, "run 1"), 3.0 * 1.2, 1e-6);
    const clod_mesh_view *view = clod_mesh_look(self.mesh);
    double most_y = 0.0, most_z = 0.0;
    for (size_t v = 0; v < view->vertex_count; v++) {
        most_y = fmax(most_y, fabs(view->vertices[v][1]));
        most_z = fmax(most_z, view->vertices[v][2]);
    }
    check_close(most_y, 0.2 + 0.4 * cos(0.7), 1e-6);
    check_close(most_z, 0.4 * sin(0.7), 1e-6);
    for (size_t f = 0; f < view->facet_count; f++) {
        assert_true(area_of(view, f).z > 0.0); // normals look at the ore
    }
    clod_setup_belt_fini(&self);
}

/** Facets of 0.15 m at most: the same shape without T-junctions, though nothing divides evenly. */
static void facets_are_as_small_as_asked(void **state)
{
    (void)state;
    clod_case_belt belt = {.heading = {1.0, 0.0, 0.0},
                           .runs = BENT,
                           .run_count = 2,
                           .width = 1.2,
                           .idler_angle = 0.5,
                           .middle_roll = 0.5,
                           .transition = 0.7,
                           .speed = 2.0,
                           .pulley = {0.3, 2.0, 0.7},
                           .skirts = {.from = 0.5, .to = 2.5, .distance = 0.6, .height = 0.4}};
    static const char *const PARTS[] = {"run 1", "run 2", "pulley", "return", "skirts"};
    clod_setup_belt coarse = made(&belt);
    belt.facet = 0.15;
    clod_setup_belt fine = made(&belt);
    check_sound(&fine);
    const clod_mesh_view *view = clod_mesh_look(fine.mesh);
    for (size_t k = 0; k < sizeof PARTS / sizeof *PARTS; k++) {
        const double twisted = strcmp(PARTS[k], "run 2") == 0 ? 5e-3 : 1e-6; // the transition
        check_close(part_area(&fine, PARTS[k]), part_area(&coarse, PARTS[k]), twisted);
    }
    for (size_t f = 0; f < view->facet_count; f++) {
        for (int c = 0; c < 3;
             c++) { // two sides, and the diagonal; a mitre stretches by 1/cos(0.1)
            const clod_vec3 side =
                clod_vec3_sub(corner(view, f, (c + 1) % 3), corner(view, f, c));
            assert_true(clod_vec3_length(side) < 0.15 * sqrt(2.0) * 1.02);
        }
    }
    // run 1: 14 along, 3 and 4 and 3 across, two facets each
    size_t facets = 0;
    for (size_t f = 0; f < view->facet_count; f++) {
        facets += strcmp(view->parts[view->part[f]].name, "run 1") == 0;
    }
    assert_int_equal(facets, 14 * 10 * 2);
    clod_setup_belt_fini(&fine);
    clod_setup_belt_fini(&coarse);
}

/** Points of the pulley lie on its circle, and its material moves there with the belt's speed. */
static void a_pulley_turns_with_the_belt(void **state)
{
    (void)state;
    clod_case_belt_run run[] = {{.length = 2.0, .rise = -0.15}};
    const clod_case_belt belt = {.from = {1.0, -2.0, 3.0},
                                 .heading = {0.6, 0.8, 0.0},
                                 .runs = run,
                                 .run_count = 1,
                                 .width = 0.8,
                                 .idler_angle = 0.5,
                                 .transition = 0.9,
                                 .speed = 1.7,
                                 .pulley = {0.25, 2.0, 0.0}};
    clod_setup_belt self = made(&belt);
    check_sound(&self);
    const clod_mesh_view *view = clod_mesh_look(self.mesh);
    const clod_case_surface *turns = &self.parts[1];
    const clod_vec3 axis = clod_vec3_of(turns->spin_axis);
    const clod_vec3 middle = clod_vec3_of(turns->spin_point);
    // by hand: the end of the run, and the radius down from there across the run
    const double ahead = 2.0 * cos(0.15) - 0.25 * sin(0.15);
    check_close(middle.x, 1.0 + 0.6 * ahead, 1e-12);
    check_close(middle.y, -2.0 + 0.8 * ahead, 1e-12);
    check_close(middle.z, 3.0 - 2.0 * sin(0.15) - 0.25 * cos(0.15), 1e-12);
    for (size_t f = 0; f < view->facet_count; f++) {
        const bool pulley = strcmp(view->parts[view->part[f]].name, "pulley") == 0;
        for (int c = 0; pulley && c < 3; c++) {
            const clod_vec3 arm = clod_vec3_sub(corner(view, f, c), middle);
            const clod_vec3 out = clod_vec3_axpy(arm, -clod_vec3_dot(arm, axis), axis);
            check_close(clod_vec3_length(out), 0.25, 2e-6);
            const clod_vec3 v = clod_vec3_scale(clod_vec3_cross(axis, out), turns->spin);
            check_close(clod_vec3_length(v), 1.7, 1e-5);
            assert_true(clod_vec3_dot(area_of(view, f), out) > 0.0);
        }
    }
    const clod_vec3 along = clod_vec3_of(self.parts[0].direction);
    check_close(self.parts[0].speed, 1.7, 0.0);
    check_close(along.x, cos(0.15) * 0.6, 1e-12);
    check_close(along.y, cos(0.15) * 0.8, 1e-12);
    check_close(along.z, -sin(0.15), 1e-12);
    clod_setup_belt_fini(&self);
}

static void skirts_stand_along_both_sides(void **state)
{
    (void)state;
    const clod_case_belt belt = {
        .heading = {1.0, 0.0, 0.0},
        .runs = BENT,
        .run_count = 2,
        .width = 0.8,
        .idler_angle = 0.5,
        .middle_roll = 0.3,
        .speed = 2.0,
        .skirts = {.from = 0.5, .to = 1.5, .distance = 0.6, .gap = 0.01, .height = 0.25}};
    clod_setup_belt self = made(&belt);
    check_sound(&self);
    check_close(part_area(&self, "skirts"), 2.0 * 0.25, 1e-6);
    const clod_mesh_view *view = clod_mesh_look(self.mesh);
    for (size_t f = 0; f < view->facet_count; f++) {
        const bool skirts = strcmp(view->parts[view->part[f]].name, "skirts") == 0;
        for (int c = 0; skirts && c < 3; c++) {
            const clod_vec3 at = corner(view, f, c);
            const double low = (0.3 - 0.15) * tan(0.5) + 0.01;
            check_close(fabs(at.y), 0.3, 1e-6);
            assert_true(at.x > 0.5 - 1e-6 && at.x < 1.5 + 1e-6);
            check_close(fabs(at.z - low - 0.125), 0.125, 1e-6);
        }
    }
    clod_setup_belt_fini(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flat_belt_has_the_area_of_its_width),
        cmocka_unit_test(a_trough_keeps_the_width),
        cmocka_unit_test(facets_are_as_small_as_asked),
        cmocka_unit_test(a_pulley_turns_with_the_belt),
        cmocka_unit_test(skirts_stand_along_both_sides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
