// Facets near grains are kept once: each has its own place, and all that a facet made anew has.
#include "step/touch_facets.h"

#include "mesh/mesh_maker.h"
#include "support/dice.h"

#define STRIPS 700 // twice as many facets, so slots grow more than once

static clod_surface *plane_of_strips(double height)
{
    maker *self = maker_new();
    for (int k = 0; k < STRIPS; k++) {
        const float x0 = (float)k, x1 = (float)(k + 1), z = (float)height;
        maker_add(self, (float[3]){x0, 0, z}, (float[3]){x1, 0, z}, (float[3]){x1, 1, z});
        maker_add(self, (float[3]){x0, 0, z}, (float[3]){x1, 1, z}, (float[3]){x0, 1, z});
    }
    return maker_surface(self, 0.35);
}

static void check_same(const clod_surface_facet *a, const clod_surface_facet *b)
{
    assert_ptr_equal(a->surface, b->surface);
    assert_int_equal(a->number, b->number);
    assert_int_equal(a->plane, b->plane);
    assert_int_equal(a->patch, b->patch);
    assert_int_equal(a->rims, b->rims);
    assert_memory_equal(a->corner, b->corner, sizeof a->corner);
    assert_memory_equal(a->inward, b->inward, sizeof a->inward);
    assert_memory_equal(a->square, b->square, sizeof a->square);
    assert_memory_equal(&a->normal, &b->normal, sizeof a->normal);
    assert_memory_equal(&a->point, &b->point, sizeof a->point);
}

/** Facets of two surfaces, which have the same numbers, taken in any order and again and again. */
static void each_facet_is_there_once(void **state)
{
    (void)state;
    clod_surface *surface[2] = {plane_of_strips(0.0), plane_of_strips(1.0)};
    static int64_t place[2][2 * STRIPS];
    clod_touch_facets table = {0};
    dice source = {.state = 7};
    for (int round = 0; round < 2; round++) {
        clod_touch_facets_begin(&table);
        assert_int_equal(table.count, 0);
        memset(place, -1, sizeof place);
        size_t distinct = 0;
        for (int k = 0; k < 20000; k++) {
            const int of = dice_pick(&source, 2);
            const uint32_t number = (uint32_t)dice_pick(&source, 2 * STRIPS);
            uint32_t at;
            assert_true(clod_touch_facets_take(&table, surface[of], number, &at));
            distinct += place[of][number] < 0;
            assert_true(place[of][number] < 0 || place[of][number] == at);
            place[of][number] = at;
            assert_int_equal(table.count, distinct);
            const clod_surface_facet made = clod_surface_facet_of(surface[of], number);
            check_same(&table.facet[at], &made);
        }
        assert_true(distinct > 2 * STRIPS); // most of both
    }
    clod_touch_facets_fini(&table);
    clod_surface_release(surface[0]);
    clod_surface_release(surface[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_facet_is_there_once)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
