#include "report/free_tables.h"

#define BLOCKS                                                                                 \
    "standard deviation of the means of ten blocks of time; the error of the mean is this "    \
    "over \u221a10 if the blocks are independent."

const clod_free_table CLOD_FREE_TABLES[CLOD_FREE_TABLE_COUNT] = {
    {"Gauges", "gauges", NULL, NULL, "\u00b1 " BLOCKS, false},
    {"Balance", "balance", NULL, NULL, "\u00b1 " BLOCKS, true},
    {"Out, of the balance", "balance", "out", NULL, "\u00b1 " BLOCKS, false},
    {"Resting material", "build_up", NULL, NULL, NULL, false},
    {"Residence time", "residence", NULL, "what left",
     "\u00b1 standard deviation of the times of the grains that left, no error of their mean.",
     false},
    {"Fields", "fields", NULL, NULL, "\u00b1 " BLOCKS, false},
    {"Mixing", "mixing", NULL, NULL, "mean \u00b1 " BLOCKS, false},
    {"Angle of repose", "repose", NULL, NULL,
     "angle \u00b1 standard error of the line through the flank at the end; mean \u00b1 " BLOCKS,
     false},
    {"Inlets", "inlets", NULL, NULL, NULL, false},
    {"Outlets", "outlets", NULL, NULL, NULL, false},
    {"Left at the sides of the domain", "left", NULL, NULL, NULL, false},
    {"Surfaces", "surfaces", NULL, NULL, NULL, false},
    {"Belts", "belts", NULL, NULL, "\u00b1 " BLOCKS, false},
    {"Walls at the end", "walls", NULL, NULL, NULL, false},
    {"Clumps", "clumps", NULL, NULL, NULL, false},
    {"Stages", "stages", NULL, NULL, NULL, false},
};

json_t *clod_free_tables_of(const clod_free_table *self, const json_t *summary)
{
    json_t *found = json_object_get(summary, self->key);
    if (self->within != NULL) {
        found = json_object_get(found, self->within);
    }
    if (found != NULL && self->alone != NULL) {
        return json_pack("{s:O}", self->alone, found);
    }
    return json_incref(found);
}
