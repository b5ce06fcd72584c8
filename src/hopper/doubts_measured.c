/**
 * @file doubts_measured.c
 * Whether each property that was measured, and strength beside friction, is one that a solid has.
 */

#include <math.h>
#include <stdio.h>

#include "hopper/doubts.h"
#include "hopper/repeats.h"

#define DEGREE (M_PI / 180.0)
#define LEAST_TEST                                                                             \
    100.0 // Pa: a tenth of the least preshear stress that ring shear testers are used at
#define MOST_TEST 1e6               // Pa: hoppers and silos have some 100 kPa at most
#define LEAST_PHI_W (3.0 * DEGREE)  // PTFE has some 6 deg
#define MOST_FFC 100.0              // the best powder testers tell an ffc of some 50
#define AT_TEXT 48                  ///< bytes of where a value is
#define LEAST_PHI_E (20.0 * DEGREE) // bulk solids have 25 to 70 deg
#define DENSER 1.03                 // away from the walls: more than a density is measured to
#define MOST_RHO 5030.0 // kg/m3: 0.64, random close packing, of spheres of steel, 7850
#define APART 10.0      // of stresses of two tables: another unit, as a rule
#define FIRM 2.0        // standard errors

/** Point of a curve that is nearest to a stress. */
static const clod_curve_point *nearest(const clod_curve *curve, double stress)
{
    const clod_curve_point *found = &curve->points[0];
    for (size_t i = 1; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        found = fabs(point->x - stress) < fabs(found->x - stress) ? point : found;
    }
    return found;
}

/** Stresses that no tester of bulk solids is used at. */
static void warn_unit(clod_hopper *self, const clod_curve *curve, const char *what,
                      const char *stress)
{
    const double low = curve->points[0].x, high = curve->points[curve->count - 1].x;
    if (curve->count > 1 && (high < LEAST_TEST || low > MOST_TEST)) {
        clod_warning_list_add(
            &self->warnings, "%s: all its %s are %s, %s. Is the unit of the table another one?",
            what, stress, high < LEAST_TEST ? "below 100 Pa" : "above 1 MPa",
            high < LEAST_TEST ? "less than testers can do" : "more than any hopper has");
    }
}

/** Whether a strength is above what consolidated the solid. */
static bool is_above_stress(const clod_curve_point *p)
{
    return p->y - FIRM * clod_curve_stated(p) > p->x;
}

/** Points of a flow function that no tester gives: wrong units or columns, as a rule. */
static void warn_strength(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.strength;
    const clod_hopper_strength *from = &self->from.strength;
    const char *unit = from->file != NULL || from->after_storage != NULL
                           ? " Is its unit another one, Pa under a header in kPa for instance?"
                           : ""; // it comes of points
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *p = &curve->points[i];
        const double ffc = p->x / (p->y + FIRM * clod_curve_stated(p));
        if (p->y > 0.0 && ffc > MOST_FFC) {
            clod_warning_list_add(
                &self->warnings,
                "Flow function: f_c is %.6g kPa at sigma_1 %.6g kPa, ffc %.0f. No tester tells "
                "so little strength.%s",
                1e-3 * p->y, 1e-3 * p->x, p->x / p->y, unit);
        }
        if (is_above_stress(p)) {
            clod_warning_list_add(
                &self->warnings,
                "Flow function: f_c is %.6g kPa at sigma_1 %.6g kPa. A solid stronger than what "
                "consolidated it was stored for long, or the columns are interchanged.",
                1e-3 * p->y, 1e-3 * p->x);
        }
    }
    warn_unit(self, curve, "Flow function", "sigma_1");
}

/**
 * The strength that a solid has at most: the circle of its strength ends at the origin, and touches the same line as that of steady
 * flow, which ends at sigma_2 = sigma_1 (1 - s)/(1 + s), s = sin(phi_e). With an angle of 0 or more it is not the larger one, so
 * f_c <= sigma_1 - sigma_2 = sigma_1 2 s/(1 + s).
 */
typedef struct bound {
    double value, error;
    double phi_e;
} bound;

static bound most_strength(const clod_solid *solid, const clod_curve_point *p)
{
    const double phi_e = clod_curve_at(&solid->phi_e, p->x);
    const double s = sin(phi_e);
    const double share = 2.0 * s / (1.0 + s);
    const double slope = p->x * 2.0 * cos(phi_e) / ((1.0 + s) * (1.0 + s)); // over phi_e
    return (bound){share * p->x,
                   hypot(share * p->x_error, slope * nearest(&solid->phi_e, p->x)->y_error),
                   phi_e};
}

/** The point that is farthest beyond what a straight yield locus allows beside phi_e. Strength after storage may be there,
 *  and one above sigma_1 has been told. */
static void warn_beside_friction(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.strength;
    const clod_curve_point *worst = NULL;
    double most = 1.0;
    for (size_t i = 0; i < curve->count && self->from.strength.after_storage == NULL; i++) {
        const clod_curve_point *p = &curve->points[i];
        const bound at = most_strength(&self->solid, p);
        const double allowed =
            fmax(FIRM * hypot(clod_curve_stated(p), at.error), CLOD_DOUBTS_APART * at.value);
        if (!is_above_stress(p) && p->y - at.value > allowed && p->y / at.value > most) {
            worst = p;
            most = p->y / at.value;
        }
    }
    if (worst != NULL) {
        const bound at = most_strength(&self->solid, worst);
        clod_warning_list_add(
            &self->warnings,
            "Flow function: f_c is %.6g kPa at sigma_1 %.6g kPa, where phi_e is %.4g deg: no straight yield "
            "locus has more than sigma_1 2 sin(phi_e)/(1 + sin(phi_e)), %.4g kPa. One of the three is wrong, "
            "or in another unit, or of a solid that was stored (after_storage).",
            1e-3 * worst->y, 1e-3 * worst->x, at.phi_e / DEGREE, 1e-3 * at.value);
    }
}

/** " at sigma_1 2 kPa"; "" of a single value, which is that of any stress. */
static void put_at(const clod_curve *self, const clod_curve_point *point, char text[AT_TEXT])
{
    text[0] = '\0';
    if (self->count > 1) {
        snprintf(text, AT_TEXT, " at sigma_1 %.6g kPa", 1e-3 * point->x);
    }
}

/** The smallest effective angle, where no bulk solid has so small a one. */
static void warn_friction(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.phi_e;
    const clod_curve_point *least = &curve->points[0];
    for (size_t i = 1; i < curve->count; i++) {
        least = curve->points[i].y < least->y ? &curve->points[i] : least;
    }
    if (least->y < LEAST_PHI_E) {
        char at[AT_TEXT];
        put_at(curve, least, at);
        clod_warning_list_add(
            &self->warnings,
            "Effective friction: phi_e is %.4g deg%s. Bulk solids have 25 to 70 deg. Is its unit another one, "
            "rad under a header in deg for instance, or is it the angle of something else?",
            least->y / DEGREE, at);
    }
}

/** Stresses and angles that no wall has. */
static void warn_wall(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.wall;
    const clod_curve *strength = &self->solid.strength;
    warn_unit(self, curve, "Wall friction", "sigma_w");
    double least = (double)INFINITY;
    for (size_t i = 0; i < curve->count; i++) {
        least = fmin(least, atan2(curve->points[i].y, curve->points[i].x));
    }
    if (least < LEAST_PHI_W) {
        clod_warning_list_add(
            &self->warnings,
            "Wall friction: the angle is %.4g deg. The smoothest liners have some 6 deg. Is its unit another "
            "one, rad under a header in deg for instance?",
            least / DEGREE);
    }
    const double low = curve->points[0].x, high = curve->points[curve->count - 1].x;
    const double from = strength->points[0].x, to = strength->points[strength->count - 1].x;
    if (curve->count > 1 && (APART * high < from || low > APART * to)) {
        clod_warning_list_add(
            &self->warnings,
            "Wall friction: sigma_w of %.4g to %.4g kPa lie far from sigma_1 of the flow function, %.4g to "
            "%.4g kPa. Is the unit of one of the tables another one?",
            1e-3 * low, 1e-3 * high, 1e-3 * from, 1e-3 * to);
    }
}

/** What is said of a property that falls. */
typedef struct falling {
    const char *what, *name, *unit;
    double scale;
    const char *weaker;
} falling;

/** Stresses from which a property that consolidation raises falls to the next, by more than its errors. */
static void warn_falls(clod_hopper *self, const clod_curve *curve, const falling *of)
{
    size_t next = clod_repeats_end(curve, 0);
    clod_curve_point p = clod_repeats_mean(curve, 0, next), q;
    for (size_t first = next; first < curve->count; first = next, p = q) {
        next = clod_repeats_end(curve, first);
        q = clod_repeats_mean(curve, first, next);
        const double error = hypot(p.y_error, q.y_error);
        if (p.y - q.y > fmax(FIRM * error, CLOD_DOUBTS_APART * p.y)) {
            clod_warning_list_add(
                &self->warnings,
                "%s: %s falls from %.6g %s at sigma_1 %.6g kPa to %.6g %s at %.6g kPa, by more than its errors "
                "tell. No solid gets %s by consolidation: are columns or rows interchanged?",
                of->what, of->name, of->scale * p.y, of->unit, 1e-3 * p.x, of->scale * q.y,
                of->unit, 1e-3 * q.x, of->weaker);
        }
    }
}

/** A cell of a few grains is looser than the same solid in a hopper: the loosest of them. */
static void warn_narrow_cells(clod_hopper *self)
{
    const clod_curve_point *worst = NULL;
    for (size_t i = 0; i < self->solid.rho.count; i++) {
        const clod_curve_point *p = &self->solid.rho.points[i];
        if (p->inside > DENSER * p->y &&
            (worst == NULL || p->inside * worst->y > worst->inside * p->y)) {
            worst = p;
        }
    }
    if (worst != NULL) {
        clod_warning_list_add(
            &self->warnings,
            "Bulk density: away from the walls of the cell it was %.0f kg/m3 at sigma_1 %.3f kPa, "
            "%.0f %% above rho_b, %.0f kg/m3, which is used here. Hoppers are wide, so their outlets "
            "come out too wide; give the key bulk_density.",
            worst->inside, 1e-3 * worst->x, 100.0 * (worst->inside / worst->y - 1.0), worst->y);
    }
}

/** The largest bulk density, where hardly any bulk solid has so large a one. */
static void warn_dense(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.rho;
    const clod_curve_point *most = &curve->points[0];
    for (size_t i = 1; i < curve->count; i++) {
        most = curve->points[i].y > most->y ? &curve->points[i] : most;
    }
    if (most->y > MOST_RHO) {
        char at[AT_TEXT];
        put_at(curve, most, at);
        clod_warning_list_add(
            &self->warnings,
            "Bulk density: rho_b is %.6g kg/m3%s. Spheres of steel have 5000 when they are packed at random as "
            "densely as they can be, ores and iron powders less. Is its unit another one?",
            most->y, at);
    }
}

void clod_doubts_measured(clod_hopper *self)
{
    static const falling STRENGTH = {"Flow function", "f_c", "kPa", 1e-3, "weaker"};
    static const falling DENSITY = {"Bulk density", "rho_b", "kg/m3", 1.0, "looser"};
    warn_strength(self);
    warn_beside_friction(self);
    warn_falls(self, &self->solid.strength, &STRENGTH);
    warn_friction(self);
    warn_wall(self);
    warn_falls(self, &self->solid.rho, &DENSITY);
    warn_dense(self);
    warn_narrow_cells(self);
}
