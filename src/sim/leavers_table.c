#include "sim/leavers_table.h"

#include <stdio.h>
#include <stdlib.h>

#include "sim/exits.h"

const char *const CLOD_LEAVERS_TABLE_COLUMN[CLOD_LEAVERS_TABLE_COLUMNS] = {
    "id [1]", "material", "radius [m]", "mass [kg]", "born [s]", "left [s]", "way"};

/** Grains that leave at one moment stand in any order. */
static int compare(const void *a, const void *b)
{
    const clod_gone_grain *one = a, *other = b;
    if (one->left != other->left) {
        return one->left < other->left ? -1 : 1;
    }
    return one->id < other->id ? -1 : one->id > other->id;
}

static bool write_row(clod_series *series, const clod_case *from, const clod_gone_grain *grain,
                      clod_status *status)
{
    char number[4][CLOD_SERIES_NUMBER], way[64], text[512];
    const double value[4] = {grain->radius, grain->mass, grain->birth, grain->left};
    for (int k = 0; k < 4; k++) {
        clod_series_number(number[k], value[k]);
    }
    const int length =
        snprintf(text, sizeof text, "%llu,%s,%s,%s,%s,%s,%s\n", (unsigned long long)grain->id,
                 from->materials[grain->material].name, number[0], number[1], number[2],
                 number[3], clod_exits_key(from, grain->exit, way, sizeof way));
    return clod_series_text(series, text, (size_t)length, status);
}

bool clod_leavers_table_write(clod_series *series, const clod_case *from, clod_state *state,
                              clod_status *status)
{
    clod_gone *gone = &state->gone;
    if (gone->lacks_memory) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the rows of %s",
                                CLOD_LEAVERS_TABLE);
    }
    if (gone->count > 0) {
        qsort(gone->rows, gone->count, sizeof *gone->rows, compare);
    }
    bool good = true;
    for (size_t k = 0; good && k < gone->count; k++) {
        good = write_row(series, from, &gone->rows[k], status);
    }
    gone->count = 0;
    return good;
}
