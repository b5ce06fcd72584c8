#include "tester/ring_shear.h"

#include <math.h>
#include <stdio.h>

#include "tester/bed.h"
#include "tester/limits.h"
#include "tester/shear_tester.h"

// The programme below is the operator's hand: none of these numbers is a property of the solid,
// and the results folder shows what each did. Displacements are at the mean radius r_m.
#define TOUCH_FRACTION 0.05 ///< of the preshear stress: the lid carries
#define FINE_STEPS 50       ///< steps per look while the speed changes
#define BLOCK_SAMPLES 50    ///< samples per block of preshear

const char *clod_ring_shear_phase_name(clod_ring_shear_phase phase)
{
    static const char *const NAMES[] = {"fill",   "lower", "consolidate", "preshear", "reverse",
                                        "reduce", "shear", "done",        "twist"};
    return NAMES[phase];
}

/** Load of the lid that gives a normal stress at the shear plane. */
static void set_stress(const clod_ring_shear *self, clod_state *state, double stress)
{
    clod_wall *lid = clod_bed_wall(state, "lid");
    lid->load_force =
        fmax((stress - clod_shear_tester_solid_above(self, state)) * self->area, 0.0);
}

static void enter(clod_ring_shear *self, clod_state *state, clod_ring_shear_phase phase)
{
    self->phase = phase;
    self->phase_start = (double)state->step * state->dt;
    self->displacement = 0.0;
    self->calm = 0;
    clod_walls_reset_sums(&state->walls);
}

void clod_ring_shear_begin(clod_ring_shear *self, const clod_case *from, clod_state *state)
{
    const clod_case_programme *programme = clod_case_shear(from);
    const clod_shear_tester *tester = clod_shear_tester_of_case(from);
    tester->describe(self, from, state);
    self->kind = tester->kind;
    self->lid_start = clod_bed_wall(state, "lid")->shapes[0].center.z;
    self->grain_mass = clod_bed_mass(state);
    self->preshear_stress = programme->preshear_stress;
    self->speed = programme->speed;
    self->block_displacement = programme->block_displacement;
    self->preshear_min = programme->preshear_min;
    self->preshear_max = programme->preshear_max;
    self->shear_max = programme->shear_max;
    // as the operator of a shear tester: steady is when the shear stress is (ASTM D6773); a
    // height that still changes is told in the warning box
    clod_steady_init(&self->steady, programme->steady_blocks, BLOCK_SAMPLES,
                     programme->steady_tolerance, (double)INFINITY);
    clod_peak_init(&self->peak, programme->peak_window, programme->beyond_peak);
    clod_bed_wall(state, "lid")->load = CLOD_LOAD_NONE;
    enter(self, state, CLOD_RING_SHEAR_FILL);
}

void clod_ring_shear_reverse(clod_ring_shear *self, clod_state *state)
{
    self->target_speed = -CLOD_LIMITS_REVERSE_FRACTION * self->speed;
    self->target_stress = self->preshear_stress;
    self->flags = 0; // what was not right with the preparation stands in its own
    enter(self, state, CLOD_RING_SHEAR_REVERSE);
}

void clod_ring_shear_branch(clod_ring_shear *self, double shear_stress, clod_state *state)
{
    self->shear_stress = shear_stress;
    // shear rate with the square root of the stress: the same inertial number as in preshear
    self->shear_speed = self->speed * sqrt(fmin(shear_stress / self->preshear_stress, 1.0));
    self->start_stress = self->preshear_stress;
    self->target_stress = shear_stress;
    self->flags = 0; // what was not right before stands in its own
    enter(self, state, CLOD_RING_SHEAR_REDUCE);
}

/** Steps in which the solid is sheared by `displacement` [m] at `speed`. */
static int64_t steps_for(double displacement, double speed, const clod_state *state)
{
    return (int64_t)fmax(1.0, round(displacement / (speed * state->dt)));
}

/** Way [m] from a displacement of preshear to where its first block begins, so that blocks end at preshear_max,
 *  whatever the speed and the way of coming to it; 0: within half a sample. */
static double way_to_blocks(const clod_ring_shear *self, double displacement)
{
    if (self->steady.block_count > 0 || self->steady.samples > 0) {
        return 0.0; // it has begun
    }
    const double block = self->block_displacement, half = 0.5 * block / BLOCK_SAMPLES;
    const double way = fmod(self->preshear_max - displacement, block);
    return way > half && way < block - half ? way : 0.0;
}

int64_t clod_ring_shear_plan(const clod_ring_shear *self, const clod_state *state)
{
    if (self->phase == CLOD_RING_SHEAR_DONE) {
        return 0;
    }
    if (self->phase == CLOD_RING_SHEAR_REVERSE ||
        !clod_shear_tester_of(self)->is_at_speed(self, state)) {
        return FINE_STEPS;
    }
    if (self->phase == CLOD_RING_SHEAR_PRESHEAR) {
        const double sample = self->block_displacement / BLOCK_SAMPLES;
        const double way = way_to_blocks(self, self->displacement);
        return steps_for(way > 0.0 ? fmin(way, sample) : sample, self->speed, state);
    }
    if (self->phase == CLOD_RING_SHEAR_SHEAR) { // a sample for every bin of the peak at least
        const int64_t bin =
            steps_for(self->peak.window / CLOD_PEAK_BINS, self->shear_speed, state);
        return bin < CLOD_LIMITS_COARSE_STEPS ? bin : CLOD_LIMITS_COARSE_STEPS;
    }
    return CLOD_LIMITS_COARSE_STEPS;
}

static void after_fill(clod_ring_shear *self, clod_state *state, double in_phase)
{
    bool late;
    if (clod_bed_is_filled(state, in_phase, self->fill_max, &late)) {
        self->flags |= late ? CLOD_RING_SHEAR_NOT_SETTLED : 0;
        clod_bed_put_lid(state, clod_shear_tester_lid_height(self, state), self->bar_height);
        enter(self, state, CLOD_RING_SHEAR_LOWER);
    }
}

static void after_lower(clod_ring_shear *self, clod_state *state, const double *row)
{
    if (row[CLOD_RING_SHEAR_NORMAL_STRESS] > TOUCH_FRACTION * self->preshear_stress) {
        clod_bed_take_over(clod_bed_wall(state, "lid"));
        state->adhesion = 1.0;
        self->start_stress = row[CLOD_RING_SHEAR_NORMAL_STRESS];
        self->target_stress = self->preshear_stress;
        set_stress(self, state, self->start_stress);
        enter(self, state, CLOD_RING_SHEAR_CONSOLIDATE);
    }
}

/** Raise or lower the load along its ramp; true when the ramp is over. */
static bool ramp_load(clod_ring_shear *self, clod_state *state, double in_phase)
{
    const double part = clod_bed_ramp(in_phase);
    set_stress(self, state,
               self->start_stress + part * (self->target_stress - self->start_stress));
    return part >= 1.0;
}

static void after_load(clod_ring_shear *self, clod_state *state, const double *row,
                       double in_phase, double interval)
{
    const bool ramped = ramp_load(self, state, in_phase);
    const bool late = in_phase > self->settle_max;
    const double speed = (row[CLOD_RING_SHEAR_HEIGHT] - self->last_height) / interval;
    const double stress = row[CLOD_RING_SHEAR_NORMAL_STRESS] / self->target_stress;
    const bool calm = clod_bed_is_calm(&self->calm, speed, stress);
    if (!ramped || !(calm || late)) {
        return;
    }
    self->flags |= calm ? 0 : CLOD_RING_SHEAR_NOT_SETTLED;
    if (self->phase == CLOD_RING_SHEAR_CONSOLIDATE && self->twists > 0) {
        enter(self, state, CLOD_RING_SHEAR_TWIST);
        return;
    }
    const bool consolidated = self->phase == CLOD_RING_SHEAR_CONSOLIDATE;
    self->target_speed = consolidated ? self->speed : self->shear_speed;
    enter(self, state, consolidated ? CLOD_RING_SHEAR_PRESHEAR : CLOD_RING_SHEAR_SHEAR);
}

static void after_twist(clod_ring_shear *self, clod_state *state, double interval)
{
    set_stress(self, state, self->target_stress);
    if (clod_shear_tester_of(self)->twist(self, state,
                                          CLOD_CASE_SHEAR_ACCELERATION * interval)) {
        self->target_speed = self->speed;
        enter(self, state, CLOD_RING_SHEAR_PRESHEAR);
    }
}

/** What an operator would put on the hanger for the load that the lid carries now. */
static void note_hanger(clod_ring_shear *self, const clod_state *state)
{
    self->hanger_force =
        clod_bed_wall(state, "lid")->load_force + self->lid_mass * state->gravity[2];
}

/** What preshear gave: means of the steady blocks, or where the last blocks lead to. */
static void note_preshear(clod_ring_shear *self, bool steady)
{
    const clod_steady_result blocks = clod_steady_summary(&self->steady);
    const double way = ((double)blocks.blocks - 1.0) * self->block_displacement;
    self->preshear_normal = blocks.sigma.value;
    self->preshear_shear = steady ? blocks.tau.value : blocks.tau.end;
    self->preshear_error = steady ? blocks.tau.error : blocks.tau.end_error;
    self->preshear_rate = blocks.tau.trend / way;
    self->preshear_rate_error = blocks.tau.trend_error / way;
    self->preshear_height = steady ? blocks.height.value : blocks.height.end;
    self->preshear_density =
        self->grain_mass / (self->area * self->preshear_height - self->bars_volume);
    self->preshear_dilation = blocks.height.trend / way;
    self->preshear_displacement = self->displacement;
}

static void note_inside(clod_ring_shear *self, const clod_state *state)
{
    const double lid = clod_shear_tester_lid_height(self, state);
    const clod_inside bed = clod_shear_tester_of(self)->bed(self, state, lid);
    self->preshear_inside = clod_inside_density(&bed, state);
}

/** @param way  [m] of shear before this look */
static void after_preshear(clod_ring_shear *self, clod_state *state, const double *row,
                           double way)
{
    set_stress(self, state, self->target_stress);
    if (!clod_shear_tester_of(self)->is_at_speed(self, state) ||
        way_to_blocks(self, way) > 0.0) {
        return;
    }
    const bool level =
        clod_steady_add(&self->steady, row[CLOD_RING_SHEAR_SHEAR_STRESS],
                        row[CLOD_RING_SHEAR_HEIGHT], row[CLOD_RING_SHEAR_NORMAL_STRESS]);
    // to the nearest block, whose way is a whole number of steps; and never without the blocks that a
    // mean with an error needs, however short the limit
    const bool late =
        self->displacement + 0.5 * self->block_displacement > self->preshear_max &&
        self->steady.block_count >= CLOD_STEADY_MIN;
    const bool steady = level && (late || self->displacement >= self->preshear_min);
    if (self->steady.samples > 0 || (!steady && !late)) {
        return; // at the end of a block only: what is told is told of where preshear ended
    }
    self->flags |= steady ? 0 : CLOD_RING_SHEAR_NOT_STEADY;
    note_preshear(self, steady);
    note_inside(self, state);
    note_hanger(self, state);
    enter(self, state, CLOD_RING_SHEAR_DONE);
}

static void after_reverse(clod_ring_shear *self, clod_state *state, const double *row)
{
    set_stress(self, state, self->target_stress);
    const bool late = self->displacement > CLOD_LIMITS_REVERSE_MAX ||
                      clod_shear_tester_of(self)->is_back(state);
    if (row[CLOD_RING_SHEAR_SHEAR_STRESS] > 0.0 && !late) {
        return;
    }
    self->flags |= late ? CLOD_RING_SHEAR_NO_REVERSAL : 0;
    self->target_speed = 0.0;
    enter(self, state, CLOD_RING_SHEAR_DONE);
}

static void after_shear(clod_ring_shear *self, clod_state *state, const double *row)
{
    set_stress(self, state, self->target_stress);
    const bool passed =
        clod_peak_add(&self->peak, self->displacement, row[CLOD_RING_SHEAR_SHEAR_STRESS],
                      row[CLOD_RING_SHEAR_NORMAL_STRESS]);
    const double before = self->point_shear;
    const clod_peak_result peak = clod_peak_summary(&self->peak);
    self->point_shear = peak.tau;
    self->point_error = peak.tau_error;
    self->point_displacement = peak.displacement;
    self->point_normal = peak.sigma;
    if (peak.tau > before) {
        self->point_density = row[CLOD_RING_SHEAR_BULK_DENSITY];
    }
    const bool late = self->displacement > self->shear_max;
    if (passed || late) {
        self->flags |= passed ? 0 : CLOD_RING_SHEAR_NO_PEAK;
        note_hanger(self, state);
        enter(self, state, CLOD_RING_SHEAR_DONE);
    }
}

/** Bring the speed of shear towards its target without a blow. */
static void slew(const clod_ring_shear *self, clod_state *state, double interval)
{
    const clod_shear_tester *tester = clod_shear_tester_of(self);
    const double now = tester->speed(self, state);
    const double change = self->target_speed - now;
    const double most = CLOD_CASE_SHEAR_ACCELERATION * interval;
    if (!tester->is_at_speed(self, state)) {
        tester->set_speed(self, state,
                          fabs(change) <= most ? self->target_speed
                                               : now + copysign(most, change));
    }
}

/** Speed that counts as shear displacement: while it reverses, what is still braked does not.
 */
static double sheared(const clod_ring_shear *self, const clod_state *state)
{
    const double speed = clod_shear_tester_of(self)->speed(self, state);
    return self->phase == CLOD_RING_SHEAR_REVERSE ? fmax(-speed, 0.0) : fabs(speed);
}

/** The lid has sunk until its bars touch those of the trough, or nearly: no bed is left. */
static bool is_without_bed(const clod_ring_shear *self, const clod_state *state)
{
    return self->phase != CLOD_RING_SHEAR_FILL &&
           clod_shear_tester_lid_height(self, state) < self->lowest_lid;
}

bool clod_ring_shear_trouble(const clod_ring_shear *self, char *text, size_t size)
{
    const clod_shear_tester *tester = clod_shear_tester_of(self);
    const bool trouble = (self->flags & CLOD_RING_SHEAR_NO_BED) != 0;
    if (trouble) {
        snprintf(
            text, size,
            "the lid sank to %.3g mm, where no grain fits between %s: the cell holds too few "
            "grains. %s",
            1e3 * self->last_height, tester->lid_meets, tester->if_no_bed);
    }
    return trouble;
}

bool clod_ring_shear_sample(clod_ring_shear *self, clod_state *state, double *row)
{
    const double interval = (double)clod_bed_wall(state, "lid")->sum_steps * state->dt;
    const double in_phase = (double)state->step * state->dt - self->phase_start;
    const double way = self->displacement;
    self->displacement += sheared(self, state) * interval;
    clod_shear_tester_measure(self, state, row);
    clod_walls_reset_sums(&state->walls);
    switch (self->phase) {
    case CLOD_RING_SHEAR_FILL:
        after_fill(self, state, in_phase);
        break;
    case CLOD_RING_SHEAR_LOWER:
        after_lower(self, state, row);
        break;
    case CLOD_RING_SHEAR_CONSOLIDATE:
    case CLOD_RING_SHEAR_REDUCE:
        after_load(self, state, row, in_phase, interval);
        break;
    case CLOD_RING_SHEAR_TWIST:
        after_twist(self, state, interval);
        break;
    case CLOD_RING_SHEAR_PRESHEAR:
        after_preshear(self, state, row, way);
        break;
    case CLOD_RING_SHEAR_REVERSE:
        after_reverse(self, state, row);
        break;
    case CLOD_RING_SHEAR_SHEAR:
        after_shear(self, state, row);
        break;
    default:
        break;
    }
    self->last_height = row[CLOD_RING_SHEAR_HEIGHT];
    slew(self, state, interval);
    if (is_without_bed(self, state)) {
        self->flags |= CLOD_RING_SHEAR_NO_BED;
        self->phase = CLOD_RING_SHEAR_DONE;
    }
    return self->phase == CLOD_RING_SHEAR_DONE;
}

double clod_ring_shear_progress(const clod_ring_shear *self)
{
    switch (self->phase) {
    case CLOD_RING_SHEAR_PRESHEAR:
        return fmin(self->displacement / self->preshear_max, 1.0);
    case CLOD_RING_SHEAR_SHEAR:
        return fmin(self->displacement / self->shear_max, 1.0);
    case CLOD_RING_SHEAR_DONE:
        return 1.0;
    default:
        return 0.0;
    }
}
