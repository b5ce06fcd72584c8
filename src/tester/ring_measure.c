#include "tester/ring_measure.h"

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

double clod_ring_lid_height(const clod_ring_shear *self, const clod_state *state)
{
    return self->lid_start + clod_bed_wall(state, "lid")->shift.z;
}

double clod_ring_solid_above(const clod_ring_shear *self, const clod_state *state)
{
    const double plane = self->straight != 0
                             ? self->base_height
                             : clod_ring_lid_height(self, state) - self->bar_height;
    double mass = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        mass += state->grains.place[g][2] > plane ? state->grains.motion[g][3] : 0.0;
    }
    return -mass * state->gravity[2] / self->area;
}

double clod_ring_speed(const clod_ring_shear *self, const clod_state *state)
{
    return clod_bed_wall(state, "trough")->spin * self->mean_radius;
}

void clod_ring_set_speed(const clod_ring_shear *self, clod_state *state, double speed)
{
    clod_bed_wall(state, "trough")->spin = speed / self->mean_radius;
    clod_bed_wall(state, "sides")->spin = speed / self->mean_radius;
}

bool clod_ring_is_at_speed(const clod_ring_shear *self, const clod_state *state)
{
    return clod_bed_wall(state, "trough")->spin == self->target_speed / self->mean_radius;
}

double clod_ring_bars_volume(const clod_state *state)
{
    double volume = 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const double *half = wall->shapes[s].half;
            volume += wall->shapes[s].kind == CLOD_SHAPE_BAR ? 8.0 * half[0] * half[1] * half[2]
                                                             : 0.0;
        }
    }
    return volume;
}

void clod_ring_measure(const clod_ring_shear *self, const clod_state *state, double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *trough = clod_bed_wall(state, "trough");
    const clod_wall *sides = clod_bed_wall(state, "sides");
    const double steps = (double)(lid->sum_steps > 0 ? lid->sum_steps : 1);
    const double arm = self->area * self->mean_radius;
    const double height = clod_ring_lid_height(self, state);
    const double torque_base = trough->sum_torque.z + sides->sum_torque.z;
    row[CLOD_RING_SHEAR_TIME] = (double)state->step * state->dt;
    row[CLOD_RING_SHEAR_PHASE] = (double)self->phase;
    row[CLOD_RING_SHEAR_DISPLACEMENT] = self->displacement;
    row[CLOD_RING_SHEAR_NORMAL_STRESS] =
        lid->sum_force.z / (steps * self->area) + clod_ring_solid_above(self, state);
    row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE] = -trough->sum_force.z / (steps * self->area);
    row[CLOD_RING_SHEAR_SHEAR_STRESS] = lid->sum_torque.z / (steps * arm);
    row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE] = -torque_base / (steps * arm);
    row[CLOD_RING_SHEAR_HEIGHT] = height;
    row[CLOD_RING_SHEAR_BULK_DENSITY] =
        self->grain_mass / (self->area * height - self->bars_volume);
    row[CLOD_RING_SHEAR_SPEED] = clod_ring_speed(self, state);
    row[CLOD_RING_SHEAR_POWER] = (trough->sum_power + sides->sum_power) / steps;
}
