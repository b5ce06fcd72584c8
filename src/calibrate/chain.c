#include "calibrate/chain.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/random.h"

#define WANTED 0.3       ///< accepted share
#define START_SCALE 0.05 ///< standard deviation of the first proposals
#define FORGET 0.6       ///< the adaptation's steps fall as step^-0.6
#define JITTER 1e-8      ///< added to the covariance's diagonal, so that it stays positive
#define STARTS 500       ///< random places from which a chain's start is drawn

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

/** One of the options, all as likely. */
static size_t draw_choice(chain *self)
{
    const size_t at = (size_t)(uniform(self) * (double)self->setup->options);
    return at < self->setup->options ? at : self->setup->options - 1;
}

static void draw_choices(chain *self)
{
    for (size_t k = 0; k < self->setup->choices; k++) {
        self->chosen[k] = draw_choice(self);
    }
}

static void draw_place(chain *self, double *place)
{
    for (size_t k = 0; k < self->setup->dimensions; k++) {
        place[k] = uniform(self);
    }
}

/** Places so far, of which one is kept, each as likely as its density. */
typedef struct urn {
    double top; ///< the largest density so far
    double sum; ///< of all densities over the largest
} urn;

/** Whether the next place takes the place of the one that was kept. One after the other, so that none but that needs
 *  to be kept. */
static bool takes(chain *self, urn *from, double density, bool first)
{
    if (density > from->top) {
        from->sum = from->top > -HUGE_VAL ? from->sum * exp(from->top - density) : 0.0;
        from->top = density;
    }
    const double weight = from->top > -HUGE_VAL ? exp(density - from->top) : 0.0;
    from->sum += weight;
    return first || uniform(self) * from->sum < weight;
}

/** A start drawn from random places, each with its density as its weight: a chain that began anywhere could
 *  stay at a lesser summit far from all others. */
static void draw_start(chain *self)
{
    urn from = {-HUGE_VAL, 0.0};
    self->density = -HUGE_VAL;
    for (int tried = 0; tried < STARTS && !self->stopped; tried++) {
        double place[CLOD_CHAIN_MOST];
        draw_place(self, place);
        const double density = density_at(self, place);
        if (takes(self, &from, density, tried == 0)) {
            memcpy(self->point, place, self->setup->dimensions * sizeof *place);
            self->density = density;
        }
    }
}

/** The same from the places of all chains, each with whole numbers of its own: they are the numbers of a chain behind
 *  the last one, so all chains have the same places. */
static void draw_pooled_start(chain *self)
{
    chain all = {.setup = self->setup, .number = self->setup->chains, .chosen = self->chosen};
    urn from = {-HUGE_VAL, 0.0};
    uint64_t kept = 0; // where the random numbers of the place that is kept begin
    self->density = -HUGE_VAL;
    for (size_t tried = 0; tried < STARTS * self->setup->chains && !self->stopped; tried++) {
        double place[CLOD_CHAIN_MOST];
        const uint64_t begin = all.draw;
        draw_choices(&all);
        draw_place(&all, place);
        const double density = density_at(self, place);
        if (takes(self, &from, density, tried == 0)) {
            self->density = density;
            kept = begin;
        }
    }
    all.draw = kept;
    draw_choices(&all);
    draw_place(&all, self->point);
}

static void start(chain *self)
{
    const size_t d = self->setup->dimensions;
    draw_choices(self);
    if (self->setup->start != NULL) {
        memcpy(self->point, self->setup->start, d * sizeof *self->point);
        self->density = density_at(self, self->point);
    } else if (self->setup->pooled) {
        draw_pooled_start(self);
    } else {
        draw_start(self);
    }
    for (size_t k = 0; k < d; k++) {
        self->mean[k] = self->point[k];
        self->covariance[k][k] = START_SCALE * START_SCALE;
    }
    self->log_scale = log(2.38 * 2.38 / (double)d);
    factor(self);
}

/** Whether the step goes on to a new point; `chance` [out]: how likely it was. */
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
    const double density = inside ? density_at(self, next) : -HUGE_VAL;
    *chance = density > -HUGE_VAL ? fmin(1.0, exp(density - self->density)) : 0.0;
    if (uniform(self) >= *chance) {
        return false;
    }
    memcpy(self->point, next, d * sizeof *next);
    self->density = density;
    return true;
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
        choose(self);
        memcpy(samples + k * d, self->point, d * sizeof(double));
    }
    return moved;
}

bool clod_chain_run(const clod_chain_setup *setup, double *samples, size_t *chosen,
                    double *accepted)
{
    CLOD_ASSERT(setup->dimensions >= 1 && setup->dimensions <= CLOD_CHAIN_MOST);
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
