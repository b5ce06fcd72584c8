/**
 * @file doubts_check.c
 * What cannot have been measured is refused.
 */

#include <math.h>

#include "hopper/doubts.h"

#define DEGREE (M_PI / 180.0)
#define LEAST_PHI_W (1.0 * DEGREE) // docs/theory/hopper.md
#define FIRM 2.0                   // standard errors
#define FALLS 0.1                  // of a shear stress: repeats without errors may differ by it

/** A property that has to come from somewhere. */
static bool is_known(const char *path, const clod_curve *curve, const char *key,
                     const char *column, clod_status *status)
{
    return curve->count > 0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: %s is not known: neither the key %s nor the flow function, in a "
               "column %s, gives it.",
               path, column, key, column);
}

bool clod_doubts_are_apart(const clod_curve_point *p, const clod_curve_point *q)
{
    return q->x - p->x > fmax(CLOD_DOUBTS_APART * q->x, 2.0 * (p->x_error + q->x_error));
}

/** Points through which a curve is drawn from one to the next need stresses of their own. */
static bool are_apart(const char *path, const clod_curve *curve, const char *key,
                      const char *what, clod_status *status)
{
    for (size_t i = 1; i < curve->count; i++) {
        const clod_curve_point *p = &curve->points[i - 1];
        const clod_curve_point *q = &curve->points[i];
        if (!clod_doubts_are_apart(p, q)) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s: %s: two points at nearly the same stress, %.6g and %.6g kPa%s. %s", path,
                key, 1e-3 * p->x, 1e-3 * q->x,
                p->x_error + q->x_error > 0.0 ? ", within twice their errors" : "", what);
        }
    }
    return true;
}

static bool check_strength(const char *path, const clod_curve *curve, clod_status *status)
{
    const double span = curve->points[curve->count - 1].x - curve->points[0].x;
    if (curve->count < 2 || span <= CLOD_DOUBTS_APART * curve->points[0].x) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: flow_function: %zu point%s at one stress make no flow "
                                "function; measure at two consolidation stresses at least.",
                                path, curve->count, curve->count == 1 ? "" : "s");
    }
    return curve->way == CLOD_CURVE_LINE ||
           are_apart(path, curve, "flow_function", "Average them, or use curve: line.", status);
}

/** No yield locus of a solid with strength is steeper than its effective one. */
static bool check_angles(const char *path, const clod_solid *solid, clod_status *status)
{
    for (size_t i = 0; i < solid->phi_t.count; i++) {
        const clod_curve_point *t = &solid->phi_t.points[i];
        const double phi_e = clod_curve_at(&solid->phi_e, t->x);
        if (t->y > phi_e + 2.0 * t->y_error + DEGREE) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s: at a stress of %.6g kPa the static angle of internal friction, %.2f deg, is "
                "above the effective one, %.2f deg; that cannot be. Are they interchanged?",
                path, 1e-3 * t->x, t->y / DEGREE, phi_e / DEGREE);
        }
    }
    return true;
}

/** How far specimens of a wall lie apart at those stresses that several have: the largest standard deviation of
 *  one, of its shear stress; 0: not known. */
static double scatter_of(const clod_curve *wall)
{
    double most = 0.0;
    for (size_t i = 0; i < wall->count; i++) {
        const clod_curve_point *p = &wall->points[i];
        double count = 0.0;
        for (size_t k = 0; k < wall->specimens && p->spread != NULL; k++) {
            count += isnan(p->spread[k]) ? 0.0 : 1.0;
        }
        most = fmax(most, count > 0.0 ? sqrt(count) * p->y_error / p->y : 0.0);
    }
    return most;
}

/** The error of a point of a wall, that of one specimen alone included; not what it scatters by itself. */
static double error_of(const clod_curve_point *p, double scatter)
{
    const double stated = clod_curve_stated(p);
    return p->spread != NULL ? stated : fmax(stated, scatter * p->y);
}

/** Shear stresses at a wall do not fall while the normal stress rises: columns, rows or units are wrong. */
static bool check_rise(const clod_hopper_case *from, const clod_curve *wall,
                       clod_status *status)
{
    const double scatter = scatter_of(wall);
    for (size_t i = 1; i < wall->count; i++) {
        const clod_curve_point *q = &wall->points[i];
        for (size_t k = 0; k < i && wall->points[k].x * CLOD_DOUBTS_SLOPE <= q->x; k++) {
            const clod_curve_point *p = &wall->points[k];
            const double error = hypot(error_of(p, scatter), error_of(q, scatter));
            if (p->y - q->y > fmax(FIRM * error, FALLS * p->y)) {
                return clod_status_fail(
                    status, CLOD_USAGE,
                    "%s: the wall yield locus falls: tau_w is %.6g kPa at sigma_w %.6g kPa, and %.6g kPa at "
                    "%.6g kPa. No wall bears less shear stress under more load. Look at the points: their "
                    "columns, their units, whether shear was steady.",
                    from->wall.file, 1e-3 * p->y, 1e-3 * p->x, 1e-3 * q->y, 1e-3 * q->x);
            }
        }
    }
    return true;
}

/** A wall so smooth that its angle is another unit, as a rule: the hopper would be far too flat. */
static bool check_smooth(const clod_hopper_case *from, const char *path, const clod_curve *wall,
                         clod_status *status)
{
    double most = 0.0;
    for (size_t i = 0; i < wall->count; i++) {
        most = fmax(most, atan2(wall->points[i].y, wall->points[i].x));
    }
    return most >= LEAST_PHI_W ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: the wall friction angle is %.3g deg%s. No wall is as smooth: even ice has more "
               "than 1 deg. Is its unit another one, rad in place of deg for instance?",
               from->wall.file != NULL ? from->wall.file : path, most / DEGREE,
               wall->count > 1 ? " at most" : "");
}

bool clod_doubts_check(const clod_hopper_case *from, const char *path, const clod_solid *solid,
                       clod_status *status)
{
    const char *average = "Average them.";
    return is_known(path, &solid->phi_e, "effective_friction", "phi_e", status) &&
           is_known(path, &solid->rho, "bulk_density", "rho_b", status) &&
           check_strength(path, &solid->strength, status) &&
           are_apart(path, &solid->wall, "wall_friction", average, status) &&
           check_rise(from, &solid->wall, status) &&
           check_smooth(from, path, &solid->wall, status) &&
           (!from->phi_e.present ||
            are_apart(path, &solid->phi_e, "effective_friction", average, status)) &&
           (!from->rho.present ||
            are_apart(path, &solid->rho, "bulk_density", average, status)) &&
           check_angles(path, solid, status);
}
