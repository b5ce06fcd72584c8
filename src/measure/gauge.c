#include "measure/gauge.h"

#include <math.h>
#include <string.h>

/** Variance of the radius over its square below which grains are of one size: rounding. */
#define ONE_SIZE 1e-12
/** Length of the product of two unit vectors below which they are parallel. */
#define PARALLEL 1e-6

const clod_gauge_value CLOD_GAUGE_VALUE[CLOD_GAUGE_VALUES] = {
    [CLOD_GAUGE_OF_GRAINS] = {"grains", "1", "grains", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_MASS] = {"mass", "kg", "mass_kg", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_FLOW] = {"mass_flow", "kg/s", "mass_flow_kg_per_s", CLOD_GAUGE_DIRECTION},
    [CLOD_GAUGE_OF_VELOCITY] = {"velocity_x", "m/s", "velocity_x_m_per_s", CLOD_GAUGE_ALWAYS},
    {"velocity_y", "m/s", "velocity_y_m_per_s", CLOD_GAUGE_ALWAYS},
    {"velocity_z", "m/s", "velocity_z_m_per_s", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_SPEED] = {"speed", "m/s", "speed_m_per_s", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_ANGLE] = {"angle", "deg", "angle_deg", CLOD_GAUGE_DIRECTION},
    [CLOD_GAUGE_OF_FLUCTUATION] = {"fluctuation", "m/s", "fluctuation_m_per_s",
                                   CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_CENTER] = {"center_x", "m", "center_x_m", CLOD_GAUGE_ALWAYS},
    {"center_y", "m", "center_y_m", CLOD_GAUGE_ALWAYS},
    {"center_z", "m", "center_z_m", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_OFFSET] = {"offset", "m", "offset_m", CLOD_GAUGE_ACROSS},
    [CLOD_GAUGE_OF_WIDTH] = {"width", "m", "width_m", CLOD_GAUGE_ACROSS},
    [CLOD_GAUGE_OF_SORTING] = {"sorting", "1", "sorting", CLOD_GAUGE_ACROSS},
    [CLOD_GAUGE_OF_RADIUS] = {"radius", "m", "radius_m", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_RADIUS_RATIO] = {"radius_ratio", "1", "radius_ratio", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_ENERGY] = {"kinetic_energy", "J", "kinetic_energy_J", CLOD_GAUGE_ALWAYS},
    [CLOD_GAUGE_OF_BLOCKED] = {"blocked", "1", "blocked_share", CLOD_GAUGE_ALARM},
    [CLOD_GAUGE_OF_POWER] = {"belt_power", "W", "belt_power_W", CLOD_GAUGE_BELT},
    [CLOD_GAUGE_OF_LIFTING] = {"lifting", "W", "lifting_W", CLOD_GAUGE_BELT},
    [CLOD_GAUGE_OF_ACCELERATION] = {"acceleration", "W", "acceleration_W", CLOD_GAUGE_BELT},
    [CLOD_GAUGE_OF_HEAT] = {"heat", "W", "heat_W", CLOD_GAUGE_BELT},
};

static clod_vec3 unit_or_none(clod_vec3 v)
{
    return clod_vec3_length(v) > 0.0 ? clod_vec3_unit(v) : (clod_vec3){0};
}

/** a x b as a unit vector; 0 when they are parallel. a and b: unit or 0. */
static clod_vec3 across_both(clod_vec3 a, clod_vec3 b)
{
    const clod_vec3 c = clod_vec3_cross(a, b);
    return clod_vec3_length(c) > PARALLEL ? clod_vec3_unit(c) : (clod_vec3){0};
}

static double part(clod_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/** The pair of faces that the direction meets most squarely. */
static void find_flow(clod_gauge *self)
{
    for (int a = 1; a < 3; a++) {
        if (fabs(part(self->direction, a)) > fabs(part(self->direction, self->flow_axis))) {
            self->flow_axis = a;
        }
    }
    const int a = self->flow_axis;
    self->flow_length =
        copysign(self->region.high[a] - self->region.low[a], part(self->direction, a));
}

clod_gauge clod_gauge_of(const clod_outlet *region, const double direction[3],
                         const double across[3], const double gravity[3])
{
    const double *low = region->low, *high = region->high;
    const clod_vec3 above = clod_vec3_scale(unit_or_none(clod_vec3_of(gravity)), -1.0);
    clod_gauge self = {.region = *region,
                       .middle = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]),
                                  0.5 * (low[2] + high[2])},
                       .direction = unit_or_none(clod_vec3_of(direction)),
                       .across = unit_or_none(clod_vec3_of(across))};
    if (clod_vec3_length(self.across) == 0.0) {
        self.across = across_both(above, self.direction);
    }
    self.up = across_both(self.direction, self.across);
    if (clod_vec3_dot(self.up, above) < 0.0) {
        self.up = clod_vec3_scale(self.up, -1.0);
    }
    find_flow(&self);
    return self;
}

void clod_gauge_extent(const clod_gauge *self, clod_vec3 axis, double *low, double *high)
{
    const clod_outlet *r = &self->region;
    const double half_height = 0.5 * (r->high[2] - r->low[2]) * fabs(axis.z);
    const double half = r->outer > 0.0
                            ? r->outer * hypot(axis.x, axis.y) + half_height
                            : 0.5 * (r->high[0] - r->low[0]) * fabs(axis.x) +
                                  0.5 * (r->high[1] - r->low[1]) * fabs(axis.y) + half_height;
    const double middle = clod_vec3_dot(self->middle, axis);
    *low = middle - half;
    *high = middle + half;
}

static void add_position(clod_gauge_exact *sums, const clod_gauge *self,
                         const double position[4], double m)
{
    const clod_vec3 arm = clod_vec3_sub(clod_vec3_of(position), self->middle);
    const double s = clod_vec3_dot(arm, self->across), r = position[3];
    clod_exact_add(&sums->mass, m);
    clod_exact_add(&sums->moment[0], m * arm.x);
    clod_exact_add(&sums->moment[1], m * arm.y);
    clod_exact_add(&sums->moment[2], m * arm.z);
    clod_exact_add(&sums->across2, m * s * s);
    clod_exact_add(&sums->radius, m * r);
    clod_exact_add(&sums->radius2, m * r * r);
    clod_exact_add(&sums->radius_across, m * r * s);
}

static void add_motion(clod_gauge_exact *sums, const double v[4], const double w[4],
                       const double load[8])
{
    const double m = v[3], v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const double w2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    for (int a = 0; a < 3; a++) {
        clod_exact_add(&sums->momentum[a], m * v[a]);
    }
    clod_exact_add(&sums->speed, m * sqrt(v2));
    clod_exact_add(&sums->speed2, m * v2);
    clod_exact_add(&sums->energy, 0.5 * m * v2 + 0.5 / w[3] * w2);
    clod_exact_add(&sums->acceleration, load[0] * v[0] + load[1] * v[1] + load[2] * v[2] +
                                            load[4] * w[0] + load[5] * w[1] + load[6] * w[2]);
}

void clod_gauge_add(clod_gauge_exact *self, const clod_gauge *gauge, const clod_grains *grains,
                    size_t row, const double place[4])
{
    self->count += 1.0;
    add_position(self, gauge, place, grains->velocity[row][3]);
    add_motion(self, grains->velocity[row], grains->angular_velocity[row], grains->load[row]);
}

void clod_gauge_merge(clod_gauge_exact *self, const clod_gauge_exact *other)
{
    self->count += other->count;
    clod_exact_merge(&self->mass, &other->mass);
    for (int a = 0; a < 3; a++) {
        clod_exact_merge(&self->momentum[a], &other->momentum[a]);
        clod_exact_merge(&self->moment[a], &other->moment[a]);
    }
    clod_exact_merge(&self->speed, &other->speed);
    clod_exact_merge(&self->speed2, &other->speed2);
    clod_exact_merge(&self->across2, &other->across2);
    clod_exact_merge(&self->radius, &other->radius);
    clod_exact_merge(&self->radius2, &other->radius2);
    clod_exact_merge(&self->radius_across, &other->radius_across);
    clod_exact_merge(&self->energy, &other->energy);
    clod_exact_merge(&self->acceleration, &other->acceleration);
}

void clod_gauge_sums_of(const clod_gauge_exact *self, const clod_gauge *gauge,
                        const clod_state *state, double *sums)
{
    memset(sums, 0, CLOD_GAUGE_SUMS * sizeof *sums);
    sums[CLOD_GAUGE_SAMPLES] = 1.0;
    sums[CLOD_GAUGE_GRAINS] = self->count;
    if (self->count == 0.0) {
        return;
    }
    const double mass = sums[CLOD_GAUGE_MASS] = clod_exact_value(&self->mass);
    double *p = &sums[CLOD_GAUGE_MOMENTUM], *moment = &sums[CLOD_GAUGE_MOMENT];
    for (int a = 0; a < 3; a++) {
        p[a] = clod_exact_value(&self->momentum[a]);
        moment[a] = clod_exact_value(&self->moment[a]);
        sums[CLOD_GAUGE_LIFTING] -= p[a] * state->gravity[a];
    }
    const double s = clod_vec3_dot(clod_vec3_of(moment), gauge->across) / mass;
    const double r = clod_exact_value(&self->radius) / mass;
    const double p2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    sums[CLOD_GAUGE_SPEED] = clod_exact_value(&self->speed);
    sums[CLOD_GAUGE_SCATTER] = fmax(0.0, clod_exact_value(&self->speed2) - p2 / mass);
    sums[CLOD_GAUGE_SPREAD] = fmax(0.0, clod_exact_value(&self->across2) - mass * s * s);
    sums[CLOD_GAUGE_RADIUS] = mass * r;
    sums[CLOD_GAUGE_RADIUS_SPREAD] = fmax(0.0, clod_exact_value(&self->radius2) - mass * r * r);
    sums[CLOD_GAUGE_SORTING] = clod_exact_value(&self->radius_across) - mass * r * s;
    sums[CLOD_GAUGE_ENERGY] = clod_exact_value(&self->energy);
    sums[CLOD_GAUGE_ACCELERATION] = clod_exact_value(&self->acceleration);
}

static double over(double a, double b)
{
    return b > 0.0 ? a / b : (double)NAN;
}

/** Correlation of radius and position across; NAN when one of them does not vary. */
static double sorting(const double *sums)
{
    const double r = over(sums[CLOD_GAUGE_RADIUS], sums[CLOD_GAUGE_MASS]);
    const double spread = sums[CLOD_GAUGE_RADIUS_SPREAD];
    const bool varies = spread > ONE_SIZE * sums[CLOD_GAUGE_MASS] * r * r;
    return varies ? over(sums[CLOD_GAUGE_SORTING], sqrt(spread * sums[CLOD_GAUGE_SPREAD]))
                  : (double)NAN;
}

/** Angle between the momentum and the direction [deg]. */
static double angle(clod_vec3 momentum, clod_vec3 direction)
{
    const double sine = clod_vec3_length(clod_vec3_cross(momentum, direction));
    const double cosine = clod_vec3_dot(momentum, direction);
    return sine == 0.0 && cosine == 0.0 ? (double)NAN : atan2(sine, cosine) * (180.0 / M_PI);
}

static void put_positions(const clod_gauge *self, const double *sums, double *values)
{
    const double mass = sums[CLOD_GAUGE_MASS];
    const double *moment = &sums[CLOD_GAUGE_MOMENT];
    const double middle[3] = {self->middle.x, self->middle.y, self->middle.z};
    for (int a = 0; a < 3; a++) {
        values[CLOD_GAUGE_OF_CENTER + a] = middle[a] + over(moment[a], mass);
    }
    values[CLOD_GAUGE_OF_OFFSET] =
        over(clod_vec3_dot(clod_vec3_of(moment), self->across), mass);
    values[CLOD_GAUGE_OF_WIDTH] = sqrt(over(sums[CLOD_GAUGE_SPREAD], mass));
    values[CLOD_GAUGE_OF_SORTING] = sorting(sums);
    values[CLOD_GAUGE_OF_RADIUS] = over(sums[CLOD_GAUGE_RADIUS], mass);
    values[CLOD_GAUGE_OF_RADIUS_RATIO] =
        values[CLOD_GAUGE_OF_RADIUS] /
        over(sums[CLOD_GAUGE_ALL_RADIUS], sums[CLOD_GAUGE_ALL_MASS]);
}

static void put_powers(const double *sums, double *values)
{
    const double samples = sums[CLOD_GAUGE_SAMPLES];
    const double power = over(sums[CLOD_GAUGE_WORK], sums[CLOD_GAUGE_TIME]);
    const double lifting = over(sums[CLOD_GAUGE_LIFTING], samples);
    const double acceleration = over(sums[CLOD_GAUGE_ACCELERATION], samples);
    values[CLOD_GAUGE_OF_POWER] = power;
    values[CLOD_GAUGE_OF_LIFTING] = lifting;
    values[CLOD_GAUGE_OF_ACCELERATION] = acceleration;
    values[CLOD_GAUGE_OF_HEAT] = power - lifting - acceleration;
}

void clod_gauge_values(const clod_gauge *self, const double *sums, double *values)
{
    const double samples = sums[CLOD_GAUGE_SAMPLES], mass = sums[CLOD_GAUGE_MASS];
    const double *p = &sums[CLOD_GAUGE_MOMENTUM];
    values[CLOD_GAUGE_OF_GRAINS] = over(sums[CLOD_GAUGE_GRAINS], samples);
    values[CLOD_GAUGE_OF_MASS] = over(mass, samples);
    values[CLOD_GAUGE_OF_FLOW] = // no flow is 0, never -0
        over(p[self->flow_axis], samples) / self->flow_length + 0.0;
    for (int a = 0; a < 3; a++) {
        values[CLOD_GAUGE_OF_VELOCITY + a] = over(p[a], mass);
    }
    values[CLOD_GAUGE_OF_SPEED] = over(sums[CLOD_GAUGE_SPEED], mass);
    values[CLOD_GAUGE_OF_ANGLE] = angle(clod_vec3_of(p), self->direction);
    values[CLOD_GAUGE_OF_FLUCTUATION] = sqrt(over(sums[CLOD_GAUGE_SCATTER], mass));
    put_positions(self, sums, values);
    values[CLOD_GAUGE_OF_ENERGY] = over(sums[CLOD_GAUGE_ENERGY], samples);
    values[CLOD_GAUGE_OF_BLOCKED] = over(sums[CLOD_GAUGE_BLOCKED], samples);
    put_powers(sums, values);
}
