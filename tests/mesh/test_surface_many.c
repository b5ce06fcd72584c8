// A large mesh beside a small piece of it: a grain finds the same facets and the same contacts, and
// looks at no others.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/surface_touch.h"
#include "support/dice.h"

#define SPACING 0x1p-6 ///< m, between the points of the sheet
#define SIDE 224       ///< squares of the large one along a side: 100 352 facets
#define PIECE 12       ///< of the small one
#define FIRST 150      ///< where that begins
#define RADIUS 0.02
#define REACH 0.03
#define MOST 64

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
    clod_mesh *mesh = maker_read(made, &METRES);
    clod_status status;
    clod_surface *surface = clod_surface_make(mesh, NULL, 0.35, &status);
    assert_non_null(surface);
    clod_mesh_destroy(&mesh);
    return surface;
}

typedef struct list {
    const clod_surface *surface;
    clod_surface_facet facet[MOST];
    int32_t count;
} list;

static double note(void *context, uint32_t facet, double reach)
{
    list *self = context;
    assert_true(self->count < MOST);
    self->facet[self->count++] = clod_surface_facet_of(self->surface, facet);
    return reach;
}

static int by_place(const void *left, const void *right)
{
    return memcmp(left, right, 3 * sizeof(clod_vec3));
}

/** Corners of the facets that a grain looks at, sorted; how many. */
static int32_t facets_near(const list *found, clod_vec3 to[MOST][3])
{
    for (int32_t k = 0; k < found->count; k++) {
        memcpy(to[k], found->facet[k].corner, sizeof to[k]);
    }
    qsort(to, (size_t)found->count, sizeof *to, by_place);
    return found->count;
}

static int contacts_of(const list *found, clod_vec3 p, clod_surface_closest *contact)
{
    clod_surface_hit hits[MOST];
    const int32_t count = clod_surface_touch(found->facet, found->count, p, RADIUS, hits);
    int contacts = 0;
    for (int32_t k = 0; k < count; k++) {
        if (hits[k].root == k) {
            contact[contacts++] = hits[k].at;
        }
    }
    return contacts;
}

static void a_large_mesh_is_its_pieces(void **state)
{
    (void)state;
    clod_surface *large = sheet(0, SIDE), *small = sheet(FIRST, PIECE);
    assert_int_equal(large->facet_count, 2 * SIDE * SIDE);
    dice roll = {4};
    int touching = 0, facets = 0;
    for (int k = 0; k < 3000; k++) { // inside of the piece, farther from its rim than the reach
        const clod_vec3 p = {SPACING * (FIRST + dice_real(&roll, 3.0, PIECE - 3.0)),
                             SPACING * (FIRST + dice_real(&roll, 3.0, PIECE - 3.0)),
                             dice_real(&roll, -0.03, 0.03)};
        static list in_large, in_small;
        static clod_vec3 a[MOST][3], b[MOST][3];
        in_large = (list){.surface = large};
        in_small = (list){.surface = small};
        clod_surface_near(large, p, REACH, note, &in_large);
        clod_surface_near(small, p, REACH, note, &in_small);
        const int32_t count = facets_near(&in_large, a);
        assert_int_equal(count, facets_near(&in_small, b));
        assert_memory_equal(a, b, (size_t)count * sizeof *a);
        clod_surface_closest found[MOST], twin[MOST];
        const int contacts = contacts_of(&in_large, p, found);
        assert_int_equal(contacts, contacts_of(&in_small, p, twin));
        for (int c = 0; c < contacts; c++) {
            check_close(found[c].distance, twin[c].distance, 1e-9); // planes are fitted
            check_close(clod_vec3_dot(found[c].direction, twin[c].direction), 1.0, 1e-9);
        }
        touching += contacts > 0;
        facets += count;
    }
    assert_true(touching > 1000 && facets > 10000);
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
