/**
 * @file check_soften.c
 * What contacts.soften costs and what it leaves, for the preflight (docs/theory/softening.md).
 */

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "law/law_cycle.h"
#include "law/law_kinds.h"
#include "setup/bed.h"
#include "setup/bound.h"
#include "setup/collision.h"
#include "setup/state.h"
#include "sim/check_testers.h"
#include "tester/limits.h"

/** What two mean grains do under a stress and in an impact, with the stiffness of a case. */
static void look_at(const clod_check_subject *subject, const clod_case *from,
                    const clod_setup_bound *bound, const clod_check_report *report,
                    clod_check_contact *to)
{
    const int m = subject->material;
    const clod_case_material *material = &from->materials[m];
    const clod_law law = clod_law_make(clod_case_pair(from, m, m), material, material);
    const double r = report->radius_mean;
    const double r_star = 0.5 * r;
    const double mass = 4.0 / 3.0 * M_PI * r * r * r * material->density;
    to->automatic = clod_setup_bound_timestep(bound, from).automatic;
    const double force = clod_timestep_force(bound->stress, r);
    const double rest = clod_law_cycle_overlap(&law, r_star, force);
    to->overlap_ratio = rest / r;
    to->pull_off = clod_law_cycle_pull(&law, r_star, rest).force;
    to->wave_speed = 2.0 * r * sqrt(clod_law_stiffest(&law, rest, r_star) / mass);
    if (report->impact_speed > 0.0) {
        const double deep =
            clod_timestep_impact(&law, r_star, 0.5 * mass, report->impact_speed);
        to->impact_ratio = deep / r;
        to->impact_time = clod_collision_time(&law, r_star, 0.5 * mass, deep);
        to->impact_force = clod_law_cycle_force(&law, r_star, deep);
        to->impact_pull = clod_law_cycle_pull(&law, r_star, deep).force;
    }
}

bool clod_check_soften(const clod_check_subject *subject, clod_check_report *report,
                       clod_status *status)
{
    const clod_case *from = subject->from;
    if (!(from->soften > 1.0)) {
        return true;
    }
    const size_t pairs = from->material_count * from->material_count;
    clod_case hard = *from; // the same case without softening; it borrows all but its pairs
    hard.soften = 0.0;
    hard.pairs = clod_memory_alloc(pairs, sizeof *hard.pairs);
    if (hard.pairs == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu contact laws", pairs);
    }
    for (size_t p = 0; p < pairs; p++) {
        hard.pairs[p] = from->pairs[p];
        hard.pairs[p].soften = 0.0;
    }
    clod_setup_bound bound;
    const bool good = clod_setup_bound_init(&bound, from, &subject->state, status);
    if (good) {
        report->soften = from->soften;
        report->rest_stress = bound.stress;
        report->impact_speed =
            clod_case_tester(from) == NULL ? clod_setup_impact_speed(&subject->state) : 0.0;
        look_at(subject, from, &bound, report, &report->soft);
        look_at(subject, &hard, &bound, report, &report->hard);
    }
    clod_setup_bound_fini(&bound);
    clod_memory_free(hard.pairs);
    return good;
}

void clod_check_soften_write(clod_check_page *to, const clod_check_report *r)
{
    const clod_check_contact *soft = &r->soft;
    const clod_check_contact *hard = &r->hard;
    if (!(r->soften > 1.0)) {
        return;
    }
    clod_check_line(to, "softening",
                    "every stiffness divided by %.6g; in brackets: without softening",
                    r->soften);
    clod_check_line(to, "", "automatic step %.3g s (%.3g s), %.3g times as long",
                    soft->automatic, hard->automatic, soft->automatic / hard->automatic);
    clod_check_line(to, "",
                    "under %.4g kPa: overlap %.3g %% of the radius (%.3g %%), waves run at "
                    "%.3g m/s (%.3g m/s)",
                    1e-3 * r->rest_stress, 100.0 * soft->overlap_ratio,
                    100.0 * hard->overlap_ratio, soft->wave_speed, hard->wave_speed);
    if (r->impact_speed > 0.0) {
        clod_check_line(to, "",
                        "impact at %.3g m/s, the most there may be: overlap %.3g %% of the "
                        "radius (%.3g %%),",
                        r->impact_speed, 100.0 * soft->impact_ratio,
                        100.0 * hard->impact_ratio);
        clod_check_line(to, "",
                        "%.3g us (%.3g us) long, largest force %.3g N (%.3g N), pull-off after "
                        "it %.3g N (%.3g N)",
                        1e6 * soft->impact_time, 1e6 * hard->impact_time, soft->impact_force,
                        hard->impact_force, soft->impact_pull, hard->impact_pull);
    }
    clod_check_line(to, "", "pull-off after the same press of %.4g kPa: %.4g N (%.4g N)",
                    1e-3 * r->rest_stress, soft->pull_off, hard->pull_off);
    clod_check_line(to, "",
                    "stays while overlaps are small: stresses and angles of slow shear, "
                    "friction, restitution;");
    clod_check_line(to, "",
                    "changes: overlaps, bulk density (here by about %+.2g %%), waves, duration "
                    "and force of impacts",
                    150.0 * (soft->overlap_ratio - hard->overlap_ratio));
}

static const clod_check_real REALS[] = {
    CLOD_CHECK_REAL("soften", soften),
    CLOD_CHECK_REAL("soften_stress_Pa", rest_stress),
    CLOD_CHECK_REAL("soften_impact_speed_m_per_s", impact_speed),
    CLOD_CHECK_REAL("softened_step_auto_s", soft.automatic),
    CLOD_CHECK_REAL("softened_overlap_ratio", soft.overlap_ratio),
    CLOD_CHECK_REAL("softened_pull_off_N", soft.pull_off),
    CLOD_CHECK_REAL("softened_wave_speed_m_per_s", soft.wave_speed),
    CLOD_CHECK_REAL("softened_impact_overlap_ratio", soft.impact_ratio),
    CLOD_CHECK_REAL("softened_impact_time_s", soft.impact_time),
    CLOD_CHECK_REAL("softened_impact_force_N", soft.impact_force),
    CLOD_CHECK_REAL("softened_impact_pull_off_N", soft.impact_pull),
    CLOD_CHECK_REAL("unsoftened_step_auto_s", hard.automatic),
    CLOD_CHECK_REAL("unsoftened_overlap_ratio", hard.overlap_ratio),
    CLOD_CHECK_REAL("unsoftened_pull_off_N", hard.pull_off),
    CLOD_CHECK_REAL("unsoftened_wave_speed_m_per_s", hard.wave_speed),
    CLOD_CHECK_REAL("unsoftened_impact_overlap_ratio", hard.impact_ratio),
    CLOD_CHECK_REAL("unsoftened_impact_time_s", hard.impact_time),
    CLOD_CHECK_REAL("unsoftened_impact_force_N", hard.impact_force),
    CLOD_CHECK_REAL("unsoftened_impact_pull_off_N", hard.impact_pull),
};

void clod_check_soften_put(json_t *to, const clod_check_report *r)
{
    if (r->soften > 1.0) {
        clod_check_put(to, r, REALS, sizeof REALS / sizeof REALS[0]);
    }
}

/** What a pair's law owns beside its stiffnesses, which no factor of them can keep in scale. */
static void note_scale(const clod_case_contact *pair, const char *a, const char *b,
                       clod_check_report *r)
{
    if (clod_law_kinds_row((clod_law_kind)pair->law)->keys.plasticity_depth != NULL) {
        clod_check_note(r,
                        "%s-%s: plasticity_depth is a length, so the force at which %s "
                        "becomes elastic is divided by %.6g too: contacts get there under less "
                        "stress. plasticity_depth times as large keeps it (docs/theory/"
                        "softening.md)",
                        a, b, CLOD_LAW_NAMES[pair->law], r->soften);
    }
    if (pair->surface_energy > 0.0) {
        const double more = pow(r->soften, 0.5 / pair->exponent);
        clod_check_note(r,
                        "%s-%s: surface_energy is not divided, and its pull grows with the "
                        "plastic patch: %.3g times after the same press. surface_energy "
                        "divided by that keeps it (docs/theory/softening.md)",
                        a, b, more);
    }
    if (pair->pull_off_force > 0.0) {
        clod_check_note(r,
                        "%s-%s: pull_off_force is not divided: it stays beside weight and "
                        "stress, but parts further away: grains stick up to %.3g times the "
                        "speed of impact (docs/theory/softening.md)",
                        a, b, pow(r->soften, 0.5 / pair->exponent));
    }
}

/** Impacts, where only a stress was given; else the common warning knows of them. */
static void warn_impact(const clod_check_subject *subject, clod_check_report *r)
{
    const double deep = r->soft.impact_ratio;
    if (!(subject->from->time.design_stress > 0.0) || deep <= CLOD_LIMITS_OVERLAP_MOST) {
        return;
    }
    char good[96];
    const double n = subject->law.exponent;
    const double least = r->soften * pow(CLOD_LIMITS_OVERLAP_MOST / deep, n + 1.0);
    if (least >= 1.0) {
        snprintf(good, sizeof good, "contacts.soften: %.2g keeps them there", least);
    } else {
        snprintf(good, sizeof good, "the stiffness as given has %.3g %%",
                 100.0 * r->hard.impact_ratio);
    }
    clod_check_warning(
        r,
        "impacts at up to %.3g m/s may press grains %.3g %% of their radius into "
        "each other%s. Below %.0f %% is good; %s",
        r->impact_speed, 100.0 * deep,
        deep > subject->from->time.overlap_limit
            ? ", beyond time.overlap_limit, where a run stops"
            : "",
        100.0 * CLOD_LIMITS_OVERLAP_MOST, good);
}

void clod_check_soften_warn(const clod_check_subject *subject, clod_check_report *r)
{
    if (!(r->soften > 1.0)) {
        return;
    }
    const clod_case *from = subject->from;
    warn_impact(subject, r);
    const size_t n = from->material_count;
    for (size_t a = 0; a < n; a++) {
        for (size_t b = a; b < n; b++) {
            note_scale(&from->pairs[a * n + b], from->materials[a].name,
                       from->materials[b].name, r);
        }
    }
}
