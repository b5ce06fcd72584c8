#include "sim/check.h"

#include <math.h>

#include "law/law_cycle.h"
#include "setup/begin.h"
#include "setup/jenike_cell.h"
#include "setup/ring_cell.h"
#include "setup/state.h"
#include "setup/uniaxial_cell.h"
#include "setup/walls.h"
#include "sim/shear_cell.h"

/** Solid fraction assumed of a settled bed of a free run. */
#define BED_FRACTION 0.6

static double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void look_at_grains(const clod_grains *grains, clod_check_report *report)
{
    report->grains = grains->count;
    report->radius_min = HUGE_VAL;
    for (size_t g = 0; g < grains->count; g++) {
        const double r = grains->place[g][3];
        report->radius_min = fmin(report->radius_min, r);
        report->radius_max = fmax(report->radius_max, r);
        report->radius_mean += r / (double)grains->count;
        report->mass += grains->motion[g][3];
        report->solid_volume += 4.0 / 3.0 * M_PI * r * r * r;
    }
}

static void look_at_step(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_timestep *t = &subject->timestep;
    const clod_case_material *materials = subject->from->materials;
    report->step = t->step;
    report->step_given = t->given;
    report->automatic = t->automatic;
    report->critical = t->critical;
    report->reason = t->text;
    report->pair_1 = materials[t->material_a].name;
    report->pair_2 = materials[t->material_b].name;
    report->pair_wall = t->wall;
    report->stiffness = t->stiffness;
    report->spring_mass = t->mass;
    report->rayleigh = t->rayleigh;
    report->rayleigh_fraction = t->rayleigh_fraction;
    report->rayleigh_imposed = t->reason == CLOD_TIMESTEP_RAYLEIGH;
}

/** Two mean grains under the target stress; after it the largest pull (PHYSICS 1). */
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
        report->stress = subject->timestep.force / (4.0 * r * r);
    }
    report->contact_force = clod_timestep_force(report->stress, r);
    report->overlap = clod_law_cycle_overlap(law, 0.5 * r, report->contact_force);
    report->overlap_ratio = report->overlap / r;
    report->pull_off = clod_law_cycle_pull(law, 0.5 * r, report->overlap).force;
    report->weight = 4.0 / 3.0 * M_PI * r * r * r * from->materials[subject->material].density *
                     length3(from->gravity);
    report->bond = report->weight > 0.0 ? report->pull_off / report->weight : 0.0;
}

/** I = (shear rate) d sqrt(rho/sigma) with a rate that is the same everywhere (PHYSICS 5). */
static double inertial_number(const clod_check_subject *subject, double diameter, double rate,
                              double stress)
{
    const double density = subject->from->materials[subject->material].density;
    return rate * diameter * sqrt(density / stress);
}

/** Between these heights the specimen settles, how far nobody knows before it is tried. */
static bool find_heights(const clod_check_subject *subject, clod_check_report *report,
                         clod_status *status)
{
    clod_case full = *subject->from;
    full.ring_shear.grain_count = full.jenike.grain_count = full.uniaxial.grain_count = 0;
    double depth = full.uniaxial.height;
    if (report->kind == CLOD_CHECK_UNIAXIAL) {
        report->full_grains = clod_uniaxial_cell_count(&full, full.seed, status);
    } else {
        depth = clod_shear_cell_of(&full).height;
        report->full_grains = full.jenike.present
                                  ? clod_jenike_cell_count(&full, full.seed, status)
                                  : clod_ring_cell_count(&full, full.seed, status);
    }
    if (report->full_grains == 0) {
        return false;
    }
    report->height_aimed = depth * (double)report->grains / (double)report->full_grains;
    for (size_t g = 0; g < report->grains; g++) {
        const double *place = subject->state.grains.place[g];
        report->height_loose = fmax(report->height_loose, place[2] + place[3]);
    }
    report->across_depth = report->height_aimed / (2.0 * report->radius_mean);
    return true;
}

/** Crushed at the lowest consolidation stress, as if the strength were as much. */
static bool look_at_uniaxial(const clod_check_subject *subject, clod_check_report *report,
                             clod_status *status)
{
    const clod_case_uniaxial *test = &subject->from->uniaxial;
    if (!find_heights(subject, report, status)) {
        return false;
    }
    const double diameter = 2.0 * report->radius_mean;
    double lowest = report->stress;
    for (size_t s = 0; s < test->consolidation_stress_count; s++) {
        lowest = fmin(lowest, test->consolidation_stresses[s]);
    }
    report->lowest_stress = lowest;
    report->inertial_lowest =
        inertial_number(subject, diameter, test->speed / report->height_aimed, lowest);
    report->across_width = test->diameter / diameter;
    return true;
}

/** Of a ring or of a Jenike cell. */
static bool look_at_shear(const clod_check_subject *subject, clod_check_report *report,
                          clod_status *status)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    const clod_case_programme *shear = cell.programme;
    if (!find_heights(subject, report, status)) {
        return false;
    }
    const double diameter = 2.0 * report->radius_mean;
    double lowest = shear->preshear_stress;
    for (size_t s = 0; s < shear->shear_stress_count; s++) {
        lowest = fmin(lowest, shear->shear_stresses[s]);
    }
    report->lowest_stress = lowest;
    report->lowest_speed = shear->speed * sqrt(lowest / shear->preshear_stress);
    report->inertial_preshear = inertial_number(
        subject, diameter, shear->speed / report->height_aimed, shear->preshear_stress);
    report->inertial_loose = inertial_number(
        subject, diameter, shear->speed / report->height_loose, shear->preshear_stress);
    report->inertial_lowest =
        inertial_number(subject, diameter, report->lowest_speed / report->height_aimed, lowest);
    report->across_width = cell.width / diameter;
    const clod_case_ring_shear *ring = &subject->from->ring_shear;
    report->bar_diameters = ring->bar_count > 0 ? ring->bar_height / diameter : 0.0;
    return true;
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

static bool make_subject(const clod_case *from, const clod_check_options *options,
                         clod_check_subject *subject, clod_status *status)
{
    *subject = (clod_check_subject){.from = from, .options = options};
    if (!clod_begin_state(from, from->seed, &subject->state, status) ||
        !clod_setup_timestep(from, &subject->state, &subject->timestep, status)) {
        return false;
    }
    const int m = subject->state.grains.material[0];
    subject->material = m;
    subject->law =
        clod_law_make(clod_case_pair(from, m, m), &from->materials[m], &from->materials[m]);
    return true;
}

static clod_check_kind kind_of(const clod_case *from)
{
    if (from->ring_shear.present) {
        return CLOD_CHECK_RING_SHEAR;
    }
    if (from->jenike.present) {
        return CLOD_CHECK_JENIKE;
    }
    if (from->uniaxial.present) {
        return CLOD_CHECK_UNIAXIAL;
    }
    return from->grains_count == 0 ? CLOD_CHECK_CONTACT_BENCH : CLOD_CHECK_FREE_RUN;
}

static bool look_at_tester(const clod_check_subject *subject, clod_check_report *report,
                           clod_status *status)
{
    switch (report->kind) {
    case CLOD_CHECK_RING_SHEAR:
    case CLOD_CHECK_JENIKE:
        return look_at_shear(subject, report, status);
    case CLOD_CHECK_UNIAXIAL:
        return look_at_uniaxial(subject, report, status);
    default:
        return true;
    }
}

bool clod_check_report_make(const clod_case *from, const clod_check_options *options,
                            clod_check_report *report, clod_status *status)
{
    *report =
        (clod_check_report){.kind = kind_of(from), .path = from->path, .title = from->title};
    if (report->kind == CLOD_CHECK_CONTACT_BENCH) {
        return true;
    }
    clod_check_subject subject;
    bool good = make_subject(from, options, &subject, status);
    if (good) {
        look_at_grains(&subject.state.grains, report);
        look_at_step(&subject, report);
        look_at_contact(&subject, report);
        look_at_servo(&subject, report);
        good = look_at_tester(&subject, report, status) &&
               clod_check_cost(&subject, report, status);
    }
    if (good) {
        clod_check_warn(&subject, report);
    }
    clod_state_fini(&subject.state);
    return good;
}
