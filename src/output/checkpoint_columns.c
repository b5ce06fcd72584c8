#include "output/checkpoint_columns.h"

#include <stdio.h>

#include "base/assert.h"

/** Where the rows of a group of columns start, and how they follow each other. */
typedef struct clod_rows {
    const void *base; ///< NULL only without rows
    size_t count, stride;
} clod_rows;

static void add(clod_checkpoint_columns *self, clod_rows rows, size_t offset, const char *name,
                const char *units, clod_hdf_type type, size_t components)
{
    CLOD_ASSERT(self->count < CLOD_CHECKPOINT_COLUMNS);
    self->column[self->count++] = (clod_hdf_column){
        .name = name,
        .units = units,
        .type = type,
        .components = components,
        .rows = rows.base == NULL ? 0 : rows.count,
        .data = rows.base == NULL ? NULL : (const char *)rows.base + offset,
        .stride = rows.stride,
    };
}

static void add_state(clod_checkpoint_columns *self, const clod_state *state)
{
    const clod_rows one = {state, 1, sizeof *state};
#define ADD(field, name, units, type, n)                                                       \
    add(self, one, offsetof(clod_state, field), "state/" name, units, CLOD_HDF_##type, n)
    ADD(step, "step", "1", I64, 1);
    ADD(time, "time", "s", F64, 1);
    ADD(dt, "dt", "s", F64, 1);
    ADD(adhesion, "adhesion", "1", F64, 1);
    ADD(gravity, "gravity", "m s-2", F64, 3);
    ADD(domain.min, "domain_min", "m", F64, 3);
    ADD(domain.max, "domain_max", "m", F64, 3);
    ADD(domain.periodic, "domain_periodic", "1", U8, 3);
    ADD(ledger.open, "ledger_open", "1", I64, 1);
    ADD(ledger.start, "ledger_start", "J", F64, 1);
    ADD(ledger.plastic, "ledger_plastic", "J", F64, 1);
    ADD(ledger.dash_pot, "ledger_dash_pot", "J", F64, 1);
    ADD(ledger.friction, "ledger_friction", "J", F64, 1);
    ADD(ledger.rolling, "ledger_rolling", "J", F64, 1);
    ADD(ledger.lag, "ledger_lag", "J", F64, 1);
    ADD(ledger.wall_work, "ledger_wall_work", "J", F64, 1);
    ADD(ledger.exchanged, "ledger_exchanged", "J", F64, 1);
    ADD(exchange.walls_removed, "walls_removed", "1", I64, 1);
    ADD(exchange.added, "grains_added", "1", I64, 1);
    ADD(exchange.removed, "grains_removed", "1", I64, 1);
    ADD(exchange.added_mass, "mass_added", "kg", F64, 1);
    ADD(exchange.removed_mass, "mass_removed", "kg", F64, 1);
    ADD(exchange.left, "grains_left", "1", I64, CLOD_EXITS);
    ADD(exchange.left_mass, "mass_left", "kg", F64, CLOD_EXITS);
    ADD(exchange.left_energy, "energy_left", "J", F64, CLOD_EXITS);
    ADD(exchange.residence_since, "residence_since", "s", F64, 1);
    ADD(exchange.residence, "residence", "s", F64, 1);
    ADD(exchange.residence_squared, "residence_squared", "s2", F64, 1);
    ADD(exchange.residence_least, "residence_least", "s", F64, 1);
    ADD(exchange.residence_most, "residence_most", "s", F64, 1);
    ADD(exchange.residence_count, "residence_count", "1", I64, CLOD_TIME_CLASSES);
    ADD(exchange.left_clumps, "left_clumps", "1", I64, 1 + CLOD_CLUMP_CLASSES);
    ADD(domain.removes, "domain_removes", "1", U8, 1);
    ADD(domain.outlets, "outlets", "1", I32, 1);
    ADD(domain.outlet, "outlet", "m", F64, CLOD_OUTLETS * CLOD_OUTLET_NUMBERS);
    ADD(build_motion, "build_motion", "m", F64, 1);
    ADD(build_skin, "build_skin", "m", F64, 1);
#undef ADD
}

void clod_checkpoint_columns_of_grains(clod_checkpoint_columns *self, const clod_state *state)
{
    self->count = 0;
    const clod_grains *grains = &state->grains;
    const size_t n = grains->count;
    const size_t real = sizeof(double);
    const clod_rows id = {grains->id, n, sizeof *grains->id};
    const clod_rows birth = {grains->birth, n, sizeof *grains->birth};
    const clod_rows material = {grains->material, n, sizeof *grains->material};
    const clod_rows position = {grains->position, n, sizeof *grains->position};
    const clod_rows velocity = {grains->velocity, n, sizeof *grains->velocity};
    const clod_rows angular_velocity = {grains->angular_velocity, n,
                                        sizeof *grains->angular_velocity};
    const clod_rows load = {grains->load, n, sizeof *grains->load};
    add(self, id, 0, "grains/id", "1", CLOD_HDF_U64, 1);
    add(self, birth, 0, "grains/birth", "s", CLOD_HDF_F64, 1);
    if (grains->clump != NULL) {
        const clod_rows clump = {grains->clump, n, sizeof *grains->clump};
        add(self, clump, offsetof(clod_grain_clump, since), "grains/clump_since", "s",
            CLOD_HDF_F64, 1);
        add(self, clump, offsetof(clod_grain_clump, seen), "grains/clump_size", "1",
            CLOD_HDF_I32, 1);
    }
    add(self, material, 0, "grains/material", "1", CLOD_HDF_U16, 1);
    add(self, position, 0, "grains/position", "m", CLOD_HDF_F64, 3);
    add(self, position, 3 * real, "grains/radius", "m", CLOD_HDF_F64, 1);
    add(self, velocity, 0, "grains/velocity", "m s-1", CLOD_HDF_F64, 3);
    add(self, velocity, 3 * real, "grains/mass", "kg", CLOD_HDF_F64, 1);
    add(self, angular_velocity, 0, "grains/angular_velocity", "rad s-1", CLOD_HDF_F64, 3);
    add(self, angular_velocity, 3 * real, "grains/inverse_inertia", "kg-1 m-2", CLOD_HDF_F64,
        1);
    add(self, load, 0, "grains/force", "N", CLOD_HDF_F64, 3);
    add(self, load, 4 * real, "grains/torque", "N m", CLOD_HDF_F64, 3);
    if (state->build_position != NULL && n > 0) {
        const clod_rows build = {state->build_position, n, sizeof *state->build_position};
        add(self, build, 0, "grains/build_position", "m", CLOD_HDF_F64, 4);
    }
}

/** Where the walls were when the lists were made. */
static void add_build(clod_checkpoint_columns *self, const clod_state *state)
{
    if (state->build_walls != NULL && state->walls.count > 0) {
        const clod_rows build = {state->build_walls, (size_t)state->walls.count,
                                 sizeof *state->build_walls};
        add(self, build, 0, "walls/build_shift", "m", CLOD_HDF_F64, 3);
        add(self, build, 3 * sizeof(double), "walls/build_angle", "rad", CLOD_HDF_F64, 1);
        add(self, build, 4 * sizeof(double), "walls/build_orientation", "1", CLOD_HDF_F64, 4);
    }
}

/** Planes and what has passed them; the state says how many there are. */
static void add_planes(clod_checkpoint_columns *self, const clod_state *state)
{
    const clod_planes *planes = &state->planes;
    const size_t n = (size_t)planes->count;
    const clod_rows plane = {planes->plane, n, sizeof *planes->plane};
    const clod_rows passed = {planes->passed, n, sizeof *planes->passed};
    if (n == 0) { // most runs have none
        return;
    }
    add(self, plane, offsetof(clod_plane, region), CLOD_CHECKPOINT_PLANES, "m", CLOD_HDF_F64,
        CLOD_OUTLET_NUMBERS);
    add(self, plane, offsetof(clod_plane, at), "planes/at", "m", CLOD_HDF_F64, 1);
    add(self, plane, offsetof(clod_plane, axis), "planes/axis", "1", CLOD_HDF_I32, 1);
    add(self, plane, offsetof(clod_plane, sign), "planes/sign", "1", CLOD_HDF_I32, 1);
    add(self, passed, offsetof(clod_passed, grains), "planes/grains", "1", CLOD_HDF_I64,
        CLOD_PASSED_WAYS);
    // settled: the rest of an exact sum is zero
    add(self, passed, offsetof(clod_passed, mass[CLOD_PASSED_FORWARD].chunk),
        "planes/mass_forward", "1", CLOD_HDF_I64, CLOD_EXACT_CHUNKS);
    add(self, passed, offsetof(clod_passed, mass[CLOD_PASSED_BACK].chunk), "planes/mass_back",
        "1", CLOD_HDF_I64, CLOD_EXACT_CHUNKS);
}

void clod_checkpoint_columns_of_walls(clod_checkpoint_columns *self, const clod_wall *walls,
                                      size_t rows)
{
    const clod_rows all = {walls, rows, sizeof *walls};
    self->count = 0;
    add(self, all, offsetof(clod_wall, name), "walls/name", NULL, CLOD_HDF_TEXT,
        sizeof walls->name);
#define ADD(field, units, type, n)                                                             \
    add(self, all, offsetof(clod_wall, field), "walls/" #field, units, CLOD_HDF_##type, n)
    ADD(material, "1", U16, 1);
    ADD(shape_count, "1", I32, 1);
    ADD(velocity, "m s-1", F64, 3);
    ADD(surface_velocity, "m s-1", F64, 3);
    ADD(spin, "rad s-1", F64, 1);
    ADD(spin_axis, "1", F64, 3);
    ADD(spin_point, "m", F64, 3);
    ADD(orientation, "1", F64, 4);
    ADD(shift, "m", F64, 3);
    ADD(angle, "rad", F64, 1);
    ADD(oscillation.direction, "1", F64, 3);
    ADD(oscillation.amplitude, "m", F64, 1);
    ADD(oscillation.angle, "rad", F64, 1);
    ADD(oscillation.frequency, "Hz", F64, 1);
    ADD(oscillation.phase, "rad", F64, 1);
    ADD(travel, "m", F64, 3);
    ADD(turned, "rad", F64, 1);
    ADD(sway_velocity, "m s-1", F64, 3);
    ADD(sway_spin, "rad s-1", F64, 1);
    ADD(start_up.at, "s", F64, 1);
    ADD(start_up.duration, "s", F64, 1);
    ADD(belt_lag, "1", F64, 1);
    ADD(load, "1", I32, 1);
    ADD(load_axis, "1", F64, 3);
    ADD(load_force, "N", F64, 1);
    ADD(area, "m2", F64, 1);
    ADD(mass, "kg", F64, 1);
    ADD(damping, "N s m-1", F64, 1);
    ADD(servo_velocity, "m s-1", F64, 1);
    ADD(force, "N", F64, 3);
    ADD(torque, "N m", F64, 3);
    ADD(power, "W", F64, 1);
    ADD(belt_power, "W", F64, 1);
    ADD(sum_steps, "1", I64, 1);
    ADD(sum_force, "N", F64, 3);
    ADD(sum_torque, "N m", F64, 3);
    ADD(sum_power, "W", F64, 1);
    ADD(wear_places, "1", I32, 1);
    ADD(wear_rows, "1", I32, 1);
    ADD(wear_since, "s", F64, 1);
    ADD(wear_row, "s", F64, 1);
#undef ADD
}

void clod_checkpoint_columns_of_wear(clod_checkpoint_columns *self,
                                     const double (*sums)[CLOD_WEAR_SUMS], size_t rows)
{
    const clod_rows all = {sums, rows, sizeof *sums};
    self->count = 0;
    if (rows > 0) { // most runs have none
        add(self, all, 0, "walls/wear", "1", CLOD_HDF_F64, CLOD_WEAR_SUMS);
    }
}

void clod_checkpoint_columns_of_shapes(clod_checkpoint_columns *self, const clod_shape *shapes,
                                       size_t rows)
{
    const clod_rows all = {shapes, rows, sizeof *shapes};
    self->count = 0;
#define ADD(field, units, type, n)                                                             \
    add(self, all, offsetof(clod_shape, field), "shapes/" #field, units, CLOD_HDF_##type, n)
    ADD(kind, "1", I32, 1);
    ADD(material, "1", I32, 1);
    ADD(center, "m", F64, 3);
    ADD(axis, "1", F64, 9);
    ADD(inner, "m", F64, 1);
    ADD(outer, "m", F64, 1);
    ADD(half, "m", F64, 3);
    ADD(side, "1", I32, 1);
    ADD(patch, "1", I32, 1);
    ADD(slot, "1", I32, 1);
    ADD(outlet, "1", I32, 1);
    ADD(archard, "m3 J-1", F64, 1);
    ADD(finnie, "m3 J-1", F64, 1);
    ADD(belt.velocity, "m s-1", F64, 3);
    ADD(belt.direction, "1", F64, 3);
    ADD(belt.speed, "m s-1", F64, 1);
    ADD(belt.spin, "rad s-1", F64, 1);
    ADD(belt.spin_axis, "1", F64, 3);
    ADD(belt.spin_point, "m", F64, 3);
#undef ADD
}

void clod_checkpoint_columns_list(clod_checkpoint_columns *self, const clod_state *state)
{
    self->count = 0;
    add_state(self, state);
    add_build(self, state);
    add_planes(self, state);
}

void clod_checkpoint_columns_of_contacts(clod_checkpoint_columns *self,
                                         const clod_contact *contacts,
                                         const uint64_t (*partners)[2], size_t rows)
{
    const clod_rows all = {contacts, rows, sizeof *contacts};
    const clod_rows ids = {partners, rows, sizeof *partners};
    self->count = 0;
    add(self, ids, 0, "contacts/partners", "1", CLOD_HDF_U64, 2);
    add(self, all, offsetof(clod_contact, shape), "contacts/shape", "1", CLOD_HDF_I32, 1);
    for (int f = 0; f < CLOD_HISTORY_FIELDS; f++) {
        const clod_history_field *field = &CLOD_HISTORY[f];
        const size_t first =
            offsetof(clod_contact, history) + (size_t)field->first * sizeof(double);
        snprintf(self->name[f], sizeof self->name[f], "contacts/%s", field->name);
        add(self, all, first, self->name[f], field->unit, CLOD_HDF_F64,
            (size_t)field->components);
    }
}

void clod_checkpoint_columns_put(const clod_checkpoint_columns *self, clod_hdf *hdf)
{
    for (size_t c = 0; c < self->count; c++) {
        clod_hdf_put(hdf, &self->column[c]);
    }
}

void clod_checkpoint_columns_get(const clod_checkpoint_columns *self, clod_hdf *hdf)
{
    for (size_t c = 0; c < self->count; c++) {
        clod_hdf_get(hdf, &self->column[c]);
    }
}

clod_hdf_column clod_checkpoint_columns_wall_count(const size_t *count)
{
    return (clod_hdf_column){.name = "state/wall_contact_count",
                             .units = "1",
                             .type = CLOD_HDF_U64,
                             .components = 1,
                             .rows = 1,
                             .data = count,
                             .stride = sizeof *count};
}
