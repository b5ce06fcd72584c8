#include "hopper/doubts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "clod/locus.h"
#include "hopper/fields.h"
#include "hopper/told.h"
#include "hopper/words.h"

#define DEGREE (M_PI / 180.0)
#define READING (1.0 * DEGREE) // how well charts are read
#define FEW 3 // degrees of freedom below which the scatter of specimens is hardly known

/** An error as large as its value: another unit or column, as a rule. */
static void warn_large_error(clod_hopper *self, const clod_curve *curve, const char *what,
                             const char *unit, double scale)
{
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *p = &curve->points[i];
        if (p->y > 0.0 && p->y_error >= p->y && p->by_line == 0.0) {
            char at[40] = ""; // a single value is that of any stress
            if (curve->count > 1) {
                snprintf(at, sizeof at, " at %.6g kPa", 1e-3 * p->x);
            }
            clod_warning_list_add(
                &self->warnings,
                "%s is %.6g %s with a standard error of %.6g %s%s: nothing was measured then. "
                "Is the unit of one of them another one?",
                what, scale * p->y, unit, scale * p->y_error, unit, at);
            return;
        }
    }
}

static void warn_large_errors(clod_hopper *self)
{
    const clod_solid *solid = &self->solid;
    const clod_hopper_property *wall = &self->from.wall;
    warn_large_error(self, &solid->strength, "Flow function: f_c", "kPa", 1e-3);
    warn_large_error(self, &solid->phi_e, "Effective friction: phi_e", "deg", 1.0 / DEGREE);
    warn_large_error(self, &solid->phi_t, "Static friction: phi_t", "deg", 1.0 / DEGREE);
    warn_large_error(self, &solid->rho, "Bulk density: rho_b", "kg/m3", 1.0);
    if (wall->has_value) { // an angle, which the curve has as a line
        clod_curve_point angle = {.y = wall->value, .y_error = wall->error};
        const clod_curve one = {.points = &angle, .count = 1};
        warn_large_error(self, &one, "Wall friction: the angle", "deg", 1.0 / DEGREE);
    } else {
        warn_large_error(self, &solid->wall, "Wall friction: tau_w", "kPa", 1e-3);
    }
}

/** Whether the limit is that of the smallest outlet at which the solid slides: the half angle itself. */
static bool is_edge(const clod_hopper_design *at)
{
    return at->sticks && at->built == at->outlet;
}

/** A limit from a chart for wedges that lies below the limit of a cone. */
static void warn_limit(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_wish *wish = &found->wish;
    const double cone =
        wish->limit > 0.0 && found->design.design_state.sigma_1 > 0.0
            ? clod_hopper_limit_at(&self->solid, found->design.design_state.sigma_1,
                                   CLOD_RADIAL_TOLERANCE)
            : 0.0;
    if (wish->limit + 2.0 * found->limit_error < cone - READING) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the limit that is given, %.1f deg, is below that of a cone, %.1f deg, where sigma_1 is %.3f "
            "kPa. Charts for wedges allow more than for cones: was it read at another phi_e or wall friction "
            "angle, or is it a half angle from which the margin is taken off already?",
            name, wish->limit / DEGREE, cone / DEGREE,
            1e-3 * found->design.design_state.sigma_1);
    }
}

/** A half angle that was given, close to the limit of mass flow or beyond it. */
static void warn_angle(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    const double most = at->limit - found->wish.margin;
    if (at->outcome == CLOD_HOPPER_UNPROVEN) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the half angle of %.1f deg is %.1f deg flatter than the limit of mass flow in a "
            "cone, %.1f deg. A wedge may be some degrees flatter than a cone; how many is not "
            "known here (docs/theory/hopper.md). Take the angle from a chart for wedges, or "
            "half_angle: auto.",
            name, at->half_angle / DEGREE, (at->half_angle - at->limit) / DEGREE,
            at->limit / DEGREE);
    } else if (found->wish.half_angle > 0.0 && at->outcome != CLOD_HOPPER_FUNNEL &&
               !is_edge(at) && at->half_angle > most) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the half angle of %.1f deg is steeper than the limit of mass flow %s, "
            "%.1f deg, by less than the margin of %.1f deg.%s",
            name, at->half_angle / DEGREE,
            found->wish.limit > 0.0 ? "that is given" : "in a cone", at->limit / DEGREE,
            found->wish.margin / DEGREE,
            found->wish.shape == CLOD_RADIAL_WEDGE && found->wish.limit == 0.0
                ? " A wedge may be flatter, see docs/theory/hopper.md."
                : "");
    }
}

static void warn_shape(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    if (at->outcome == CLOD_HOPPER_UNSETTLED) {
        clod_warning_list_add(
            &self->warnings,
            "%s: no critical state was found: the measured properties change too much with "
            "stress.",
            name);
    }
    clod_doubts_wall(self, name, found);
    clod_doubts_no_arch(self, name, found);
    clod_doubts_ranges(self, name, found);
    clod_doubts_beyond(self, name, found);
    warn_angle(self, name, found);
    warn_limit(self, name, found);
    clod_doubts_outlet(self, name, found);
}

static bool has_errors(const clod_curve *curve)
{
    bool any = curve->count == 0;
    for (size_t i = 0; i < curve->count; i++) {
        any = any || curve->points[i].x_error > 0.0 || curve->points[i].y_error > 0.0;
    }
    return any;
}

/** Hoppers of a given half angle of which nobody knows how sure they are: "cone", "cone and wedge". */
static size_t list_unsure(const clod_hopper *self, char text[32])
{
    size_t count = 0;
    text[0] = '\0';
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        if (!clod_told_is_sure(self, &self->shape[s])) {
            const size_t used = strlen(text);
            snprintf(text + used, 32 - used, "%s%s", used > 0 ? " and " : "",
                     CLOD_HOPPER_SHAPE_NAMES[s]);
            count++;
        }
    }
    return count;
}

/** Whether three points or more, at several stresses, tell no error: they lie on their line to the last digit. */
static bool is_exact_line(const clod_curve *curve)
{
    return curve->count > 2 && curve->points[curve->count - 1].x > curve->points[0].x;
}

#define EXACT_LINE                                                                             \
    "Its points lie on a line to the last digit, as fitted, not as measured: give what was measured"

/** Limits of mass flow whose interval nobody knows, since the wall has no errors. */
static void warn_no_interval(clod_hopper *self)
{
    static const char *const ANGLES[CLOD_HOPPER_SHAPES + 1] = {
        "it and the half angle have no interval, and other intervals leave that out",
        "it and the half angle that is not given have no interval, and other intervals leave that out",
        "it has no interval"};
    const clod_curve *wall = &self->solid.wall;
    char unsure[32], given[224] = "";
    const size_t count = list_unsure(self, unsure);
    if (count > 0) {
        snprintf(
            given, sizeof given,
            " The half angle of the %s is given, and is mass flow only below that limit: its outlet has no interval, "
            "and shares of its samples are not known.",
            unsure);
    }
    if (clod_curve_has_errors(wall)) {
        if (count > 0) {
            clod_warning_list_add(&self->warnings,
                                  "The limit that is given has no limit_error.%s", given);
        }
        return;
    }
    clod_warning_list_add(
        &self->warnings,
        "How far the limit of mass flow may be off is not known, since wall friction has no errors, or not at all "
        "points: %s.%s %s.",
        ANGLES[count], given,
        self->from.wall.file == NULL ? "Give the key error of wall_friction"
        : is_exact_line(wall)
            ? EXACT_LINE ", or tau_w_error"
            : "Give tau_w_error, or points at three normal stresses or more: their scatter about "
              "a line tells it");
}

/** Errors that are the scatter of the points. @param more  what makes which interval narrower */
static void warn_by_line(clod_hopper *self, const clod_curve *curve, const char *what,
                         const char *more)
{
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *p = &curve->points[i];
        if (p->by_line > 0.0) {
            clod_warning_list_add(
                &self->warnings,
                "%s: points without an error, or with a smaller one, get what the %zu points scatter by about their line, "
                "%.3g kPa, drawn from Student's t of %zu degree%s of freedom: so few tell it roughly. More points, "
                "or %s narrower.",
                what, p->freedom + 2, 1e-3 * p->by_line, p->freedom, p->freedom == 1 ? "" : "s",
                more);
            return;
        }
    }
}

/** What would tell the errors of the flow function. */
static const char *strength_advice(const clod_hopper *self)
{
    const bool table = self->from.strength.file != NULL;
    if (is_exact_line(&self->solid.strength)) {
        return table ? EXACT_LINE ", or f_c_error" : EXACT_LINE;
    }
    return table
               ? "Give f_c_error, or strengths at three consolidation stresses or more, or repeats: "
                 "their scatter about a line tells it"
               : "Give three shear points or more to each yield locus, or yield loci at three "
                 "consolidation stresses or more: their scatter about a line tells it";
}

/** Outlets whose interval nobody knows, since the flow function has no errors. */
static void warn_no_outlet(clod_hopper *self)
{
    if (!clod_told_strength(self)) {
        clod_warning_list_add(
            &self->warnings,
            "How much wider than the critical outlet, or the rathole, to build is not known, since the flow function "
            "has no errors, or not at all points: critical outlet, rathole and stress over strength have no "
            "interval, shares of the samples, but for that of funnel flow where the wall decides it, are not known, and other intervals leave that "
            "out. %s.",
            strength_advice(self));
    }
}

/** Properties that were given without errors, and so do not widen the intervals. */
static void warn_errors(clod_hopper *self, bool preshear_untold)
{
    static const char *const NAMES[CLOD_SOLID_CURVES] = {"flow function", "effective friction",
                                                         "static friction", "bulk density",
                                                         "wall friction"};
    char list[240] = "";
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const clod_curve *curve = &self->solid.curves[k];
        const bool decides = k == CLOD_SOLID_STRENGTH || k == CLOD_SOLID_WALL;
        if (decides ? !clod_curve_has_errors(curve) : !has_errors(curve)) {
            const size_t used = strlen(list);
            snprintf(list + used, sizeof list - used, "%s%s", used > 0 ? ", " : "", NAMES[k]);
        }
    }
    if (preshear_untold) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used,
                 "%sshear stress of preshear (tau_pre_error) in sigma_1 and phi_e",
                 used > 0 ? ", " : "");
    }
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        if (self->shape[s].wish.limit > 0.0 && self->shape[s].limit_error == 0.0) {
            const size_t used = strlen(list);
            snprintf(list + used, sizeof list - used, "%slimit of the %s", used > 0 ? ", " : "",
                     CLOD_HOPPER_SHAPE_NAMES[s]);
        }
    }
    if (list[0] != '\0') {
        clod_warning_list_add(&self->warnings,
                              "Without errors, and so not part of the intervals: %s.", list);
    }
}

/** A rathole whose phi_t is where Jenike's function is not known, as measured or in samples. */
static void warn_hole(clod_hopper *self, int hole)
{
    const double share = 1.0 - self->holed[hole];
    char text[CLOD_WORDS_MOST];
    if (clod_words_no_rathole(self, hole, text)) {
        clod_warning_list_add(&self->warnings, "%s", text);
    } else if (share > 0.0) {
        clod_warning_list_add(
            &self->warnings,
            "Rathole, %s: in %.1f %% of the samples the static angle of internal friction is "
            "outside 30 to 70 deg, where Jenike's function G is known; the interval is that of "
            "the others.",
            CLOD_WORDS_HOLES[hole], 100.0 * share);
    }
}

static void warn_rathole(clod_hopper *self)
{
    if (self->solid.phi_t.count == 0) {
        clod_warning_list_add(
            &self->warnings,
            "No rathole diameter: the key static_friction, or a column phi_t of the flow "
            "function, is missing.");
    } else {
        warn_hole(self, CLOD_HOPPER_EMPTYING);
        if (self->silo.diameter > 0.0) {
            warn_hole(self, CLOD_HOPPER_FILLING);
        }
    }
    clod_doubts_beyond_holes(self);
    clod_doubts_holes(self);
    if (self->hole.filling > self->silo.diameter && self->silo.diameter > 0.0) {
        clod_warning_list_add(
            &self->warnings,
            "The rathole after filling is wider than the silo: a solid that does not slide "
            "along the wall may stay at all of it.");
    }
}

/** Few specimens or repeats, whose scatter is hardly known, where it is that of intervals. */
static void warn_few(clod_hopper *self, const char *loci, const char *table,
                     const clod_curve *curve)
{
    size_t least = 0;
    bool repeats = false;
    for (size_t i = 0; i < curve->count && clod_curve_has_errors(curve); i++) {
        const clod_curve_point *point = &curve->points[i];
        const size_t freedom = point->by_line > 0.0 ? 0 : point->freedom;
        if (freedom > 0 && (least == 0 || freedom < least)) {
            least = freedom;
            repeats = curve->specimens == 0 && !point->unsure;
        }
    }
    const char *what = repeats ? "repeats" : "specimens";
    if (least > 0 && least < FEW) {
        clod_warning_list_add(
            &self->warnings,
            "%s: the intervals rest on the scatter of %zu %s, which tells little of how %s differ: "
            "they are drawn from Student's t of %zu degree%s of freedom. More %s make them narrower.",
            repeats ? table : loci, least + 1, what, what, least, least == 1 ? "" : "s", what);
    }
}

void clod_doubts_warn(clod_hopper *self, const clod_tables_notes *notes)
{
    clod_doubts_measured(self);
    warn_large_errors(self);
    clod_doubts_line(self);
    warn_shape(self, "Cone", &self->shape[CLOD_RADIAL_CONE]);
    warn_shape(self, "Wedge", &self->shape[CLOD_RADIAL_WEDGE]);
    clod_doubts_looser(self);
    warn_rathole(self);
    warn_errors(self, notes->preshear_untold);
    warn_few(self, "Yield loci",
             self->from.strength.after_storage != NULL ? "Flow function after storage"
                                                       : "Flow function",
             &self->solid.strength);
    warn_few(self, "Wall yield locus", "Wall yield locus", &self->solid.wall);
    warn_by_line(
        self, &self->solid.strength, "Flow function",
        self->from.strength.file != NULL
            ? "f_c_error, make the interval of the outlet"
            : "more shear points to each yield locus, make the interval of the outlet");
    warn_by_line(self, &self->solid.wall, "Wall yield locus",
                 "tau_w_error, make the interval of the half angle");
    warn_no_outlet(self);
    warn_no_interval(self);
    if (notes->specimen != NULL) {
        clod_warning_list_add(&self->warnings, "Yield loci: errors of %s.", notes->specimen);
    }
}
