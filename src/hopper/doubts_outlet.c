/**
 * @file doubts_outlet.c
 * Whether a hopper flows within the errors of what was measured, and through the outlet that is given.
 */

#include <math.h>
#include <stdio.h>

#include "hopper/doubts.h"
#include "hopper/fields.h"
#include "hopper/words.h"

#define DEGREE (M_PI / 180.0)
#define SHOWN 0.0005 // least share that is not printed as 0.0 %

/** "208.2 mm (161.8 to 246.2)"; an end may be infinite; "208.2 mm" without an interval. */
static void put_size(char text[96], const clod_hopper_value *size)
{
    char high[32] = "infinite";
    if (isnan(size->low)) {
        snprintf(text, 96, "%.1f mm", 1e3 * size->value);
        return;
    }
    if (isfinite(size->high)) {
        snprintf(high, sizeof high, "%.1f", 1e3 * size->high);
    }
    snprintf(text, 96, "%.1f mm (%.1f to %s)", 1e3 * size->value, 1e3 * size->low, high);
}

/**
 * Why samples do not flow through an outlet: ": the solid does not slide along the wall".
 *
 * @param told  whether the reason as measured is told, so that one reason alone is left out
 */
static void put_why(const clod_hopper_found *found, bool told, char text[128])
{
    const double arches = found->arching - found->held;
    text[0] = '\0';
    if (arches >= SHOWN && found->held >= SHOWN) {
        snprintf(text, 128,
                 ": an arch stands in %.1f %%, and in %.1f %% the solid does not slide along "
                 "the wall",
                 100.0 * arches, 100.0 * found->held);
    } else if (!told) {
        snprintf(text, 128, ": %s",
                 arches >= SHOWN ? "an arch stands"
                                 : "the solid does not slide along the wall");
    }
}

/** " 5.7 % of the samples do not flow", and why, as a sentence; "" if nothing tells the share. */
static void put_share(const clod_hopper_found *found, bool told, char text[192])
{
    char reason[128];
    text[0] = '\0';
    if (!isnan(found->arching)) {
        put_why(found, told, reason);
        snprintf(text, 192, " %.1f %% of the samples do not flow%s.", 100.0 * found->arching,
                 reason);
    }
}

/** An outlet that is given beside the critical one and its interval. */
static void warn_planned(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_value *critical = &found->number[CLOD_HOPPER_OUTLET];
    const double tail = 0.5 * (1.0 - self->from.interval.level);
    const double planned = found->planned;
    const bool below = planned < critical->value;
    char outlet[96], reason[128], share[192];
    put_size(outlet, critical);
    put_why(found, below, reason);
    put_share(found, below, share);
    const char *why =
        clod_ranges_hold(&found->lower, planned)
            ? "no arch stands over it, but one does above it, where the hopper is wider"
        : found->design.sticks ? "the solid does not slide along the wall"
                               : "it arches";
    if (isinf(critical->value)) {
        clod_warning_list_add(
            &self->warnings, "%s: the outlet of %.6g mm is not large enough, as none is: %s.%s",
            name, 1e3 * planned, why, share);
    } else if (below) {
        clod_warning_list_add(
            &self->warnings, "%s: the outlet of %.6g mm is below the critical one, %s: %s%s.%s",
            name, 1e3 * planned, outlet, planned < critical->low ? "" : "as measured ", why,
            share);
    } else if (planned < critical->high && found->arching >= SHOWN) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the outlet of %.6g mm is inside the interval of the critical "
            "one, %s.%s",
            name, 1e3 * planned, outlet, share);
    } else if (found->arching > tail) {
        clod_warning_list_add(&self->warnings,
                              "%s: %.1f %% of the samples do not flow through the outlet of "
                              "%.6g mm with the half angle of %.1f deg%s.",
                              name, 100.0 * found->arching, 1e3 * planned,
                              found->design.half_angle / DEGREE, reason);
    }
}

/** An outlet that is given beside the particles. */
static void warn_particles(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    if (found->planned < found->mechanical) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the outlet of %.6g mm is below %d times the largest particle, "
            "%.1f mm: particles may lock over it, whatever the strength is.",
            name, 1e3 * found->planned, found->wish.shape == CLOD_RADIAL_CONE ? 8 : 4,
            1e3 * found->mechanical);
    }
}

/** The first of its outlets that is wider than the silo above. */
static void warn_silo(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const double diameter = self->silo.diameter;
    const struct {
        const char *what;
        double outlet;
    } of[] = {{"the outlet that is given", found->planned},
              {"the critical outlet", found->number[CLOD_HOPPER_OUTLET].value},
              {"the outlet by particles", found->mechanical}};
    for (size_t k = 0; diameter > 0.0 && k < sizeof of / sizeof *of; k++) {
        if (isfinite(of[k].outlet) && of[k].outlet > diameter) {
            clod_warning_list_add(
                &self->warnings,
                "%s: %s, %.6g mm, is wider than the silo, %.6g mm (silo.diameter).", name,
                of[k].what, 1e3 * of[k].outlet, 1e3 * diameter);
            return;
        }
    }
}

/** What decides on an outlet in place of an arch. */
static void tell_funnel(char text[256], const clod_hopper *self, clod_radial_shape shape)
{
    char width[96];
    put_size(width, &self->slot_width);
    if (shape == CLOD_RADIAL_CONE) {
        snprintf(text, 256, "it is funnel flow, where a rathole decides in place of an arch");
    } else if (isinf(self->slot_width.value)) {
        snprintf(text, 256, "it is funnel flow, where a dome stands over a slot of any width");
    } else {
        snprintf(text, 256,
                 "it is funnel flow, where a slot must be wider than %s, and its diagonal "
                 "longer than the rathole's diameter",
                 width);
    }
}

/** Why an outlet that is given has no stress over strength. */
static void warn_no_margin(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    clod_hopper_wish built = found->wish;
    built.half_angle = found->design.half_angle;
    built.first = found->design.design_state.sigma_1;
    const clod_hopper_margin at = clod_hopper_margin_of(&self->solid, &built, found->planned);
    char why[256];
    if (found->design.outcome == CLOD_HOPPER_FUNNEL) {
        tell_funnel(why, self, found->wish.shape);
    } else if (at.sticks) {
        snprintf(
            why, sizeof why,
            "the solid would have to slide along a wall of %.1f deg where sigma_1 is %.3f kPa, "
            "and does not; so it does not flow",
            built.half_angle / DEGREE, 1e-3 * at.state.sigma_1);
    } else {
        snprintf(
            why, sizeof why,
            "no state of flow was found: the measured properties change too much with stress");
    }
    clod_warning_list_add(&self->warnings,
                          "%s: the outlet of %.6g mm has no stress over strength: %s.", name,
                          1e3 * found->planned, why);
}

/** Mass flow as measured, and not in too many samples. */
static void warn_samples(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const double *share = found->share;
    const double tail = 0.5 * (1.0 - self->from.interval.level);
    const double without = isnan(share[CLOD_HOPPER_FLOWS])
                               ? share[CLOD_HOPPER_FUNNEL] + share[CLOD_HOPPER_UNPROVEN]
                               : 1.0 - share[CLOD_HOPPER_FLOWS] - share[CLOD_HOPPER_NO_ARCH];
    if (clod_hopper_is_mass_flow(&found->design) && without > tail) {
        char told[CLOD_WORDS_MOST];
        clod_words_shares(found, told);
        clod_warning_list_add(
            &self->warnings,
            "%s: mass flow is what the means of the measured properties say; within their errors it "
            "is not certain. Samples: %s.",
            name, told);
    }
}

void clod_doubts_outlet(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    warn_silo(self, name, found);
    warn_samples(self, name, found);
    if (found->planned <= 0.0) {
        return;
    }
    if (found->design.outcome != CLOD_HOPPER_FUNNEL) {
        warn_planned(self, name, found);
    }
    warn_particles(self, name, found);
    if (isnan(found->number[CLOD_HOPPER_MARGIN].value)) {
        warn_no_margin(self, name, found);
    }
}
