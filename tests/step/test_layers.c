// The order of grains in memory: layers, lines, places; partners are near in it.
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "step/layers.h"
#include "support/check.h"
#include "support/dice.h"

#define GRAINS 4000
#define RADIUS 0.5

/** Grains at random in a box, as dense as a bed (0.6 of its volume). */
static void fill(double (*place)[4], const double side[3], uint64_t seed)
{
    dice roll = {seed};
    for (int g = 0; g < GRAINS; g++) {
        for (int a = 0; a < 3; a++) {
            place[g][a] = dice_real(&roll, -3.0, side[a] - 3.0);
        }
        place[g][3] = RADIUS;
    }
}

static void sort(double (*place)[4], clod_layers *layers)
{
    static clod_sort_item items[GRAINS], scratch[GRAINS];
    static double old[GRAINS][4];
    *layers = clod_layers_of((const double(*)[4])place, GRAINS);
    memcpy(old, place, sizeof old);
    for (size_t g = 0; g < GRAINS; g++) {
        items[g] = (clod_sort_item){clod_layers_key(layers, place[g]), g};
    }
    clod_sort(items, scratch, GRAINS);
    for (size_t g = 0; g < GRAINS; g++) {
        memcpy(place[g], old[items[g].index], sizeof *place);
    }
}

static double length(const double a[4], const double b[4])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/** Layers across y, lines across x, places along z: by the lengths of the sides. */
static void test_longest_side_first(void **state)
{
    (void)state;
    static double place[GRAINS][4];
    clod_layers layers;
    fill(place, (double[3]){15.0, 29.0, 8.0}, 3);
    sort(place, &layers);
    double low[2] = {INFINITY, INFINITY};
    for (int g = 0; g < GRAINS; g++) {
        low[0] = fmin(low[0], place[g][1]);
        low[1] = fmin(low[1], place[g][0]);
    }
    for (int g = 1; g < GRAINS; g++) {
        const double layer = floor(place[g][1] - low[0]) - floor(place[g - 1][1] - low[0]);
        const double line = floor(place[g][0] - low[1]) - floor(place[g - 1][0] - low[1]);
        assert_true(layer == 1.0 || layer == 0.0);
        assert_true(layer == 1.0 || line == 1.0 || line == 0.0);
        if (layer == 0.0 && line == 0.0) {
            assert_true(place[g][2] >= place[g - 1][2]);
        }
    }
}

/** Grains that touch are in the same layer or in the next: fewer rows apart than two layers. */
static void test_partners_are_near(void **state)
{
    (void)state;
    static double place[GRAINS][4];
    clod_layers layers;
    fill(place, (double[3]){15.0, 29.0, 8.0}, 5);
    sort(place, &layers);
    const size_t fullest = clod_layers_fullest(&layers, (const double(*)[4])place, GRAINS);
    assert_in_range(fullest, GRAINS / 29, GRAINS / 15);
    size_t pairs = 0, within = 0;
    for (size_t i = 0; i < GRAINS; i++) {
        for (size_t j = i + 1; j < GRAINS; j++) {
            if (length(place[i], place[j]) < 2.0 * RADIUS) {
                assert_true(j - i < 2 * fullest);
                pairs++;
                within += j - i <= fullest;
            }
        }
    }
    assert_true(pairs > GRAINS);
    assert_true((double)within > 0.95 * (double)pairs);
}

/** With radii of 1 and 2 the largest grains reach over the next layer, never farther. */
static void test_unequal_partners_are_near(void **state)
{
    (void)state;
    static double place[GRAINS][4];
    clod_layers layers;
    fill(place, (double[3]){15.0, 29.0, 8.0}, 7);
    for (size_t g = 0; g < GRAINS; g++) {
        place[g][3] = g % 8 == 0 ? RADIUS : 0.5 * RADIUS;
    }
    sort(place, &layers);
    const size_t fullest = clod_layers_fullest(&layers, (const double(*)[4])place, GRAINS);
    size_t pairs = 0, within = 0;
    for (size_t i = 0; i < GRAINS; i++) {
        for (size_t j = i + 1; j < GRAINS; j++) {
            if (length(place[i], place[j]) < place[i][3] + place[j][3]) {
                assert_true(j - i < 3 * fullest);
                pairs++;
                within += 3 * (j - i) <= 4 * fullest; // 2 r_max / (r_min + r_max)
            }
        }
    }
    assert_true(pairs > GRAINS / 4);
    assert_true((double)within > 0.95 * (double)pairs);
}

#define MANY 40000

/** Layers of ten thousand grains are cut into two strips, each with all its layers. */
static void test_large_layers_are_cut_into_strips(void **state)
{
    (void)state;
    static double place[MANY][4];
    static clod_sort_item items[MANY], scratch[MANY];
    const double side[3] = {3.8, 4.0, 3.9};
    double low[3] = {INFINITY, INFINITY, INFINITY}, high = 0.0;
    dice roll = {11};
    for (size_t g = 0; g < MANY; g++) {
        for (int a = 0; a < 3; a++) {
            place[g][a] = dice_real(&roll, 0.0, side[a]);
            low[a] = fmin(low[a], place[g][a]);
        }
        place[g][3] = RADIUS;
        high = fmax(high, place[g][2]);
    }
    const clod_layers layers = clod_layers_of((const double(*)[4])place, MANY);
    assert_true(layers.strips == 2.0);
    for (size_t g = 0; g < MANY; g++) {
        items[g] = (clod_sort_item){clod_layers_key(&layers, place[g]), g};
    }
    clod_sort(items, scratch, MANY);
    size_t seen[2][4] = {{0}};
    int before = 0; // strip, layer and line in one number
    for (size_t g = 0; g < MANY; g++) {
        const double *here = place[items[g].index];
        const int strip = here[2] - low[2] >= 0.5 * (high - low[2]) ? 1 : 0;
        const int layer = (int)(here[1] - low[1]), line = (int)(here[2] - low[2]);
        seen[strip][layer]++;
        const int now = 100 * strip + 10 * layer + line;
        assert_true(now >= before);
        before = now;
    }
    for (int strip = 0; strip < 2; strip++) {
        for (int layer = 0; layer < 4; layer++) {
            assert_in_range(seen[strip][layer], 4700, 5300);
        }
    }
}

/** Beds without a side: no grain, one grain, all at one place, a row of them far apart. */
static void test_flat_beds(void **state)
{
    (void)state;
    double place[3][4] = {
        {1.0, 2.0, 3.0, RADIUS}, {1.0, 2.0, 3.0, RADIUS}, {1.0, 2.0, 3.0, RADIUS}};
    const double(*rows)[4] = (const double(*)[4])place;
    for (size_t count = 0; count <= 3; count++) {
        const clod_layers layers = clod_layers_of(rows, count);
        assert_int_equal(clod_layers_fullest(&layers, rows, count), count);
        assert_true(clod_layers_key(&layers, place[0]) == clod_layers_key(&layers, place[1]));
    }
    place[1][2] = 3.0 + 1e9; // more diameters than a key has steps
    place[2][2] = 3.0 + 2e9;
    const clod_layers layers = clod_layers_of(rows, 3);
    assert_int_equal(layers.axis[0], 2);
    assert_int_equal(clod_layers_fullest(&layers, rows, 3), 1);
    assert_true(clod_layers_key(&layers, place[0]) < clod_layers_key(&layers, place[1]));
    assert_true(clod_layers_key(&layers, place[1]) < clod_layers_key(&layers, place[2]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_longest_side_first),
        cmocka_unit_test(test_partners_are_near),
        cmocka_unit_test(test_unequal_partners_are_near),
        cmocka_unit_test(test_large_layers_are_cut_into_strips),
        cmocka_unit_test(test_flat_beds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
