#include "sim/part_fields.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "sim/fields.h"

#define COLUMN_TEXT 128

/** Where a part's fields remember: behind the data of its tester. */
static void *memory_of(const clod_part_fields *self, void *data)
{
    return (unsigned char *)data + self->tester->size;
}

/** A test has no steady time of the whole run: its rows are all that there is. */
static clod_free_moment moment_of(const clod_part_fields *self, clod_state *state,
                                  const clod_survey *survey)
{
    return (clod_free_moment){
        .from = self->from, .state = state, .survey = survey, .steady = {HUGE_VAL, 1.0}};
}

static bool measure(void *data, const void *context, clod_state *state,
                    const clod_survey *survey, clod_status *status)
{
    const clod_part_fields *self = context;
    const clod_free_moment now = moment_of(self, state, survey);
    return CLOD_MEASURE_FIELDS.look(memory_of(self, data), &now, status);
}

static bool sample(void *data, const void *context, clod_state *state,
                   const clod_survey *survey, double *row)
{
    const clod_part_fields *self = context;
    const clod_free_moment now = moment_of(self, state, survey);
    CLOD_MEASURE_FIELDS.row(memory_of(self, data), &now, row + self->tester->column_count);
    return self->tester->sample(data, self->tester->context, state, survey, row);
}

size_t clod_part_fields_size(const clod_case *from)
{
    return from->field_count > 0 ? CLOD_MEASURE_FIELDS.size(from) : 0;
}

bool clod_part_fields_init(clod_part_fields *self, const clod_case *from,
                           const clod_procedure *tester, clod_status *status)
{
    *self = (clod_part_fields){.from = from, .tester = tester};
    if (from->field_count == 0) {
        return true;
    }
    const size_t own = tester->column_count, made = CLOD_MEASURE_FIELDS.columns(from, NULL);
    self->columns = clod_memory_alloc(own + made, sizeof *self->columns);
    self->text = clod_memory_alloc(made, COLUMN_TEXT);
    if (self->columns == NULL || self->text == NULL) {
        clod_part_fields_fini(self);
        return clod_status_fail(status, CLOD_FAILED, "no memory for the columns of fields");
    }
    self->count = own + made;
    memcpy(self->columns, tester->columns, own * sizeof *self->columns);
    for (size_t k = 0; k < made; k++) {
        char *text = self->text + k * COLUMN_TEXT;
        CLOD_MEASURE_FIELDS.column(from, NULL, k, text, COLUMN_TEXT);
        self->columns[own + k] = text;
    }
    return true;
}

void clod_part_fields_fini(clod_part_fields *self)
{
    clod_memory_free(self->columns);
    clod_memory_free(self->text);
    *self = (clod_part_fields){0};
}

void clod_part_fields_join(const clod_part_fields *self, clod_procedure *procedure)
{
    if (self->count > 0) {
        procedure->context = self;
        procedure->measures_size = clod_part_fields_size(self->from);
        procedure->columns = self->columns;
        procedure->column_count = self->count;
        procedure->measure = measure;
        procedure->sample = sample;
    }
}
