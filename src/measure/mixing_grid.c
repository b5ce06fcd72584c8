#include "measure/mixing_grid.h"

#include <math.h>

#include "base/memory.h"
#include "parallel/fixed.h"

size_t clod_mixing_grid_samples(const clod_mixing_grid *self)
{
    return (size_t)(self->cells[0] * self->cells[1] * self->cells[2]);
}

/** Number of the cell that a place in the region is in. */
static int64_t cell_of(const clod_mixing_grid *self, const double p[4])
{
    int64_t at[3];
    for (int a = 0; a < 3; a++) {
        const double k = floor((p[a] - self->region.low[a]) / self->cell);
        at[a] = (int64_t)fmin(fmax(k, 0.0), (double)self->cells[a] - 1.0);
    }
    return (at[2] * self->cells[1] + at[1]) * self->cells[0] + at[0];
}

/** Number of the cell that a grain counts in, -1: in none; and whether it is of the first kind. */
static int64_t find_cell(const clod_mixing_grid *self, const clod_survey_part *here, size_t g,
                         bool *first)
{
    const clod_grains *grains = &here->state->grains;
    double p[4];
    clod_domain_place(&here->state->domain, grains->position[g], p);
    *first = self->material >= 0 ? grains->material[g] == self->material : p[3] > self->above;
    const bool counts = clod_survey_has(here, g) && clod_outlet_has(&self->region, p);
    return counts ? cell_of(self, p) : -1;
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    (void)status;
    clod_mixing_sample *samples = question->sums;
    for (size_t g = 0; g < here->state->grains.count; g++) {
        bool first;
        const int64_t cell = find_cell(question->asked, here, g, &first);
        if (cell >= 0) {
            samples[cell].grains++;
            samples[cell].first += first;
        }
    }
    return true;
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    clod_mixing_sample *mine = into;
    const clod_mixing_sample *other = from;
    mine->grains += other->grains;
    mine->first += other->first;
}

const clod_survey_way CLOD_MIXING_GRID_WAY = {
    .add = add, .merge = merge, .unit = sizeof(clod_mixing_sample)};

// ---- weighed

/** A sample in fixed point: grains in any order, on any rank, make the same sums. */
typedef struct weights {
    clod_fixed sum; ///< mass and square of the first kind, mass and square of the others
    int64_t grains;
} weights;

static bool add_weights(const clod_survey_question *question, const clod_survey_part *here,
                        clod_status *status)
{
    (void)status;
    const clod_mixing_grid *self = question->asked;
    weights *samples = question->sums;
    for (size_t g = 0; g < here->state->grains.count; g++) {
        bool first;
        const int64_t cell = find_cell(self, here, g, &first);
        if (cell >= 0) {
            const double m = here->state->grains.velocity[g][3] / self->unit;
            const int at = first ? 0 : 2;
            double addend[CLOD_FIXED_COLUMNS] = {0.0};
            addend[at] = m;
            addend[at + 1] = m * m;
            clod_fixed_add(&samples[cell].sum, addend);
            if (++samples[cell].grains % CLOD_FIXED_ADDENDS == 0) {
                clod_fixed_carry(&samples[cell].sum);
            }
        }
    }
    for (size_t k = 0; k < clod_mixing_grid_samples(self); k++) {
        clod_fixed_carry(&samples[k].sum);
    }
    return true;
}

static void merge_weights(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    weights *mine = into;
    const weights *other = from;
    clod_fixed_merge(&mine->sum, &other->sum);
    mine->grains += other->grains;
}

const clod_survey_way CLOD_MIXING_GRID_MASS_WAY = {
    .add = add_weights, .merge = merge_weights, .unit = sizeof(weights)};

bool clod_mixing_grid_weigh(const clod_mixing_grid *self, const clod_survey *survey,
                            clod_mixing_weighed *samples, clod_status *status)
{
    const size_t count = clod_mixing_grid_samples(self);
    weights *sums = clod_memory_alloc(count, sizeof *sums);
    if (sums == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu samples of mixing",
                                count);
    }
    const clod_survey_question question = {.kind = CLOD_SURVEY_MIXING_MASS,
                                           .asked = self,
                                           .asked_bytes = sizeof *self,
                                           .sums = sums,
                                           .sums_bytes = count * sizeof *sums};
    const bool good = clod_survey_ask(survey, &question, status);
    for (size_t k = 0; good && k < count; k++) {
        double value[CLOD_FIXED_COLUMNS];
        clod_fixed_value(&sums[k].sum, value);
        samples[k] = (clod_mixing_weighed){.grains = sums[k].grains,
                                           .mass = {value[0], value[2]},
                                           .square = {value[1], value[3]}};
    }
    clod_memory_free(sums);
    return good;
}

bool clod_mixing_grid_count(const clod_mixing_grid *self, const clod_survey *survey,
                            clod_mixing_sample *samples, clod_status *status)
{
    const clod_survey_question question = {.kind = CLOD_SURVEY_MIXING,
                                           .asked = self,
                                           .asked_bytes = sizeof *self,
                                           .sums = samples,
                                           .sums_bytes = clod_mixing_grid_samples(self) *
                                                         sizeof *samples};
    return clod_survey_ask(survey, &question, status);
}
