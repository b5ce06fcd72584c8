#include "tester/jenike.h"

#include <math.h>

#include "tester/bed.h"
#include "tester/ring_measure.h"

void clod_jenike_begin(clod_ring_shear *self, const clod_case *from, clod_state *state)
{
    const clod_case_jenike *cell = &from->jenike;
    *self = (clod_ring_shear){
        .area = 0.25 * M_PI * cell->diameter * cell->diameter,
        .lid_mass = cell->lid_mass,
        .lowest_lid = cell->base_height + 2.0 * clod_bed_largest(state),
        .fill_max = cell->fill_max,
        .settle_max = cell->settle_max,
        .straight = 1,
        .base_height = cell->base_height,
        .twist_angle = cell->twist_angle,
        .twists = cell->twists,
    };
    clod_ring_shear_start(self, &cell->programme, state);
}

void clod_jenike_set_speed(clod_state *state, double speed)
{
    clod_bed_wall(state, "shear_ring")->velocity.x = speed;
    clod_bed_wall(state, "lid")->velocity.x = speed;
}

double clod_jenike_speed(const clod_state *state)
{
    return clod_bed_wall(state, "shear_ring")->velocity.x;
}

bool clod_jenike_is_at_speed(const clod_ring_shear *self, const clod_state *state)
{
    return clod_jenike_speed(state) == self->target_speed;
}

bool clod_jenike_is_behind(const clod_state *state)
{
    const clod_wall *ring = clod_bed_wall(state, "shear_ring");
    const clod_shape *rim = &ring->shapes[1];
    return rim->center.x + ring->shift.x <= rim->inner - rim->outer;
}

/** Bring a spin towards its target; whether it is there. */
static bool slew_spin(clod_wall *wall, double target, double most)
{
    const double change = target - wall->spin;
    wall->spin = fabs(change) <= most ? target : wall->spin + copysign(most, change);
    return wall->spin == target;
}

bool clod_jenike_twist(clod_ring_shear *self, clod_state *state, double change)
{
    clod_wall *lid = clod_bed_wall(state, "lid");
    const double radius = lid->shapes[0].outer;
    // first to the positive side; the last way, after all turns, ends where it began
    const double way = self->turns % 2 == 0 ? 1.0 : -1.0;
    const bool last = self->turns == 2 * self->twists;
    const bool there = way * lid->angle >= (last ? 0.0 : self->twist_angle);
    if (last && there) {
        return slew_spin(lid, 0.0, change / radius);
    }
    self->turns += there ? 1 : 0;
    slew_spin(lid, (there ? -way : way) * self->speed / radius, change / radius);
    return false;
}

void clod_jenike_measure(const clod_ring_shear *self, const clod_state *state, double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *ring = clod_bed_wall(state, "shear_ring");
    const clod_wall *base = clod_bed_wall(state, "base");
    const clod_wall *base_ring = clod_bed_wall(state, "base_ring");
    const double steps = (double)(lid->sum_steps > 0 ? lid->sum_steps : 1);
    const double area = steps * self->area;
    const double height = clod_ring_lid_height(self, state);
    row[CLOD_RING_SHEAR_TIME] = (double)state->step * state->dt;
    row[CLOD_RING_SHEAR_PHASE] = (double)self->phase;
    row[CLOD_RING_SHEAR_DISPLACEMENT] = self->displacement;
    row[CLOD_RING_SHEAR_NORMAL_STRESS] =
        lid->sum_force.z / area + clod_ring_solid_above(self, state);
    row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE] =
        -(base->sum_force.z + base_ring->sum_force.z) / area;
    row[CLOD_RING_SHEAR_SHEAR_STRESS] = -(lid->sum_force.x + ring->sum_force.x) / area;
    row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE] =
        (base->sum_force.x + base_ring->sum_force.x) / area;
    row[CLOD_RING_SHEAR_HEIGHT] = height;
    row[CLOD_RING_SHEAR_BULK_DENSITY] = self->grain_mass / (self->area * height);
    row[CLOD_RING_SHEAR_SPEED] = clod_jenike_speed(state);
    // of the drive: what the lid does on its way down is the load's, not the stem's
    row[CLOD_RING_SHEAR_POWER] =
        row[CLOD_RING_SHEAR_SHEAR_STRESS] * self->area * row[CLOD_RING_SHEAR_SPEED];
}
