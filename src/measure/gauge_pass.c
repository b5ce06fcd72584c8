#include "measure/gauge_pass.h"

#include "base/memory.h"

/** What is added up for one gauge. */
typedef struct worker {
    clod_gauge_exact exact;
    clod_gauge_slice *across, *along; ///< owned; NULL without bins
} worker;

static bool open_bins(worker *self, const clod_gauge_part *part)
{
    if (part->profile != NULL) {
        self->across = clod_gauge_bins_open(&part->across);
    }
    if (part->trajectory != NULL) {
        self->along = clod_gauge_bins_open(&part->along);
    }
    return (part->profile == NULL || self->across != NULL) &&
           (part->trajectory == NULL || self->along != NULL);
}

static void add_grain(worker *self, const clod_gauge_part *part, const clod_grains *grains,
                      size_t g, const double place[4])
{
    const double mass = grains->velocity[g][3];
    clod_gauge_add(&self->exact, &part->gauge, grains, g, place);
    if (self->across != NULL) {
        clod_gauge_bins_add(self->across, &part->gauge, &part->across, place, mass);
    }
    if (self->along != NULL) {
        clod_gauge_bins_add(self->along, &part->gauge, &part->along, place, mass);
    }
}

/** Go through the grains; `all` has the sums over every one. */
static void add_grains(worker *workers, const clod_gauge_part *parts, size_t count,
                       const clod_state *state, clod_exact all[2])
{
    const clod_grains *grains = &state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        double place[4];
        clod_domain_place(&state->domain, grains->position[g], place);
        const double mass = grains->velocity[g][3];
        clod_exact_add(&all[0], mass);
        clod_exact_add(&all[1], mass * grains->position[g][3]);
        for (size_t k = 0; k < count; k++) {
            if (clod_outlet_has(&parts[k].gauge.region, place)) {
                add_grain(&workers[k], &parts[k], grains, g, place);
            }
        }
    }
}

static void finish(worker *self, const clod_gauge_part *part, const clod_state *state,
                   const clod_exact all[2])
{
    clod_gauge_sums_of(&self->exact, &part->gauge, state, part->sums);
    part->sums[CLOD_GAUGE_ALL_MASS] = clod_exact_value(&all[0]);
    part->sums[CLOD_GAUGE_ALL_RADIUS] = clod_exact_value(&all[1]);
    if (self->across != NULL) {
        clod_gauge_bins_take(part->profile, &part->across, self->across);
    }
    if (self->along != NULL) {
        clod_gauge_bins_take(part->trajectory, &part->along, self->along);
    }
}

bool clod_gauge_pass(const clod_gauge_part *parts, size_t count, const clod_state *state,
                     clod_status *status)
{
    worker *workers = clod_memory_alloc(count + 1, sizeof *workers); // all zero
    clod_exact all[2] = {{.pending = 0}, {.pending = 0}};
    bool good = workers != NULL;
    for (size_t k = 0; good && k < count; k++) {
        good = open_bins(&workers[k], &parts[k]);
    }
    if (good) {
        add_grains(workers, parts, count, state, all);
    } else {
        clod_status_fail(status, CLOD_FAILED, "no memory for the sums of %zu gauges", count);
    }
    for (size_t k = 0; workers != NULL && k < count; k++) {
        if (good) {
            finish(&workers[k], &parts[k], state, all);
        }
        clod_memory_free(workers[k].across);
        clod_memory_free(workers[k].along);
    }
    clod_memory_free(workers);
    return good;
}
