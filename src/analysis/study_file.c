#include "analysis/study_file.h"

clod_locus_study *clod_study_of_points(const char *path, const clod_locus_point *points,
                                       size_t count, clod_status *status)
{
    clod_status why = {0};
    clod_locus_study *study = clod_locus_study_create(points, count, &why);
    if (study == NULL) {
        clod_status_fail(status, why.code, "%s: %s", path, why.text);
    }
    return study;
}

clod_locus_study *clod_study_of_file(const char *path, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(path, NULL, &points, &count, status)) {
        return NULL;
    }
    clod_locus_study *study = clod_study_of_points(path, points, count, status);
    clod_locus_free(points);
    return study;
}
