#include "calibrate/population.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/random.h"

#define LEFT 0.5    ///< share of the members that still count where the power is raised
#define HALVINGS 60 ///< of the search for the next power
#define MOVES 5     ///< of each member at the whole density
#define LEAP 0.2    ///< chance of a step by the whole difference, from one summit to another
#define WIDE                                                                                   \
    2.38 ///< over sqrt(2 d) of the difference: the widest of the other steps (ter Braak 2006)
#define DECADES 2.0 ///< from the widest step to the narrowest

/** A population on its way to the density. */
typedef struct course {
    const clod_chain_setup *setup;
    clod_population *of;
    double power;
    uint64_t draw;
    size_t turn; ///< of the next choice to be drawn
    bool stopped;
} course;

static double uniform(course *self)
{
    const clod_chain_setup *setup = self->setup;
    return clod_random_uniform(setup->seed, CLOD_RANDOM_CALIBRATE,
                               setup->stream + setup->chains, self->draw++);
}

static double density_at(course *self, const double *place, const size_t *chosen)
{
    const clod_chain_setup *setup = self->setup;
    self->stopped = self->stopped || clod_stop_asked(setup->stop);
    return self->stopped ? -HUGE_VAL : setup->density(setup->context, place, chosen);
}

static size_t below(double die, size_t count)
{
    const size_t at = (size_t)(die * (double)count);
    return at < count ? at : count - 1;
}

/** All of the cube, each place as likely. */
static void scatter(course *self)
{
    const clod_chain_setup *setup = self->setup;
    for (size_t i = 0; i < self->of->count; i++) {
        double *place = self->of->places + i * setup->dimensions;
        size_t *chosen = self->of->chosen + i * setup->choices;
        for (size_t k = 0; k < setup->choices; k++) {
            chosen[k] = below(uniform(self), setup->options);
        }
        for (size_t k = 0; k < setup->dimensions; k++) {
            place[k] = uniform(self);
        }
        self->of->density[i] = density_at(self, place, chosen);
    }
}

static double top_of(const clod_population *self)
{
    double top = -HUGE_VAL;
    for (size_t i = 0; i < self->count; i++) {
        top = fmax(top, self->density[i]);
    }
    return top;
}

/** Weight of a member when the power rises by so much; `top` of all densities. */
static double weight(const clod_population *self, size_t i, double rise, double top)
{
    return self->density[i] > -HUGE_VAL ? exp(rise * (self->density[i] - top)) : 0.0;
}

/** How many members count, (sum of weights)^2 over the sum of their squares. */
static double counted(const clod_population *self, double rise, double top)
{
    double sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        const double w = weight(self, i, rise, top);
        sum += w;
        squares += w * w;
    }
    return squares > 0.0 ? sum * sum / squares : 0.0;
}

/** How far the power may rise: to 1, or until LEFT of the members that have a density count. */
static double rise_of(const course *self, double top)
{
    const double wanted = LEFT * counted(self->of, 0.0, top);
    double low = 0.0, high = 1.0 - self->power;
    if (counted(self->of, high, top) >= wanted) {
        return high;
    }
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        if (counted(self->of, middle, top) >= wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high; // never 0
}

/** Draw the members anew by their weights, from `to`, which is room for as many: one die for all, so that a member of
 *  weight w is drawn w times but for rounding. */
static void draw_anew(course *self, double rise, double top, clod_population *to)
{
    const clod_chain_setup *setup = self->setup;
    clod_population *from = self->of;
    double sum = 0.0;
    for (size_t i = 0; i < from->count; i++) {
        sum += weight(from, i, rise, top);
    }
    const double die = uniform(self);
    double passed = weight(from, 0, rise, top);
    size_t at = 0;
    for (size_t i = 0; i < from->count; i++) {
        const double mark = ((double)i + die) * sum / (double)from->count;
        while (passed < mark && at + 1 < from->count) {
            passed += weight(from, ++at, rise, top);
        }
        memcpy(to->places + i * setup->dimensions, from->places + at * setup->dimensions,
               setup->dimensions * sizeof *to->places);
        memcpy(to->chosen + i * setup->choices, from->chosen + at * setup->choices,
               setup->choices * sizeof *to->chosen);
        to->density[i] = from->density[at];
    }
    const clod_population before = *from;
    *from = *to;
    *to = before;
}

bool clod_population_propose(const clod_population *self, size_t dimensions,
                             const clod_population_dice *dice, const double *from, double *next)
{
    const size_t one = below(dice->one, self->count);
    const size_t rest = below(dice->other, self->count - 1);
    const double *to = self->places + one * dimensions;
    const double *other = self->places + (rest < one ? rest : rest + 1) * dimensions;
    const double narrow = (dice->scale - LEAP) / (1.0 - LEAP); // 0 to 1, or a leap below
    const double scale = narrow < 0.0 ? 1.0
                                      : WIDE / sqrt(2.0 * (double)dimensions) *
                                            pow(10.0, -DECADES * narrow * narrow);
    bool inside = true;
    for (size_t k = 0; k < dimensions; k++) {
        next[k] = from[k] + scale * (to[k] - other[k]);
        inside = inside && next[k] > 0.0 && next[k] < 1.0;
    }
    return inside;
}

/** Whether a density takes the place of another one at the present power. */
static bool accepts(course *self, double density, double before)
{
    return density > -HUGE_VAL && log(uniform(self)) < self->power * (density - before);
}

/** A step of one member: along the difference of two members, one of its whole numbers drawn anew, or both at once, since
 *  another draw may have its summit elsewhere. */
static void step(course *self, size_t i, bool along, bool anew)
{
    const clod_chain_setup *setup = self->setup;
    clod_population *of = self->of;
    double *place = of->places + i * setup->dimensions;
    double next[CLOD_CHAIN_MOST];
    bool inside = true;
    memcpy(next, place, setup->dimensions * sizeof *next);
    if (along) {
        const clod_population_dice dice = {uniform(self), uniform(self), uniform(self)};
        inside = clod_population_propose(of, setup->dimensions, &dice, place, next);
    }
    size_t none = 0;
    size_t *one =
        anew ? &of->chosen[i * setup->choices + self->turn++ % setup->choices] : &none;
    const size_t before = *one;
    *one = anew ? below(uniform(self), setup->options) : before;
    const double density =
        inside ? density_at(self, next, of->chosen + i * setup->choices) : -HUGE_VAL;
    if (accepts(self, density, of->density[i])) {
        memcpy(place, next, setup->dimensions * sizeof *next);
        of->density[i] = density;
    } else {
        *one = before;
    }
}

static void move(course *self, size_t i)
{
    step(self, i, true, false);
    if (self->setup->choices > 0) {
        step(self, i, false, true);
        step(self, i, true, true);
    }
}

static void move_all(course *self)
{
    for (size_t i = 0; i < self->of->count && !self->stopped; i++) {
        move(self, i);
    }
}

static bool alloc(const clod_chain_setup *setup, size_t count, clod_population *self)
{
    *self = (clod_population){
        .count = count,
        .places = clod_memory_alloc(count * setup->dimensions, sizeof *self->places),
        .chosen = clod_memory_alloc(count * setup->choices + 1, sizeof *self->chosen),
        .density = clod_memory_alloc(count, sizeof *self->density)};
    return self->places != NULL && self->chosen != NULL && self->density != NULL;
}

bool clod_population_create(const clod_chain_setup *setup, size_t count, clod_population *self,
                            clod_status *status)
{
    clod_population room;
    bool good = alloc(setup, count, self);
    good = alloc(setup, count, &room) && good;
    course on = {.setup = setup, .of = self};
    if (good) {
        scatter(&on);
    }
    while (good && on.power < 1.0 && !on.stopped) {
        const double top = top_of(self);
        const double rise = rise_of(&on, top);
        on.power += rise;
        draw_anew(&on, rise, top, &room);
        move_all(&on);
    }
    for (int k = 1; good && k < MOVES; k++) {
        move_all(&on);
    }
    clod_population_fini(&room);
    return !good ? clod_status_fail(status, CLOD_FAILED, "No memory for a population.")
                 : !on.stopped || clod_stop_fail(status);
}

void clod_population_fini(clod_population *self)
{
    clod_memory_free(self->places);
    clod_memory_free(self->chosen);
    clod_memory_free(self->density);
    *self = (clod_population){0};
}
