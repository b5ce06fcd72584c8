#include "tester/uniaxial.h"

#include <math.h>
#include <stdio.h>

#include "tester/bed.h"
#include "tester/inside.h"
#include "tester/limits.h"

// The operator's hand, as in the ring shear test: none of these numbers is physics, and the
// results folder shows what each did.
#define CARRY_FRACTION 0.05 ///< of the consolidation stress: the lid carries
#define TOUCH_FRACTION 0.01 ///< of it: the lid has met the free specimen
#define ACCELERATION 1.0    ///< m/s2 of the lid: some 0.1 kPa of inertia in a bed of 100 mm
#define FINE_STEPS 50       ///< steps per look while the speed changes or something may end
#define FREE_LEAST 0.02     ///< s without the mould at least: what falls is fast by then
#define FREE_SPEED 2e-3     ///< m/s, root mean square of the grains at rest
#define PEAK_STRAIN 0.002   ///< over which the peak is smoothed

const char *const clod_uniaxial_columns[CLOD_UNIAXIAL_COLUMNS] = {
    "time [s]",
    "phase [1]",
    "strain [1]",
    "axial_stress [Pa]",
    "axial_stress_base [Pa]",
    "mould_force [N]",
    "height [m]",
    "bulk_density [kg/m3]",
    "solid_fraction [1]",
    "speed [m/s]",
};

const char *clod_uniaxial_phase_name(clod_uniaxial_phase phase)
{
    static const char *const NAMES[] = {"fill", "lower", "consolidate", "unload",
                                        "free", "crush", "done"};
    return NAMES[phase];
}

static double height_of(const clod_uniaxial *self, const clod_state *state)
{
    return self->lid_start + clod_bed_wall(state, "lid")->shift.z;
}

static void enter(clod_uniaxial *self, clod_state *state, clod_uniaxial_phase phase)
{
    self->phase = phase;
    self->phase_start = (double)state->step * state->dt;
    self->calm = 0;
    clod_walls_reset_sums(&state->walls);
}

void clod_uniaxial_begin(clod_uniaxial *self, const clod_case *from, clod_state *state)
{
    const clod_case_uniaxial *cell = &from->uniaxial;
    *self = (clod_uniaxial){
        .area = 0.25 * M_PI * cell->diameter * cell->diameter,
        .grain_mass = clod_bed_mass(state),
        .lid_start = clod_bed_wall(state, "lid")->shapes[0].center.z,
        .lowest_lid = 2.0 * clod_bed_largest(state),
        .speed = cell->speed,
        .crush_max = cell->crush_max,
        .beyond_peak = cell->beyond_peak,
        .fill_max = cell->fill_max,
        .settle_max = cell->settle_max,
    };
    for (size_t g = 0; g < state->grains.count; g++) {
        const double r = state->grains.position[g][3];
        self->solid_volume += 4.0 / 3.0 * M_PI * r * r * r;
    }
    clod_bed_wall(state, "lid")->load = CLOD_LOAD_NONE;
    enter(self, state, CLOD_UNIAXIAL_FILL);
}

void clod_uniaxial_branch(clod_uniaxial *self, double stress, clod_state *state)
{
    self->stress = stress;
    self->flags = 0; // what was not right with the filling stands in its own
    clod_bed_put_lid(state, height_of(self, state), 0.0);
    enter(self, state, CLOD_UNIAXIAL_LOWER);
}

/** Steps in which the lid, at its speed, goes through one bin of the peak. */
static int64_t bin_steps(const clod_uniaxial *self, const clod_state *state)
{
    const double bin = PEAK_STRAIN * self->unloaded_height / CLOD_PEAK_BINS;
    return (int64_t)fmax(1.0, round(bin / (self->speed * state->dt)));
}

int64_t clod_uniaxial_plan(const clod_uniaxial *self, const clod_state *state)
{
    switch (self->phase) {
    case CLOD_UNIAXIAL_DONE:
        return 0;
    case CLOD_UNIAXIAL_UNLOAD:
        return FINE_STEPS;
    case CLOD_UNIAXIAL_CRUSH:
        if (clod_bed_wall(state, "lid")->velocity.z != -self->speed) {
            return FINE_STEPS;
        }
        return (int64_t)fmin((double)bin_steps(self, state), CLOD_LIMITS_COARSE_STEPS);
    default:
        return CLOD_LIMITS_COARSE_STEPS;
    }
}

/** Mean forces on the walls since the last look. */
static void measure(const clod_uniaxial *self, const clod_state *state, double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *base = clod_bed_wall(state, "base");
    const clod_wall *mould = clod_bed_wall(state, "mould");
    const double steps = (double)(lid->sum_steps > 0 ? lid->sum_steps : 1);
    const double height = height_of(self, state);
    const double zero = self->unloaded_height;
    row[CLOD_UNIAXIAL_TIME] = (double)state->step * state->dt;
    row[CLOD_UNIAXIAL_PHASE] = (double)self->phase;
    row[CLOD_UNIAXIAL_STRAIN] = zero > 0.0 ? 1.0 - height / zero : 0.0;
    row[CLOD_UNIAXIAL_STRESS] = lid->sum_force.z / (steps * self->area);
    row[CLOD_UNIAXIAL_STRESS_BASE] = -base->sum_force.z / (steps * self->area);
    row[CLOD_UNIAXIAL_MOULD_FORCE] =
        mould != NULL ? 0.0 - mould->sum_force.z / steps : 0.0; // never -0
    row[CLOD_UNIAXIAL_HEIGHT] = height;
    row[CLOD_UNIAXIAL_BULK_DENSITY] = self->grain_mass / (self->area * height);
    row[CLOD_UNIAXIAL_SOLID_FRACTION] = self->solid_volume / (self->area * height);
    row[CLOD_UNIAXIAL_SPEED] = -lid->velocity.z - lid->servo_velocity * lid->load_axis.z;
}

static void after_fill(clod_uniaxial *self, clod_state *state, double in_phase)
{
    bool late;
    if (clod_bed_is_filled(state, in_phase, self->fill_max, &late)) {
        self->flags |= late ? CLOD_UNIAXIAL_NOT_SETTLED : 0;
        enter(self, state, CLOD_UNIAXIAL_DONE);
    }
}

/** Load of the lid that gives an axial stress. */
static void set_stress(const clod_uniaxial *self, clod_state *state, double stress)
{
    clod_bed_wall(state, "lid")->load_force = stress * self->area;
}

static void after_lower(clod_uniaxial *self, clod_state *state, const double *row)
{
    if (row[CLOD_UNIAXIAL_STRESS] > CARRY_FRACTION * self->stress) {
        clod_bed_take_over(clod_bed_wall(state, "lid"));
        state->adhesion = 1.0;
        self->start_stress = row[CLOD_UNIAXIAL_STRESS];
        set_stress(self, state, self->start_stress);
        enter(self, state, CLOD_UNIAXIAL_CONSOLIDATE);
    }
}

static double inside(const clod_uniaxial *self, const clod_state *state)
{
    const clod_inside bed = {.outer = clod_bed_wall(state, "mould")->shapes[0].outer,
                             .high = height_of(self, state)};
    return clod_inside_density(&bed, state);
}

static void after_consolidate(clod_uniaxial *self, clod_state *state, const double *row,
                              double in_phase, double interval)
{
    const double part = clod_bed_ramp(in_phase);
    const double speed = (row[CLOD_UNIAXIAL_HEIGHT] - self->last_height) / interval;
    const double stress = row[CLOD_UNIAXIAL_STRESS] / self->stress;
    const bool calm = clod_bed_is_calm(&self->calm, speed, stress);
    const bool late = in_phase > self->settle_max;
    set_stress(self, state, self->start_stress + part * (self->stress - self->start_stress));
    if (part < 1.0 || !(calm || late)) {
        return;
    }
    self->flags |= calm ? 0 : CLOD_UNIAXIAL_NOT_SETTLED;
    self->sigma_1 = row[CLOD_UNIAXIAL_STRESS];
    self->sigma_base = row[CLOD_UNIAXIAL_STRESS_BASE];
    self->height = row[CLOD_UNIAXIAL_HEIGHT];
    self->density = row[CLOD_UNIAXIAL_BULK_DENSITY];
    self->inside = inside(self, state);
    self->solid_fraction = row[CLOD_UNIAXIAL_SOLID_FRACTION];
    clod_wall *lid = clod_bed_wall(state, "lid");
    lid->load = CLOD_LOAD_NONE;
    lid->servo_velocity = 0.0;
    enter(self, state, CLOD_UNIAXIAL_UNLOAD);
}

/** Bring the speed of the lid towards its target without a blow; upwards is positive. */
static void slew(clod_state *state, double target, double interval)
{
    clod_wall *lid = clod_bed_wall(state, "lid");
    const double change = target - lid->velocity.z;
    const double most = ACCELERATION * interval;
    lid->velocity.z = fabs(change) <= most ? target : lid->velocity.z + copysign(most, change);
}

/** The lid carries nothing any more: the mould is taken off. */
static void after_unload(clod_uniaxial *self, clod_state *state, const double *row,
                         double interval)
{
    slew(state, self->speed, interval);
    if (row[CLOD_UNIAXIAL_STRESS] <= 0.0) {
        clod_bed_wall(state, "lid")->velocity.z = 0.0;
        self->unloaded_height = row[CLOD_UNIAXIAL_HEIGHT];
        clod_changes_remove_wall(&state->changes, "mould");
        enter(self, state, CLOD_UNIAXIAL_FREE);
    }
}

static void after_free(clod_uniaxial *self, clod_state *state, double in_phase)
{
    const bool late = in_phase > self->settle_max;
    const double least = fmax(FREE_LEAST, 2.0 * clod_bed_fall_time(state, FREE_SPEED));
    if (late || (in_phase > least && clod_bed_rms_speed(state) < FREE_SPEED)) {
        self->flags |= late ? CLOD_UNIAXIAL_NOT_FREE : 0;
        clod_peak_init(&self->peak, PEAK_STRAIN * self->unloaded_height,
                       self->beyond_peak * self->unloaded_height);
        enter(self, state, CLOD_UNIAXIAL_CRUSH);
    }
}

static void note_peak(clod_uniaxial *self)
{
    const clod_peak_result peak = clod_peak_summary(&self->peak);
    self->strength = peak.tau;
    self->strength_error = peak.tau_error;
    self->strength_base = peak.sigma;
    self->peak_strain = peak.displacement / self->unloaded_height;
}

static void after_crush(clod_uniaxial *self, clod_state *state, const double *row,
                        double interval)
{
    slew(state, -self->speed, interval);
    if (row[CLOD_UNIAXIAL_STRESS] > TOUCH_FRACTION * self->stress) {
        self->touched = 1;
    }
    bool passed = false;
    if (self->touched != 0) {
        passed = clod_peak_add(&self->peak, self->unloaded_height - row[CLOD_UNIAXIAL_HEIGHT],
                               row[CLOD_UNIAXIAL_STRESS], row[CLOD_UNIAXIAL_STRESS_BASE]);
        note_peak(self);
    }
    if (passed || row[CLOD_UNIAXIAL_STRAIN] > self->crush_max) {
        const int64_t late =
            self->touched != 0 ? CLOD_UNIAXIAL_NO_PEAK : CLOD_UNIAXIAL_COLLAPSED;
        self->flags |= passed ? 0 : late;
        clod_bed_wall(state, "lid")->velocity.z = 0.0;
        enter(self, state, CLOD_UNIAXIAL_DONE);
    }
}

bool clod_uniaxial_trouble(const clod_uniaxial *self, char *text, size_t size)
{
    const bool trouble = (self->flags & CLOD_UNIAXIAL_NO_BED) != 0;
    if (trouble) {
        snprintf(text, size,
                 "the lid sank to %.3g mm, where no grain fits between it and the base: the "
                 "mould holds too few grains. Raise uniaxial.grain_count (or fill_fraction)",
                 1e3 * self->last_height);
    }
    return trouble;
}

bool clod_uniaxial_sample(clod_uniaxial *self, clod_state *state, double *row)
{
    const double interval = (double)clod_bed_wall(state, "lid")->sum_steps * state->dt;
    const double in_phase = (double)state->step * state->dt - self->phase_start;
    measure(self, state, row);
    clod_walls_reset_sums(&state->walls);
    switch (self->phase) {
    case CLOD_UNIAXIAL_FILL:
        after_fill(self, state, in_phase);
        break;
    case CLOD_UNIAXIAL_LOWER:
        after_lower(self, state, row);
        break;
    case CLOD_UNIAXIAL_CONSOLIDATE:
        after_consolidate(self, state, row, in_phase, interval);
        break;
    case CLOD_UNIAXIAL_UNLOAD:
        after_unload(self, state, row, interval);
        break;
    case CLOD_UNIAXIAL_FREE:
        after_free(self, state, in_phase);
        break;
    case CLOD_UNIAXIAL_CRUSH:
        after_crush(self, state, row, interval);
        break;
    default:
        break;
    }
    self->last_height = row[CLOD_UNIAXIAL_HEIGHT];
    if (self->last_height < self->lowest_lid) {
        self->flags |= CLOD_UNIAXIAL_NO_BED;
        self->phase = CLOD_UNIAXIAL_DONE;
    }
    return self->phase == CLOD_UNIAXIAL_DONE;
}

double clod_uniaxial_progress(const clod_uniaxial *self)
{
    if (self->phase == CLOD_UNIAXIAL_DONE) {
        return 1.0;
    }
    const bool crushes = self->phase == CLOD_UNIAXIAL_CRUSH;
    return crushes
               ? fmin((1.0 - self->last_height / self->unloaded_height) / self->crush_max, 1.0)
               : 0.0;
}
