// Places of inserted grains, bit by bit those that a search of all grains one after the other gives: at
// random and in layers, where space repeats upwards and where it does not. No grid, no bands.

#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "setup/insertion.h"
#include "support/check.h"

#define SEED 7
#define CLEARANCE 1e-6 ///< of the radius, that grains keep away: ADR 0042, insertion_batch.h
#define LAYER_NUMBER (UINT64_C(1) << 32)

typedef struct scene {
    clod_state state;
    clod_case_region region;
    clod_sizes sizes;
    clod_insertion what;
    double (*expected)[4]; ///< of all grains, with those that were there before
    size_t count;
} scene;

static void scene_init(scene *s, const double wide[3], bool through)
{
    memset(s, 0, sizeof *s);
    s->region.kind = CLOD_REGION_BOX;
    memcpy(s->region.max, wide, sizeof s->region.max);
    s->state.domain =
        (clod_domain){.max = {wide[0], wide[1], wide[2]}, .periodic = {true, true, through}};
    s->what = (clod_insertion){.name = "grains.0",
                               .region = &s->region,
                               .sizes = &s->sizes,
                               .seed = SEED,
                               .first_id = 1,
                               .density = 2500.0};
    s->expected = calloc(300000, sizeof *s->expected);
    assert_non_null(s->expected);
}

/** A group of radii that are uniform between two. */
static void set_group(scene *s, size_t count, double least, double largest)
{
    clod_status status = {0};
    const clod_case_grains from = {
        .sizes = CLOD_SIZE_UNIFORM, .radius_min = least, .radius_max = largest};
    assert_true(clod_sizes_init(&s->sizes, &from, &status));
    s->what.first_id += s->what.count;
    s->what.count = count;
}

static void put(scene *s)
{
    clod_status status = {0};
    if (!clod_insert_region(&s->state, &s->what, &status)) {
        fail_msg("%s", status.text);
    }
}

static void scene_fini(scene *s)
{
    clod_state_fini(&s->state);
    free(s->expected);
}

static double radius_of(const scene *s, size_t g)
{
    return clod_sizes_radius(&s->sizes, SEED, s->what.first_id + g);
}

static double draw(const scene *s, size_t g, uint64_t number, uint64_t axis)
{
    return clod_random_uniform(SEED, CLOD_RANDOM_POSITION, s->what.first_id + g,
                               3 * number + axis);
}

/** Whether a place, of a radius with its clearance, is free of grains: expected[0 ... count). */
static bool is_free(const scene *s, size_t count, const double place[4])
{
    for (size_t k = 0; k < count; k++) {
        const double *other = s->expected[k];
        double square = 0.0;
        for (int a = 0; a < 3; a++) {
            const double d = fabs(place[a] - other[a]);
            const double period = s->state.domain.max[a];
            const double near = s->state.domain.periodic[a] ? fmin(d, period - d) : d;
            square += near * near;
        }
        if (square < (place[3] + other[3]) * (place[3] + other[3])) {
            return false;
        }
    }
    return true;
}

// ---- at random: the largest first, each where the first of its draws is free

typedef struct sized {
    double radius;
    size_t number;
} sized;

static int larger_first(const void *a, const void *b)
{
    const sized *x = a, *y = b;
    return x->radius != y->radius ? (x->radius < y->radius ? 1 : -1)
                                  : (x->number > y->number) - (x->number < y->number);
}

/** Expected places of the group, behind `before` others; in the order in which they are found. */
static void expect_random(scene *s, size_t before, sized *order)
{
    for (size_t g = 0; g < s->what.count; g++) {
        order[g] = (sized){radius_of(s, g), g};
    }
    qsort(order, s->what.count, sizeof *order, larger_first);
    for (size_t k = 0; k < s->what.count; k++) {
        double place[4] = {0.0};
        place[3] = order[k].radius * (1.0 + CLEARANCE);
        bool found = false;
        for (uint64_t t = 0; !found; t++) {
            assert_true(t < 4000);
            for (uint64_t a = 0; a < 3; a++) {
                const double r = s->state.domain.periodic[a] ? 0.0 : place[3];
                const double low = s->region.min[a] + r;
                place[a] = low + draw(s, order[k].number, t, a) * (s->region.max[a] - r - low);
            }
            found = is_free(s, before + k, place);
        }
        memcpy(s->expected[before + k], place, sizeof place);
    }
}

static void check_random(bool through)
{
    enum { LARGE = 20, SMALL = 1200 };
    const double wide[3] = {20e-3, 24e-3, 26e-3};
    static sized order[SMALL];
    scene s;
    scene_init(&s, wide, through);
    set_group(&s, LARGE, 2.5e-3, 3e-3);
    expect_random(&s, 0, order);
    put(&s);
    for (size_t k = 0; k < LARGE;
         k++) { // as a second group sees them: in order, without clearance
        memcpy(s.expected[k], s.state.grains.position[k], sizeof *s.expected);
    }
    set_group(&s, SMALL, 0.5e-3, 0.9e-3); // 0.26 of the box is solid
    expect_random(&s, LARGE, order);
    put(&s);
    assert_int_equal(s.state.grains.count, LARGE + SMALL);
    for (size_t k = 0; k < SMALL; k++) {
        const size_t g = LARGE + order[k].number;
        assert_memory_equal(s.state.grains.position[g], s.expected[LARGE + k],
                            3 * sizeof(double));
        assert_true(s.state.grains.position[g][3] == order[k].radius);
    }
    scene_fini(&s);
}

static void random_places_are_those_of_brute_force(void **state)
{
    (void)state;
    check_random(false);
}

static void random_places_in_a_period_are_those_of_brute_force(void **state)
{
    (void)state;
    check_random(true);
}

// ---- in layers: one grain after the other takes the next site that is free of the large grains. Those of
// its own group never meet: each stays in its cell.

static size_t pieces(double length, double pitch)
{
    return (size_t)(length / pitch * (1.0 + 1e-12));
}

static void expect_layers(scene *s, size_t before)
{
    double pitch[3], largest = 0.0;
    size_t n[3];
    for (size_t g = 0; g < s->what.count; g++) {
        largest = fmax(largest, radius_of(s, g) * (1.0 + CLEARANCE));
    }
    for (int a = 0; a < 3; a++) {
        n[a] = pieces(s->region.max[a], 2.0 * largest);
        pitch[a] = s->region.max[a] / (double)n[a];
    }
    size_t g = 0;
    for (size_t site = 0; g < s->what.count; site++) {
        assert_true(site < n[0] * n[1] * n[2]);
        const size_t at[3] = {site % n[0], site / n[0] % n[1], site / n[0] / n[1]};
        double *place = s->expected[before + g];
        place[3] = radius_of(s, g) * (1.0 + CLEARANCE);
        for (uint64_t a = 0; a < 3; a++) {
            place[a] = ((double)at[a] + 0.5) * pitch[a] +
                       (draw(s, g, LAYER_NUMBER, a) - 0.5) * (pitch[a] - 2.0 * place[3]);
        }
        g += is_free(s, before, place);
    }
}

/** Large grains at random, then as many small ones around them as make several blocks of bands. */
static void check_layers(bool through)
{
    enum { LARGE = 60, SMALL = 140000 };
    const double wide[3] = {80e-3, 80e-3, 52e-3};
    static sized order[LARGE];
    scene s;
    scene_init(&s, wide, through);
    set_group(&s, LARGE, 2e-3, 3e-3);
    expect_random(&s, 0, order);
    put(&s);
    for (size_t k = 0; k < LARGE; k++) {
        memcpy(s.expected[k], s.state.grains.position[k], sizeof *s.expected);
    }
    set_group(&s, SMALL, 0.58e-3, 0.6e-3);
    expect_layers(&s, LARGE);
    put(&s);
    assert_int_equal(s.state.grains.count, LARGE + SMALL);
    for (size_t g = 0; g < SMALL; g++) {
        assert_memory_equal(s.state.grains.position[LARGE + g], s.expected[LARGE + g],
                            3 * sizeof(double));
    }
    scene_fini(&s);
}

static void layers_are_those_of_brute_force(void **state)
{
    (void)state;
    check_layers(false);
}

static void layers_in_a_period_are_those_of_brute_force(void **state)
{
    (void)state;
    check_layers(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_places_are_those_of_brute_force),
        cmocka_unit_test(random_places_in_a_period_are_those_of_brute_force),
        cmocka_unit_test(layers_are_those_of_brute_force),
        cmocka_unit_test(layers_in_a_period_are_those_of_brute_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
