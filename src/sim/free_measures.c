#include "sim/free_measures.h"

#include <string.h>

#include "sim/balance.h"
#include "sim/belt_loads.h"
#include "sim/build_up.h"
#include "sim/clumps.h"
#include "sim/fields.h"
#include "sim/gauges.h"
#include "sim/history_map.h"
#include "sim/inlets.h"
#include "sim/leavers.h"
#include "sim/mixing.h"
#include "sim/residence.h"
#include "sim/surfaces.h"
#include "sim/wall_loads.h"

/** In the order of the series' columns. */
static const clod_free_measure *const MEASURES[] = {
    &CLOD_MEASURE_LEAVERS,   &CLOD_MEASURE_INLETS,     &CLOD_MEASURE_OUTLETS,
    &CLOD_MEASURE_RESIDENCE, &CLOD_MEASURE_WALL_LOADS, &CLOD_MEASURE_SURFACES,
    &CLOD_MEASURE_BALANCE,   &CLOD_MEASURE_BELT_LOADS, &CLOD_MEASURE_GAUGES,
    &CLOD_MEASURE_FIELDS,    &CLOD_MEASURE_MIXING,     &CLOD_MEASURE_REPOSE,
    &CLOD_MEASURE_CLUMPS,    &CLOD_MEASURE_BUILD_UP,   &CLOD_MEASURE_HISTORY_MAP,
};
enum { COUNT = sizeof MEASURES / sizeof *MEASURES };

#define ALIGNMENT 16

/** Before what each measure remembers. */
typedef struct clod_free_memory {
    _Alignas(ALIGNMENT) double begin; ///< s, time at which the run began
    double unused;                    ///< no gap with chance bytes
} clod_free_memory;

static size_t size_of(const clod_free_measure *self, const clod_case *from)
{
    const size_t size = self->size != NULL ? self->size(from) : 0;
    return (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

/** The memory of measure number k. */
static void *memory_of(const void *memory, const clod_case *from, int k)
{
    const unsigned char *at = (const unsigned char *)memory + sizeof(clod_free_memory);
    for (int m = 0; m < k; m++) {
        at += size_of(MEASURES[m], from);
    }
    return MEASURES[k]->size != NULL ? (void *)at : NULL;
}

size_t clod_free_measures_size(const clod_case *from)
{
    size_t size = sizeof(clod_free_memory);
    for (int k = 0; k < COUNT; k++) {
        size += size_of(MEASURES[k], from);
    }
    return size;
}

clod_free_start clod_free_start_of(const clod_state *state)
{
    const clod_measure_motion all = clod_measure_motion_of(state);
    clod_free_start bed = {.grains = all.grains, .mass = all.mass};
    for (size_t g = 0; g < state->grains.count; g++) {
        bed.last_id = state->grains.id[g] > bed.last_id ? state->grains.id[g] : bed.last_id;
    }
    return bed;
}

void clod_free_measures_begin(void *memory, const clod_case *from, const clod_state *state)
{
    const clod_free_start bed = clod_free_start_of(state);
    clod_free_measures_begin_with(memory, from, state, &bed);
}

void clod_free_measures_begin_with(void *memory, const clod_case *from, const clod_state *state,
                                   const clod_free_start *bed)
{
    clod_free_memory *self = memory;
    self->begin = state->time;
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->begin != NULL) {
            MEASURES[k]->begin(memory_of(memory, from, k), from, state, bed);
        }
    }
}

clod_free_moment clod_free_measures_moment(const void *memory, const clod_case *from,
                                           clod_state *state, const clod_survey *survey)
{
    const clod_free_memory *self = memory;
    return (clod_free_moment){.from = from,
                              .state = state,
                              .survey = survey,
                              .steady = clod_steady_time_of(from, self->begin, state->dt)};
}

void clod_free_measures_sight(const void *memory, const clod_free_moment *now, clod_sight *sees)
{
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->sight != NULL) {
            MEASURES[k]->sight(memory_of(memory, now->from, k), now, sees);
        }
    }
}

bool clod_free_measures_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    bool good = true;
    for (int k = 0; good && k < COUNT; k++) {
        good = MEASURES[k]->act == NULL ||
               MEASURES[k]->act(memory_of(memory, now->from, k), now, status);
    }
    return good;
}

int64_t clod_free_measures_plan(const void *memory, const clod_case *from,
                                const clod_state *state)
{
    const clod_free_memory *self = memory;
    const clod_steady_time steady = clod_steady_time_of(from, self->begin, state->dt);
    int64_t first = INT64_MAX;
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->plan != NULL) {
            const int64_t steps =
                MEASURES[k]->plan(memory_of(memory, from, k), from, state, &steady);
            first = steps < first ? steps : first;
        }
    }
    return first;
}

bool clod_free_measures_need(const clod_case *from, const char *wall, char *text, size_t size)
{
    bool needed = false;
    for (int k = 0; !needed && k < COUNT; k++) {
        needed = MEASURES[k]->needs != NULL && MEASURES[k]->needs(from, wall, text, size);
    }
    return needed;
}

bool clod_free_measures_news(void *memory, const clod_case *from, const clod_state *state,
                             clod_news *news)
{
    bool found = false;
    for (int k = 0; !found && k < COUNT; k++) {
        found = MEASURES[k]->news != NULL &&
                MEASURES[k]->news(memory_of(memory, from, k), from, state, news);
    }
    return found;
}

bool clod_free_measures_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    bool good = true;
    for (int k = 0; good && k < COUNT; k++) {
        good = MEASURES[k]->look == NULL ||
               MEASURES[k]->look(memory_of(memory, now->from, k), now, status);
    }
    return good;
}

bool clod_free_measures_picture(void *memory, const clod_free_moment *now,
                                const clod_frame *frame, clod_status *status)
{
    bool good = true;
    for (int k = 0; good && k < COUNT; k++) {
        good = MEASURES[k]->picture == NULL ||
               MEASURES[k]->picture(memory_of(memory, now->from, k), now, frame, status);
    }
    return good;
}

static size_t columns_of(int k, const clod_case *from, const clod_state *state)
{
    return MEASURES[k]->columns != NULL ? MEASURES[k]->columns(from, state) : 0;
}

size_t clod_free_measures_columns(const clod_case *from, const clod_state *state)
{
    size_t columns = 0;
    for (int k = 0; k < COUNT; k++) {
        columns += columns_of(k, from, state);
    }
    return columns;
}

/** The measure that has column k of all; k becomes the number among its own. */
static int find_owner(const clod_case *from, const clod_state *state, size_t *k)
{
    int m = 0;
    for (size_t columns; *k >= (columns = columns_of(m, from, state)); m++) {
        *k -= columns;
    }
    return m;
}

void clod_free_measures_column(const clod_case *from, const clod_state *state, size_t k,
                               char *text, size_t size)
{
    const int m = find_owner(from, state, &k);
    MEASURES[m]->column(from, state, k, text, size);
}

int clod_free_measures_owner(const clod_case *from, const clod_state *state, size_t k)
{
    return find_owner(from, state, &k);
}

void clod_free_measures_row(void *memory, const clod_free_moment *now, double *row)
{
    for (int k = 0; k < COUNT; k++) {
        const size_t columns = columns_of(k, now->from, now->state);
        if (columns > 0) {
            MEASURES[k]->row(memory_of(memory, now->from, k), now, row);
            row += columns;
        }
    }
}

void clod_free_measures_sums_end(void *memory, const clod_free_moment *now)
{
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->sums_end != NULL) {
            MEASURES[k]->sums_end(memory_of(memory, now->from, k), now);
        }
    }
}

void clod_free_measures_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->report != NULL) {
            MEASURES[k]->report(out, memory_of(memory, now->from, k), now);
        }
    }
}

void clod_free_measures_warn(json_t *list, const void *memory, const clod_free_moment *now)
{
    for (int k = 0; k < COUNT; k++) {
        if (MEASURES[k]->warn != NULL) {
            MEASURES[k]->warn(list, memory_of(memory, now->from, k), now);
        }
    }
}

static bool is_told(int k, const clod_case *from)
{
    return MEASURES[k]->json != NULL && (MEASURES[k]->told == NULL || MEASURES[k]->told(from));
}

void clod_free_measures_paths(const clod_case *from, const clod_state *state,
                              clod_free_paths *paths)
{
    for (int k = 0; k < COUNT; k++) {
        if (is_told(k, from)) {
            paths->key = MEASURES[k]->key;
            MEASURES[k]->paths(from, state, paths);
        }
    }
    paths->key = NULL;
}

void clod_free_measures_json(json_t *summary, const void *memory, const clod_free_moment *now)
{
    for (int k = 0; k < COUNT; k++) {
        json_t *told = is_told(k, now->from)
                           ? MEASURES[k]->json(memory_of(memory, now->from, k), now)
                           : NULL;
        if (told != NULL) {
            json_object_set_new(summary, MEASURES[k]->key, told);
        }
    }
}

bool clod_free_measures_write(const clod_folder *folder, const void *memory,
                              const clod_free_moment *now, clod_status *status)
{
    bool good = true;
    for (int k = 0; good && k < COUNT; k++) {
        good = MEASURES[k]->write == NULL ||
               MEASURES[k]->write(folder, memory_of(memory, now->from, k), now, status);
    }
    return good;
}
