#include "sim/check.h"

#include <math.h>

#include "base/given.h"
#include "config/source.h"
#include "law/law_cycle.h"
#include "setup/begin.h"
#include "setup/collision.h"
#include "setup/grains.h"
#include "setup/state.h"
#include "setup/walls.h"
#include "sim/check_testers.h"
#include "sim/mesh_doubts.h"
#include "sim/testers.h"
#include "sim/trial.h"

#define TRIED_STEPS 100       ///< of a run, before anything is said of it
#define TRIED_GRAINS 300000.0 ///< grains above which a case is neither made nor tried
#define SAMPLE_GRAINS 20000.0 ///< that are made of such a case, for sizes and time step

/** Solid fraction assumed of a settled bed of a free run. */
#define BED_FRACTION 0.6

static double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void look_at_grains(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_grains *grains = &subject->state.grains;
    report->radius_min = HUGE_VAL;
    for (size_t g = 0; g < grains->count; g++) {
        const double r = grains->position[g][3];
        report->radius_min = fmin(report->radius_min, r);
        report->radius_max = fmax(report->radius_max, r);
        report->radius_mean += r / (double)grains->count;
        report->mass += grains->velocity[g][3];
        report->solid_volume += 4.0 / 3.0 * M_PI * r * r * r;
    }
    report->grains = grains->count;
    if (subject->expected > 0.0) {
        const double more = subject->expected / (double)grains->count;
        report->sampled = grains->count;
        report->grains = (size_t)subject->expected;
        report->mass *= more;
        report->solid_volume *= more;
    }
}

/** How finely a collision of the pair that sets the step is cut, and what that does to e. */
static void look_at_collision(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_timestep *t = &subject->timestep;
    const clod_case *from = subject->from;
    const clod_case_contact *pair = clod_case_pair(from, t->material_a, t->material_b);
    const clod_law law =
        clod_law_make(pair, &from->materials[t->material_a], &from->materials[t->material_b]);
    report->collision_steps = t->collision / t->step;
    report->restitution = pair->restitution;
    const clod_collision_range range =
        clod_collision_restitution(&law, report->collision_steps);
    report->restitution_least = range.least;
    report->restitution_most = range.most;
}

static void look_at_step(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_timestep *t = &subject->timestep;
    const clod_case_material *materials = subject->from->materials;
    report->step = t->step;
    report->step_given = t->given;
    report->automatic = t->automatic;
    report->critical = t->critical;
    report->stable = t->bed;
    report->sheared = clod_case_shear(subject->from) != NULL;
    report->reason = t->text;
    report->pair_1 = materials[t->material_a].name;
    report->pair_2 = materials[t->material_b].name;
    report->pair_wall = t->wall;
    report->pair_radius_1 = t->radius_a;
    report->pair_radius_2 = t->radius_b;
    report->stiffness = t->stiffness;
    report->spring_mass = t->mass;
    report->rayleigh = t->rayleigh;
    report->rayleigh_fraction = t->rayleigh_fraction;
    report->rayleigh_imposed = t->reason == CLOD_TIMESTEP_RAYLEIGH;
}

/** Two mean grains under the target stress; after it the largest pull (docs/theory/mepa.md). */
static void look_at_contact(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_case *from = subject->from;
    const clod_law *law = &subject->law;
    const double r = report->radius_mean;
    if (from->time.design_stress > 0.0) {
        report->stress = from->time.design_stress;
    } else if (clod_case_tester(from) != NULL) {
        report->stress = clod_case_tester_stress(from);
    } else { // the largest of loads, weight and impacts that the time step was made for
        const double smaller = subject->timestep.radius;
        report->stress = subject->timestep.force / (4.0 * smaller * smaller);
    }
    report->contact_force = clod_timestep_force(report->stress, r);
    report->overlap = clod_law_cycle_overlap(law, 0.5 * r, report->contact_force);
    report->overlap_ratio = report->overlap / r;
    report->pull_off = clod_law_cycle_pull(law, 0.5 * r, report->overlap).force;
    report->weight = 4.0 / 3.0 * M_PI * r * r * r * from->materials[subject->material].density *
                     length3(from->gravity);
    report->bond = report->weight > 0.0 ? report->pull_off / report->weight : 0.0;
}

/** Shortest period of a loaded wall on the stiffness of the bed under it. */
static void look_at_servo(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_state *state = &subject->state;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        if (wall->load == CLOD_LOAD_NONE || !(wall->area > 0.0)) {
            continue;
        }
        const double height = report->solid_volume / (BED_FRACTION * wall->area);
        const double stiffness = clod_setup_bed_stiffness(
            subject->timestep.unloading, wall->area, height, report->radius_mean);
        const double period = clod_timestep_period(wall->mass, stiffness);
        if (report->servo_period == 0.0 || period < report->servo_period) {
            report->servo_period = period;
        }
    }
}

/**
 * The state with which the case begins, when it can: tried as a run does it. Of a case with
 * very many grains only a sample is made: making all would take longer than an estimate may.
 * Grains that come during the run are in it as if they were there.
 */
static bool make_state(const clod_case *from, clod_check_subject *subject, clod_status *status)
{
    const clod_case_programme *shear = clod_case_shear(from);
    const double seeds = shear != NULL ? (double)shear->seeds : 1.0;
    const clod_run_options how = {.threads = 1, .simd = subject->options->simd};
    const double share = subject->options->ranks > 1 ? 0.0 : 1.0; // on how many machines?
    double expected;
    if (!clod_begin_has_grains(from, status) ||
        !clod_begin_expect(from, share, &expected, status)) {
        return false;
    }
    const bool come = clod_setup_grains_coming(from) > 0;
    if (come || expected * seeds > TRIED_GRAINS) {
        subject->expected = expected;
        return clod_begin_sample(from, expected, SAMPLE_GRAINS, &subject->state, status);
    }
    return clod_begin_state(from, from->seed, &subject->state, status) &&
           clod_trial_run(from, &how, TRIED_STEPS, status);
}

static bool make_subject(const clod_case *from, const clod_check_options *options,
                         clod_check_subject *subject, clod_status *status)
{
    *subject = (clod_check_subject){.from = from, .options = options};
    if (!make_state(from, subject, status) ||
        !clod_setup_timestep(from, &subject->state, &subject->timestep, status)) {
        return false;
    }
    const int m = subject->state.grains.material[0];
    subject->material = m;
    subject->law =
        clod_law_make(clod_case_pair(from, m, m), &from->materials[m], &from->materials[m]);
    return true;
}

/** A doubt about a mesh, as a warning or as a note. */
static void tell(void *context, bool wrong, const char *text)
{
    (wrong ? clod_check_warning : clod_check_note)(context, "%s", text);
}

bool clod_check_report_make(const clod_case *from, const clod_check_options *options,
                            clod_check_report *report, clod_status *status)
{
    if (!CLOD_GIVEN(from, status) || !CLOD_GIVEN(options, status) ||
        !CLOD_GIVEN(report, status)) {
        return false;
    }
    if (options->ranks < 0 || options->ranks > CLOD_CHECK_RANKS) {
        return clod_status_fail(status, CLOD_USAGE, "ranks: %d; allowed 0 to %d",
                                options->ranks, CLOD_CHECK_RANKS);
    }
    *report = (clod_check_report){
        .kind = clod_case_kind_of(from), .path = from->path, .title = from->title};
    const clod_tester_row *tester = clod_testers_row(report->kind);
    if (tester->run == NULL) {
        return true;
    }
    clod_check_subject subject;
    bool good = make_subject(from, options, &subject, status);
    if (good) {
        look_at_grains(&subject, report);
        look_at_step(&subject, report);
        look_at_collision(&subject, report);
        look_at_contact(&subject, report);
        look_at_servo(&subject, report);
        good = clod_check_soften(&subject, report, status) &&
               (tester->look == NULL || tester->look(&subject, report, status)) &&
               clod_check_cost(&subject, report, status);
    }
    if (good) {
        clod_check_warn(&subject, report);
        good = clod_mesh_doubts(from, report->radius_mean, tell, report, status);
    }
    clod_state_fini(&subject.state);
    return good || clod_source_tell(from, status);
}
