#include "measure/gauge_pass.h"

#include "base/memory.h"

/** What is asked of one gauge. */
typedef struct gauge_ask {
    clod_gauge gauge;
    clod_gauge_axis across, along; ///< count 0: no bins
} gauge_ask;

/** Behind the sums of all grains lie those of each gauge, and behind them its slices. */
typedef struct all_sums {
    clod_exact mass, radius; ///< the second by mass
} all_sums;

static size_t slices_of(const gauge_ask *ask)
{
    return (size_t)ask->across.count + (size_t)ask->along.count;
}

static size_t bytes_of(const gauge_ask *ask)
{
    return sizeof(clod_gauge_exact) + slices_of(ask) * sizeof(clod_gauge_slice);
}

static size_t bytes_of_all(const gauge_ask *asks, size_t count)
{
    size_t bytes = sizeof(all_sums);
    for (size_t k = 0; k < count; k++) {
        bytes += bytes_of(&asks[k]);
    }
    return bytes;
}

/** The sums of one gauge. */
typedef struct gauge_sums {
    clod_gauge_exact *exact;
    clod_gauge_slice *across, *along;
} gauge_sums;

/** Those of the gauge at a place in the sums; the next place. */
static char *sums_at(char *at, const gauge_ask *ask, gauge_sums *sums)
{
    sums->exact = (clod_gauge_exact *)(void *)at;
    sums->across = (clod_gauge_slice *)(void *)(at + sizeof *sums->exact);
    sums->along = sums->across + ask->across.count;
    return at + bytes_of(ask);
}

static void add_grain(const gauge_sums *self, const gauge_ask *ask, const clod_grains *grains,
                      size_t g, const double place[4])
{
    const double mass = grains->velocity[g][3];
    clod_gauge_add(self->exact, &ask->gauge, grains, g, place);
    if (ask->across.count > 0) {
        clod_gauge_bins_add(self->across, &ask->gauge, &ask->across, place, mass);
    }
    if (ask->along.count > 0) {
        clod_gauge_bins_add(self->along, &ask->gauge, &ask->along, place, mass);
    }
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    (void)status;
    const gauge_ask *asks = question->asked;
    const size_t count = question->asked_bytes / sizeof *asks;
    const clod_grains *grains = &here->state->grains;
    all_sums *all = question->sums;
    for (size_t g = 0; g < grains->count; g++) {
        if (!clod_survey_has(here, g)) {
            continue;
        }
        double place[4];
        clod_domain_place(&here->state->domain, grains->position[g], place);
        const double mass = grains->velocity[g][3];
        clod_exact_add(&all->mass, mass);
        clod_exact_add(&all->radius, mass * grains->position[g][3]);
        char *at = (char *)(all + 1);
        for (size_t k = 0; k < count; k++) {
            gauge_sums sums;
            at = sums_at(at, &asks[k], &sums);
            if (clod_outlet_has(&asks[k].gauge.region, place)) {
                add_grain(&sums, &asks[k], grains, g, place);
            }
        }
    }
    return true;
}

static void merge_slices(clod_gauge_slice *into, const clod_gauge_slice *from, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        clod_gauge_bins_merge(&into[k], &from[k]);
    }
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    const gauge_ask *asks = question->asked;
    const all_sums *others = from;
    all_sums *all = into;
    clod_exact_merge(&all->mass, &others->mass);
    clod_exact_merge(&all->radius, &others->radius);
    char *at = (char *)(all + 1);
    for (size_t k = 0; k < question->asked_bytes / sizeof *asks; k++) {
        gauge_sums mine;
        const char *other = (const char *)from + (at - (char *)into);
        at = sums_at(at, &asks[k], &mine);
        clod_gauge_merge(mine.exact, (const clod_gauge_exact *)(const void *)other);
        merge_slices(mine.across,
                     (const clod_gauge_slice *)(const void *)(other + sizeof *mine.exact),
                     slices_of(&asks[k]));
    }
}

const clod_survey_way CLOD_GAUGE_PASS_WAY = {.add = add, .merge = merge};

/** What is asked, without chance bytes in its gaps; NULL without memory. */
static gauge_ask *make_asks(const clod_gauge_part *parts, size_t count)
{
    gauge_ask *asks = clod_memory_alloc(count + 1, sizeof *asks); // all zero
    for (size_t k = 0; asks != NULL && k < count; k++) {
        asks[k].gauge = parts[k].gauge;
        if (parts[k].profile != NULL) {
            asks[k].across = parts[k].across;
        }
        if (parts[k].trajectory != NULL) {
            asks[k].along = parts[k].along;
        }
    }
    return asks;
}

static void finish(all_sums *all, const gauge_ask *asks, const clod_gauge_part *parts,
                   size_t count, const clod_state *state)
{
    char *at = (char *)(all + 1);
    for (size_t k = 0; k < count; k++) {
        const clod_gauge_part *part = &parts[k];
        gauge_sums sums;
        at = sums_at(at, &asks[k], &sums);
        clod_gauge_sums_of(sums.exact, &part->gauge, state, part->sums);
        part->sums[CLOD_GAUGE_ALL_MASS] = clod_exact_value(&all->mass);
        part->sums[CLOD_GAUGE_ALL_RADIUS] = clod_exact_value(&all->radius);
        if (part->profile != NULL) {
            clod_gauge_bins_take(part->profile, &part->across, sums.across);
        }
        if (part->trajectory != NULL) {
            clod_gauge_bins_take(part->trajectory, &part->along, sums.along);
        }
    }
}

bool clod_gauge_pass(const clod_gauge_part *parts, size_t count, const clod_survey *survey,
                     clod_status *status)
{
    gauge_ask *asks = make_asks(parts, count);
    const size_t bytes = asks != NULL ? bytes_of_all(asks, count) : 0;
    all_sums *all = clod_memory_alloc(bytes + 1, 1); // all zero
    const clod_survey_question question = {.kind = CLOD_SURVEY_GAUGES,
                                           .asked = asks,
                                           .asked_bytes = count * sizeof *asks,
                                           .sums = all,
                                           .sums_bytes = bytes};
    bool good =
        (asks != NULL && all != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for the sums of %zu gauges", count);
    good = good && clod_survey_ask(survey, &question, status);
    if (good) {
        finish(all, asks, parts, count, survey->state);
    }
    clod_memory_free(asks);
    clod_memory_free(all);
    return good;
}
