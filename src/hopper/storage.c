#include "hopper/storage.h"

#include <math.h>

#include "hopper/repeats.h"
#include "hopper/tables_note.h"

/** Rows of this table are drawn apart from those of the flow function. */
#define FIRST_ROW ((size_t)1 << 20)

static const char STORED[] = "Flow function after storage";

/** Standard error of the mean of the repeats that are nearest to a stress. */
static double error_near(const clod_curve *curve, double stress)
{
    double nearest = (double)INFINITY, error = 0.0;
    for (size_t first = 0, end; first < curve->count; first = end) {
        end = clod_repeats_end(curve, first);
        const clod_curve_point mean = clod_repeats_mean(curve, first, end);
        if (fabs(mean.x - stress) < nearest) {
            nearest = fabs(mean.x - stress);
            error = mean.y_error;
        }
    }
    return error;
}

/** Strengths, the means of repeats, below those without storage, by more than their errors tell. */
static void warn_weaker(const clod_curve *stored, const clod_curve *at_once,
                        clod_warning_list *warnings)
{
    for (size_t first = 0, end; first < stored->count; first = end) {
        end = clod_repeats_end(stored, first);
        const clod_curve_point mean = clod_repeats_mean(stored, first, end);
        const double strength = clod_curve_at(at_once, mean.x);
        const double error = hypot(mean.y_error, error_near(at_once, mean.x));
        if (mean.y + 2.0 * error < 0.99 * strength) {
            clod_warning_list_add(
                warnings,
                "After storage: f_c is %.6g kPa at sigma_1 %.6g kPa, where it is %.6g kPa without. No solid "
                "gets weaker by storage: are the tables interchanged? sigma_1 is that of the yield locus "
                "without storage.",
                1e-3 * mean.y, 1e-3 * mean.x, 1e-3 * strength);
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
                       clod_tables_notes *notes, clod_status *status)
{
    clod_solid stored = {0};
    bool good = clod_tables_read_flow(path, &stored, notes, status);
    if (good) {
        stored.strength.way = solid->strength.way;
        clod_curve_sort(&stored.strength);
        clod_tables_note_uniaxial(path, STORED, notes);
        good = clod_tables_take_scatter(&stored.strength, STORED, notes, status);
    }
    if (good) {
        warn_weaker(&stored.strength, &solid->strength, notes->warnings);
        if (solid->strength.spread != NULL) { // of specimens, whose other curves go on with it
            solid->rho.spread = solid->strength.spread;
            solid->strength.spread = NULL;
        }
        replace(&solid->strength, &stored.strength);
        if (phi_t && stored.phi_t.count > 0) {
            replace(&solid->phi_t, &stored.phi_t);
        } else if (stored.phi_t.count > 0) {
            clod_warning_list_add(notes->warnings,
                                  "static_friction replaces the column phi_t of %s.", path);
        }
    }
    clod_tables_fini(&stored);
    return good;
}
