// A large mesh beside a small piece of it: a grain finds the same facets and the same contacts, and
// looks at no others.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"
#include "support/dice.h"

#define SPACING 0x1p-6 ///< m, between the points of the sheet
#define SIDE 224       ///< squares of the large one along a side: 100 352 facets
#define PIECE 12       ///< of the small one
#define FIRST 150      ///< where that begins
#define RADIUS 0.02
#define REACH 0.03
#define MOST 64 ///< facets near a grain

/** A corner of the sheet, which has waves. */
static void corner(int i, int j, float to[3])
{
    to[0] = (float)(i * SPACING);
    to[1] = (float)(j * SPACING);
    to[2] = (float)(0.01 * sin(9.0 * i * SPACING) * cos(7.0 * j * SPACING));
}

static clod_surface *sheet(int from, int side)
{
    maker *made = maker_new();
    for (int k = 0; k < side * side; k++) {
        const int i = from + k / side, j = from + k % side;
        float p[4][3];
        for (int c = 0; c < 4; c++) {
            corner(i + (c == 1 || c == 2), j + (c >= 2), p[c]);
        }
        maker_add(made, p[0], p[1], p[2]);
        maker_add(made, p[0], p[2], p[3]);
    }
    return maker_surface(made, 0.35);
}

static int by_place(const void *left, const void *right)
{
    return memcmp(left, right, 3 * sizeof(clod_vec3));
}

/** Corners of the facets that a grain looks at, sorted; how many. */
static int32_t facets_near(const touching *found, clod_vec3 to[MOST][3])
{
    assert_true(found->count <= MOST);
    for (int32_t k = 0; k < found->count; k++) {
        memcpy(to[k], found->facet[k].corner, sizeof to[k]);
    }
    qsort(to, (size_t)found->count, sizeof *to, by_place);
    return found->count;
}

static void a_large_mesh_is_its_pieces(void **state)
{
    (void)state;
    clod_surface *large = sheet(0, SIDE), *small = sheet(FIRST, PIECE);
    assert_int_equal(large->facet_count, 2 * SIDE * SIDE);
    dice roll = {4};
    int with = 0, facets = 0;
    for (int k = 0; k < 3000; k++) { // inside of the piece, farther from its rim than the reach
        const clod_vec3 p = {SPACING * (FIRST + dice_real(&roll, 3.0, PIECE - 3.0)),
                             SPACING * (FIRST + dice_real(&roll, 3.0, PIECE - 3.0)),
                             dice_real(&roll, -0.03, 0.03)};
        static touching in_large, in_small;
        static clod_vec3 a[MOST][3], b[MOST][3];
        touching_near(&in_large, large, p, REACH);
        touching_near(&in_small, small, p, REACH);
        const int32_t count = facets_near(&in_large, a);
        assert_int_equal(count, facets_near(&in_small, b));
        assert_memory_equal(a, b, (size_t)count * sizeof *a);
        const int contacts = touching_find(&in_large, p, RADIUS);
        assert_int_equal(contacts, touching_find(&in_small, p, RADIUS));
        for (int c = 0; c < contacts; c++) {
            const clod_surface_closest *at = &in_large.contact[c]->at;
            const clod_surface_closest *same = &in_small.contact[c]->at;
            check_close(at->distance, same->distance, 1e-9); // planes are fitted
            check_close(clod_vec3_dot(at->direction, same->direction), 1.0, 1e-9);
        }
        with += contacts > 0;
        facets += count;
    }
    assert_true(with > 1000 && facets > 10000);
    clod_surface_release(large);
    clod_surface_release(small);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_large_mesh_is_its_pieces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
