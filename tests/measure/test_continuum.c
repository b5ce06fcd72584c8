// Fields of grains and contacts made by hand: every expected number is computed by hand.

#include "measure/continuum_pass.h"

#include <string.h>

#include "base/memory.h"
#include "support/check.h"
#include "support/dice.h"

#define MOST 8
#define DENSITY 2500.0

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};

/** Contacts with the forces that a test gives them. */
typedef struct given {
    clod_contact contact[MOST];
    clod_contact_force told[MOST]; ///< of contacts met from i to j
    size_t count, at;
} given;

static void given_begin(void *context, size_t *pairs, size_t *walls)
{
    given *self = context;
    self->at = *walls = 0;
    *pairs = self->count;
}

static size_t given_next(void *context, clod_contact *to, size_t room)
{
    given *self = context;
    size_t count = 0;
    for (; count < room && self->at < self->count; self->at++) {
        to[count++] = self->contact[self->at];
    }
    return count;
}

static clod_contact_force given_force(const void *laws, const clod_contact *contact)
{
    const given *self = laws;
    for (size_t k = 0; k < self->count; k++) {
        if (self->contact[k].i == contact->i && self->contact[k].j == contact->j) {
            return self->told[k];
        }
    }
    fail(); // it was turned: tests give contacts from the smaller id
    return self->told[0];
}

static clod_contact_source source_of(given *self)
{
    return (clod_contact_source){.context = self,
                                 .begin = given_begin,
                                 .next = given_next,
                                 .laws = self,
                                 .force = given_force};
}

static void add(clod_state *state, double x, double y, double z, double r, const double v[3])
{
    const double position[4] = {x, y, z, r};
    assert_true(clod_grains_add(&state->grains, position, v, NONE, DENSITY, 0,
                                state->grains.count + 1, &status));
}

static double mass_of(double r)
{
    return DENSITY * 4.0 / 3.0 * M_PI * r * r * r;
}

static clod_continuum box_of(const double low[3], const double high[3], double cell,
                             double width)
{
    clod_outlet box = {.outer = 0.0};
    memcpy(box.low, low, sizeof box.low);
    memcpy(box.high, high, sizeof box.high);
    return clod_continuum_make(&box, cell, width);
}

/** Sums of one sample over all points, times the volume of each; owned points in `each` if it is
 *  not NULL. */
static void sample(const clod_continuum *field, const clod_state *state, given *contacts,
                   double sum[CLOD_CONTINUUM_SUMS], double (**each)[CLOD_CONTINUUM_SUMS])
{
    given none = {.count = 0};
    const clod_contact_source source = source_of(contacts != NULL ? contacts : &none);
    const size_t points = (size_t)clod_continuum_points(field);
    double(*to)[CLOD_CONTINUUM_SUMS] = clod_memory_alloc(points, sizeof *to);
    const clod_continuum_part part = {field, to};
    const clod_survey survey = clod_survey_of(state, &source);
    assert_true(clod_continuum_pass(&part, 1, &survey, &status));
    const double volume = field->cell > 0.0 ? field->cell * field->cell * field->cell
                                            : clod_continuum_volume(&field->region);
    memset(sum, 0, CLOD_CONTINUUM_SUMS * sizeof *sum);
    for (size_t p = 0; p < points; p++) {
        for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
            sum[c] += volume * to[p][c];
        }
    }
    if (each != NULL) {
        *each = to;
    } else {
        clod_memory_free(to);
    }
}

static const double LOW[3] = {0.0, 0.0, 0.0}, HIGH[3] = {0.1, 0.1, 0.1};

/** A grid of half a width takes all of a grain's mass: its kernel is a smooth function. */
static void a_grid_has_the_mass_of_a_grain(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    const double v[3] = {1.0, -2.0, 3.0};
    double sum[CLOD_CONTINUUM_SUMS];
    add(&state, 0.0513, 0.0479, 0.0502, 3e-3, v);
    for (int k = 0; k < 3; k++) { // two, three and four cells to a width
        static const double CELL[] = {0.01, 0.02 / 3.0, 0.005};
        static const double ERROR[] = {2e-2, 2e-3, 1e-3};
        const clod_continuum field = box_of(LOW, HIGH, CELL[k], 0.02);
        sample(&field, &state, NULL, sum, NULL);
        check_relative(sum[CLOD_CONTINUUM_MASS], mass_of(3e-3), ERROR[k]);
        check_relative(sum[CLOD_CONTINUUM_MOMENTUM + 1] / sum[CLOD_CONTINUUM_MASS], -2.0,
                       1e-12);
        check_relative(sum[CLOD_CONTINUUM_FLUX + 4] / sum[CLOD_CONTINUUM_MASS], 3.0, 1e-12);
        check_relative(sum[CLOD_CONTINUUM_VOLUME] / sum[CLOD_CONTINUUM_MASS], 1.0 / DENSITY,
                       1e-12);
        check_relative(sum[CLOD_CONTINUUM_NUMBER] / 8e-6, 1.0, ERROR[k]); // times width^3
    }
    clod_state_fini(&state);
}

/** Two grains at x and x + 6 mm that press each other with a force (2, 1, 0) N on the first. */
static given make_pair(clod_state *state, double x)
{
    add(state, x, 0.05, 0.05, 3e-3, NONE);
    add(state, x + 6e-3, 0.05, 0.05, 3e-3, NONE);
    given pair = {.count = 1};
    pair.contact[0] = (clod_contact){.i = 0, .j = 1, .shape = -1};
    pair.told[0] = (clod_contact_force){{-2.0, 1.0, 0.0}, {x + 6e-3, 0.05, 0.05}};
    return pair;
}

/** The integral of the stress is force x branch: (-2, 1, 0) N x (-6, 0, 0) mm. */
static void check_pair(const double *sum, double error)
{
    check_relative(sum[CLOD_CONTINUUM_CONTACT], 12e-3, error);
    check_relative(sum[CLOD_CONTINUUM_CONTACT + 3], -6e-3, error); // yx: force y, branch x
    check_close(sum[CLOD_CONTINUUM_CONTACT + 1], 0.0, 1e-18);      // xy
    check_close(sum[CLOD_CONTINUUM_CONTACT + 8], 0.0, 1e-18);
    check_close(sum[CLOD_CONTINUUM_WALL_FORCE], 0.0, 0.0);
}

static void two_grains_pressed_together(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double sum[CLOD_CONTINUUM_SUMS], values[CLOD_CONTINUUM_NUMBERS];
    given pair = make_pair(&state, 0.047);
    const clod_continuum grid = box_of(LOW, HIGH, 0.005, 0.02);
    const clod_continuum whole = box_of(LOW, HIGH, 0.0, 0.0);
    sample(&grid, &state, &pair, sum, NULL);
    check_pair(sum, 2e-3);
    sample(&whole, &state, &pair, sum, NULL);
    check_pair(sum, 1e-12);
    for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
        sum[c] /= 1e-3; // m3
    }
    clod_continuum_values(&whole, sum, 1.0, values);
    check_relative(values[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_PRESSURE].first], 4.0, 1e-12);
    check_relative(values[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_COORDINATION].first], 1.0,
                   1e-12);
    // a third of the branch is beyond x = 51 mm
    const clod_continuum part = box_of(LOW, (const double[]){0.051, 0.1, 0.1}, 0.0, 0.0);
    sample(&part, &state, &pair, sum, NULL);
    check_relative(sum[CLOD_CONTINUUM_CONTACT], 8e-3, 1e-12);
    check_relative(sum[CLOD_CONTINUUM_MASS], mass_of(3e-3), 1e-12);
    clod_state_fini(&state);
}

/** Across a periodic side: once on a grid, in the whole and in parts, wherever rows stand. */
static void periodic_sides_count_once(void **unused)
{
    (void)unused;
    double sum[CLOD_CONTINUUM_SUMS], more[CLOD_CONTINUUM_SUMS];
    for (int beyond = 0; beyond < 2; beyond++) {
        clod_state state = {.dt = 1e-3};
        given pair = make_pair(&state, 0.098);
        state.domain = (clod_domain){.max = {0.1, 0.1, 0.1}, .periodic = {true, true, false}};
        if (beyond == 0) { // the second grain has come in on the other side
            state.grains.position[1][0] = 0.004;
        }
        const clod_continuum grid = box_of(LOW, HIGH, 0.005, 0.02);
        const clod_continuum whole = box_of(LOW, HIGH, 0.0, 0.0);
        sample(&grid, &state, &pair, sum, NULL);
        check_pair(sum, 2e-3);
        check_relative(sum[CLOD_CONTINUUM_MASS], 2.0 * mass_of(3e-3), 2e-3);
        sample(&whole, &state, &pair, sum, NULL);
        check_pair(sum, 1e-12);
        check_relative(sum[CLOD_CONTINUUM_MASS], 2.0 * mass_of(3e-3), 1e-12);
        // of the branch 2 mm are before the side and 4 mm behind it
        const clod_continuum last = box_of((const double[]){0.05, 0.0, 0.0}, HIGH, 0.0, 0.0);
        const clod_continuum first = box_of(LOW, (const double[]){0.05, 0.1, 0.1}, 0.0, 0.0);
        sample(&last, &state, &pair, sum, NULL);
        sample(&first, &state, &pair, more, NULL);
        check_relative(sum[CLOD_CONTINUUM_CONTACT], 4e-3, 1e-9);
        check_relative(more[CLOD_CONTINUUM_CONTACT], 8e-3, 1e-9);
        check_relative(sum[CLOD_CONTINUUM_MASS], mass_of(3e-3), 1e-12);
        check_relative(more[CLOD_CONTINUUM_MASS], mass_of(3e-3), 1e-12);
        clod_state_fini(&state);
    }
}

/** Fields near a periodic side are those far from it. */
static void a_side_is_no_place(void **unused)
{
    (void)unused;
    double sum[CLOD_CONTINUUM_SUMS];
    double(*at_side)[CLOD_CONTINUUM_SUMS], (*within)[CLOD_CONTINUUM_SUMS];
    const clod_continuum grid = box_of(LOW, HIGH, 0.01, 0.02);
    const clod_domain domain = {.max = {0.1, 0.1, 0.1}, .periodic = {true, false, false}};
    clod_state a = {.dt = 1e-3, .domain = domain}, b = {.dt = 1e-3, .domain = domain};
    given pair = make_pair(&a, 0.098), other = make_pair(&b, 0.048);
    sample(&grid, &a, &pair, sum, &at_side);
    sample(&grid, &b, &other, sum, &within);
    for (int p = 0; p < 1000; p++) {
        const int q = p / 10 * 10 + (p + 5) % 10;
        for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
            check_close(at_side[q][c], within[p][c], 1e-9 * (1.0 + fabs(within[p][c])));
        }
    }
    clod_memory_free(at_side);
    clod_memory_free(within);
    clod_state_fini(&a);
    clod_state_fini(&b);
}

/** On the sides themselves, at min or at max: grains, a branch that lies in them, and the point
 *  where a wall pushes. */
static void on_a_side_counts_once(void **unused)
{
    (void)unused;
    double sum[CLOD_CONTINUUM_SUMS];
    const double low[3] = {0.01, -0.03, 0.0}, high[3] = {0.05, 0.01, 0.1};
    for (int k = 0; k < 4; k++) {
        clod_state state = {.dt = 1e-3};
        state.domain = (clod_domain){.periodic = {true, true, false}};
        memcpy(state.domain.min, low, sizeof low);
        memcpy(state.domain.max, high, sizeof high);
        const double x = k % 2 == 0 ? low[0] : high[0], y = k < 2 ? low[1] : high[1];
        add(&state, x, y, 0.0029, 3e-3, NONE);
        add(&state, x, y, 0.0089, 3e-3, NONE);
        given two = {.count = 2};
        two.contact[0] = (clod_contact){.i = 0, .j = 1, .shape = -1};
        two.told[0] = (clod_contact_force){{0.0, 1.0, -5.0}, {x, y, 0.0089}};
        two.contact[1] = (clod_contact){.i = 0, .j = 0, .shape = 0};
        two.told[1] = (clod_contact_force){{2.0, 0.0, 7.0}, {x, y, 0.0}};
        const clod_continuum whole = box_of(low, high, 0.0, 0.0);
        sample(&whole, &state, &two, sum, NULL);
        check_relative(sum[CLOD_CONTINUUM_MASS], 2.0 * mass_of(3e-3), 1e-12);
        check_relative(sum[CLOD_CONTINUUM_CONTACT + 5], -6e-3, 1e-12); // yz: 1 N x -6 mm
        check_relative(sum[CLOD_CONTINUUM_CONTACT + 8], 30e-3 + 7.0 * 2.9e-3, 1e-12);
        check_relative(sum[CLOD_CONTINUUM_WALL_FORCE + 2] / whole.scale, 7.0, 1e-12);
        // a quarter at each corner: one of them has all
        double mass = 0.0;
        for (int q = 0; q < 4; q++) {
            const double from[3] = {q % 2 == 0 ? 0.01 : 0.03, q < 2 ? -0.03 : -0.01, 0.0};
            const double to[3] = {from[0] + 0.02, from[1] + 0.02, 0.1};
            const clod_continuum quarter = box_of(from, to, 0.0, 0.0);
            sample(&quarter, &state, &two, sum, NULL);
            mass += sum[CLOD_CONTINUUM_MASS];
        }
        check_relative(mass, 2.0 * mass_of(3e-3), 1e-12);
        clod_state_fini(&state);
    }
}

/** A lattice that begins on the sides has the density of one that does not. */
static void a_lattice_on_the_sides(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double sum[CLOD_CONTINUUM_SUMS];
    state.domain = (clod_domain){.max = {0.1, 0.1, 0.1}, .periodic = {true, true, false}};
    for (int k = 0; k < 1000; k++) {
        add(&state, 0.01 * (k % 10), 0.01 * (k / 10 % 10), 5e-3 + 0.01 * (k / 100), 5e-3, NONE);
    }
    const clod_continuum whole = box_of(LOW, HIGH, 0.0, 0.0);
    sample(&whole, &state, NULL, sum, NULL);
    check_relative(sum[CLOD_CONTINUUM_MASS], 1000.0 * mass_of(5e-3), 1e-12);
    clod_state_fini(&state);
}

/** A wall below pushes a grain with 5 N: its force at the point of contact, its stress along the
 *  radius. */
static void walls_push_where_they_touch(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double sum[CLOD_CONTINUUM_SUMS];
    add(&state, 0.05, 0.05, 0.0529, 3e-3, NONE);
    given wall = {.count = 1};
    wall.contact[0] = (clod_contact){.i = 0, .j = 0, .shape = 2};
    wall.told[0] = (clod_contact_force){{0.0, 0.0, 5.0}, {0.05, 0.05, 0.05}};
    const clod_continuum grid = box_of(LOW, HIGH, 0.005, 0.02);
    sample(&grid, &state, &wall, sum, NULL);
    check_relative(sum[CLOD_CONTINUUM_WALL_FORCE + 2] / grid.scale, 5.0, 2e-3);
    check_relative(sum[CLOD_CONTINUUM_CONTACT + 8], 5.0 * 2.9e-3, 2e-3);
    check_relative(sum[CLOD_CONTINUUM_PARTNERS] / sum[CLOD_CONTINUUM_NUMBER], 1.0, 1e-12);
    const clod_continuum below = box_of(LOW, (const double[]){0.1, 0.1, 0.051}, 0.0, 0.0);
    sample(&below, &state, &wall, sum, NULL);
    check_relative(sum[CLOD_CONTINUUM_WALL_FORCE + 2] / below.scale, 5.0, 1e-12);
    check_relative(sum[CLOD_CONTINUUM_CONTACT + 8], 5.0 * 1e-3, 1e-10);
    clod_state_fini(&state);
}

/** Velocities +-u: the kinetic stress is density u u, the temperature u^2/3; two samples that
 *  drift in opposite directions are one gas. */
static void a_gas_of_set_velocities(void **unused)
{
    (void)unused;
    double sum[CLOD_CONTINUUM_SUMS], both[CLOD_CONTINUUM_SUMS], v[CLOD_CONTINUUM_NUMBERS];
    const double u[3] = {0.3, -0.2, 0.6}, drift[3] = {5.0, 0.0, 1.0};
    const clod_continuum whole = box_of(LOW, HIGH, 0.0, 0.0);
    memset(both, 0, sizeof both);
    for (int sign = -1; sign <= 1; sign += 2) {
        clod_state state = {.dt = 1e-3};
        for (int k = 0; k < 10; k++) {
            double velocity[3];
            for (int a = 0; a < 3; a++) {
                velocity[a] = sign * drift[a] + (k % 2 == 0 ? u[a] : -u[a]);
            }
            add(&state, 0.01 * k, 0.05, 0.05, 3e-3, velocity);
        }
        sample(&whole, &state, NULL, sum, NULL);
        for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
            both[c] += sum[c] / 1e-3;
            sum[c] /= 1e-3;
        }
        clod_continuum_values(&whole, sum, 1.0, v);
        const double density = 10.0 * mass_of(3e-3) / 1e-3;
        const double *kinetic = &v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_KINETIC].first];
        for (int k = 0; k < 9; k++) {
            check_close(kinetic[k], density * u[k / 3] * u[k % 3], 1e-10);
        }
        check_close(v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_TEMPERATURE].first], 0.49 / 3.0,
                    1e-12);
        check_close(v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_VELOCITY].first], sign * 5.0,
                    1e-12);
        clod_state_fini(&state);
    }
    clod_continuum_values(&whole, both, 2.0, v); // about a mean of 0: u^2 + drift^2
    check_close(v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_TEMPERATURE].first],
                (0.49 + 26.0) / 3.0, 1e-12);
    check_close(v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_DENSITY].first],
                10.0 * mass_of(3e-3) / 1e-3, 1e-10);
}

/** Uniform shear: at the middle of a lattice the kernel's mean velocity is that of its place. */
static void uniform_shear(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double sum[CLOD_CONTINUUM_SUMS], v[CLOD_CONTINUUM_NUMBERS];
    double(*each)[CLOD_CONTINUUM_SUMS];
    for (int k = 0; k < 50 * 50 * 50; k++) {
        const double at[3] = {2e-3 * (k % 50), 2e-3 * (k / 50 % 50), 2e-3 * (k / 2500)};
        add(&state, at[0], at[1], at[2], 1e-3, (const double[]){40.0 * at[2], 0.0, 0.0});
    }
    const clod_continuum grid = box_of(LOW, HIGH, 0.01, 0.02);
    sample(&grid, &state, NULL, sum, &each);
    for (int k = 3; k < 7; k++) {
        clod_continuum_values(&grid, each[555 % 100 + 100 * k], 1.0, v);
        check_relative(v[0], mass_of(1e-3) / 8e-9, 1e-3); // one grain in (2 mm)^3
        check_relative(v[2], 40.0 * (0.01 * k + 0.005), 2e-4);
        // <z^2> = w^2/12 of each direction: fluctuations that are none of the gas
        check_relative(v[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_KINETIC].first] / v[0],
                       1600.0 * 4e-4 / 12.0, 5e-3);
    }
    clod_memory_free(each);
    clod_state_fini(&state);
}

/** Lines through boxes and rings. */
static void shares_of_lines(void **unused)
{
    (void)unused;
    const clod_outlet ring = {
        .low = {-2.0, -2.0, 0.0}, .high = {2.0, 2.0, 1.0}, .inner = 1.0, .outer = 2.0};
    const double a[3] = {-4.0, 0.0, 0.5}, b[3] = {4.0, 0.0, 0.5};
    check_close(clod_continuum_share(&ring, a, b), 2.0 / 8.0, 1e-14);
    const double c[3] = {0.0, 0.0, 0.5};
    check_close(clod_continuum_share(&ring, a, c), 1.0 / 4.0, 1e-14);
    const double up[3] = {1.5, 0.0, -1.0}, down[3] = {1.5, 0.0, 3.0};
    check_close(clod_continuum_share(&ring, up, down), 1.0 / 4.0, 1e-14);
    const double beside[3] = {-4.0, 2.5, 0.5}, there[3] = {4.0, 2.5, 0.5};
    check_close(clod_continuum_share(&ring, beside, there), 0.0, 0.0);
    const double tangent[3] = {-4.0, 1.5, 0.5}, along[3] = {4.0, 1.5, 0.5};
    check_close(clod_continuum_share(&ring, tangent, along), sqrt(4.0 - 2.25) / 4.0, 1e-14);
    check_close(clod_continuum_volume(&ring), 3.0 * M_PI, 1e-14);
}

/** Sums do not depend on the order of rows: grains in two orders, to the bit. */
static void rows_in_any_order(void **unused)
{
    (void)unused;
    double sum[CLOD_CONTINUUM_SUMS];
    double(*each[2])[CLOD_CONTINUUM_SUMS];
    const clod_continuum grid = box_of(LOW, HIGH, 0.01, 0.02);
    for (int turn = 0; turn < 2; turn++) {
        clod_state state = {.dt = 1e-3};
        for (int k = 0; k < 500; k++) {
            dice roll = {(uint64_t)(turn == 0 ? k : 499 - k) + 7};
            const double x = dice_real(&roll, 0.0, 0.1), y = dice_real(&roll, 0.0, 0.1);
            const double z = dice_real(&roll, 0.0, 0.1), r = dice_real(&roll, 1e-3, 3e-3);
            add(&state, x, y, z, r, (const double[]){z, -3.0 * x, y});
        }
        sample(&grid, &state, NULL, sum, &each[turn]);
        clod_state_fini(&state);
    }
    assert_true(sum[CLOD_CONTINUUM_MASS] > 0.0);
    assert_memory_equal(each[0], each[1], 1000 * sizeof *each[0]);
    clod_memory_free(each[0]);
    clod_memory_free(each[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_grid_has_the_mass_of_a_grain),
        cmocka_unit_test(two_grains_pressed_together),
        cmocka_unit_test(periodic_sides_count_once),
        cmocka_unit_test(a_side_is_no_place),
        cmocka_unit_test(on_a_side_counts_once),
        cmocka_unit_test(a_lattice_on_the_sides),
        cmocka_unit_test(walls_push_where_they_touch),
        cmocka_unit_test(a_gas_of_set_velocities),
        cmocka_unit_test(uniform_shear),
        cmocka_unit_test(shares_of_lines),
        cmocka_unit_test(rows_in_any_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
