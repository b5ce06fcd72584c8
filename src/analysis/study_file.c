#include "analysis/study_file.h"

#include "analysis/angles.h"

static clod_locus_study *evaluate(const char *path, const clod_locus_point *points,
                                  size_t count, clod_status *status)
{
    clod_status why = {0};
    clod_locus_study *study = clod_locus_study_create(points, count, &why);
    if (study == NULL) {
        clod_status_fail(status, why.code, "%s: %s", path, why.text);
    }
    return study;
}

clod_locus_study *clod_study_of_points(const char *path, const clod_locus_point *points,
                                       size_t count, clod_status *status)
{
    clod_locus_study *study = evaluate(path, points, count, status);
    const clod_angles_source source = {path, count};
    if (study != NULL && !clod_angles_check(study, points, &source, 1, status)) {
        clod_locus_study_destroy(&study);
    }
    return study;
}

/** Of points, as a table of measured ones or of those of a run. */
typedef clod_locus_study *study_maker(const char *path, const clod_locus_point *points,
                                      size_t count, clod_status *status);

static clod_locus_study *of_file(const char *path, study_maker *make, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(path, NULL, &points, &count, status)) {
        return NULL;
    }
    clod_locus_study *study = make(path, points, count, status);
    clod_locus_free(points);
    return study;
}

clod_locus_study *clod_study_of_file(const char *path, clod_status *status)
{
    return of_file(path, clod_study_of_points, status);
}

clod_locus_study *clod_study_of_run(const char *path, clod_status *status)
{
    return of_file(path, evaluate, status);
}
