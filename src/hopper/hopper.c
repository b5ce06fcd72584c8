/**
 * @file hopper.c
 * From a case file to a finished design.
 */

#include <math.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "hopper/doubts.h"
#include "hopper/interval.h"
#include "hopper/tables.h"

// Source: Marinelli, "Mass flow design considerations (arching, part 1)": 6 to 8 times the largest
// particle in cones, 3 to 4 times in slots; the larger numbers.
static const double PARTICLES[] = {[CLOD_RADIAL_WEDGE] = 4.0, [CLOD_RADIAL_CONE] = 8.0};

/** What is wanted of a shape, and its values. */
static void design(clod_hopper *self, clod_radial_shape shape, const clod_hopper_shape *wanted)
{
    clod_hopper_found *found = &self->shape[shape];
    found->wish = (clod_hopper_wish){.shape = shape,
                                     .half_angle = wanted->half_angle,
                                     .limit = wanted->limit,
                                     .margin = self->from.margin,
                                     .arch = (clod_hopper_arch)self->from.arch,
                                     .outlet = wanted->outlet,
                                     .least = PARTICLES[shape] * self->from.largest_particle,
                                     .tolerance = CLOD_RADIAL_TOLERANCE};
    found->planned = found->wish.outlet;
    found->limit_error = wanted->limit_error;
    found->mechanical = found->wish.least;
    found->design = clod_hopper_design_shape(&self->solid, &found->wish);
    found->lower = clod_ranges_of_outlets(&self->solid, &found->wish, &found->design);
    clod_hopper_outcome outcome;
    double number[CLOD_HOPPER_NUMBERS];
    clod_interval_numbers(&self->solid, found, &outcome, number);
    for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
        found->number[n].value = number[n];
    }
}

static bool fill(clod_hopper *self, clod_status *status)
{
    design(self, CLOD_RADIAL_CONE, &self->from.cone);
    design(self, CLOD_RADIAL_WEDGE, &self->from.wedge);
    self->silo = (clod_rathole_silo){self->from.silo.diameter, self->from.silo.height,
                                     self->from.silo.stress_ratio};
    self->hole = clod_rathole_of(&self->solid, &self->silo);
    self->lower_holes = clod_rathole_ranges(&self->solid, &self->hole);
    self->slot = clod_rathole_slot_of(&self->solid);
    self->slot_width.value = self->slot.width;
    self->rathole[CLOD_HOPPER_EMPTYING].value = self->hole.emptying;
    self->rathole[CLOD_HOPPER_FILLING].value = self->hole.filling;
    return clod_interval_fill(self, status) && clod_interval_specimens(self, status);
}

/** Whether as many overrides are there as were said. */
static bool overrides_given(const char *const *overrides, size_t count, clod_status *status)
{
    bool given =
        count == 0 || clod_given(overrides != NULL, "clod_hopper_create", "overrides", status);
    for (size_t k = 0; given && k < count; k++) {
        given =
            clod_given(overrides[k] != NULL, "clod_hopper_create", "one of overrides", status);
    }
    return given;
}

/** Copy what was said in place of the file. */
static bool keep_overrides(clod_hopper *self, const char *const *overrides, size_t count)
{
    self->overrides = clod_memory_alloc(count, sizeof *self->overrides);
    bool good = self->overrides != NULL || count == 0;
    for (size_t k = 0; good && k < count; k++) {
        self->overrides[k] = clod_memory_text(overrides[k]);
        good = self->overrides[k] != NULL;
        self->override_count += good ? 1 : 0;
    }
    return good;
}

clod_hopper *clod_hopper_create(const char *path, const char *const *overrides,
                                size_t override_count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !overrides_given(overrides, override_count, status)) {
        return NULL;
    }
    clod_hopper *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL || (self->path = clod_memory_text(path)) == NULL ||
        !keep_overrides(self, overrides, override_count)) {
        clod_hopper_destroy(&self);
        clod_status_fail(status, CLOD_FAILED, "No memory for the design.");
        return NULL;
    }
    clod_tables_notes notes = {.warnings = &self->warnings};
    if (!clod_hopper_case_load(path, overrides, override_count, &self->from, status) ||
        !clod_tables_read(&self->from, &self->solid, &notes, status) ||
        !clod_doubts_check(&self->from, path, &self->solid, status) || !fill(self, status)) {
        clod_hopper_destroy(&self);
        return NULL;
    }
    clod_doubts_warn(self, &notes);
    return self;
}

void clod_hopper_destroy(clod_hopper **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    clod_hopper_case_fini(&(*self)->from);
    clod_tables_fini(&(*self)->solid);
    for (size_t k = 0; k < (*self)->override_count; k++) {
        clod_memory_free((*self)->overrides[k]);
    }
    clod_memory_free((*self)->overrides);
    clod_memory_free((*self)->specimens);
    clod_memory_free((*self)->path);
    clod_memory_free(*self);
    *self = NULL;
}

void clod_hopper_free(char *text)
{
    clod_memory_free(text);
}
