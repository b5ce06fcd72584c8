#include "analysis/angles.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mohr.h"
#include "analysis/warnings.h"
#include "output/file.h"
#include "output/folder_names.h"

#define DEGREES (180.0 / 3.14159265358979323846)
#define PLACES                                                                                 \
    320 ///< bytes for files and lines, so that messages around them keep their reason
#define MORE ", ..."

/** Find whether a table is a measured one: not points.csv of a results folder. */
static bool find_measured(const char *path, bool *measured, clod_status *status)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    const int folder = (int)(name - path);
    char lock[PATH_MAX + sizeof CLOD_FOLDER_LOCK];
    *measured = true;
    if (strcmp(name, "points.csv") != 0 || folder >= PATH_MAX) {
        return true;
    }
    snprintf(lock, sizeof lock, "%.*s%s", folder, path, CLOD_FOLDER_LOCK);
    bool of_run;
    const bool good = clod_file_is_there(lock, &of_run, status);
    *measured = !of_run;
    return good;
}

static size_t source_of(const clod_angles_source *sources, size_t count, size_t index)
{
    size_t at = 0;
    while (at + 1 < count && index >= sources[at].end) {
        at++;
    }
    return at;
}

/** Append; what has no room becomes dots, once. */
static void append(char text[PLACES], const char *more)
{
    const size_t used = strlen(text);
    if (used + strlen(more) + sizeof MORE <= PLACES) {
        memcpy(text + used, more, strlen(more) + 1);
    } else if (used < sizeof MORE || strcmp(text + used - (sizeof MORE - 1), MORE) != 0) {
        memcpy(text + used, MORE, sizeof MORE);
    }
}

/** The files and lines of a locus: "a.csv:2, 3, 5", and "; b.csv:2" of another file. */
static void list_places(const clod_locus *locus, const clod_locus_point *points,
                        const clod_angles_source *sources, size_t source_count,
                        char text[PLACES])
{
    size_t last = source_count;
    text[0] = '\0';
    for (size_t k = 0; k < locus->point_count; k++) {
        const size_t index = locus->marks[k].index;
        const size_t source = source_of(sources, source_count, index);
        char line[32];
        snprintf(line, sizeof line, "%s%zu", source == last ? ", " : ":", points[index].row);
        if (source != last) {
            append(text, last == source_count ? "" : "; ");
            append(text, sources[source].path);
        }
        append(text, line);
        last = source;
    }
}

/** The preshear point, which no steady flow puts so far below the line. */
static bool check_preshear(const clod_locus *locus, const char *places, const char *seed,
                           clod_status *status)
{
    const double t = tan(locus->phi_lin.value);
    const double sigma = locus->sigma_p.value, tau = locus->tau_p.value;
    const double share = clod_mohr_share(locus->c.value, t, sigma, tau);
    const double least = clod_mohr_share_least(t);
    const double limit = fmin(CLOD_ANGLES_SHARE_LEAST, least);
    return share >= limit ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: the yield locus at a preshear stress of %.3f kPa%s has tau_pre = %.3f kPa, "
               "%.3f of the %.3f kPa that the line through its points has there; it must be "
               "%.2f of it or more, and steady flow has at least %.2f. Has sigma_pre or tau_pre "
               "another unit or column than the points, are sigma_sh and tau_sh exchanged, or "
               "has one of them a slip? If not, preshear ended long before steady flow: shear further, and measure again.",
               places, 1e-3 * sigma, seed, 1e-3 * tau, share, 1e-3 * tau / share, limit, least);
}

static bool check_locus(const clod_locus *locus, const char *places, clod_status *status)
{
    const struct {
        const char *name, *columns;
        double value; ///< deg
    } ANGLES[] = {
        {"phi_sf", "sigma_pre and tau_pre", locus->phi_sf.value * DEGREES},
        {"phi_lin", "sigma_sh and tau_sh", locus->phi_lin.value * DEGREES},
    };
    char seed[32] = "";
    if (locus->marks[0].seed != 0) { // as of a table without that column
        snprintf(seed, sizeof seed, ", seed %lld", (long long)locus->marks[0].seed);
    }
    for (size_t k = 0; k < sizeof ANGLES / sizeof ANGLES[0]; k++) {
        const double value = ANGLES[k].value;
        if (!(value >= CLOD_ANGLES_LEAST && value <= CLOD_ANGLES_MOST)) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s: the yield locus at a preshear stress of %.3f kPa%s has %s = %.2f deg; it "
                "must be %.0f to %.0f deg. Spheres without friction have 6 deg, and no solid is "
                "beyond %.0f deg. Have %s been exchanged, or has one another unit?",
                places, 1e-3 * locus->sigma_p.value, seed, ANGLES[k].name, value,
                CLOD_ANGLES_LEAST, CLOD_ANGLES_MOST, CLOD_ANGLES_MOST, ANGLES[k].columns);
        }
    }
    return check_preshear(locus, places, seed, status);
}

/** Points sheared above their preshear stress, which consolidated anew: they are no part of the locus. */
static bool check_points(const clod_locus *locus, const clod_locus_point *points,
                         const clod_angles_source *sources, size_t source_count,
                         clod_status *status)
{
    for (size_t k = 0; k < locus->point_count; k++) {
        const size_t index = locus->marks[k].index;
        const clod_locus_point *p = &points[index];
        if (p->sigma_s > (1.0 + CLOD_WARNINGS_SAME_STRESS) * p->sigma_p) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s:%zu: shear at %.3f kPa after a preshear at %.3f kPa: above its preshear stress a solid consolidates "
                "anew, and the point belongs to no yield locus of it; tests shear at 20 to 80 %% of it. Has one of the "
                "two a slip or another unit, or are sigma_pre and sigma_sh exchanged? Else leave the point out.",
                sources[source_of(sources, source_count, index)].path, p->row,
                1e-3 * p->sigma_s, 1e-3 * p->sigma_p);
        }
    }
    return true;
}

bool clod_angles_check(const clod_locus_study *study, const clod_locus_point *points,
                       const clod_angles_source *sources, size_t source_count,
                       clod_status *status)
{
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus_group *group = &study->groups[g];
        for (size_t s = 0; s < group->seed_count; s++) {
            char places[PLACES];
            const size_t first = group->seeds[s].marks[0].index;
            const char *path = sources[source_of(sources, source_count, first)].path;
            bool measured;
            if (!find_measured(path, &measured, status)) {
                return false;
            }
            if (!measured) {
                continue;
            }
            list_places(&group->seeds[s], points, sources, source_count, places);
            if (!check_points(&group->seeds[s], points, sources, source_count, status) ||
                !check_locus(&group->seeds[s], places, status)) {
                return false;
            }
        }
    }
    return true;
}
