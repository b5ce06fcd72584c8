#include "measure/mixing_grid.h"

#include <math.h>

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

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    (void)status;
    const clod_mixing_grid *self = question->asked;
    clod_mixing_sample *samples = question->sums;
    const clod_grains *grains = &here->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        double p[4];
        clod_domain_place(&here->state->domain, grains->position[g], p);
        if (clod_survey_has(here, g) && clod_outlet_has(&self->region, p)) {
            clod_mixing_sample *of = &samples[cell_of(self, p)];
            of->grains++;
            of->first += self->material >= 0 ? grains->material[g] == self->material
                                             : p[3] > self->above;
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
