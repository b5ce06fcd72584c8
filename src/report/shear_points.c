#include "report/shear_points.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "clod/locus.h"
#include "report/html.h"
#include "report/rounded.h"
#include "report/shear_rows.h"

#define WRITTEN 1e-8 ///< relative: nine digits of points.csv
#define SAME 1e-9    ///< shear stresses of a point and its part are one number

/** Whether a part has this flag. */
static bool is_flagged(const json_t *part, const char *flag)
{
    size_t k;
    const json_t *one;
    json_array_foreach(json_object_get(part, "flags"), k, one)
    {
        if (strcmp(json_string_value(one) != NULL ? json_string_value(one) : "", flag) == 0) {
            return true;
        }
    }
    return false;
}

/** The part of a run that sheared a point; NULL: it is none of a run, or not known. */
static const json_t *part_of(const json_t *summary, const json_t *point)
{
    const double tau = clod_shear_number(point, "tau_s_Pa");
    size_t k;
    const json_t *part;
    json_array_foreach(json_object_get(summary, "parts"), k, part)
    {
        const char *name = json_string_value(json_object_get(part, "part"));
        const double stress = clod_shear_number(part, "shear_stress_Pa");
        if (name != NULL && strstr(name, "point-") != NULL &&
            clod_shear_number(part, "seed") == clod_shear_number(point, "seed") &&
            fabs(stress - tau) <= SAME * tau) {
            return part;
        }
    }
    return NULL;
}

// ---- summaries without errors of points

/** The row of a table that a point was; NULL: it is none of them. */
static const clod_locus_point *row_of(const clod_locus_point *rows, size_t count,
                                      const json_t *point)
{
    const double sigma = clod_shear_number(point, "sigma_s_Pa");
    const double tau = clod_shear_number(point, "tau_s_Pa");
    const double seed = clod_shear_number(point, "seed");
    for (size_t k = 0; k < count; k++) {
        if ((double)rows[k].seed == seed && fabs(rows[k].sigma_s - sigma) <= WRITTEN * sigma &&
            fabs(rows[k].tau_s - tau) <= WRITTEN * tau) {
            return &rows[k];
        }
    }
    return NULL;
}

void clod_shear_points_recall(const clod_run_files *run)
{
    static const char *const KEY = "tau_s_error_Pa";
    json_t *loci = json_object_get(json_object_get(run->summary, "locus"), "loci");
    const json_t *first = json_array_get(json_object_get(json_array_get(loci, 0), "points"), 0);
    clod_locus_point *rows = NULL;
    size_t count = 0;
    clod_status ignored = {0};
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/points.csv", run->folder);
    if (first == NULL || json_object_get(first, KEY) != NULL ||
        !clod_locus_read(path, NULL, &rows, &count, &ignored)) {
        return;
    }
    size_t g, k;
    json_t *locus, *point;
    json_array_foreach(loci, g, locus)
    {
        json_array_foreach(json_object_get(locus, "points"), k, point)
        {
            const clod_locus_point *row = row_of(rows, count, point);
            if (row != NULL && row->tau_s_error > 0.0) {
                json_object_set_new(point, KEY, json_real(row->tau_s_error));
            }
        }
    }
    clod_locus_free(rows);
}

// ---- how preshear ended

/** Mean of a number of all preshears of a run with its error, owned: of several the standard error of the mean, of
 *  one its own (`error_key`, NULL: none). NULL: no preshear has the number. */
static json_t *mean_of_preshears(const json_t *parts, const char *key, const char *error_key)
{
    double n = 0.0, mean = 0.0, squares = 0.0, own = (double)NAN;
    size_t k;
    const json_t *part;
    json_array_foreach(parts, k, part)
    {
        const double value = clod_shear_number(part, key);
        if (json_object_get(part, "steady") != NULL && isfinite(value)) { // a preshear
            const double off = value - mean;
            n += 1.0;
            mean += off / n;
            squares += off * (value - mean);
            own = error_key != NULL ? clod_shear_number(part, error_key) : (double)NAN;
        }
    }
    const double error = n > 1.0 ? sqrt(squares / (n - 1.0) / n) : own;
    return n > 0.0 ? json_pack("{s:f, s:o}", "value", mean, "error", clod_json_number(error))
                   : NULL;
}

void clod_shear_points_preshear(const clod_run_files *run)
{
    const json_t *parts = json_object_get(run->summary, "parts");
    json_t *way = mean_of_preshears(parts, "displacement_m", NULL);
    json_t *slope = mean_of_preshears(parts, "shear_stress_rate_Pa_per_m",
                                      "shear_stress_rate_error_Pa_per_m");
    size_t g;
    json_t *locus;
    json_array_foreach(json_object_get(json_object_get(run->summary, "locus"), "loci"), g,
                       locus)
    {
        if (way != NULL) {
            json_object_set(locus, CLOD_SHEAR_POINTS_WAY, way);
        }
        if (slope != NULL) {
            json_object_set(locus, CLOD_SHEAR_POINTS_SLOPE, slope);
        }
    }
    json_decref(way);
    json_decref(slope);
}

// ---- table

static void put_stress(FILE *out, const json_t *from, const char *key, double error)
{
    const double value = clod_shear_number(from, key);
    clod_rounded_begin(out, "td", value, error, "Pa");
    if (isfinite(value)) {
        clod_rounded_put(clod_writer_page(out), 1e-3 * value, 1e-3 * error, (double)NAN, 3, "");
    }
    fputs("</td>", out);
}

double clod_shear_points_error(const json_t *point)
{
    const double measured = clod_shear_number(point, "tau_s_Pa");
    return clod_shear_number(point, "tau_s_error_Pa") *
           clod_shear_number(point, "prorated_Pa") / measured;
}

/** Which of a laboratory's: preshear stress, and specimen where there are several. */
static void put_specimen(FILE *out, const json_t *locus, const json_t *point)
{
    const double stress = clod_shear_number(locus, "sigma_p_Pa");
    const double seed = clod_shear_number(point, "seed");
    if (isfinite(stress)) {
        fprintf(out, ", %.4g kPa", 1e-3 * stress);
    }
    if (clod_shear_number(locus, "seed_count") > 1.0 && isfinite(seed)) {
        fprintf(out, ", specimen %.0f", seed);
    }
}

static void put_point(FILE *out, const json_t *locus, const json_t *point, const json_t *part,
                      const clod_shear_loci *set)
{
    const char *name = json_string_value(json_object_get(part, "part"));
    fputs("<tr><th>", out);
    clod_html_text(out, set->of);
    if (name != NULL) {
        fputs(", ", out);
        clod_html_text(out, name);
    } else if (set->lab) {
        put_specimen(out, locus, point);
    }
    fputs("</th>", out);
    put_stress(out, locus, "sigma_p_Pa", (double)NAN);
    put_stress(out, point, "sigma_s_Pa", (double)NAN);
    put_stress(out, point, "tau_s_Pa", clod_shear_number(point, "tau_s_error_Pa"));
    put_stress(out, point, "prorated_Pa", clod_shear_points_error(point));
    put_stress(out, point, "line_Pa", (double)NAN);
    fputs(is_flagged(part, "no peak") ? "<td>no peak</td></tr>\n" : "<td></td></tr>\n", out);
}

void clod_shear_points_put(FILE *out, const json_t *summary, const clod_shear_loci *sets,
                           size_t count)
{
    fputs(
        "<div class=\"scroll\"><table id=\"points-table\"><thead><tr><th>shear points [kPa]</th>"
        "<th>&sigma;<sub>pre</sub></th><th>&sigma;</th>"
        "<th>&tau;</th><th>&tau; prorated</th><th>&tau; of the line</th><th></th></tr>"
        "</thead>\n<tbody>",
        out);
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            size_t k;
            const json_t *point;
            json_array_foreach(json_object_get(locus, "points"), k, point)
            {
                put_point(out, locus, point, sets[s].lab ? NULL : part_of(summary, point),
                          &sets[s]);
            }
        }
    }
    fputs("</tbody></table></div>\n", out);
}

// ---- marks

/** Standard error of what a part gave [Pa]; NaN: not known. */
static double error_of(const json_t *study, const json_t *summary, const json_t *part)
{
    const bool preshear =
        strstr(json_string_value(json_object_get(part, "part")), "point-") == NULL;
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL; g++) {
        if (preshear && clod_shear_number(locus, "seed_count") == 1.0) { // else of their mean
            return clod_shear_number(json_object_get(locus, "tau_p_Pa"), "error");
        }
        size_t k;
        const json_t *point;
        json_array_foreach(json_object_get(locus, "points"), k, point)
        {
            if (part_of(summary, point) == part) {
                return clod_shear_number(point, "tau_s_error_Pa");
            }
        }
    }
    return (double)NAN;
}

void clod_shear_points_mark(clod_figure *figure, const clod_run_files *run, const char *part,
                            int number)
{
    size_t k;
    const json_t *one;
    json_array_foreach(json_object_get(run->summary, "parts"), k, one)
    {
        const char *name = json_string_value(json_object_get(one, "part"));
        const double x = clod_shear_number(one, "displacement_m");
        const double y = clod_shear_number(one, "shear_stress_Pa");
        if (name != NULL && strcmp(name, part) == 0 && isfinite(x) && isfinite(y)) {
            const bool vague = is_flagged(one, "no peak") || is_flagged(one, "not steady");
            const double error =
                error_of(json_object_get(run->summary, "locus"), run->summary, one);
            clod_figure_add(figure, "", vague ? CLOD_FIGURE_VAGUE : CLOD_FIGURE_READ, number, 1,
                            &x, &y, isfinite(error) ? &error : NULL);
        }
    }
}
