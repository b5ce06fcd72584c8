#include "analysis/warnings_points.h"

#include <math.h>

#include "analysis/bulk_density.h"
#include "analysis/warnings.h"

#define KILO 1000.0
#define DEGREES (180.0 / 3.14159265358979323846)
#define LEAST_TEST 100.0 // Pa: a tenth of the least preshear stress of ring shear testers
#define MOST_TEST 1e6    // Pa: hoppers and silos have some 100 kPa at most
// of the smaller one, docs/theory/yield-locus.md
#define DENSITY_ROWS 0.05
#define DENSITY_SEEDS 0.1

/** Preshear as it is in no solid: columns exchanged, or another unit. */
static void check_preshear(clod_locus *locus)
{
    if (!clod_warnings_is_usual(locus->phi_sf.value)) {
        clod_warnings_add(
            locus,
            "Preshear at %.3f kPa with a shear stress of %.3f kPa: phi_sf = %.2f "
            "deg is outside %.0f to %.0f deg; check columns and units of preshear.",
            locus->sigma_p.value / KILO, locus->tau_p.value / KILO,
            locus->phi_sf.value * DEGREES, CLOD_WARNINGS_PHI_LOW, CLOD_WARNINGS_PHI_HIGH);
    }
    if (locus->sigma_p.value < LEAST_TEST || locus->sigma_p.value > MOST_TEST) {
        clod_warnings_add(locus,
                          "The preshear stress is %.6g kPa, %s. Is its unit another one?",
                          locus->sigma_p.value / KILO,
                          locus->sigma_p.value < LEAST_TEST ? "less than testers can do"
                                                            : "more than any hopper has");
    }
}

/** Points that no table had: its reader refuses such densities. */
static void check_density_units(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const double first = points[i].rho_b, inside = points[i].rho_inside;
        const bool wrong = first > 0.0 && !clod_bulk_density_is_usual(first);
        const double density = wrong ? first : inside;
        if (density > 0.0 && !clod_bulk_density_is_usual(density)) {
            clod_warnings_add(locus,
                              "A bulk density of %.4g kg/m3 is outside %.0f to %.0f kg/m3, "
                              "between aerogel and heavy metal; check its unit (1 g/cm3 is "
                              "1000 kg/m3).",
                              density, CLOD_BULK_DENSITY_LEAST, CLOD_BULK_DENSITY_MOST);
            return;
        }
    }
}

static void check_densities(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    double low = INFINITY;
    double high = 0.0;
    for (size_t i = 0; i < count; i++) {
        low = points[i].rho_b > 0.0 ? fmin(low, points[i].rho_b) : low;
        high = fmax(high, points[i].rho_b);
    }
    if (high > (1.0 + DENSITY_ROWS) * low) {
        clod_warnings_add(
            locus,
            "Bulk densities from %.6g to %.6g kg/m3 are of one preshear stress, "
            "which hardly gives densities more than %.0f %% apart: is one of them "
            "a slip? rho_b is their mean.",
            low, high, 100.0 * DENSITY_ROWS);
    }
}

void clod_warnings_points_check_seeds(clod_locus *locus, const clod_locus *loci, size_t count)
{
    double low = INFINITY;
    double high = 0.0;
    for (size_t i = 0; i < count; i++) { // NAN: a seed without density
        low = fmin(low, loci[i].rho_b.value);
        high = fmax(high, loci[i].rho_b.value);
    }
    if (high > (1.0 + DENSITY_SEEDS) * low) {
        clod_warnings_add(locus,
                          "Bulk densities of the seeds are from %.6g to %.6g kg/m3, more than "
                          "%.0f %% apart: are they of one solid? rho_b is their mean.",
                          low, high, 100.0 * DENSITY_SEEDS);
    }
}

/** A stated error as large as its value: most likely the wrong column or unit. */
static void check_stated(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        const struct {
            const char *name, *unit;
            double value, error, scale;
        } STATED[] = {{"tau_pre", "kPa", p->tau_p, p->tau_p_error, KILO},
                      {"tau_sh", "kPa", p->tau_s, p->tau_s_error, KILO},
                      {"rho_b", "kg/m3", p->rho_b, p->rho_b_error, 1.0}};
        for (size_t k = 0; k < sizeof STATED / sizeof STATED[0]; k++) {
            if (STATED[k].error > 0.0 && STATED[k].error >= STATED[k].value) {
                clod_warnings_add(locus,
                                  "%s is %.3f %s with a stated standard error of %.3f %s: "
                                  "nothing was measured then; check the column of errors and "
                                  "its unit.",
                                  STATED[k].name, STATED[k].value / STATED[k].scale,
                                  STATED[k].unit, STATED[k].error / STATED[k].scale,
                                  STATED[k].unit);
                return;
            }
        }
    }
}

bool clod_warnings_points_unmeasured(const clod_locus_point *points, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        if ((p->tau_s_error > 0.0 && p->tau_s_error >= p->tau_s) ||
            p->tau_p_error >= p->tau_p) {
            return true;
        }
    }
    return false;
}

void clod_warnings_points_check(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    check_preshear(locus);
    check_density_units(locus, points, count);
    check_densities(locus, points, count);
    check_stated(locus, points, count);
}
