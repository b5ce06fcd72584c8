// Points near a segment: the tree finds what looking at every point finds.

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/mesh_points.h"
#include "support/check.h"

#define MOST 3000

static uint64_t dice = 7;

static double roll(void)
{
    dice = dice * 6364136223846793005u + 1442695040888963407u;
    return (double)(dice >> 11) * 0x1p-53;
}

/** Distance along the segment when the point is within reach, else -1. */
static double look(const double a[3], const double b[3], const double p[3], double reach)
{
    double length2 = 0.0, dot = 0.0, off2 = 0.0;
    for (int k = 0; k < 3; k++) {
        length2 += (b[k] - a[k]) * (b[k] - a[k]);
        dot += (b[k] - a[k]) * (p[k] - a[k]);
    }
    const double along = dot / sqrt(length2);
    for (int k = 0; k < 3; k++) {
        const double off = p[k] - a[k] - (b[k] - a[k]) * dot / length2;
        off2 += off * off;
    }
    const bool inside = along > reach && along < sqrt(length2) - reach;
    return inside && sqrt(off2) <= reach ? along : -1.0;
}

/** Compare for one set of points; clustered along a line, in a plane, or in space. */
static void compare(size_t count, int flat, double reach)
{
    static double places[MOST][3];
    static uint32_t points[MOST];
    for (size_t k = 0; k < count; k++) {
        points[k] = (uint32_t)k;
        for (int c = 0; c < 3; c++) {
            places[k][c] = c < flat ? roll() : 0.25;
        }
    }
    clod_mesh_points tree;
    clod_mesh_hits hits = {0};
    size_t all = 0;
    assert_true(clod_mesh_points_init(&tree, (const double(*)[3])places, points, count));
    for (int s = 0; s < 100; s++) {
        const double *a = places[(size_t)(roll() * (double)count)];
        const double *b = places[(size_t)(roll() * (double)count)];
        if (a == b) {
            continue;
        }
        assert_true(clod_mesh_points_near(&tree, a, b, reach, &hits));
        size_t expected = 0;
        for (size_t k = 0; k < count; k++) {
            expected += look(a, b, places[k], reach) >= 0.0;
        }
        assert_int_equal(hits.count, expected);
        for (size_t h = 0; h < hits.count; h++) {
            check_close(hits.items[h].along, look(a, b, places[hits.items[h].point], reach),
                        1e-12);
            assert_true(h == 0 || hits.items[h].along >= hits.items[h - 1].along);
        }
        all += hits.count;
    }
    assert_true(count < 1000 || all > 100);
    clod_memory_free(hits.items);
    clod_mesh_points_fini(&tree);
}

static void the_tree_finds_what_brute_force_finds(void **state)
{
    (void)state;
    for (int flat = 1; flat <= 3; flat++) {
        compare(2, flat, 0.1);
        compare(9, flat, 0.1);
        compare(100, flat, 0.05);
        compare(MOST, flat, 0.03);
    }
}

/** Boxes that are looked at for a long segment between random points, a mean over 500. */
static double boxes_of(size_t count, int flat)
{
    static double places[20 * MOST][3];
    static uint32_t points[20 * MOST];
    assert_true(count <= sizeof points / sizeof points[0]);
    for (size_t k = 0; k < count; k++) {
        points[k] = (uint32_t)k;
        for (int c = 0; c < 3; c++) {
            places[k][c] = c < flat ? roll() : 0.1 * roll() * places[k][0];
        }
    }
    clod_mesh_points tree;
    clod_mesh_hits hits = {0};
    assert_true(clod_mesh_points_init(&tree, (const double(*)[3])places, points, count));
    for (size_t s = 0; s < 500; s++) {
        assert_true(
            clod_mesh_points_near(&tree, places[2 * s], places[2 * s + 1], 1e-7, &hits));
    }
    clod_memory_free(hits.items);
    clod_mesh_points_fini(&tree);
    return (double)hits.boxes / 500.0;
}

/** Boxes that a line passes grow as the cube root of the points, a factor of 2 for 8 times as many. Numbers
 *  beside a power of two are the worst: half of the tree's leaves have no points. */
static void a_long_segment_passes_few_boxes(void **state)
{
    (void)state;
    const double few = boxes_of(4200, 3), many = boxes_of(8 * 4200, 3);
    assert_true(many < 2.5 * few);
    assert_true(many < 400.0); // of 16383
    assert_true(boxes_of(60000, 3) < 500.0);
    assert_true(boxes_of(33000, 2) < 500.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tree_finds_what_brute_force_finds),
        cmocka_unit_test(a_long_segment_passes_few_boxes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
