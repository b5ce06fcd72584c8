// The row of the Jenike shear tester (ASTM D6128): shear ring and lid move along x as one, base
// and base ring stand still (setup/jenike_cell.h; docs/theory/jenike.md).

#include <math.h>

#include "tester/bed.h"
#include "tester/shear_tester.h"

static void describe(clod_ring_shear *self, const clod_case *from, const clod_state *state)
{
    const clod_case_jenike *cell = &from->jenike;
    *self = (clod_ring_shear){
        .area = 0.25 * M_PI * cell->diameter * cell->diameter,
        .lid_mass = cell->lid_mass,
        .lowest_lid = cell->base_height + 2.0 * clod_bed_largest(state),
        .fill_max = cell->fill_max,
        .settle_max = cell->settle_max,
        .base_height = cell->base_height,
        .twist_angle = cell->twist_angle,
        .twists = cell->twists,
    };
}

static double speed(const clod_ring_shear *self, const clod_state *state)
{
    (void)self;
    return clod_bed_wall(state, "shear_ring")->velocity.x;
}

static void set_speed(const clod_ring_shear *self, clod_state *state, double speed)
{
    (void)self;
    clod_bed_wall(state, "shear_ring")->velocity.x = speed;
    clod_bed_wall(state, "lid")->velocity.x = speed;
}

static bool is_at_speed(const clod_ring_shear *self, const clod_state *state)
{
    return speed(self, state) == self->target_speed;
}

/** Bring a spin towards its target; whether it is there. */
static bool slew_spin(clod_wall *wall, double target, double most)
{
    const double change = target - wall->spin;
    wall->spin = fabs(change) <= most ? target : wall->spin + copysign(most, change);
    return wall->spin == target;
}

/** To one side and to the other, the lid's edge moving with the speed of preshear. */
static bool twist(clod_ring_shear *self, clod_state *state, double change)
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

/** Between the rings. */
static double shear_plane(const clod_ring_shear *self, double lid)
{
    (void)lid;
    return self->base_height;
}

/**
 *     tau   = -F_x(shear ring and lid)/A     tau_base   =  F_x(base and base ring)/A
 *                                            sigma_base = -F_z(base and base ring)/A
 *
 * with the forces of the grains on the walls, A the inner area.
 */
static void read(const clod_ring_shear *self, const clod_state *state, double steps,
                 double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *ring = clod_bed_wall(state, "shear_ring");
    const clod_wall *base = clod_bed_wall(state, "base");
    const clod_wall *base_ring = clod_bed_wall(state, "base_ring");
    const double area = steps * self->area;
    row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE] =
        -(base->sum_force.z + base_ring->sum_force.z) / area;
    row[CLOD_RING_SHEAR_SHEAR_STRESS] = -(lid->sum_force.x + ring->sum_force.x) / area;
    row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE] =
        (base->sum_force.x + base_ring->sum_force.x) / area;
    // of the drive: what the lid does on its way down is the load's, not the stem's
    row[CLOD_RING_SHEAR_POWER] =
        row[CLOD_RING_SHEAR_SHEAR_STRESS] * self->area * row[CLOD_RING_SHEAR_SPEED];
}

/** In the base ring, and above the shear plane in the shear ring, which has moved. */
static clod_inside bed(const clod_ring_shear *self, const clod_state *state, double lid)
{
    const clod_wall *ring = clod_bed_wall(state, "shear_ring");
    return (clod_inside){.outer = ring->shapes[0].outer,
                         .high = lid,
                         .plane = self->base_height,
                         .shift = ring->shapes[0].center.x + ring->shift.x};
}

/** The shear ring is as far behind the base ring as its rim is thick, or farther. */
static bool is_back(const clod_state *state)
{
    const clod_wall *ring = clod_bed_wall(state, "shear_ring");
    const clod_shape *rim = &ring->shapes[1];
    return rim->center.x + ring->shift.x <= rim->inner - rim->outer;
}

const clod_shear_tester CLOD_SHEAR_TESTER_JENIKE = {
    .kind = CLOD_RING_SHEAR_JENIKE,
    .key = "jenike",
    .describe = describe,
    .speed = speed,
    .set_speed = set_speed,
    .is_at_speed = is_at_speed,
    .twist = twist,
    .shear_plane = shear_plane,
    .read = read,
    .bed = bed,
    .is_back = is_back,
    .lid_meets = "it and the base ring",
    .if_no_bed = "Raise jenike.grain_count (or fill_fraction)",
    .if_not_steady = "By ASTM D6128 it then gives no valid point of a yield locus. Set "
                     "jenike.twists (or raise them), or raise preshear_max with offset and rim",
    .to_reverse = " or jenike.rim",
    .to_go_further = " with offset and rim",
};
