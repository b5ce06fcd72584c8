// The balance of momentum on a grid, density g - div(stress) + wall force = 0, of a bed made by
// hand whose forces are in equilibrium. Contacts are oblique and forces are along the axes, so that
// the stress is far from symmetric: with its indices exchanged the balance fails.

#include "base/memory.h"
#include "measure/continuum_pass.h"
#include "support/check.h"
#include "support/dice.h"

#define SIDE 10   // grains along x and y
#define HIGH 6    // and z
#define STEP 4e-3 ///< m, between grains
#define RADIUS 2e-3
#define WIDTH 12e-3
#define LEVEL (SIDE * SIDE)
#define GRAINS (LEVEL * HIGH)
#define GRAVITY 9.81
#define SQUEEZE 0.004 ///< N, along x; half of it along y

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};

/** A bed with contacts of each grain: with the next along x, y and z, and of the lowest with the floor. */
typedef struct bed {
    clod_state state;
    size_t at; ///< contact that is next
} bed;

static void make(bed *self)
{
    *self = (bed){.state = {.dt = 1e-3}};
    self->state.domain = (clod_domain){.min = {0.0, 0.0, -0.02},
                                       .max = {SIDE * STEP, SIDE * STEP, 0.06},
                                       .periodic = {true, true, false}};
    dice roll = {3};
    for (int g = 0; g < GRAINS; g++) {
        const int at[3] = {g % SIDE, g / SIDE % SIDE, g / LEVEL};
        double position[4] = {0.0, 0.0, 0.0, RADIUS};
        for (int a = 0; a < 3; a++) {
            position[a] = STEP * (at[a] + 0.5 + dice_real(&roll, -0.3, 0.3));
        }
        assert_true(clod_grains_add(&self->state.grains, position, NONE, NONE, 2500.0, 0,
                                    (uint64_t)g + 1, &status));
    }
}

static void begin(void *context, size_t *pairs, size_t *walls)
{
    ((bed *)context)->at = 0;
    *pairs = 3 * GRAINS - LEVEL;
    *walls = LEVEL;
}

static size_t next(void *context, clod_contact *to, size_t room)
{
    bed *self = context;
    size_t count = 0;
    for (; count < room && self->at < (size_t)4 * GRAINS; self->at++) {
        const int g = (int)(self->at / 4), axis = (int)(self->at % 4), x = g % SIDE;
        const int y = g / SIDE % SIDE, z = g / LEVEL;
        const int other[3] = {g - x + (x + 1) % SIDE, g + SIDE * ((y + 1) % SIDE - y),
                              g + LEVEL};
        if (axis == 3 && z == 0) {
            to[count++] = (clod_contact){.i = g, .j = 0, .shape = 0};
        } else if (axis < 2 || (axis == 2 && z + 1 < HIGH)) {
            const bool first = g < other[axis];
            to[count++] = (clod_contact){
                .i = first ? g : other[axis], .j = first ? other[axis] : g, .shape = -1};
        }
    }
    return count;
}

/** Along z a contact bears the weight of the grains above it; along x and y the force is the same
 *  all around the period. */
static clod_contact_force force(const void *laws, const clod_contact *contact)
{
    const bed *self = laws;
    const clod_grains *grains = &self->state.grains;
    const double *p = grains->position[contact->i], weight = grains->velocity[0][3] * GRAVITY;
    clod_contact_force told = {{0.0, 0.0, 0.0}, {p[0], p[1], 0.0}};
    if (contact->shape >= 0) {
        told.force[2] = HIGH * weight;
        return told;
    }
    const double *q = grains->position[contact->j];
    for (int a = 0; a < 3; a++) {
        told.from[a] = p[a] - clod_domain_separation(&self->state.domain, a, p[a], q[a]);
    }
    const int apart = contact->j - contact->i;
    if (apart == LEVEL) {
        told.force[2] = -weight * (HIGH - 1 - contact->i / LEVEL);
    } else {
        const int axis = apart == 1 || apart == SIDE - 1 ? 0 : 1;
        const double way = told.from[axis] > p[axis] ? -1.0 : 1.0;
        told.force[axis] = way * SQUEEZE / (1 + axis);
    }
    return told;
}

/** Values of a grid with their cells along each axis. */
typedef struct grid {
    clod_continuum field;
    double (*values)[CLOD_CONTINUUM_NUMBERS]; ///< owned
} grid;

static grid sample(bed *self, double cell)
{
    const clod_outlet region = {.low = {0.0, 0.0, -0.02},
                                .high = {SIDE * STEP, SIDE * STEP, 0.044}};
    grid to = {.field = clod_continuum_make(&region, cell, WIDTH)};
    const size_t points = (size_t)clod_continuum_points(&to.field);
    double(*sums)[CLOD_CONTINUUM_SUMS] = clod_memory_alloc(points, sizeof *sums);
    to.values = clod_memory_alloc(points, sizeof *to.values);
    const clod_continuum_part part = {&to.field, sums};
    const clod_contact_source source = {
        .context = self, .begin = begin, .next = next, .laws = self, .force = force};
    const clod_survey survey = clod_survey_of(&self->state, &source);
    assert_true(clod_continuum_pass(&part, 1, &survey, &status));
    for (size_t k = 0; k < points; k++) {
        clod_continuum_values(&to.field, sums[k], 1.0, to.values[k]);
    }
    clod_memory_free(sums);
    return to;
}

/** Values of the cell that is `step` cells along an axis; periodic along x and y. */
static const double *beside(const grid *self, const int64_t at[3], int axis, int step)
{
    const int64_t *n = self->field.cells;
    int64_t k[3] = {at[0], at[1], at[2]};
    k[axis] = (k[axis] + step + n[axis]) % n[axis]; // along z both ends are empty
    return self->values[(k[2] * n[1] + k[1]) * n[0] + k[0]];
}

/** Divergence of the stress by central differences of fourth order: of d s_ab/dx_b, or with `turned` d s_ba/dx_b. */
static double divergence(const grid *self, const int64_t at[3], int a, bool turned)
{
    const int first = CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_CONTACT].first;
    double sum = 0.0;
    for (int b = 0; b < 3; b++) {
        const int k = first + (turned ? 3 * b + a : 3 * a + b);
        const double near = beside(self, at, b, 1)[k] - beside(self, at, b, -1)[k];
        const double far = beside(self, at, b, 2)[k] - beside(self, at, b, -2)[k];
        sum += 8.0 * near - far;
    }
    return sum / (12.0 * self->field.cell);
}

/** Root of the mean square of what is left of the balance, over that of the walls' force. */
static double left(const grid *self, bool turned)
{
    const int wall = CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_WALL_FORCE].first;
    const int density = CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_DENSITY].first;
    double rest = 0.0, push = 0.0;
    int64_t at[3];
    for (at[2] = 0; at[2] < self->field.cells[2]; at[2]++) {
        for (at[1] = 0; at[1] < self->field.cells[1]; at[1]++) {
            for (at[0] = 0; at[0] < self->field.cells[0]; at[0]++) {
                const double *here = beside(self, at, 0, 0);
                for (int a = 0; a < 3; a++) {
                    const double g = a == 2 ? -GRAVITY : 0.0;
                    const double r =
                        here[density] * g - divergence(self, at, a, turned) + here[wall + a];
                    rest += r * r;
                    push += here[wall + a] * here[wall + a];
                }
            }
        }
    }
    return sqrt(rest / push);
}

/** What is left is the error of the differences: it falls with the fourth power of the cells. */
static void momentum_balances(void **unused)
{
    (void)unused;
    bed all;
    make(&all);
    const grid coarse = sample(&all, 4e-3), fine = sample(&all, 2e-3);
    const double rough = left(&coarse, false), rest = left(&fine, false);
    const double turned = left(&fine, true);
    check_at_most(rest, 0.01);
    check_at_most(rest, rough / 8.0); // 16 of smooth fields; 4 were it second order
    check_at_most(10.0 * rest, turned);
    clod_memory_free(coarse.values);
    clod_memory_free(fine.values);
    clod_state_fini(&all.state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(momentum_balances)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
