#include "hopper/storage.h"

#include <math.h>

#include "hopper/tables.h"

/** Rows of this table are drawn apart from those of the flow function. */
#define FIRST_ROW ((size_t)1 << 20)

/** Standard error of the point of a curve that is nearest to a stress. */
static double error_near(const clod_curve *curve, double stress)
{
    const clod_curve_point *nearest = &curve->points[0];
    for (size_t i = 1; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        nearest = fabs(point->x - stress) < fabs(nearest->x - stress) ? point : nearest;
    }
    return clod_curve_stated(nearest);
}

/** Strengths below those without storage, by more than their errors tell. */
static void warn_weaker(const clod_curve *stored, const clod_curve *at_once,
                        clod_warning_list *warnings)
{
    for (size_t i = 0; i < stored->count; i++) {
        const clod_curve_point *point = &stored->points[i];
        const double strength = clod_curve_at(at_once, point->x);
        const double error = hypot(clod_curve_stated(point), error_near(at_once, point->x));
        if (point->y + 2.0 * error < 0.99 * strength) {
            clod_warning_list_add(
                warnings,
                "After storage: f_c is %.6g kPa at sigma_1 %.6g kPa, where it is %.6g kPa without. No solid "
                "gets weaker by storage: are the tables interchanged? sigma_1 is that of the yield locus "
                "without storage.",
                1e-3 * point->y, 1e-3 * point->x, 1e-3 * strength);
        }
    }
}

static void move_rows(clod_curve *curve)
{
    for (size_t i = 0; i < curve->count; i++) {
        curve->points[i].row += FIRST_ROW;
    }
    clod_curve_sort(curve);
}

/** The points of a curve in place of those of another, which may own what still others share. */
static void replace(clod_curve *to, clod_curve *from)
{
    const clod_curve_way way = to->way;
    move_rows(from);
    clod_curve_fini(to);
    *to = *from;
    to->way = way;
    *from = (clod_curve){0};
}

bool clod_storage_read(const char *path, bool phi_t, clod_solid *solid,
                       clod_warning_list *warnings, clod_status *status)
{
    clod_solid stored = {0};
    const bool good = clod_tables_read_flow(path, &stored, status);
    if (good) {
        warn_weaker(&stored.strength, &solid->strength, warnings);
        if (solid->strength.spread != NULL) { // of specimens, whose other curves go on with it
            solid->rho.spread = solid->strength.spread;
            solid->strength.spread = NULL;
        }
        replace(&solid->strength, &stored.strength);
        if (phi_t && stored.phi_t.count > 0) {
            replace(&solid->phi_t, &stored.phi_t);
        } else if (stored.phi_t.count > 0) {
            clod_warning_list_add(warnings, "static_friction replaces the column phi_t of %s.",
                                  path);
        }
    }
    clod_tables_fini(&stored);
    return good;
}
