#include "calibrate/chain.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/random.h"
#include "calibrate/population.h"

#define WANTED 0.3       ///< accepted share
#define START_SCALE 0.05 ///< standard deviation of the first proposals
#define FORGET 0.6       ///< the adaptation's steps fall as step^-0.6
#define LEAPS 4          ///< steps along differences behind each normal step
#define JITTER 1e-8      ///< added to the covariance's diagonal, so that it stays positive

/** One chain on its way. */
typedef struct chain {
    const clod_chain_setup *setup;
    uint64_t number, draw;
    double point[CLOD_CHAIN_MOST], density;
    size_t *chosen; ///< [choices] the caller's
    size_t turn;    ///< of the next choice to be drawn
    double mean[CLOD_CHAIN_MOST];
    double covariance[CLOD_CHAIN_MOST][CLOD_CHAIN_MOST];
    double factor[CLOD_CHAIN_MOST]
                 [CLOD_CHAIN_MOST]; ///< lower Cholesky factor of the covariance
    double log_scale;
    bool stopped; ///< no density is asked for any more
} chain;

static double uniform(chain *self)
{
    return clod_random_uniform(self->setup->seed, CLOD_RANDOM_CALIBRATE,
                               self->setup->stream + self->number, self->draw++);
}

/** The density at a place; none after a stop. */
static double density_at(chain *self, const double *place)
{
    const clod_chain_setup *setup = self->setup;
    self->stopped = self->stopped || clod_stop_asked(setup->stop);
    return self->stopped ? -HUGE_VAL : setup->density(setup->context, place, self->chosen);
}

static double normal(chain *self)
{
    const uint64_t draw = self->draw;
    self->draw += 2;
    return clod_random_normal(self->setup->seed, CLOD_RANDOM_CALIBRATE,
                              self->setup->stream + self->number, draw);
}

/** Lower Cholesky factor of the covariance. */
static void factor(chain *self)
{
    const size_t d = self->setup->dimensions;
    for (size_t i = 0; i < d; i++) {
        for (size_t j = 0; j <= i; j++) {
            double sum = self->covariance[i][j] + (i == j ? JITTER : 0.0);
            for (size_t k = 0; k < j; k++) {
                sum -= self->factor[i][k] * self->factor[j][k];
            }
            self->factor[i][j] = i == j ? sqrt(fmax(sum, JITTER)) : sum / self->factor[j][j];
        }
    }
}

/** Mean and covariance of a population. */
static void look_at(chain *self, const clod_population *population)
{
    const size_t d = self->setup->dimensions;
    const double share = 1.0 / (double)population->count;
    for (size_t m = 0; m < population->count; m++) {
        for (size_t k = 0; k < d; k++) {
            self->mean[k] += share * population->places[m * d + k];
        }
    }
    for (size_t m = 0; m < population->count; m++) {
        const double *place = population->places + m * d;
        for (size_t i = 0; i < d; i++) {
            for (size_t j = 0; j <= i; j++) {
                self->covariance[i][j] +=
                    share * (place[i] - self->mean[i]) * (place[j] - self->mean[j]);
            }
        }
    }
}

/** Begin at a member of the population. */
static void draw_start(chain *self)
{
    const clod_chain_setup *setup = self->setup;
    const clod_population *from = setup->population;
    const size_t at = (size_t)(uniform(self) * (double)from->count) % from->count;
    memcpy(self->point, from->places + at * setup->dimensions,
           setup->dimensions * sizeof *self->point);
    for (size_t k = 0; k < setup->choices; k++) {
        self->chosen[k] = from->chosen[at * setup->choices + k];
    }
    self->density = from->density[at];
    look_at(self, from);
}

static void start(chain *self)
{
    const size_t d = self->setup->dimensions;
    if (self->setup->population != NULL) {
        draw_start(self);
    } else {
        memcpy(self->point, self->setup->start, d * sizeof *self->point);
        memcpy(self->mean, self->point, sizeof self->mean);
        self->density = density_at(self, self->point);
        for (size_t k = 0; k < d; k++) {
            self->covariance[k][k] = START_SCALE * START_SCALE;
        }
    }
    self->log_scale = log(2.38 * 2.38 / (double)d);
    factor(self);
}

/** Go on to a new point if it is likely enough. @param inside whether it is in the cube
 *  @param chance [out] how likely it was */
static bool go(chain *self, const double *next, bool inside, double *chance)
{
    const double density = inside ? density_at(self, next) : -HUGE_VAL;
    *chance = density > -HUGE_VAL ? fmin(1.0, exp(density - self->density)) : 0.0;
    if (uniform(self) >= *chance) {
        return false;
    }
    memcpy(self->point, next, self->setup->dimensions * sizeof *next);
    self->density = density;
    return true;
}

/** One of the options, all as likely. */
static size_t draw_choice(chain *self)
{
    const size_t at = (size_t)(uniform(self) * (double)self->setup->options);
    return at < self->setup->options ? at : self->setup->options - 1;
}

/** A step along the difference of two members of the population: to another summit, along a ridge. @param anew also draw
 *  a whole number anew, with which the summit may be elsewhere */
static void leap(chain *self, bool anew)
{
    const clod_chain_setup *setup = self->setup;
    double next[CLOD_CHAIN_MOST], chance;
    size_t none = 0;
    size_t *at = anew ? &self->chosen[self->turn++ % setup->choices] : &none;
    const size_t before = *at;
    *at = anew ? draw_choice(self) : before;
    const clod_population_dice dice = {uniform(self), uniform(self), uniform(self)};
    const bool inside =
        clod_population_propose(setup->population, setup->dimensions, &dice, self->point, next);
    if (!go(self, next, inside, &chance)) {
        *at = before;
    }
}

static void leap_on(chain *self)
{
    for (int k = 0; k < LEAPS && self->setup->population != NULL; k++) {
        leap(self, k % 2 > 0 && self->setup->choices > 0);
    }
}

/** Whether the normal step goes on to a new point; `chance` [out]: how likely it was. */
static bool advance(chain *self, double *chance)
{
    const size_t d = self->setup->dimensions;
    double next[CLOD_CHAIN_MOST];
    double dice[CLOD_CHAIN_MOST];
    const double scale = exp(0.5 * self->log_scale);
    bool inside = true;
    for (size_t i = 0; i < d; i++) {
        dice[i] = normal(self);
        double move = 0.0;
        for (size_t k = 0; k <= i; k++) {
            move += self->factor[i][k] * dice[k];
        }
        next[i] = self->point[i] + scale * move;
        inside = inside && next[i] > 0.0 && next[i] < 1.0;
    }
    return go(self, next, inside, chance);
}

/** Draw the choice anew whose turn it is. */
static void choose(chain *self)
{
    if (self->setup->choices == 0) {
        return;
    }
    size_t *at = &self->chosen[self->turn++ % self->setup->choices];
    const size_t before = *at;
    *at = draw_choice(self);
    const double density = *at != before ? density_at(self, self->point) : self->density;
    if (log(uniform(self)) < density - self->density) {
        self->density = density;
    } else {
        *at = before;
    }
}

/** Take mean, covariance and scale nearer to what the chain shows. */
static void adapt(chain *self, size_t step, double chance)
{
    const size_t d = self->setup->dimensions;
    const double weight = pow((double)step + 2.0, -FORGET);
    double away[CLOD_CHAIN_MOST];
    for (size_t k = 0; k < d; k++) {
        away[k] = self->point[k] - self->mean[k];
        self->mean[k] += weight * away[k];
    }
    for (size_t i = 0; i < d; i++) {
        for (size_t j = 0; j <= i; j++) {
            self->covariance[i][j] += weight * (away[i] * away[j] - self->covariance[i][j]);
        }
    }
    self->log_scale += 2.0 * weight * (chance - WANTED);
    factor(self);
}

/** Warm a chain up and keep its samples. @return steps of the point that were accepted */
static size_t run(chain *self, double *samples)
{
    const clod_chain_setup *setup = self->setup;
    const size_t d = setup->dimensions;
    size_t moved = 0;
    double chance;
    start(self);
    for (size_t k = 0; k < setup->warm_up && !self->stopped; k++) {
        advance(self, &chance);
        leap_on(self);
        choose(self);
        adapt(self, k, chance);
    }
    for (size_t k = 0; k < setup->kept && !self->stopped; k++) {
        if (k > 0 && setup->choices > 0) {
            memcpy(self->chosen + setup->choices, self->chosen,
                   setup->choices * sizeof *self->chosen);
            self->chosen += setup->choices;
        }
        moved += advance(self, &chance) ? 1 : 0;
        leap_on(self);
        choose(self);
        memcpy(samples + k * d, self->point, d * sizeof(double));
    }
    return moved;
}

bool clod_chain_run(const clod_chain_setup *setup, double *samples, size_t *chosen,
                    double *accepted)
{
    CLOD_ASSERT(setup->dimensions >= 1 && setup->dimensions <= CLOD_CHAIN_MOST);
    CLOD_ASSERT(setup->start != NULL || setup->population != NULL);
    CLOD_ASSERT(setup->choices == 0 || (chosen != NULL && setup->options > 0));
    size_t moved = 0;
    for (size_t c = 0; c < setup->chains; c++) {
        chain self = {.setup = setup, .number = c};
        if (setup->choices > 0) {
            self.chosen = chosen + c * setup->kept * setup->choices;
        }
        moved += run(&self, samples + c * setup->kept * setup->dimensions);
        if (self.stopped) {
            return false;
        }
    }
    *accepted = (double)moved / (double)(setup->chains * setup->kept);
    return true;
}
