// Properties of the grains as views of their rows.
#include <stdio.h>
#include <string.h>

#include "sim/sim.h"

/** A property: where its first number lies in the rows of clod_grains. */
typedef struct field {
    const char *name, *unit;
    clod_sim_type type;
    size_t components;
    size_t rows;   ///< offset in clod_grains of the pointer to the rows
    size_t stride; ///< bytes of a row
    size_t offset; ///< bytes from the start of a row
    bool writable;
} field;

#define GRAINS(member) offsetof(clod_grains, member), sizeof *((clod_grains *)NULL)->member
#define NUMBER(index) ((index) * sizeof(double))

static const field FIELDS[] = {
    // clang-format off
    // name,              unit,         type,         numbers, rows,         offset,    writable
    {"position",          "m",          CLOD_SIM_F64, 3, GRAINS(position),    NUMBER(0), true},
    {"radius",            "m",          CLOD_SIM_F64, 1, GRAINS(position),    NUMBER(3), false},
    {"velocity",          "m/s",        CLOD_SIM_F64, 3, GRAINS(velocity),   NUMBER(0), true},
    {"mass",              "kg",         CLOD_SIM_F64, 1, GRAINS(velocity),   NUMBER(3), false},
    {"angular_velocity",  "rad/s",      CLOD_SIM_F64, 3, GRAINS(angular_velocity),  NUMBER(0), true},
    {"inverse_inertia",   "1/(kg m2)",  CLOD_SIM_F64, 1, GRAINS(angular_velocity),  NUMBER(3), false},
    {"force",             "N",          CLOD_SIM_F64, 3, GRAINS(load),     NUMBER(0), true},
    {"torque",            "N m",        CLOD_SIM_F64, 3, GRAINS(load),     NUMBER(4), true},
    {"id",                "1",          CLOD_SIM_U64, 1, GRAINS(id),       0,         false},
    {"material",          "1",          CLOD_SIM_U16, 1, GRAINS(material), 0,         false},
    // clang-format on
};
#define FIELD_COUNT (sizeof FIELDS / sizeof *FIELDS)
_Static_assert(FIELD_COUNT == CLOD_SIM_ARRAYS, "room for a loan of each");

size_t clod_sim_grain_count(const clod_sim *self)
{
    CLOD_NEED(self);
    return clod_step_grains(&self->step);
}

size_t clod_sim_array_count(void)
{
    return FIELD_COUNT;
}

const char *clod_sim_array_name(size_t index)
{
    return index < FIELD_COUNT ? FIELDS[index].name : NULL;
}

static bool no_such_array(const char *name, clod_status *status)
{
    char all[512] = "";
    for (size_t f = 0; f < FIELD_COUNT; f++) {
        const size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", f > 0 ? ", " : "", FIELDS[f].name);
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "clod_sim_array: grains have no property '%s'; there are: %s", name,
                            all);
}

clod_sim_view clod_sim_view_of(clod_sim *self, size_t array)
{
    const field *from = &FIELDS[array];
    char *rows;
    memcpy(&rows, (const char *)&self->state.grains + from->rows, sizeof rows);
    return (clod_sim_view){.name = from->name,
                           .unit = from->unit,
                           .type = from->type,
                           .rows = self->state.grains.count,
                           .components = from->components,
                           .stride = from->stride,
                           .writable = from->writable,
                           .data = rows + from->offset};
}

bool clod_sim_array(clod_sim *self, const char *name, clod_sim_view *view, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(name, status) || !CLOD_GIVEN(view, status)) {
        return false;
    }
    for (size_t f = 0; f < FIELD_COUNT; f++) {
        if (strcmp(FIELDS[f].name, name) != 0) {
            continue;
        }
        if (!clod_step_see(&self->step, status)) {
            return false;
        }
        clod_sim_view made = clod_sim_view_of(self, f);
        if (clod_sim_is_spread(self) && !clod_sim_lend(self, f, &made, status)) {
            return false;
        }
        *view = made;
        return true;
    }
    return no_such_array(name, status);
}

size_t clod_sim_row_of_id(clod_sim *self, uint64_t id)
{
    CLOD_NEED(self);
    clod_status ignored;
    const clod_grains *grains = &self->state.grains;
    if (!clod_step_see(&self->step, &ignored)) {
        return SIZE_MAX;
    }
    for (size_t g = 0; g < grains->count; g++) {
        if (grains->id[g] == id) {
            return g;
        }
    }
    return SIZE_MAX;
}

bool clod_sim_positions_changed(clod_sim *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status)) {
        return false;
    }
    clod_sim_fetch(self);
    for (size_t g = 0; g < self->state.grains.count; g++) {
        char name[64];
        snprintf(name, sizeof name, "position of grain %llu",
                 (unsigned long long)self->state.grains.id[g]);
        if (!clod_sim_finite(self->state.grains.position[g], __func__, name, status)) {
            return false;
        }
    }
    clod_changes_moved(&self->state.changes);
    return true;
}
