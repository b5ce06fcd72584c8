#include "step/crew_survey.h"

#include "base/assert.h"
#include "base/memory.h"
#include "step/crew_state.h"

/** Bytes of sums that are merged at a time, where they can be cut. */
#define PIECE 65536

/** A question on its way. */
typedef struct asking {
    clod_survey_question question;
    char *asked, *sums; ///< owned by other ranks than 0
} asking;

/** All ranks know what is asked, and have room for the sums. */
static bool tell(clod_crew *self, asking *all, clod_status *status)
{
    clod_survey_question *question = &all->question;
    uint64_t head[3] = {question->kind, question->asked_bytes, question->sums_bytes};
    bool good = true;
    clod_ranks_tell(self->ranks, head, sizeof head);
    if (self->whole == NULL) {
        all->asked = clod_memory_alloc(head[1] + 1, 1);
        all->sums = clod_memory_alloc(head[2] + 1, 1); // all zero
        *question = (clod_survey_question){(clod_survey_kind)head[0], all->asked, head[1],
                                           all->sums, head[2]};
        good = all->asked != NULL && all->sums != NULL;
    }
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for sums over the bed");
    }
    if (!clod_ranks_agree(self->ranks, good, status)) {
        return false;
    }
    if (head[1] > 0) {
        clod_ranks_tell(self->ranks, (void *)question->asked, question->asked_bytes);
    }
    return true;
}

/** Units of sums that are merged together. */
typedef struct units {
    const clod_survey_question *question;
    const clod_survey_way *way;
    size_t count;
} units;

static void merge_units(const void *context, void *into, const void *from)
{
    const units *self = context;
    for (size_t k = 0; k < self->count; k++) {
        const size_t at = k * self->way->unit;
        self->way->merge(self->question, (char *)into + at, (const char *)from + at);
    }
}

/** Everything in one, or piece by piece. */
static bool merge(clod_crew *self, const clod_survey_question *question, clod_status *status)
{
    const clod_survey_way *way = clod_survey_way_of(question->kind);
    const size_t all = question->sums_bytes;
    CLOD_ASSERT(way->unit <= PIECE);
    const size_t most = way->unit > 0 ? PIECE / way->unit * way->unit : all;
    if (!clod_ranks_reserve(self->ranks, most, status)) {
        return false;
    }
    for (size_t at = 0; at < all; at += most) {
        const size_t bytes = all - at < most ? all - at : most;
        const units some = {question, way, way->unit > 0 ? bytes / way->unit : 1};
        clod_ranks_merge(self->ranks, (char *)question->sums + at, bytes, merge_units, &some);
    }
    return true;
}

/** As of clod_survey_part, of a spread. */
static void share(const void *context, void *column, size_t size)
{
    clod_spread_share(context, column, size);
}

/** Sums of the whole bed, of which this rank has a part. */
static bool make_sums(clod_crew *self, const clod_survey_question *question,
                      clod_status *status)
{
    const clod_survey_way *way = clod_survey_way_of(question->kind);
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&self->step, &reader);
    const clod_survey_part here = {.state = &self->state,
                                   .contacts = &contacts,
                                   .owner = self->spread.owner,
                                   .ranks = self->ranks,
                                   .share = share,
                                   .context = &self->spread};
    if (way->motions) {
        clod_spread_refresh(&self->spread, &self->state);
    }
    const bool good = way->add(question, &here, status);
    return clod_ranks_agree(self->ranks, good, status) && merge(self, question, status);
}

bool clod_crew_part_survey(clod_crew *self, const clod_crew_order *what,
                           const clod_survey_question *question, clod_status *status)
{
    asking all = {.asked = NULL};
    if (question != NULL) {
        all.question = *question;
    }
    const bool good = clod_crew_part_prepare(self, what, status) && tell(self, &all, status) &&
                      make_sums(self, &all.question, status);
    clod_memory_free(all.asked);
    clod_memory_free(all.sums);
    return good;
}

/** As clod_survey_ask, of a step. */
static bool ask(void *context, const clod_survey_question *question, clod_status *status)
{
    clod_step *step = context;
    return clod_crew_survey(step->crew, question, status);
}

clod_survey clod_step_survey(clod_step *self, const clod_contact_source *contacts)
{
    const bool here = self->crew == NULL || !self->crew->stale;
    return (clod_survey){self->state, contacts, here ? NULL : ask, self};
}
