// What a picture of a mesh tells of each facet: meshes by hand with one fault each.

#include "picture/mesh_picture.h"

#include <string.h>

#include "support/check.h"

#define BOX                                                                                    \
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"                 \
    "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\n"                          \
    "f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n" // facet 2 7 6 is missing

/** The faults of a mesh are those; ended by -1. */
static void check_faults(const char *text, const int *faults)
{
    clod_status status;
    const clod_mesh_placing placing = {.unit = 1.0, .scale = 1.0};
    clod_mesh *mesh = clod_mesh_parse("a.obj", text, strlen(text), &placing, &status);
    assert_non_null(mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    for (size_t f = 0; f < view->facet_count; f++) {
        assert_int_equal(clod_mesh_picture_fault(view, f), faults[f]);
    }
    assert_int_equal(faults[view->facet_count], -1);
    clod_mesh_destroy(&mesh);
}

enum {
    GOOD = CLOD_MESH_FAULT_NONE,
    TWICE = CLOD_MESH_FAULT_DUPLICATE,
    TURNED = CLOD_MESH_FAULT_TURNED,
    OPEN = CLOD_MESH_FAULT_OPEN,
    THREE = CLOD_MESH_FAULT_NONMANIFOLD,
    T_EDGE = CLOD_MESH_FAULT_T,
    NEEDLE = CLOD_MESH_FAULT_NEEDLE,
    SLIVER = CLOD_MESH_FAULT_SLIVER,
    CROSS = CLOD_MESH_FAULT_CROSSING,
};
#define TEN GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD

static void a_closed_box_is_good(void **state)
{
    (void)state;
    check_faults(BOX "f 2 7 6\n", (const int[]){TEN, GOOD, GOOD, -1});
}

/** Of equal ones the first stays, and knows of the two that went. */
static void facets_with_one_fault(void **state)
{
    (void)state;
    check_faults(BOX "f 2 7 6\nf 1 2 3\nf 3 2 1\n",
                 (const int[]){TWICE, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD, GOOD,
                               GOOD, GOOD, -1});
    check_faults(BOX "f 2 6 7\n", (const int[]){TEN, GOOD, TURNED, -1});
    // three edges of the hole, of facets 3, 5 and 7
    check_faults(BOX, (const int[]){GOOD, GOOD, OPEN, GOOD, OPEN, GOOD, OPEN, GOOD, GOOD, GOOD,
                                    GOOD, -1});
}

static void edges_of_several_facets(void **state)
{
    (void)state;
    check_faults("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 -1\n"
                 "f 1 2 3\nf 1 2 4\nf 1 2 5\n",
                 (const int[]){THREE, THREE, THREE, -1});
    // vertex 4 lies inside the edge of facet 1
    check_faults("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0 0\nv 0.5 -1 0\nv 1.5 -1 0\n"
                 "f 1 2 3\nf 1 5 4\nf 4 6 2\nf 4 5 6\n",
                 (const int[]){T_EDGE, T_EDGE, T_EDGE, OPEN, -1});
}

/** A triangle goes through another one; a third stands on it. Theirs are open edges too, which is less grave. */
static void facets_that_cross(void **state)
{
    (void)state;
    check_faults("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 2 -1\nv 1 1 1\n"
                 "v 0.5 0.5 0\nv 0.5 1 0\nv 0.5 0.5 1\nf 1 2 3\nf 4 5 6\nf 7 8 9\n",
                 (const int[]){CROSS, CROSS, OPEN, -1});
}

static void thin_facets(void **state)
{
    (void)state;
    check_faults("v 0 0 0\nv 1 0 0\nv 0.5 0.005 0\nv 0 0 1\nv 1 0 1\nv 1 0.005 1\n"
                 "f 1 2 3\nf 4 5 6\n",
                 (const int[]){SLIVER, NEEDLE, -1});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_box_is_good),
        cmocka_unit_test(facets_with_one_fault),
        cmocka_unit_test(edges_of_several_facets),
        cmocka_unit_test(facets_that_cross),
        cmocka_unit_test(thin_facets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
