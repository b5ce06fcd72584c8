/**
 * @file shear_lab.c
 * Points of a laboratory, evaluated as those of a simulation are.
 */

#include "analysis/study_file.h"
#include "clod/locus.h"
#include "report/shear.h"

json_t *clod_shear_lab(const char *path, clod_status *status)
{
    clod_locus_study *study = clod_study_of_file(path, status);
    char *text = study != NULL ? clod_locus_json(study) : NULL;
    json_t *all = text != NULL ? json_loads(text, 0, NULL) : NULL;
    if (study != NULL && all == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the laboratory's points.");
    }
    clod_locus_free(text);
    clod_locus_study_destroy(&study);
    return all;
}
