/**
 * libFuzzer target: no file of shear points may crash the reader or the evaluation, and what
 * is refused is refused with a message.
 */

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "clod/locus.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static clod_status status;
    const clod_locus_defaults defaults = {"10 kPa", "8 kPa"};
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_parse("fuzz.csv", (const char *)data, size, &defaults, &points, &count,
                          &status)) {
        if (status.text[0] == '\0') {
            abort();
        }
        return 0;
    }
    clod_locus_study *study = clod_locus_study_create(points, count, &status);
    clod_locus_free(points);
    if (study == NULL) {
        return 0;
    }
    char *texts[] = {clod_locus_table(study), clod_locus_json(study), clod_locus_csv(study)};
    for (size_t k = 0; k < 3; k++) {
        if (texts[k] == NULL) {
            abort();
        }
        clod_locus_free(texts[k]);
    }
    clod_locus_study_destroy(&study);
    return 0;
}
