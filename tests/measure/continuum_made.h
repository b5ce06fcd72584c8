#pragma once
/**
 * @file continuum_made.h
 * Grains and contacts with given forces, and the sums that a field makes of them.
 */

#include "measure/continuum_pass.h"

#include <string.h>

#include "base/memory.h"
#include "support/check.h"

#define MOST 8
#define DENSITY 2500.0

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};

/** Contacts with the forces that a test gives them. */
typedef struct given {
    clod_contact contact[MOST];
    clod_contact_force told[MOST]; ///< of contacts met from i to j
    size_t count, at;
} given;

static inline void given_begin(void *context, size_t *pairs, size_t *walls)
{
    given *self = context;
    self->at = *walls = 0;
    *pairs = self->count;
}

static inline size_t given_next(void *context, clod_contact *to, size_t room)
{
    given *self = context;
    size_t count = 0;
    for (; count < room && self->at < self->count; self->at++) {
        to[count++] = self->contact[self->at];
    }
    return count;
}

static inline clod_contact_force given_force(const void *laws, const clod_contact *contact)
{
    const given *self = laws;
    for (size_t k = 0; k < self->count; k++) {
        if (self->contact[k].i == contact->i && self->contact[k].j == contact->j) {
            return self->told[k];
        }
    }
    fail(); // it was turned: tests give contacts from the smaller id
    return self->told[0];
}

static inline clod_contact_source source_of(given *self)
{
    return (clod_contact_source){.context = self,
                                 .begin = given_begin,
                                 .next = given_next,
                                 .laws = self,
                                 .force = given_force};
}

static inline void add(clod_state *state, double x, double y, double z, double r,
                       const double v[3])
{
    const double position[4] = {x, y, z, r};
    assert_true(clod_grains_add(&state->grains, position, v, NONE, DENSITY, 0,
                                state->grains.count + 1, &status));
}

static inline double mass_of(double r)
{
    return DENSITY * 4.0 / 3.0 * M_PI * r * r * r;
}

static inline clod_continuum box_of(const double low[3], const double high[3], double cell,
                                    double width)
{
    clod_outlet box = {.outer = 0.0};
    memcpy(box.low, low, sizeof box.low);
    memcpy(box.high, high, sizeof box.high);
    return clod_continuum_make(&box, cell, width);
}

/** Sums of one sample over all points, times the volume of each; owned points in `each` if it is
 *  not NULL. */
static inline void sample(const clod_continuum *field, const clod_state *state, given *contacts,
                          double sum[CLOD_CONTINUUM_SUMS], double (**each)[CLOD_CONTINUUM_SUMS])
{
    given none = {.count = 0};
    const clod_contact_source source = source_of(contacts != NULL ? contacts : &none);
    const size_t points = (size_t)clod_continuum_points(field);
    double(*to)[CLOD_CONTINUUM_SUMS] = clod_memory_alloc(points, sizeof *to);
    const clod_continuum_part part = {field, to};
    const clod_survey survey = clod_survey_of(state, &source);
    assert_true(clod_continuum_pass(&part, 1, &survey, &status));
    const double volume = field->cell > 0.0 ? field->cell * field->cell * field->cell
                                            : clod_continuum_volume(&field->region);
    memset(sum, 0, CLOD_CONTINUUM_SUMS * sizeof *sum);
    for (size_t p = 0; p < points; p++) {
        for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
            sum[c] += volume * to[p][c];
        }
    }
    if (each != NULL) {
        *each = to;
    } else {
        clod_memory_free(to);
    }
}
