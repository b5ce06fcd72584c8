#include "tester/shear_tester.h"

#include <string.h>

#include "base/assert.h"
#include "tester/bed.h"

const char *const clod_ring_shear_columns[CLOD_RING_SHEAR_COLUMNS] = {
    "time [s]",
    "phase [1]",
    "displacement [m]",
    "normal_stress [Pa]",
    "normal_stress_base [Pa]",
    "shear_stress [Pa]",
    "shear_stress_base [Pa]",
    "height [m]",
    "bulk_density [kg/m3]",
    "speed [m/s]",
    "power [W]",
};

static const clod_shear_tester *const TESTERS[CLOD_RING_SHEAR_KINDS] = {
    [CLOD_RING_SHEAR_RING] = &CLOD_SHEAR_TESTER_RING,
    [CLOD_RING_SHEAR_JENIKE] = &CLOD_SHEAR_TESTER_JENIKE,
};

const clod_shear_tester *clod_shear_tester_of(const clod_ring_shear *self)
{
    CLOD_ASSERT(self->kind >= 0 && self->kind < CLOD_RING_SHEAR_KINDS);
    return TESTERS[self->kind];
}

const clod_shear_tester *clod_shear_tester_of_case(const clod_case *from)
{
    const char *key = clod_case_tester(from);
    const clod_shear_tester *found = NULL;
    CLOD_ASSERT(key != NULL);
    for (int kind = 0; kind < CLOD_RING_SHEAR_KINDS; kind++) {
        found = strcmp(TESTERS[kind]->key, key) == 0 ? TESTERS[kind] : found;
    }
    CLOD_ASSERT(found != NULL);
    return found;
}

double clod_shear_tester_lid_height(const clod_ring_shear *self, const clod_state *state)
{
    return self->lid_start + clod_bed_wall(state, "lid")->shift.z;
}

double clod_shear_tester_solid_above(const clod_ring_shear *self, const clod_state *state)
{
    const double lid = clod_shear_tester_lid_height(self, state);
    const double plane = clod_shear_tester_of(self)->shear_plane(self, lid);
    double mass = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        mass += state->grains.position[g][2] > plane ? state->grains.velocity[g][3] : 0.0;
    }
    return -mass * state->gravity[2] / self->area;
}

void clod_shear_tester_measure(const clod_ring_shear *self, const clod_state *state,
                               double *row)
{
    const clod_shear_tester *tester = clod_shear_tester_of(self);
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const double steps = (double)(lid->sum_steps > 0 ? lid->sum_steps : 1);
    const double height = clod_shear_tester_lid_height(self, state);
    row[CLOD_RING_SHEAR_TIME] = (double)state->step * state->dt;
    row[CLOD_RING_SHEAR_PHASE] = (double)self->phase;
    row[CLOD_RING_SHEAR_DISPLACEMENT] = self->displacement;
    row[CLOD_RING_SHEAR_NORMAL_STRESS] =
        lid->sum_force.z / (steps * self->area) + clod_shear_tester_solid_above(self, state);
    row[CLOD_RING_SHEAR_HEIGHT] = height;
    row[CLOD_RING_SHEAR_BULK_DENSITY] =
        self->grain_mass / (self->area * height - self->bars_volume);
    row[CLOD_RING_SHEAR_SPEED] = tester->speed(self, state);
    tester->read(self, state, steps, row);
}
