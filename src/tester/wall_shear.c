#include "tester/wall_shear.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "config/wall_cells.h"
#include "config/wall_ridges.h"
#include "tester/bed.h"
#include "tester/limits.h"

// The operator's hand, as in the ring shear test: none of these numbers is a property of the
// solid, and the results folder shows what each did.
#define TOUCH_FRACTION 0.05 ///< of the largest stress: the lid carries
#define FINE_STEPS 50       ///< steps per look while the speed changes
#define BLOCK_SAMPLES 25    ///< samples per block

const char *const clod_wall_shear_columns[CLOD_WALL_SHEAR_COLUMNS] = {
    "time [s]",
    "phase [1]",
    "displacement [m]",
    "normal_stress [Pa]",
    "shear_stress [Pa]",
    "normal_stress_lid [Pa]",
    "shear_stress_held [Pa]",
    "height [m]",
    "bulk_density [kg/m3]",
    "speed [m/s]",
    "power [W]",
};

const char *clod_wall_shear_phase_name(clod_wall_shear_phase phase)
{
    static const char *const NAMES[] = {"fill",   "lower", "consolidate",
                                        "run-in", "shear", "done"};
    return NAMES[phase];
}

// ---- the cell

static double height_of(const clod_wall_shear *self, const clod_state *state)
{
    return self->lid_start + clod_bed_wall(state, "lid")->shift.z;
}

/** Stress of the solid's weight on the plate [Pa]. */
static double weight_of(const clod_wall_shear *self, const clod_state *state)
{
    return -self->grain_mass * state->gravity[2] / self->area;
}

static double bulk_density(const clod_wall_shear *self, double height)
{
    return self->grain_mass / (self->area * height - self->bars_volume);
}

/** How the plate moves: one row for each way. */
typedef struct plate_drive {
    double *(*motion)(clod_wall *plate);          ///< spin [rad/s], or velocity [m/s]
    double (*resistance)(const clod_wall *wall);  ///< torque [N m], or force [N], times steps
    double (*lever)(const clod_wall_shear *self); ///< m; 1 where motion is the speed itself
} plate_drive;

static double *spin(clod_wall *plate)
{
    return &plate->spin;
}

static double torque(const clod_wall *wall)
{
    return wall->sum_torque.z;
}

static double mean_lever(const clod_wall_shear *self)
{
    return self->mean_radius;
}

static double *velocity(clod_wall *plate)
{
    return &plate->velocity.x;
}

static double force(const clod_wall *wall)
{
    return wall->sum_force.x;
}

static double no_lever(const clod_wall_shear *self)
{
    (void)self;
    return 1.0;
}

static const plate_drive TURNS = {spin, torque, mean_lever};
static const plate_drive SLIDES = {velocity, force, no_lever};

static const plate_drive *drive_of(const clod_wall_shear *self)
{
    return self->mean_radius > 0.0 ? &TURNS : &SLIDES;
}

/** Spin or velocity of the plate. */
static double *motion_of(const clod_wall_shear *self, const clod_state *state)
{
    return drive_of(self)->motion(clod_bed_wall(state, "plate"));
}

/** Speed of the plate, in a ring at r_m [m/s]. */
static double speed_of(const clod_wall_shear *self, const clod_state *state)
{
    return *motion_of(self, state) * drive_of(self)->lever(self);
}

static void set_speed(const clod_wall_shear *self, clod_state *state, double speed)
{
    *motion_of(self, state) = speed / drive_of(self)->lever(self);
}

/** Whether the speed is the target, to the last bit. */
static bool is_at_speed(const clod_wall_shear *self, const clod_state *state)
{
    return *motion_of(self, state) == self->target_speed / drive_of(self)->lever(self);
}

/** Load of the lid that gives a normal stress on the plate, as long as the sides carry none. */
static void set_stress(const clod_wall_shear *self, clod_state *state, double stress)
{
    clod_bed_wall(state, "lid")->load_force =
        fmax((stress - weight_of(self, state)) * self->area, 0.0);
}

/** Shear stress that the drive of a wall, or its bearing, feels, times steps [Pa]. */
static double sheared(const clod_wall_shear *self, const clod_wall *wall)
{
    const plate_drive *drive = drive_of(self);
    return drive->resistance(wall) / (self->area * drive->lever(self));
}

/** Mean forces on the walls since the last look. */
static void measure(const clod_wall_shear *self, const clod_state *state, double *row)
{
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const clod_wall *sides = clod_bed_wall(state, "sides");
    const clod_wall *plate = clod_bed_wall(state, "plate");
    const double steps = (double)(lid->sum_steps > 0 ? lid->sum_steps : 1);
    const double height = height_of(self, state);
    row[CLOD_WALL_SHEAR_TIME] = (double)state->step * state->dt;
    row[CLOD_WALL_SHEAR_PHASE] = (double)self->phase;
    row[CLOD_WALL_SHEAR_DISPLACEMENT] = self->displacement;
    row[CLOD_WALL_SHEAR_NORMAL_STRESS] = -plate->sum_force.z / (steps * self->area);
    row[CLOD_WALL_SHEAR_SHEAR_STRESS] = 0.0 - sheared(self, plate) / steps; // never -0
    row[CLOD_WALL_SHEAR_NORMAL_STRESS_LID] =
        lid->sum_force.z / (steps * self->area) + weight_of(self, state);
    row[CLOD_WALL_SHEAR_SHEAR_STRESS_HELD] =
        (sheared(self, lid) + sheared(self, sides)) / steps;
    row[CLOD_WALL_SHEAR_HEIGHT] = height;
    row[CLOD_WALL_SHEAR_BULK_DENSITY] = bulk_density(self, height);
    row[CLOD_WALL_SHEAR_SPEED] = speed_of(self, state);
    row[CLOD_WALL_SHEAR_POWER] = plate->sum_power / steps;
}

// ---- beginnings

static void enter(clod_wall_shear *self, clod_state *state, clod_wall_shear_phase phase)
{
    self->phase = phase;
    self->phase_start = (double)state->step * state->dt;
    self->in_phase = 0.0;
    self->calm = 0;
    clod_walls_reset_sums(&state->walls);
}

static int descending(const void *first, const void *second)
{
    const double a = *(const double *)first;
    const double b = *(const double *)second;
    return (a < b) - (a > b);
}

void clod_wall_shear_programme(clod_wall_shear *self, const clod_case *from)
{
    const clod_case_wall_friction *test = &from->wall_friction;
    self->stress_count = (int64_t)test->wall_stress_count;
    for (size_t k = 0; k < test->wall_stress_count; k++) {
        self->stresses[k] = test->wall_stresses[k];
    }
    qsort(self->stresses, test->wall_stress_count, sizeof *self->stresses, descending);
    self->speed = test->speed;
    self->block_displacement = test->block_displacement;
    self->steady_blocks = test->steady_blocks;
    self->steady_tolerance = test->steady_tolerance;
    self->shear_min = test->shear_min;
    self->shear_max = test->shear_max;
    self->settle_max = test->settle_max;
}

/** Radius at which a uniform shear stress has its torque [m]; 0: the plate does not turn. */
static double mean_radius(const clod_case_wall_friction *cell)
{
    const double ri = cell->inner_radius;
    const double ro = cell->outer_radius;
    return clod_wall_cell_of(cell)->turns
               ? 2.0 / 3.0 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri)
               : 0.0;
}

void clod_wall_shear_begin(clod_wall_shear *self, const clod_case *from, clod_state *state)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    const clod_wall *lid = clod_bed_wall(state, "lid");
    const double bars = lid->shape_count > 1 ? cell->bar_height : 0.0;
    *self = (clod_wall_shear){
        .area = lid->area,
        .mean_radius = mean_radius(cell),
        .grain_mass = clod_bed_mass(state),
        .bars_volume = clod_bed_bars_volume(state) + clod_wall_ridges_of(cell).volume,
        .bar_height = bars,
        .lid_start = lid->shapes[0].center.z,
        .lowest_lid = bars + cell->plate_ridges.height + 2.0 * clod_bed_largest(state),
        .fill_max = cell->fill_max,
    };
    clod_wall_shear_programme(self, from);
    clod_bed_wall(state, "lid")->load = CLOD_LOAD_NONE;
    enter(self, state, CLOD_WALL_SHEAR_FILL);
}

void clod_wall_shear_branch(clod_wall_shear *self, clod_state *state)
{
    self->flags = 0; // what was not right with the filling stands in its own
    clod_bed_put_lid(state, height_of(self, state), self->bar_height);
    enter(self, state, CLOD_WALL_SHEAR_LOWER);
}

/** Move on the plate to the stress number `at`; the first is the one that consolidated. */
static void run_in(clod_wall_shear *self, clod_state *state)
{
    self->start_stress = self->stresses[self->at > 0 ? self->at - 1 : 0];
    // speed with the square root of the stress: the same inertial number at all of them
    self->target_speed = self->speed * sqrt(self->stresses[self->at] / self->stresses[0]);
    enter(self, state, CLOD_WALL_SHEAR_RUN_IN);
}

// ---- planning

int64_t clod_wall_shear_plan(const clod_wall_shear *self, const clod_state *state)
{
    if (self->phase == CLOD_WALL_SHEAR_DONE) {
        return 0;
    }
    if (!is_at_speed(self, state)) {
        return FINE_STEPS;
    }
    if (self->phase == CLOD_WALL_SHEAR_SHEAR) {
        const double sample = self->block_displacement / BLOCK_SAMPLES;
        return (int64_t)fmax(1.0, round(sample / (self->target_speed * state->dt)));
    }
    return CLOD_LIMITS_COARSE_STEPS;
}

// ---- after each look

static void after_fill(clod_wall_shear *self, clod_state *state, double time)
{
    bool late;
    if (clod_bed_is_filled(state, time, self->fill_max, &late)) {
        self->flags |= late ? CLOD_WALL_SHEAR_NOT_SETTLED : 0;
        enter(self, state, CLOD_WALL_SHEAR_DONE);
    }
}

static void after_lower(clod_wall_shear *self, clod_state *state, const double *row)
{
    const double carried = row[CLOD_WALL_SHEAR_NORMAL_STRESS_LID];
    if (carried - weight_of(self, state) > TOUCH_FRACTION * self->stresses[0]) {
        clod_bed_take_over(clod_bed_wall(state, "lid"));
        state->adhesion = 1.0;
        self->start_stress = carried;
        set_stress(self, state, carried);
        enter(self, state, CLOD_WALL_SHEAR_CONSOLIDATE);
    }
}

/** Raise or lower the load along its ramp; true when the ramp is over. */
static bool ramp_load(clod_wall_shear *self, clod_state *state, double time)
{
    const double part = clod_bed_ramp(time);
    const double target = self->stresses[self->at];
    set_stress(self, state, self->start_stress + part * (target - self->start_stress));
    return part >= 1.0;
}

static void after_consolidate(clod_wall_shear *self, clod_state *state, const double *row,
                              double time, double interval)
{
    const bool ramped = ramp_load(self, state, time);
    const bool late = time > self->settle_max;
    const double speed = (row[CLOD_WALL_SHEAR_HEIGHT] - self->last_height) / interval;
    const double stress = row[CLOD_WALL_SHEAR_NORMAL_STRESS_LID] / self->stresses[0];
    const bool calm = clod_bed_is_calm(&self->calm, speed, stress);
    if (ramped && (calm || late)) {
        self->flags |= calm ? 0 : CLOD_WALL_SHEAR_NOT_SETTLED;
        run_in(self, state);
    }
}

/** The load is there, and a block's way has been sheared: the blocks may count. */
static void after_run_in(clod_wall_shear *self, clod_state *state, double time)
{
    const bool ramped = ramp_load(self, state, time);
    if (ramped && is_at_speed(self, state) && self->in_phase >= self->block_displacement) {
        clod_steady_init(&self->steady, self->steady_blocks, BLOCK_SAMPLES,
                         self->steady_tolerance, (double)INFINITY);
        enter(self, state, CLOD_WALL_SHEAR_SHEAR);
    }
}

/** Means of the steady blocks, or of the last ones when it was not steady. */
static clod_wall_shear_point point_of(const clod_wall_shear *self)
{
    const clod_steady_result blocks = clod_steady_summary(&self->steady);
    const double block = self->in_phase / (double)self->steady.block_count;
    const double way = ((double)blocks.blocks - 1.0) * block;
    return (clod_wall_shear_point){
        .normal = blocks.sigma.value,
        .normal_error = blocks.sigma.error,
        .shear = blocks.tau.value,
        .shear_error = blocks.tau.error,
        .rate = blocks.tau.trend / way,
        .rate_error = blocks.tau.trend_error / way,
        .height = blocks.height.value,
        .density = bulk_density(self, blocks.height.value),
        .displacement = self->in_phase,
        .steady = blocks.steady,
    };
}

static void after_shear(clod_wall_shear *self, clod_state *state, const double *row)
{
    set_stress(self, state, self->stresses[self->at]);
    const bool level =
        clod_steady_add(&self->steady, row[CLOD_WALL_SHEAR_SHEAR_STRESS],
                        row[CLOD_WALL_SHEAR_HEIGHT], row[CLOD_WALL_SHEAR_NORMAL_STRESS]);
    // both to the nearest block: its way is a whole number of steps
    const double way = self->in_phase + 0.5 * self->block_displacement;
    const bool steady = level && way >= self->shear_min;
    // never without the blocks that a mean with an error needs, however short the limit
    const bool late = way > self->shear_max && self->steady.block_count >= CLOD_STEADY_MIN;
    if (self->steady.samples > 0 || (!steady && !late)) {
        return; // at the end of a block only
    }
    self->flags |= steady ? 0 : CLOD_WALL_SHEAR_NOT_STEADY;
    self->point[self->at++] = point_of(self);
    if (self->at < self->stress_count) {
        run_in(self, state);
    } else {
        enter(self, state, CLOD_WALL_SHEAR_DONE);
    }
}

/** Bring the speed of the plate towards its target without a blow. */
static void slew(const clod_wall_shear *self, clod_state *state, double interval)
{
    const double now = speed_of(self, state);
    const double change = self->target_speed - now;
    const double most = CLOD_CASE_SHEAR_ACCELERATION * interval;
    if (!is_at_speed(self, state)) {
        set_speed(self, state,
                  fabs(change) <= most ? self->target_speed : now + copysign(most, change));
    }
}

static void move_on(clod_wall_shear *self, clod_state *state, const double *row,
                    double interval)
{
    const double time = (double)state->step * state->dt - self->phase_start;
    switch (self->phase) {
    case CLOD_WALL_SHEAR_FILL:
        after_fill(self, state, time);
        break;
    case CLOD_WALL_SHEAR_LOWER:
        after_lower(self, state, row);
        break;
    case CLOD_WALL_SHEAR_CONSOLIDATE:
        after_consolidate(self, state, row, time, interval);
        break;
    case CLOD_WALL_SHEAR_RUN_IN:
        after_run_in(self, state, time);
        break;
    case CLOD_WALL_SHEAR_SHEAR:
        after_shear(self, state, row);
        break;
    default:
        break;
    }
}

bool clod_wall_shear_sample(clod_wall_shear *self, clod_state *state, double *row)
{
    const double interval = (double)clod_bed_wall(state, "lid")->sum_steps * state->dt;
    const double way = fabs(speed_of(self, state)) * interval;
    self->displacement += way;
    self->in_phase += way;
    measure(self, state, row);
    clod_walls_reset_sums(&state->walls);
    move_on(self, state, row, interval);
    self->last_height = row[CLOD_WALL_SHEAR_HEIGHT];
    slew(self, state, interval);
    if (self->phase != CLOD_WALL_SHEAR_FILL && self->last_height < self->lowest_lid) {
        self->flags |= CLOD_WALL_SHEAR_NO_BED;
        self->phase = CLOD_WALL_SHEAR_DONE;
    }
    return self->phase == CLOD_WALL_SHEAR_DONE;
}

bool clod_wall_shear_trouble(const clod_wall_shear *self, char *text, size_t size)
{
    const bool trouble = (self->flags & CLOD_WALL_SHEAR_NO_BED) != 0;
    if (trouble) {
        snprintf(text, size,
                 "the lid sank to %.3g mm, where no grain fits between it and the plate: the "
                 "cell holds too few grains. Raise wall_friction.grain_count (or "
                 "fill_fraction), or lower bar_height",
                 1e3 * self->last_height);
    }
    return trouble;
}

double clod_wall_shear_progress(const clod_wall_shear *self)
{
    if (self->phase == CLOD_WALL_SHEAR_DONE) {
        return 1.0;
    }
    const double here = self->phase == CLOD_WALL_SHEAR_SHEAR
                            ? fmin(self->in_phase / self->shear_max, 1.0)
                            : 0.0;
    return ((double)self->at + here) / (double)self->stress_count;
}
