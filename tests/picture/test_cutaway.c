/**
 * @file test_cutaway.c
 * Faces, planes without an end and veils, on a box whose answer is plain.
 */

#include "picture/cutaway.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "support/check.h"

/** The twelve triangles of a box from 0 to 1, and one grain in its middle. */
static void make_box(clod_scene *scene)
{
    *scene = (clod_scene){.corner = clod_memory_alloc(12, sizeof *scene->corner),
                          .wall = clod_memory_alloc(12, sizeof *scene->wall),
                          .part = clod_memory_alloc(12, sizeof *scene->part),
                          .veiled = clod_memory_alloc(12, 1),
                          .center = clod_memory_alloc(1, sizeof *scene->center),
                          .radius = clod_memory_alloc(1, sizeof *scene->radius),
                          .spheres = 1};
    scene->radius[0] = 0.1;
    for (int face = 0; face < 6; face++) {
        const int n = face / 2;
        double q[4][3];
        for (int k = 0; k < 4; k++) {
            q[k][n] = face % 2;
            q[k][(n + 1) % 3] = k == 1 || k == 2;
            q[k][(n + 2) % 3] = k >= 2;
        }
        const int order[2][3] = {{0, 1, 2}, {0, 2, 3}};
        for (int half = 0; half < 2; half++) {
            for (int c = 0; c < 3; c++) {
                memcpy(scene->corner[scene->triangles][c], q[order[half][c]], sizeof q[0]);
            }
            scene->triangles++;
        }
    }
    for (int d = 0; d < 3; d++) {
        scene->center[0][d] = 0.5;
    }
}

/** Six faces of two triangles; twelve edges, and no line along the diagonals. */
static void a_box_has_six_faces_and_twelve_edges(void **state)
{
    (void)state;
    clod_scene scene;
    clod_faces faces;
    clod_status status;
    make_box(&scene);
    assert_true(clod_faces_make(&faces, &scene, &status));
    assert_int_equal(faces.count, 6);
    assert_int_equal(scene.lines, 12);
    for (int t = 0; t < 12; t++) {
        assert_int_equal(faces.face[t], t / 2);
        for (int c = 0; c < 3; c++) { // flat: the face's own direction, up to the side
            check_close(fabs(scene.normal[t][c][t / 4]), 1.0, 1e-12);
        }
    }
    clod_faces_fini(&faces);
    clod_scene_fini(&scene);
}

/** From -y the face y = 0 (triangles 4 and 5) hides the grain, and nothing else does. */
static void only_the_near_face_is_veiled(void **state)
{
    (void)state;
    clod_scene scene;
    clod_faces faces;
    clod_status status;
    make_box(&scene);
    assert_true(clod_faces_make(&faces, &scene, &status));
    assert_true(clod_cutaway_veil(&scene, &faces, (clod_vec3){0.4, -5.0, 0.6}, &status));
    for (int t = 0; t < 12; t++) {
        assert_int_equal(scene.veiled[t], t == 4 || t == 5);
    }
    clod_faces_fini(&faces);
    clod_scene_fini(&scene);
}

/** A tube about z, of 24 strips: one face, whose near half hides the grain within. */
static void a_tube_is_veiled_on_the_near_side(void **state)
{
    (void)state;
    enum { STRIPS = 24 };
    clod_scene scene = {.corner = clod_memory_alloc(2 * STRIPS, sizeof *scene.corner),
                        .wall = clod_memory_alloc(2 * STRIPS, sizeof *scene.wall),
                        .part = clod_memory_alloc(2 * STRIPS, sizeof *scene.part),
                        .veiled = clod_memory_alloc(2 * STRIPS, 1),
                        .center = clod_memory_alloc(1, sizeof *scene.center),
                        .radius = clod_memory_alloc(1, sizeof *scene.radius),
                        .spheres = 1,
                        .triangles = 2 * STRIPS};
    for (int k = 0; k < 2 * STRIPS; k++) {
        const double a = 2.0 * M_PI * (k / 2) / STRIPS;
        const double b = 2.0 * M_PI * ((k / 2 + 1) % STRIPS) / STRIPS;
        const double low_a[3] = {cos(a), sin(a), -1.0};
        const double low_b[3] = {cos(b), sin(b), -1.0};
        const double high_a[3] = {cos(a), sin(a), 1.0};
        const double high_b[3] = {cos(b), sin(b), 1.0};
        // every other triangle goes round the other way: faces must not depend on that
        memcpy(scene.corner[k][0], k % 2 == 0 ? low_a : high_b, sizeof low_a);
        memcpy(scene.corner[k][1], low_b, sizeof low_a);
        memcpy(scene.corner[k][2], k % 2 == 0 ? high_a : high_a, sizeof low_a);
    }
    clod_faces faces;
    clod_status status;
    assert_true(clod_faces_make(&faces, &scene, &status));
    assert_int_equal(faces.count, 1);
    assert_int_equal(scene.lines, 2 * STRIPS); // both rims
    assert_true(clod_cutaway_veil(&scene, &faces, (clod_vec3){0.01, -9.0, 0.02}, &status));
    for (int k = 0; k < 2 * STRIPS; k++) {
        const double middle = 2.0 * M_PI * (k / 2 + 0.5) / STRIPS;
        assert_int_equal(scene.veiled[k], -9.0 * sin(middle) > 1.0); // the eye is before it
    }
    clod_faces_fini(&faces);
    clod_scene_fini(&scene);
}

/** A flat strip from x = 0 to `squares` at y = 0, one face, each square a part; grains behind it. */
static void make_strip(clod_scene *scene, int squares, int grains)
{
    const size_t n = 2 * (size_t)squares;
    *scene = (clod_scene){.corner = clod_memory_alloc(n, sizeof *scene->corner),
                          .wall = clod_memory_alloc(n, sizeof *scene->wall),
                          .part = clod_memory_alloc(n, sizeof *scene->part),
                          .veiled = clod_memory_alloc(n, 1),
                          .center = clod_memory_alloc((size_t)grains, sizeof *scene->center),
                          .radius = clod_memory_alloc((size_t)grains, sizeof *scene->radius),
                          .spheres = (size_t)grains,
                          .triangles = n};
    for (size_t t = 0; t < n; t++) {
        const double x = (double)(t / 2);
        const double corner[2][3][3] = {{{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 0, 1}},
                                        {{x, 0, 0}, {x + 1, 0, 1}, {x, 0, 1}}};
        memcpy(scene->corner[t], corner[t % 2], sizeof corner[0]);
        scene->part[t] = (int32_t)(t / 2) - 1; // the first has no name
    }
}

static void veil_strip(clod_scene *scene)
{
    clod_faces faces;
    clod_status status;
    assert_true(clod_faces_make(&faces, scene, &status));
    assert_int_equal(faces.count, 1);
    assert_true(clod_cutaway_veil(scene, &faces, (clod_vec3){25.0, -1e5, 0.5}, &status));
    clod_faces_fini(&faces);
}

/** Of three squares of a face the middle one hides both grains: the others are no veils, be they
 *  parts with a name or not. Without parts the face is one veil. */
static void parts_of_a_face_are_judged_apart(void **state)
{
    (void)state;
    for (int named = 0; named < 2; named++) {
        clod_scene scene;
        make_strip(&scene, 3, 2);
        for (int g = 0; g < 2; g++) {
            memcpy(scene.center[g], (double[3]){1.3 + 0.4 * g, 0.5, 0.4},
                   sizeof scene.center[g]);
        }
        for (int t = 0; t < 6; t++) {
            scene.part[t] = named ? scene.part[t] : -1;
        }
        veil_strip(&scene);
        for (int t = 0; t < 6; t++) {
            assert_int_equal(scene.veiled[t], !named || t / 2 == 1);
        }
        clod_scene_fini(&scene);
    }
}

/** Each of 50 parts hides one of 100 grains, too few for a veil; together they hide 50, and all of
 *  them are veils but for that with nothing behind it. Where 99 grains are seen and one is
 *  hidden, none is. */
static void many_parts_that_hide_few_grains_each_are_veiled(void **state)
{
    (void)state;
    for (int hidden = 1; hidden <= 50; hidden += 49) {
        clod_scene scene;
        make_strip(&scene, 51, 100);
        for (int g = 0; g < 100; g++) {
            const double y = g < hidden ? 0.5 : -0.5;
            memcpy(scene.center[g], (double[3]){0.5 + g % 50, y, 0.5}, sizeof scene.center[g]);
        }
        veil_strip(&scene);
        for (int t = 0; t < 102; t++) {
            assert_int_equal(scene.veiled[t], hidden == 50 && t / 2 < 50);
        }
        clod_scene_fini(&scene);
    }
}

static double area(double (*const t)[3])
{
    const clod_vec3 a = clod_vec3_of(t[0]);
    return 0.5 * clod_vec3_length(clod_vec3_cross(clod_vec3_sub(clod_vec3_of(t[1]), a),
                                                  clod_vec3_sub(clod_vec3_of(t[2]), a)));
}

/** A square of 20 by 20, cut to a box of 1 by 2, has that area; one beyond it has none. */
static void planes_end_at_the_box(void **state)
{
    (void)state;
    double corner[2][3][3] = {{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}},
                              {{-10, -10, 0}, {10, 10, 0}, {-10, 10, 0}}};
    double piece[CLOD_CUTAWAY_PIECES][3][3];
    clod_cutaway_box box = {{0.0, 1.0, -1.0}, {1.0, 3.0, 1.0}};
    size_t count = clod_cutaway_clip(&box, corner, piece);
    double sum = 0.0;
    for (size_t k = 0; k < count; k++) {
        sum += area(piece[k]);
    }
    check_close(sum, 2.0, 1e-12);
    box.min[2] = 0.5;
    assert_int_equal(clod_cutaway_clip(&box, corner, piece), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_has_six_faces_and_twelve_edges),
        cmocka_unit_test(only_the_near_face_is_veiled),
        cmocka_unit_test(a_tube_is_veiled_on_the_near_side),
        cmocka_unit_test(parts_of_a_face_are_judged_apart),
        cmocka_unit_test(many_parts_that_hide_few_grains_each_are_veiled),
        cmocka_unit_test(planes_end_at_the_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
