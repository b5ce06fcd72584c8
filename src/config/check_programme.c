#include <stdio.h>

#include "config/check.h"

#define PATH_TEXT 64

/** Path of a key of the tester. */
static const char *path_of(const char *section, const char *key, char path[PATH_TEXT])
{
    snprintf(path, PATH_TEXT, "%s.%s", section, key);
    return path;
}

static void check_stresses(clod_loader *loader, const char *section,
                           const clod_case_programme *programme, const clod_check_above *above)
{
    if (programme->preshear_stress == 0.0) {
        return; // missing or wrong, which has been said
    }
    for (size_t i = 0; i < programme->shear_stress_count; i++) {
        char path[PATH_TEXT];
        snprintf(path, sizeof path, "%s.shear_stresses.%zu", section, i);
        if (programme->shear_stresses[i] <= above->weight) {
            clod_check_fail(loader, path,
                            "%.10g Pa is not above the weight of the solid %s, about %.2g Pa; "
                            "the lid cannot pull",
                            programme->shear_stresses[i], above->where, above->weight);
        }
        if (programme->shear_stresses[i] >= programme->preshear_stress) {
            clod_check_fail(
                loader, path,
                "%.10g Pa is not below preshear_stress = %.10g Pa; points of a yield "
                "locus lie below it",
                programme->shear_stresses[i], programme->preshear_stress);
        }
    }
}

/** Points that make a line: two at least, at stresses that differ. */
static void check_points(clod_loader *loader, const char *section,
                         const clod_case_programme *programme)
{
    char path[PATH_TEXT];
    path_of(section, "shear_stresses", path);
    if (programme->shear_stress_count == 0 || !clod_report_clean(loader->report, path)) {
        return; // missing or wrong, which has been said
    }
    if (programme->shear_stress_count == 1) {
        clod_check_fail(loader, path,
                        "one point gives no yield locus, two do, four are better: 20, 40, 60 "
                        "and 80 %% of preshear_stress are usual");
        return;
    }
    clod_check_apart(loader, path, programme->shear_stresses, programme->shear_stress_count,
                     CLOD_CHECK_APART * programme->preshear_stress,
                     "both give the same point of the yield locus");
}

/** Complain at the one of two keys of the tester that was written. */
static const char *written(const clod_loader *loader, const char *section, const char *first,
                           const char *second, char path[PATH_TEXT])
{
    char other[PATH_TEXT];
    path_of(section, first, path);
    path_of(section, second, other);
    return clod_check_written(loader, path, other) == path ? path
                                                           : path_of(section, second, path);
}

/** The ways of shear must be long enough for what is to be seen on them. */
static void check_ways(clod_loader *loader, const char *section,
                       const clod_case_programme *programme)
{
    char path[PATH_TEXT];
    if (!clod_report_clean(loader->report, section)) {
        return;
    }
    const double blocks = (double)programme->steady_blocks * programme->block_displacement;
    const double start =
        0.5 * programme->speed * programme->speed / CLOD_CASE_SHEAR_ACCELERATION;
    // products of decimal numbers round, and the start is a whole number of looks
    if (start + blocks > programme->preshear_max + 0.005 * programme->block_displacement) {
        clod_check_fail(loader,
                        written(loader, section, "preshear_max", "block_displacement", path),
                        "preshear can never be steady: %lld blocks (steady_blocks) of %.10g m "
                        "(block_displacement) behind the %.3g m on which it comes to its speed "
                        "are longer than preshear_max = %.10g m; make that %.4g m or more",
                        (long long)programme->steady_blocks, programme->block_displacement,
                        start, programme->preshear_max, 1.0005 * (start + blocks));
    }
    if (programme->preshear_min > programme->preshear_max) {
        clod_check_fail(loader, written(loader, section, "preshear_max", "preshear_min", path),
                        "preshear cannot end: it shears by preshear_min = %.10g m at least, "
                        "which is above preshear_max = %.10g m",
                        programme->preshear_min, programme->preshear_max);
    }
    if (programme->beyond_peak + programme->peak_window >= programme->shear_max) {
        clod_check_fail(
            loader, written(loader, section, "shear_max", "beyond_peak", path),
            "no peak can be passed: beyond_peak + peak_window = %.10g m is not less "
            "than shear_max = %.10g m",
            programme->beyond_peak + programme->peak_window, programme->shear_max);
    }
}

void clod_check_programme(clod_loader *loader, const char *section,
                          const clod_case_programme *programme, const clod_check_above *above)
{
    check_stresses(loader, section, programme, above);
    check_points(loader, section, programme);
    check_ways(loader, section, programme);
}
