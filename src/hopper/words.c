#include "hopper/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hopper/joint.h"

#define DEGREES 57.295779513082323
#define NO_ANGLE 1.5 ///< rad: of a wall that the solid does not slide along
#define MOST 0.5     ///< of the samples

/** Whether a half angle is given that is flatter than the limit that is given. */
static bool is_beyond(const clod_hopper_found *found)
{
    return found->wish.limit > 0.0 && found->wish.half_angle > found->wish.limit;
}

/** Share of the samples in funnel flow, or not known to be mass flow. */
static double without_mass_flow(const clod_hopper_found *found)
{
    return found->share[CLOD_HOPPER_FUNNEL] + found->share[CLOD_HOPPER_UNPROVEN];
}

/** Beside the verdict of mass flow, that too many samples do not have it. */
static void put_doubt(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    if (clod_hopper_is_mass_flow(&found->design) &&
        found->share[CLOD_HOPPER_FUNNEL] > CLOD_WORDS_SOME) {
        const size_t used = strlen(text);
        snprintf(text + used, CLOD_WORDS_MOST - used,
                 " But %.1f %% of the samples are in funnel flow: see the warnings.",
                 100.0 * found->share[CLOD_HOPPER_FUNNEL]);
    }
}

void clod_words_verdict(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "Mass flow, and no cohesive arch above the critical outlet.",
        [CLOD_HOPPER_NO_ARCH] =
            ("Mass flow. The strength nowhere reaches the stress of an arch: no cohesive arch "
             "at any outlet. Particles and the flow rate decide about its size."),
        [CLOD_HOPPER_ARCHES] =
            ("The strength stays above the stress of an arch, at every stress or beyond some "
             "stress: no outlet is large enough, the solid cannot flow by gravity."),
        [CLOD_HOPPER_FUNNEL] =
            ("Funnel flow: the solid does not slide along this wall. A smoother or a steeper "
             "one may help; otherwise only an outlet wider than the rathole empties."),
        [CLOD_HOPPER_UNSETTLED] = "No critical state was found; see the warnings.",
    };
    const clod_hopper_design *at = &found->design;
    if (clod_hopper_is_mass_flow(&found->design) && without_mass_flow(found) > MOST) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Mass flow is less likely than not: %.1f %% of the samples have none. As "
            "measured, without errors, it is mass flow, and no cohesive arch stands %s: see "
            "the warnings.",
            100.0 * without_mass_flow(found),
            at->outlet > 0.0 ? "above the critical outlet" : "at any outlet");
        return;
    }
    if (at->outcome == CLOD_HOPPER_UNPROVEN) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Not known to be mass flow: a wedge steeper than %.1f deg is, this one has %.1f "
            "deg. If a chart for wedges allows that, no cohesive arch stands %s.",
            DEGREES * at->limit, DEGREES * at->half_angle,
            at->outlet > 0.0 ? "above the critical outlet" : "at any outlet");
    } else if (is_beyond(found)) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Funnel flow: the half angle of %.1f deg is flatter than the limit of mass flow "
            "that is given, %.1f deg.",
            DEGREES * found->wish.half_angle, DEGREES * found->wish.limit);
    } else if (at->outcome == CLOD_HOPPER_NO_ARCH &&
               clod_words_arched(found) > CLOD_WORDS_SOME) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Mass flow. As measured no cohesive arch stands at any outlet, but one does in %.1f %% of the "
            "samples, which is within the errors: no answer yet, see the warnings.",
            100.0 * clod_words_arched(found));
    } else if (at->sticks) {
        snprintf(text, CLOD_WORDS_MOST,
                 "Mass flow, and no cohesive arch above the critical outlet. It is the wall's: "
                 "at the stresses of smaller ones the solid does not slide along it.");
    } else if (at->outcome == CLOD_HOPPER_FUNNEL && found->wish.shape == CLOD_RADIAL_WEDGE) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Funnel flow: the solid does not slide along this wall. A smoother or a steeper one "
            "may help; otherwise only a slot empties that is wider than the width in funnel "
            "flow, and whose diagonal is longer than the rathole's diameter.");
    } else {
        snprintf(text, CLOD_WORDS_MOST, "%s", WORDS[at->outcome]);
    }
    put_doubt(found, text);
}

/** "the wall friction angle is 24.1 deg", or that there is none. */
static void put_wall(const clod_solid_state *state, char text[64])
{
    if (state->phi_w < NO_ANGLE) {
        snprintf(text, 64, "the wall friction angle is %.1f deg", DEGREES * state->phi_w);
    } else {
        snprintf(text, 64, "the solid slides at no half angle");
    }
}

/** Which state makes it funnel flow. */
static void judge_funnel(const clod_hopper_design *at, char text[CLOD_WORDS_MOST])
{
    char wall[64];
    put_wall(&at->state, wall);
    if (at->built > 0.0) {
        const bool above = at->state.sigma_1 > at->design_state.sigma_1;
        snprintf(
            text, CLOD_WORDS_MOST,
            "at the outlet of %.1f mm, sigma_1 of %.3f kPa, the solid slides; at %s, sigma_1 of "
            "%.3f kPa, it does not: %s",
            1e3 * at->built, 1e-3 * at->design_state.sigma_1,
            above ? "larger stresses above it" : "smaller stresses", 1e-3 * at->state.sigma_1,
            wall);
    } else {
        snprintf(text, CLOD_WORDS_MOST, "where sigma_1 is %.3f kPa, phi_e %.1f deg, and %s",
                 1e-3 * at->state.sigma_1, DEGREES * at->state.phi_e, wall);
    }
}

bool clod_words_design_state(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    const clod_hopper_design *at = &found->design;
    if (at->outcome == CLOD_HOPPER_FUNNEL) {
        judge_funnel(at, text);
        return at->state.sigma_1 > 0.0 && !is_beyond(found);
    }
    const bool other = at->built > 0.0 && !(at->design_state.sigma_1 == at->state.sigma_1);
    snprintf(text, CLOD_WORDS_MOST,
             "at %s outlet of %.1f mm, where sigma_1 is %.3f kPa, phi_e %.1f and the wall "
             "friction angle %.1f deg",
             at->at_measured ? "the smallest measured stress, that of an" : "the",
             1e3 * at->built, 1e-3 * at->design_state.sigma_1, DEGREES * at->design_state.phi_e,
             DEGREES * at->design_state.phi_w);
    return other;
}

double clod_words_arched(const clod_hopper_found *found)
{
    return found->share[CLOD_HOPPER_FLOWS] + found->share[CLOD_HOPPER_ARCHES];
}

bool clod_words_line(const clod_hopper *self, char text[CLOD_WORDS_MOST])
{
    const clod_curve_misfit *at = &self->solid.strength.misfit;
    const char *why = "not all points have errors of f_c";
    char specimens[64];
    if (at->specimens > 0) {
        snprintf(specimens, sizeof specimens, "%zu specimens hardly tell how they differ",
                 at->specimens + 1);
        why = specimens;
    } else if (at->unsure) {
        why = "the few points of a yield locus hardly tell its errors";
    }
    const int used =
        snprintf(text, CLOD_WORDS_MOST, "Flow function: f_c = %.3f kPa %c %.4f sigma_1, ",
                 1e-3 * at->line.a, at->line.b < 0.0 ? '-' : '+', fabs(at->line.b));
    const size_t room = CLOD_WORDS_MOST - (size_t)used;
    int more = at->weighted ? snprintf(text + used, room, "points weighted by their errors")
                            : snprintf(text + used, room, "all points alike, since %s", why);
    if (at->freedom > 0) {
        char chance[32] = "below 0.001", wider[64] = "";
        if (at->chance >= 1e-3) {
            snprintf(chance, sizeof chance, "%.2g", at->chance);
        }
        if (at->stretch > 1.0) {
            snprintf(wider, sizeof wider, ", errors of the line times %.3g", at->stretch);
        }
        snprintf(text + used + more, room - (size_t)more,
                 "; chi-square %.3g, degrees of freedom %zu, p %s%s.", at->chi_square,
                 at->freedom, chance, wider);
    } else {
        snprintf(text + used + more, room - (size_t)more, ".");
    }
    return at->stretch > 0.0;
}

void clod_words_shares(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "with a critical outlet",
        [CLOD_HOPPER_NO_ARCH] = "without an arch",
        [CLOD_HOPPER_ARCHES] = "arching at any outlet",
        [CLOD_HOPPER_FUNNEL] = "in funnel flow",
        [CLOD_HOPPER_UNSETTLED] = "not settled",
        [CLOD_HOPPER_UNPROVEN] = "not known to be mass flow"};
    const char *untold = "";
    if (isnan(
            found->share
                [CLOD_HOPPER_FUNNEL])) { // which the wall decides, at a stress that the strength may
        untold =
            "nothing tells the errors of wall friction, of the limit that is given, or of the "
            "flow function";
    } else if (isnan(found->share[CLOD_HOPPER_FLOWS])) {
        untold = "nothing tells the errors of the flow function";
    }
    text[0] = '\0';
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        if (found->share[k] > 0.0) {
            const size_t used = strlen(text);
            snprintf(text + used, CLOD_WORDS_MOST - used, "%s%.1f %% %s", used > 0 ? ", " : "",
                     100.0 * found->share[k], WORDS[k]);
        }
    }
    if (untold[0] != '\0') {
        const size_t used = strlen(text);
        snprintf(
            text + used, CLOD_WORDS_MOST - used, "%s%s",
            used > 0 ? "; of the others it is not known whether they flow: " : "-: ", untold);
    }
}

bool clod_words_drawn(const clod_hopper *self, char text[CLOD_WORDS_MOST])
{
    const clod_joint_rows rows = clod_joint_count(&self->solid);
    const size_t all = rows.together + rows.apart;
    if (rows.apart == 0) {
        snprintf(text, CLOD_WORDS_MOST,
                 "Errors of one yield locus (sigma_1, f_c, phi_e, phi_t) are drawn together.");
    } else {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Errors of one yield locus (sigma_1, f_c, phi_e, phi_t) are drawn "
            "independently in %zu of %zu rows: the flow function has no correlations of them.",
            rows.apart, all);
    }
    return all > 0;
}

const char *const CLOD_WORDS_HOLES[CLOD_HOPPER_HOLES] = {
    [CLOD_HOPPER_EMPTYING] = "emptying", [CLOD_HOPPER_FILLING] = "after filling"};

/** The diameter with the smallest angle for which G is known: G, and the diameter, grow with it. */
static double bound_of(const clod_hopper *self, int hole)
{
    clod_curve_point least = {.x = 1.0, .y = CLOD_RATHOLE_LEAST};
    clod_solid other = self->solid;
    other.phi_t = (clod_curve){.way = CLOD_CURVE_HELD, .points = &least, .count = 1};
    const clod_rathole at = clod_rathole_of(&other, &self->silo);
    return hole == CLOD_HOPPER_EMPTYING ? at.emptying : at.filling;
}

bool clod_words_no_rathole(const clod_hopper *self, int hole, char text[CLOD_WORDS_MOST])
{
    const double phi_t = hole == CLOD_HOPPER_EMPTYING
                             ? self->hole.state.phi_t
                             : clod_curve_at(&self->solid.phi_t, self->hole.filling_stress);
    if (!isnan(self->rathole[hole].value)) {
        return false;
    }
    if (phi_t >= CLOD_RATHOLE_LEAST && phi_t <= CLOD_RATHOLE_MOST) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "No rathole diameter, %s: the measured properties change too much with stress.",
            CLOD_WORDS_HOLES[hole]);
    } else {
        snprintf(text, CLOD_WORDS_MOST,
                 "No rathole diameter, %s: Jenike's function G is known from 30 to 70 deg, and "
                 "the static angle of internal friction is %.1f deg.",
                 CLOD_WORDS_HOLES[hole], DEGREES * phi_t);
        const double bound = phi_t < CLOD_RATHOLE_LEAST ? bound_of(self, hole) : (double)NAN;
        if (isfinite(bound)) {
            const size_t used = strlen(text);
            snprintf(text + used, CLOD_WORDS_MOST - used,
                     " G grows with it, so the diameter is at most that of 30 deg, %.1f mm.",
                     1e3 * bound);
        }
    }
    return true;
}
