#include "hopper/tables_note.h"

#include <math.h>

#include "analysis/bulk_density.h"

void clod_tables_note_uniaxial(const char *path, const char *what, clod_tables_notes *notes)
{
    if (notes->uniaxial) {
        clod_warning_list_add(
            notes->warnings,
            "%s: %s has columns of a uniaxial test. Its strength is usually below that of a shear tester at "
            "the same sigma_1 (docs/theory/uniaxial.md), to a third in a pair there, so outlets may come out far too "
            "narrow. Design with yield loci of a shear tester.",
            what, path);
    }
}

/** A column that is empty at the smallest stress: the value of the next one stands in for it. */
static void warn_blank(const clod_solid *solid, const clod_curve *curve, const char *what,
                       double scale, const char *unit, clod_tables_notes *notes)
{
    const clod_curve_point *first = &solid->strength.points[0];
    const clod_curve_point *next = curve->points;
    for (size_t i = 1; i < solid->strength.count; i++) {
        const clod_curve_point *point = &solid->strength.points[i];
        first = point->x < first->x ? point : first;
    }
    for (size_t i = 1; i < curve->count; i++) {
        next = curve->points[i].x < next->x ? &curve->points[i] : next;
    }
    if (curve->count > 0 && next->x > first->x) {
        clod_warning_list_add(
            notes->warnings,
            "Flow function: %s is missing at the smallest sigma_1, %.6g kPa; at it, and below, that at the "
            "next, %.6g kPa, is used: %.6g %s. Fill the gap.",
            what, 1e-3 * first->x, 1e-3 * next->x, scale * next->y, unit);
    }
}

void clod_tables_note_blanks(const clod_hopper_case *from, const clod_solid *solid,
                             clod_tables_notes *notes)
{
    static const double DEGREES = 180.0 / M_PI;
    if (!from->phi_e.present) {
        warn_blank(solid, &solid->phi_e, "phi_e", DEGREES, "deg", notes);
    }
    if (!from->phi_t.present) {
        warn_blank(solid, &solid->phi_t, "phi_t", DEGREES, "deg", notes);
    }
    if (!from->rho.present) {
        warn_blank(solid, &solid->rho, "rho_b", 1.0, "kg/m3", notes);
    }
}

/** A section of the case in place of a column that the flow function brought. */
static void warn_replaced(const clod_hopper_case *from, const clod_hopper_property *by,
                          const clod_curve *column, const char *text, clod_tables_notes *notes)
{
    if (by->present && column->count > 0) {
        const char *file = from->strength.file;
        clod_warning_list_add(notes->warnings, "%s of %s.", text,
                              file != NULL ? file : "the shear tests");
    }
}

void clod_tables_note_replaced(const clod_hopper_case *from, const clod_solid *solid,
                               clod_tables_notes *notes)
{
    warn_replaced(from, &from->phi_e, &solid->phi_e,
                  "effective_friction replaces the column phi_e", notes);
    warn_replaced(from, &from->phi_t, &solid->phi_t,
                  "static_friction replaces the column phi_t", notes);
    warn_replaced(from, &from->rho, &solid->rho, "bulk_density replaces the column rho_b",
                  notes);
}

void clod_tables_note_light(const clod_hopper_case *from, const clod_solid *solid,
                            clod_tables_notes *notes)
{
    if (!from->rho.present && from->strength.test_count > 0) {
        return; // the evaluation of the tests has said it
    }
    double least = INFINITY;
    for (size_t i = 0; i < solid->rho.count; i++) {
        least = fmin(least, solid->rho.points[i].y);
    }
    char text[CLOD_LOCUS_WARNING_TEXT];
    if (clod_bulk_density_warn(least, text)) {
        clod_warning_list_add(notes->warnings, "Bulk density: %s", text);
    }
}
