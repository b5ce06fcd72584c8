// Labels of the parts of a wall's meshes: the cleaned name, and what makes it the only one.

#include <stdio.h>

#include "base/memory.h"
#include "mesh/surface.h"
#include "state/part_labels.h"
#include "state/wear.h"
#include "support/check.h"

/** The surface of a mesh with a facet for each name; a name of NULL ends them. */
static clod_surface *surface_of(const char *const *names)
{
    char text[4096] = "";
    size_t used = 0;
    for (int k = 0; names[k] != NULL; k++) {
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "o %s\nv %d 0 0\nv %d 0 1\nv %d 1 0\nf -3 -2 -1\n", names[k],
                                 2 * k, 2 * k, 2 * k);
        assert_true(used < sizeof text);
    }
    clod_status status = {CLOD_OK, ""};
    const clod_mesh_placing placing = {.unit = 1.0, .scale = 1.0};
    clod_mesh *mesh = clod_mesh_parse("parts.obj", text, used, &placing, &status);
    assert_non_null(mesh);
    clod_surface *surface = clod_surface_make(mesh, NULL, 0.3, &status);
    assert_non_null(surface);
    clod_mesh_destroy(&mesh);
    return surface;
}

/** A wall `w`: NULL is a plane, the rest are names of the parts of a mesh each. */
static clod_wall wall_of(const char *const *const *shapes, int32_t count)
{
    clod_wall wall = {.name = "w", .shape_count = count};
    wall.shapes = clod_memory_alloc((size_t)count, sizeof *wall.shapes);
    assert_non_null(wall.shapes);
    for (int32_t s = 0; s < count; s++) {
        wall.shapes[s].kind = shapes[s] != NULL ? CLOD_SHAPE_MESH : CLOD_SHAPE_PLANE;
        wall.shapes[s].surface = shapes[s] != NULL ? surface_of(shapes[s]) : NULL;
    }
    assert_true(clod_part_labels_make(&wall));
    return wall;
}

static void check_names(const clod_wall *wall, const char *const *expected)
{
    int32_t count = 0;
    for (; expected[count] != NULL; count++) {
        char name[CLOD_WEAR_NAME];
        assert_true(count < clod_wear_faces(wall));
        clod_wear_name(wall, count, name, sizeof name);
        assert_string_equal(name, expected[count]);
    }
    assert_int_equal(clod_wear_faces(wall), count);
}

#define NAMES(...) ((const char *const[]){__VA_ARGS__, NULL})

/** Names of one mesh stay, without what has a meaning in a table; others have their numbers. */
static void names_of_their_own_stay(void **state)
{
    (void)state;
    clod_wall wall = wall_of(
        (const char *const *const[]){NAMES("run 1", "a,b [m]", "\"q\";", "<b>&amp", ""), NULL},
        2);
    check_names(&wall, NAMES("w.run 1", "w.a_b _m_", "w._q__", "w.<b>&amp", "w.5", "w.6"));
    clod_wall_fini(&wall);
    wall = wall_of((const char *const *const[]){NULL}, 1);
    check_names(&wall, NAMES("w"));
    clod_wall_fini(&wall);
}

/** The number of the shape, counted with those that are no meshes. */
static void shapes_tell_equal_names_apart(void **state)
{
    (void)state;
    clod_wall wall = wall_of(
        (const char *const *const[]){NULL, NAMES("left", "hood"), NAMES("left", "right")}, 3);
    check_names(&wall, NAMES("w.1", "w.2.left", "w.hood", "w.3.left", "w.right"));
    assert_true(clod_part_labels_asked(wall.shapes[1].surface, 0, "left"));
    assert_true(clod_part_labels_asked(wall.shapes[1].surface, 0, "2.left"));
    assert_false(clod_part_labels_asked(wall.shapes[1].surface, 0, "3.left"));
    assert_false(clod_part_labels_asked(wall.shapes[1].surface, 1, "left"));
    clod_wall_fini(&wall);
}

/** Names that are equal once they are clean, that are numbers of surfaces without a name, and that
 *  are what others would get: every one is the only one. */
static void nothing_is_called_alike(void **state)
{
    (void)state;
    clod_wall wall = wall_of((const char *const *const[]){NAMES("a,b", "a;b", "1.a_b", "5"),
                                                          NAMES("", "5", "a_b", "07"), NULL},
                             3);
    check_names(&wall, NAMES("w.1.a_b (2)", "w.1.a_b (3)", "w.1.a_b", "w.1.5", "w.5", "w.2.5",
                             "w.2.a_b", "w.07", "w.9"));
    clod_wall_fini(&wall);
}

/** Names are whole: those that are alike in their first 254 bytes too. */
static void long_names_are_whole(void **state)
{
    (void)state;
    char one[CLOD_MESH_NAME_MOST + 1], two[CLOD_MESH_NAME_MOST + 1], name[CLOD_WEAR_NAME];
    memset(one, 'x', sizeof one);
    one[CLOD_MESH_NAME_MOST] = '\0';
    memcpy(two, one, sizeof two);
    two[CLOD_MESH_NAME_MOST - 1] = 'y';
    clod_wall wall = wall_of((const char *const *const[]){NAMES(one, two), NAMES(one, "z")}, 2);
    for (int32_t face = 0; face < 3; face++) {
        static const char *const BEFORE[] = {"w.1.", "w.", "w.2."};
        char expected[CLOD_WEAR_NAME];
        snprintf(expected, sizeof expected, "%s%s", BEFORE[face], face == 1 ? two : one);
        clod_wear_name(&wall, face, name, sizeof name);
        assert_string_equal(name, expected);
    }
    clod_wall_fini(&wall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_of_their_own_stay),
        cmocka_unit_test(shapes_tell_equal_names_apart),
        cmocka_unit_test(nothing_is_called_alike),
        cmocka_unit_test(long_names_are_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
