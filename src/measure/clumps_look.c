#include "measure/clumps_look.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"

// ---- grains

/** Number and size of each own grain's clump, in the column that is kept for it. */
static void show(const clod_clumps *clumps, const clod_survey_part *here)
{
    const clod_grains *grains = &here->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        if (clod_survey_has(here, g)) {
            const int32_t k = clumps->of[g];
            grains->clump[g].number = k >= 0 ? clumps->name[k].id : 0;
            grains->clump[g].size = k >= 0 ? (int32_t)clumps->name[k].grains : 0;
        }
    }
}

static void add_life(clod_clump_lives *self, double time)
{
    self->least = self->grains == 0 ? time : fmin(time, self->least);
    self->most = fmax(time, self->most);
    self->grains++;
    self->count[clod_time_class(time)]++;
    clod_exact_add(&self->sum, time);
}

/** Grains that have come into a clump, or are in none any more, since the last look. */
static void follow(clod_clump_lives *lives, const clod_survey_part *here)
{
    const clod_state *state = here->state;
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_grain_clump *clump = &state->grains.clump[g];
        if (!clod_survey_has(here, g)) {
            continue;
        }
        clump->seen = clump->size;
        if (clump->size > 0 && clump->since < 0.0) {
            clump->since = state->time;
        } else if (clump->size == 0 && clump->since >= 0.0) {
            add_life(lives, state->time - clump->since);
            clump->since = -1.0;
        }
    }
}

// ---- sums

void clod_clump_lives_merge(clod_clump_lives *self, const clod_clump_lives *other)
{
    if (other->grains > 0) {
        self->least = self->grains == 0 ? other->least : fmin(self->least, other->least);
        self->most = fmax(self->most, other->most);
    }
    self->grains += other->grains;
    clod_exact_merge(&self->sum, &other->sum);
    for (int k = 0; k < CLOD_TIME_CLASSES; k++) {
        self->count[k] += other->count[k];
    }
}

/** What is found rank 0 alone has; the others have zeros. */
static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    clod_clumps_seen *mine = into;
    const clod_clumps_seen *other = from;
    clod_clump_lives_merge(&mine->lives, &other->lives);
    double *to = (double *)mine->found;
    const double *of = (const double *)other->found;
    for (size_t k = 0; k < CLOD_CLUMPS_CHOICES * (sizeof(clod_clumps_found) / sizeof(double));
         k++) {
        to[k] += of[k];
    }
}

/** Clumps of a choice. */
static bool find(const clod_clumps_look *self, int32_t choice, const clod_survey_part *here,
                 const clod_bonds *bonds, clod_clumps_seen *seen, clod_status *status)
{
    clod_clumps clumps;
    clod_clumps_found *found = &seen->found[choice];
    bool good = clod_clumps_find(&clumps, here, bonds, &self->choice[choice], status);
    if (good) {
        good = clod_clumps_sum_up(&clumps, &found->stats, &found->sizes, status);
        good = clod_survey_agree(here, good, status);
    }
    if (good && choice == 0) {
        show(&clumps, here);
    }
    clod_clumps_fini(&clumps);
    return good;
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    const clod_clumps_look *self = question->asked;
    clod_clumps_seen *seen = question->sums;
    clod_bonds bonds;
    CLOD_ASSERT(here->state->grains.clump != NULL);
    bool good = clod_bonds_find(&bonds, here, self->bond, status);
    for (int32_t k = 0; good && k < self->choices; k++) {
        good = find(self, k, here, &bonds, seen, status);
    }
    if (good && self->follows) {
        follow(&seen->lives, here);
    }
    clod_bonds_fini(&bonds);
    return good;
}

const clod_survey_way CLOD_CLUMPS_LOOK_WAY = {.add = add, .merge = merge};

bool clod_clumps_look_at(const clod_clumps_look *self, const clod_survey *survey,
                         clod_clumps_seen *seen, clod_status *status)
{
    const clod_survey_question question = {.kind = CLOD_SURVEY_CLUMPS,
                                           .asked = self,
                                           .asked_bytes = sizeof *self,
                                           .sums = seen,
                                           .sums_bytes = sizeof *seen};
    memset(seen, 0, sizeof *seen);
    return clod_survey_ask(survey, &question, status);
}
