/**
 * @file shear_lab.c
 * Points of a laboratory, evaluated as those of a simulation are.
 */

#include "base/memory.h"
#include "clod/locus.h"
#include "report/shear.h"

json_t *clod_shear_lab(const char *path, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(path, NULL, &points, &count, status)) {
        return NULL;
    }
    clod_status why = {0};
    clod_locus_study *study = clod_locus_study_create(points, count, &why);
    clod_locus_free(points);
    if (study == NULL) {
        clod_status_fail(status, why.code, "%s: %s", path, why.text);
    }
    char *text = study != NULL ? clod_locus_json(study) : NULL;
    json_t *all = text != NULL ? json_loads(text, 0, NULL) : NULL;
    if (study != NULL && all == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the laboratory's points.");
    }
    clod_locus_free(text);
    clod_locus_study_destroy(&study);
    return all;
}
