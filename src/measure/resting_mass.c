#include "measure/resting_mass.h"

#include <string.h>

#include "base/memory.h"

/** Whether a shape of a wall is of a target. */
static bool is_of(const clod_resting_target *self, const clod_state *state,
                  const clod_resting *on)
{
    if (self->wall != on->wall || self->part < 0) {
        return self->wall == on->wall;
    }
    const clod_shape *shapes = state->walls.wall[on->wall].shapes;
    const clod_surface *surface = shapes[self->first].surface;
    const clod_shape *shape = &shapes[on->shape];
    return shape->surface == surface && on->shape >= self->first &&
           (int32_t)surface->patches[shape->patch].part == self->part;
}

/** Add the mass of each own grain to what it rests on. */
static void weigh(const clod_resting_question *asked, const clod_survey_part *here,
                  const clod_resting *on, clod_exact *mass)
{
    const clod_grains *grains = &here->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        const bool counts = clod_survey_has(here, g) && on[g].wall >= 0;
        for (size_t t = 0; counts && t < asked->count; t++) {
            if (is_of(&asked->target[t], here->state, &on[g])) {
                clod_exact_add(&mass[t], grains->velocity[g][3]);
            }
        }
    }
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    const clod_resting_question *asked = question->asked;
    const size_t n = here->state->grains.count;
    clod_resting *on = clod_memory_alloc(n + 1, sizeof *on);
    bool good = on != NULL || clod_status_fail(status, CLOD_FAILED,
                                               "no memory for what rests of %zu grains", n);
    good = clod_survey_agree(here, good, status) &&
           clod_resting_find(on, here, asked->speed, status);
    if (good) {
        weigh(asked, here, on, question->sums);
    }
    clod_memory_free(on);
    return good;
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    clod_exact_merge(into, from);
}

const clod_survey_way CLOD_RESTING_MASS_WAY = {
    .add = add, .merge = merge, .unit = sizeof(clod_exact)};

bool clod_resting_mass(const clod_resting_question *asked, const clod_survey *survey,
                       clod_exact *mass, clod_status *status)
{
    const clod_survey_question question = {.kind = CLOD_SURVEY_RESTING,
                                           .asked = asked,
                                           .asked_bytes = sizeof *asked +
                                                          asked->count * sizeof *asked->target,
                                           .sums = mass,
                                           .sums_bytes = asked->count * sizeof *mass};
    memset(mass, 0, question.sums_bytes);
    return clod_survey_ask(survey, &question, status);
}
