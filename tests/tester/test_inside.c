// Bulk density away from the walls, of beds whose density one knows.
#include "tester/inside.h"

#include <math.h>
#include <string.h>

#include "support/check.h"
#include "support/dice.h"

#define RADIUS 0.001
#define APART (CLOD_INSIDE_APART * 2.0 * RADIUS) ///< 3 mm
#define SKIN (APART - RADIUS)                    ///< of centres
#define MASS 1e-5
#define MOST 200000

static double place[MOST][4], motion[MOST][4];
static clod_state state;

static int empty(void **context)
{
    (void)context;
    memset(&state, 0, sizeof state);
    state.grains.position = place;
    state.grains.velocity = motion;
    return 0;
}

static void add(double x, double y, double z)
{
    const size_t g = state.grains.count++;
    memcpy(place[g], (double[4]){x, y, z, RADIUS}, sizeof place[g]);
    motion[g][3] = MASS;
}

/** Cubic lattice in an annulus about (shift, 0), one grain in every `cell` cubed. */
static void fill(double inner, double outer, double low, double high, double shift, double cell)
{
    const int n = (int)ceil(outer / cell);
    for (double z = low + 0.5 * cell; z < high; z += cell) {
        for (int i = -n; i <= n; i++) {
            for (int j = -n; j <= n; j++) {
                const double x = (i + 0.31) * cell;
                const double y = (j + 0.17) * cell;
                const double r = hypot(x, y);
                if (r > inner && r < outer && state.grains.count < MOST) {
                    add(x + shift, y, z);
                }
            }
        }
    }
    assert_true(state.grains.count < MOST);
}

static void check(const clod_inside *bed, double density, double within)
{
    assert_true(fabs(clod_inside_density(bed, &state) / density - 1.0) < within);
}

/** 12.5 mm3 to a grain in a core, nothing in what is near the walls: mass over area and height tells half. */
static void a_loose_skin_does_not_count(void **context)
{
    (void)context;
    const clod_inside bed = {.inner = 0.05, .outer = 0.1, .low = 0.004, .high = 0.045};
    const double cell = 0.0025;
    fill(bed.inner + APART, bed.outer - APART, bed.low + APART, bed.high - APART, 0.0, cell);
    const double dense = MASS / (cell * cell * cell);
    // 14 layers of 2.5 mm in 35 mm; the edge of a circle cuts a lattice by 1 %
    check(&bed, dense, 0.01);
    const double all = MASS * (double)state.grains.count /
                       (3.14159265358979 * (0.1 * 0.1 - 0.05 * 0.05) * 0.041);
    assert_true(all < 0.8 * dense);
}

/** Grains packed into the skin alone, which they do not leave, weigh nothing inside. */
static void a_dense_skin_does_not_count(void **context)
{
    (void)context;
    const clod_inside bed = {.inner = 0.05, .outer = 0.1, .low = 0.0, .high = 0.05};
    fill(0.05, 0.1, 0.0, 0.05, 0.0, 0.0025);
    const double before = clod_inside_density(&bed, &state);
    fill(0.05, 0.05 + SKIN, 0.0, 0.05, 0.0, 0.0021);
    fill(0.1 - SKIN, 0.1, 0.0, 0.05, 0.0, 0.0021);
    fill(0.05, 0.1, 0.0, SKIN, 0.0, 0.0021);
    fill(0.05, 0.1, 0.05 - SKIN, 0.05, 0.0, 0.0021);
    check(&bed, before, 1e-12);
}

/** One grain on the edge of the room: half of it, and then a cap. */
static void grains_count_by_their_share(void **context)
{
    (void)context;
    const clod_inside bed = {.outer = 0.1, .low = 0.0, .high = 0.02};
    const double room = 3.14159265358979 * (0.1 - APART) * (0.1 - APART) * (0.02 - 2.0 * APART);
    add(0.0, 0.0, APART);
    check(&bed, 0.5 * MASS / room, 1e-12);
    // cap of height h = 0.6 R: pi h^2 (3 R - h)/3 over 4 pi R^3/3 = 0.216
    place[0][2] = APART - 0.4 * RADIUS;
    check(&bed, 0.216 * MASS / room, 0.03);
}

/** Grains at random everywhere, which know of no wall: inside is as dense as the whole. */
static void a_bed_without_a_skin_is_as_dense_inside(void **context)
{
    (void)context;
    const clod_inside bed = {.outer = 0.03, .high = 0.05};
    dice roll = {7};
    size_t in = 0;
    while (in < 100000) {
        const double x = dice_real(&roll, -0.03, 0.03);
        const double y = dice_real(&roll, -0.03, 0.03);
        if (hypot(x, y) < bed.outer) {
            add(x, y, dice_real(&roll, 0.0, bed.high));
            in++;
        }
    }
    const double volume = 3.14159265358979 * bed.outer * bed.outer * bed.high;
    check(&bed, MASS * 100000 / volume, 0.01); // 1/sqrt(71 000) is 0.4 %
}

/** The upper ring of a Jenike cell has moved by 8 mm. */
static void a_moved_ring_takes_its_room_along(void **context)
{
    (void)context;
    clod_inside bed = {.outer = 0.03, .high = 0.04, .plane = 0.02, .shift = 0.008};
    // 17 layers of 2 mm in the 34 mm of the room, whatever their places
    fill(0.0, 0.03, 0.0005, 0.0205, 0.0, 0.002);
    fill(0.0, 0.03, 0.0205, 0.0405, 0.008, 0.002);
    const double dense = MASS / (0.002 * 0.002 * 0.002);
    check(&bed, dense, 0.01);
    bed.shift = 0.0; // where it was before: 27 mm of radius reach 5 mm behind the ring
    assert_true(clod_inside_density(&bed, &state) < 0.97 * dense);
}

/** The gap goes by the mean diameter, the density by each grain's mass. */
static void grains_of_two_sizes(void **context)
{
    (void)context;
    const clod_inside bed = {.outer = 0.1, .high = 0.05};
    add(0.0, 0.0, 0.02);
    add(0.0, 0.0, 0.03);
    place[1][3] = 3.0 * RADIUS;
    motion[1][3] = 27.0 * MASS;
    const double gap = CLOD_INSIDE_APART * 4.0 * RADIUS; // of diameters of 2 and 6 mm
    const double room = 3.14159265358979 * (0.1 - gap) * (0.1 - gap) * (0.05 - 2.0 * gap);
    check(&bed, 28.0 * MASS / room, 1e-12);
}

static void a_narrow_bed_has_no_inside(void **context)
{
    (void)context;
    fill(0.0, 0.1, 0.0, 0.05, 0.0, 0.0025);
    clod_inside bed = {.inner = 0.05, .outer = 0.0579, .high = 0.05}; // 7.9 mm, 8 is least
    assert_true(isnan(clod_inside_density(&bed, &state)));
    bed.outer = 0.0581;
    assert_true(clod_inside_density(&bed, &state) > 0.0);
    bed = (clod_inside){.outer = 0.1, .high = 0.0079};
    assert_true(isnan(clod_inside_density(&bed, &state)));
    bed = (clod_inside){.outer = 0.1, .low = 0.1, .high = 0.2}; // none is there
    assert_true(isnan(clod_inside_density(&bed, &state)));
}

int main(void)
{
#define T(name) cmocka_unit_test_setup(name, empty)
    const struct CMUnitTest tests[] = {
        T(a_loose_skin_does_not_count),
        T(a_dense_skin_does_not_count),
        T(a_bed_without_a_skin_is_as_dense_inside),
        T(a_moved_ring_takes_its_room_along),
        T(a_narrow_bed_has_no_inside),
        T(grains_count_by_their_share),
        T(grains_of_two_sizes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
