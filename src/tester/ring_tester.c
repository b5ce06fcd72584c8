// The row of the Schulze ring shear tester: trough and sides turn about z, the lid is held by
// its torque. Speeds and displacements are at the mean radius r_m (docs/theory/ring-shear.md).

#include <math.h>

#include "tester/bed.h"
#include "tester/shear_tester.h"

static void describe(clod_ring_shear *self, const clod_case *from, const clod_state *state)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    const double ri = cell->inner_radius;
    const double ro = cell->outer_radius;
    *self = (clod_ring_shear){
        .area = M_PI * (ro * ro - ri * ri),
        .mean_radius = 2.0 / 3.0 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri),
        .bars_volume = clod_bed_bars_volume(state),
        .bar_height = cell->bar_height,
        .lid_mass = cell->lid_mass,
        .lowest_lid = 2.0 * cell->bar_height + 2.0 * clod_bed_largest(state),
        .fill_max = cell->fill_max,
        .settle_max = cell->settle_max,
    };
}

static double speed(const clod_ring_shear *self, const clod_state *state)
{
    return clod_bed_wall(state, "trough")->spin * self->mean_radius;
}

static void set_speed(const clod_ring_shear *self, clod_state *state, double speed)
{
    clod_bed_wall(state, "trough")->spin = speed / self->mean_radius;
    clod_bed_wall(state, "sides")->spin = speed / self->mean_radius;
}

static bool is_at_speed(const clod_ring_shear *self, const clod_state *state)
{
    return clod_bed_wall(state, "trough")->spin == self->target_speed / self->mean_radius;
}

/** At the tips of the lid's bars. */
static double shear_plane(const clod_ring_shear *self, double lid)
{
    return lid - self->bar_height;
}

/**
 *     tau   = T_z(lid)/(A r_m)     tau_base   = -T_z(trough and sides)/(A r_m)
 *                                  sigma_base = -F_z(trough)/A
 *
 * with the torques and forces of the grains on the walls.
 */
static void read(const clod_ring_shear *self, const clod_state *state, double steps,
                 double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *trough = clod_bed_wall(state, "trough");
    const clod_wall *sides = clod_bed_wall(state, "sides");
    const double arm = self->area * self->mean_radius;
    const double torque_base = trough->sum_torque.z + sides->sum_torque.z;
    row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE] = -trough->sum_force.z / (steps * self->area);
    row[CLOD_RING_SHEAR_SHEAR_STRESS] = lid->sum_torque.z / (steps * arm);
    row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE] = -torque_base / (steps * arm);
    row[CLOD_RING_SHEAR_POWER] = (trough->sum_power + sides->sum_power) / steps;
}

/** Between the sides, and the tips of the bars of trough and lid. */
static clod_inside bed(const clod_ring_shear *self, const clod_state *state, double lid)
{
    const clod_shape *side = clod_bed_wall(state, "sides")->shapes;
    return (clod_inside){.inner = side[0].outer,
                         .outer = side[1].outer,
                         .low = self->bar_height,
                         .high = lid - self->bar_height};
}

/** A ring can be turned back as far as one likes. */
static bool is_back(const clod_state *state)
{
    (void)state;
    return false;
}

const clod_shear_tester CLOD_SHEAR_TESTER_RING = {
    .kind = CLOD_RING_SHEAR_RING,
    .key = "ring_shear",
    .describe = describe,
    .speed = speed,
    .set_speed = set_speed,
    .is_at_speed = is_at_speed,
    .twist = NULL,
    .shear_plane = shear_plane,
    .read = read,
    .bed = bed,
    .is_back = is_back,
    .lid_meets = "its bars and those of the trough",
    .if_no_bed = "Raise ring_shear.grain_count (or fill_fraction), or lower bar_height",
    .if_not_steady = "Raise ring_shear.preshear_max to see how far it goes",
    .to_reverse = "",
    .to_go_further = "",
};
