#include "sim/inlets_fill.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "config/region.h"
#include "config/sizes.h"
#include "setup/insertion_space.h"

/** Random places that are tried for a grain before it waits. */
#define TRIES 200
/** Draws of a grain at one step: three for each try. */
#define DRAWS (3 * TRIES)
/** Sizes are drawn by inlet and count, apart from the ids of all grains. */
#define SIZE_SHIFT 48

/** One inlet at one insertion. */
typedef struct inflow {
    clod_inlet *told;
    const clod_case_grains *group;
    size_t number; ///< of the inlet
    clod_sizes sizes;
    clod_insertion_space space;
    double density; ///< kg/m3
    uint16_t material;
    bool open;           ///< `space` is ready
    bool waits;          ///< its next grain is due and has no place
    double radius, mass; ///< m, kg; of its next grain
    double due;          ///< s, when that is due; HUGE_VAL: never
} inflow;

/** All of them. */
typedef struct filling {
    clod_inlets *all;
    const clod_case *from;
    clod_state *state;
    double time; ///< s
    size_t count;
    inflow of[CLOD_CASE_INLETS];
} filling;

static bool by_mass(const inflow *self)
{
    return self->group->inlet.mass_flow > 0.0;
}

/** kg/s or grains/s. */
static double flow_of(const inflow *self)
{
    return by_mass(self) ? self->group->inlet.mass_flow : self->group->inlet.number_flow;
}

/** What has come: kg or grains. */
static double come(const inflow *self)
{
    return by_mass(self) ? self->told->mass : (double)self->told->count;
}

/** Time from which on grains are due [s]. */
static double start_of(const filling *self, const inflow *source)
{
    return fmax(source->group->inlet.start, self->all->begin);
}

/** Whether the amount that the group may bring at most leaves room for its next grain. */
static bool may_come(const inflow *self)
{
    const clod_case_grains *group = self->group;
    return (group->count == 0 || self->told->count < group->count) &&
           (group->mass == 0.0 || self->told->mass + 0.5 * self->mass <= group->mass);
}

/** The next grain of an inlet; it is due when half of it is. */
static void find_next(const filling *self, inflow *source)
{
    const uint64_t number = self->all->first_id + (uint64_t)source->told->count;
    source->radius = clod_sizes_radius(&source->sizes, (uint64_t)self->from->seed,
                                       (((uint64_t)source->number + 1) << SIZE_SHIFT) + number);
    source->mass =
        source->density * (4.0 / 3.0) * M_PI * source->radius * source->radius * source->radius;
    const double half = by_mass(source) ? 0.5 * source->mass : 0.5;
    const double due = start_of(self, source) + (come(source) + half) / flow_of(source);
    const double end = source->group->inlet.end;
    source->due = may_come(source) && (end == 0.0 || due <= end) ? due : HUGE_VAL;
}

/** Note what has been put at this step: it is not in the state yet. */
static bool note_queue(inflow *self, const clod_changes *queue, clod_status *status)
{
    for (size_t k = 0; k < queue->new_grains; k++) {
        if (!clod_insertion_space_take(&self->space, queue->new_grain[k].position, status)) {
            return false;
        }
    }
    return true;
}

/** Get an inlet ready, with its space when a grain is due. */
static bool open_source(filling *self, const clod_case_grains *group, clod_status *status)
{
    const int material = clod_case_material_index(self->from, group->material);
    const size_t number = self->count++;
    inflow *one = &self->of[number];
    *one = (inflow){.told = &self->all->inlet[number],
                    .group = group,
                    .number = number,
                    .density = self->from->materials[material].density,
                    .material = (uint16_t)material};
    if (!clod_sizes_init(&one->sizes, group, status)) {
        return false;
    }
    find_next(self, one);
    if (one->due > self->time) {
        return true;
    }
    const double largest = cbrt(clod_sizes_largest_volume(&one->sizes) * 0.75 / M_PI);
    double low[3], high[3];
    clod_region_bounds(&group->region, low, high);
    one->open = true;
    return clod_insertion_space_init(&one->space, &group->region, high[2], self->state, largest,
                                     self->state->grains.count + 1, status) &&
           note_queue(one, &self->state->changes, status);
}

/** The inlet whose next grain is due first and can be tried; NULL: none. */
static inflow *next_source(filling *self)
{
    inflow *first = NULL;
    for (size_t k = 0; k < self->count; k++) {
        inflow *one = &self->of[k];
        if (one->due <= self->time && !one->waits && (first == NULL || one->due < first->due)) {
            first = one;
        }
    }
    return first;
}

/** A place for the next grain of an inlet; false: none was found. */
static bool find_place(const filling *self, const inflow *source, double place[4])
{
    const uint64_t seed = (uint64_t)self->from->seed;
    const uint64_t id = self->all->next_id;
    const uint64_t first = (uint64_t)self->state->step * DRAWS; // others at every step
    place[3] = source->radius;
    for (uint64_t t = 0; t < TRIES; t++) {
        double u[3];
        for (uint64_t a = 0; a < 3; a++) {
            u[a] = clod_random_uniform(seed, CLOD_RANDOM_POSITION, id, first + 3 * t + a);
        }
        if (clod_insertion_space_draw(&source->space, place, source->space.low[2],
                                      source->space.high[2], u) &&
            clod_insertion_space_clear(&source->space, place)) {
            return true;
        }
    }
    return false;
}

static bool add_grain(filling *self, inflow *source, const double place[4], clod_status *status)
{
    clod_new_grain grain = {
        .id = self->all->next_id++, .density = source->density, .material = source->material};
    memcpy(grain.position, place, sizeof grain.position);
    memcpy(grain.velocity, source->group->velocity, sizeof grain.velocity);
    clod_changes_add_grain(&self->state->changes, &grain);
    self->state->changes.checked++; // see inlets_act
    source->told->count++;
    source->told->mass += source->mass;
    find_next(self, source);
    for (size_t k = 0; k < self->count; k++) {
        if (self->of[k].open && !clod_insertion_space_take(&self->of[k].space, place, status)) {
            return false;
        }
    }
    return true;
}

/** Whether an inlet shares space with one that waits. */
static bool must_wait(const filling *self, const inflow *one)
{
    for (size_t k = 0; k < self->count; k++) {
        if (self->of[k].waits &&
            clod_region_overlap(&self->of[k].group->region, &one->group->region)) {
            return true;
        }
    }
    return false;
}

/** An inlet waits, with all that share its space, those that share theirs, and so on. */
static void let_wait(filling *self, inflow *source)
{
    source->waits = true;
    for (bool more = true; more;) {
        more = false;
        for (size_t k = 0; k < self->count; k++) {
            if (!self->of[k].waits && must_wait(self, &self->of[k])) {
                self->of[k].waits = more = true;
            }
        }
    }
}

static bool put_all(filling *self, clod_status *status)
{
    for (inflow *next = next_source(self); next != NULL; next = next_source(self)) {
        double place[4];
        if (!find_place(self, next, place)) {
            let_wait(self, next);
        } else if (!add_grain(self, next, place, status)) {
            return false;
        }
    }
    return true;
}

/** What is due and has not come: kg or grains. */
static double backlog_of(const filling *self, const inflow *source)
{
    const double end = source->group->inlet.end;
    const double time = end > 0.0 ? fmin(self->time, end) : self->time;
    return (time - start_of(self, source)) * flow_of(source) - come(source);
}

/** Note what waits. */
static void note(const filling *self, const inflow *source)
{
    clod_inlet *told = source->told;
    const bool waits = source->due <= self->time;
    told->backlog = waits ? backlog_of(self, source) : 0.0;
    told->most = fmax(told->most, told->backlog);
    told->blocked += waits;
    told->since = !waits ? -1 : told->since < 0 ? self->state->step : told->since;
}

bool clod_inlets_sight(const clod_case *from, clod_sight *sees)
{
    bool good = true;
    sees->boxes = 0;
    for (size_t k = 0; good && k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        clod_sizes sizes;
        clod_status ignored; // its sizes have been read before
        if (!group->comes) {
            continue;
        }
        clod_domain_box *box = &sees->box[sees->boxes++];
        good = clod_sizes_init(&sizes, group, &ignored);
        const double margin = // more than any grain that is put can reach beyond its region
            good ? 4.0 * cbrt(clod_sizes_largest_volume(&sizes) * 0.75 / M_PI) : 0.0;
        clod_sizes_fini(&sizes);
        clod_region_bounds(&group->region, box->low, box->high);
        for (int a = 0; a < 3; a++) {
            box->low[a] -= margin;
            box->high[a] += margin;
        }
    }
    return good;
}

bool clod_inlets_fill(clod_inlets *self, const clod_case *from, clod_state *state,
                      clod_status *status)
{
    filling work = {
        .all = self, .from = from, .state = state, .time = (double)state->step * state->dt};
    bool good = true;
    for (size_t k = 0; good && k < from->grains_count; k++) {
        good = !from->grains[k].comes || open_source(&work, &from->grains[k], status);
    }
    good = good && put_all(&work, status);
    for (size_t k = 0; k < work.count; k++) {
        if (good) {
            note(&work, &work.of[k]);
        }
        clod_sizes_fini(&work.of[k].sizes);
        clod_insertion_space_fini(&work.of[k].space);
    }
    return good;
}
