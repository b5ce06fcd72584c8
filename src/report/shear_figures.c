/**
 * @file shear_figures.c
 * Yield loci with Mohr circles, flow functions, curves over displacement.
 */

#include <math.h>
#include <stdio.h>

#include "report/flow_figure.h"
#include "report/part_curves.h"
#include "report/shear.h"
#include "report/shear_points.h"
#include "report/shear_rows.h"

#define MOST_POINTS 512
#define ALMOST                                                                                 \
    0.999 ///< of the preshear stress, where the circle touches if its point is above the line
#define BEYOND                                                                                 \
    1.15 ///< the effective yield locus goes on behind the point where it touches the circle

static double error_of(const json_t *locus, const char *key)
{
    return clod_shear_number(json_object_get(locus, key), "error");
}

/** A straight line of a slope through (0, c), from one stress to another. */
static void add_straight(clod_figure *figure, const char *name, clod_figure_style style,
                         int colour, const double line[2], const double x[2])
{
    const double y[2] = {line[0] + line[1] * x[0], line[0] + line[1] * x[1]};
    clod_figure_add(figure, name, style, colour, 2, x, y, NULL);
}

/** The circle of steady flow of a locus; NaN where it has none. */
static void steady_of(const json_t *locus, double *centre, double *radius)
{
    const json_t *circle = json_object_get(locus, "steady_circle");
    *centre = clod_shear_number(circle, "centre_Pa");
    *radius = clod_shear_number(circle, "radius_Pa");
}

/**
 * The line of a yield locus, from tau = c at sigma = 0 to where the circle of steady flow touches it: the solid bears
 * no circle beyond that one, so that the line is dotted from there to the preshear stress.
 *
 * @param beyond  only the part that is dotted
 */
static void add_line(clod_figure *figure, const json_t *locus, const char *name,
                     clod_figure_style style, int colour, bool beyond)
{
    const double c = clod_shear_number(locus, "c_Pa");
    const double phi = clod_shear_number(locus, "phi_lin_deg") * M_PI / 180.0;
    const double line[2] = {c, tan(phi)};
    const double begin = c < 0.0 ? -c / line[1] : 0.0;
    const double end = clod_shear_number(locus, "sigma_p_Pa");
    double centre, radius;
    steady_of(locus, &centre, &radius);
    const double touch = centre - radius * sin(phi);
    const bool cut = touch > begin && touch < ALMOST * end; // false where there is no circle
    if (!beyond) {
        add_straight(figure, name, style, colour, line,
                     (const double[2]){begin, cut ? touch : end});
    } else if (cut) {
        add_straight(figure, name, style, colour, line, (const double[2]){touch, end});
    }
}

/** The effective yield locus: from the origin to a little beyond where it touches the circle of steady flow. */
static void add_effective(clod_figure *figure, const json_t *locus, int colour)
{
    double centre, radius;
    steady_of(locus, &centre, &radius);
    const double sine = radius / centre; // of phi_e
    if (sine > 0.0 && sine < 1.0) {
        const double slope = sine / sqrt(1.0 - sine * sine);
        const double touch = centre * (1.0 - sine * sine);
        add_straight(figure, "", CLOD_FIGURE_THIN, colour, (const double[2]){0.0, slope},
                     (const double[2]){0.0, BEYOND * touch});
    }
}

static void add_points(clod_figure *figure, const json_t *locus, const char *name, bool hollow,
                       int colour)
{
    double x[MOST_POINTS], y[MOST_POINTS], error[MOST_POINTS];
    size_t count = 0;
    size_t k;
    const json_t *point;
    json_array_foreach(json_object_get(locus, "points"), k, point)
    {
        if (count < MOST_POINTS) {
            x[count] = clod_shear_number(point, "sigma_s_Pa");
            y[count] = clod_shear_number(point, "prorated_Pa");
            error[count++] = clod_shear_points_error(point);
        }
    }
    clod_figure_add(figure, name, hollow ? CLOD_FIGURE_HOLLOW : CLOD_FIGURE_POINTS, colour,
                    count, x, y, error);
}

static void add_locus(clod_figure *figure, const json_t *locus, const char *of, bool lab,
                      int colour)
{
    char name[128];
    const double sigma = clod_shear_number(locus, "sigma_p_Pa");
    const double tau = clod_shear_number(locus, "tau_p_Pa");
    const double error = error_of(locus, "tau_p_Pa");
    snprintf(name, sizeof name, "%.60s, %.4g kPa", of, 1e-3 * sigma);
    add_line(figure, locus, name, lab ? CLOD_FIGURE_DASHED : CLOD_FIGURE_LINE, colour, false);
    add_points(figure, locus, "", lab, colour);
    clod_figure_add(figure, "", lab ? CLOD_FIGURE_HOLLOW : CLOD_FIGURE_POINTS, colour, 1,
                    &sigma, &tau, isfinite(error) ? &error : NULL);
    static const char *const CIRCLES[] = {"steady_circle", "unconfined_circle"};
    for (int k = 0; k < 2; k++) {
        const json_t *circle = json_object_get(locus, CIRCLES[k]);
        clod_figure_circle(figure, "", lab ? CLOD_FIGURE_DOTTED : CLOD_FIGURE_LINE, colour,
                           clod_shear_number(circle, "centre_Pa"),
                           clod_shear_number(circle, "radius_Pa"));
    }
    add_line(figure, locus, "", CLOD_FIGURE_DOTTED, colour, true);
    add_effective(figure, locus, colour);
}

static void put_loci(clod_sheet *sheet, const clod_shear_loci *sets, size_t count)
{
    clod_figure figure;
    int colour = 0;
    clod_figure_init(&figure, "yield-locus", "Yield locus and Mohr circles");
    clod_figure_axis_set(&figure.x, "normal stress", "kPa", 1e-3);
    clod_figure_axis_set(&figure.y, "shear stress", "kPa", 1e-3);
    figure.equal = true;
    snprintf(
        figure.note, sizeof figure.note,
        "Both axes have the same scale. Points: peaks at shear to failure, prorated, and the "
        "preshear point at the largest stress; bars: standard errors. Circles: unconfined yield "
        "strength, and steady flow at preshear. The yield locus is dotted beyond where the "
        "latter touches it. Thin line: effective yield locus, of phi_e.");
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            add_locus(&figure, locus, sets[s].of, sets[s].lab, colour++);
        }
    }
    clod_sheet_figure(sheet, &figure);
}

static void put_flow_function(clod_sheet *sheet, const clod_shear_loci *sets, size_t count)
{
    clod_figure figure;
    clod_flow_figure_init(&figure);
    double largest = 0.0;
    for (size_t s = 0; s < count; s++) {
        double x[MOST_POINTS], y[MOST_POINTS], error[MOST_POINTS];
        size_t n = 0;
        const json_t *locus;
        while (n < MOST_POINTS && (locus = clod_shear_locus(sets[s].study, n)) != NULL) {
            x[n] = clod_shear_number(locus, "sigma_1_Pa");
            y[n] = clod_shear_number(locus, "sigma_c_Pa");
            error[n] = error_of(locus, "sigma_c_Pa");
            largest = fmax(largest, isfinite(x[n]) ? x[n] : 0.0);
            n++;
        }
        clod_figure_add(&figure, sets[s].of,
                        sets[s].lab ? CLOD_FIGURE_HOLLOW : CLOD_FIGURE_POINTS, (int)s, n, x, y,
                        error);
    }
    clod_flow_figure_classes(&figure, largest);
    clod_sheet_figure(sheet, &figure);
}

void clod_shear_figures(clod_sheet *sheet, const clod_shear_loci *sets, size_t count)
{
    put_loci(sheet, sets, count);
    put_flow_function(sheet, sets, count);
}

/** Curves of the parts that are asked for; false: a table is damaged. */
static bool put_parts(clod_sheet *sheet, const clod_run_files *run, bool preshear,
                      clod_status *status)
{
    static const clod_part_column COLUMNS[] = {
        {"shear_stress", "shear stress", "kPa", 1e-3},
        {"height", "height of the specimen", "mm", 1e3},
        {"bulk_density", "bulk density", "kg/m3", 1.0},
    };
    const clod_part_curves curves = {.part = preshear ? "preshear" : "point-",
                                     .over = {"displacement", "displacement", "mm", 1e3},
                                     .behind = preshear ? ", preshear" : ", shear to failure",
                                     .named_by_title = true,
                                     .columns = COLUMNS,
                                     .count = sizeof COLUMNS / sizeof COLUMNS[0],
                                     .mark = clod_shear_points_mark,
                                     .marks = CLOD_SHEAR_POINTS_MARKS};
    return clod_part_curves_put(sheet, run, &curves, status);
}

bool clod_shear_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    return put_parts(sheet, run, true, status) && put_parts(sheet, run, false, status);
}
