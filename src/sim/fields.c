#include "sim/fields.h"

#include <stdio.h>
#include <string.h>

#include "measure/continuum_pass.h"
#include "setup/domain.h"
#include "sim/outputs.h"

clod_continuum clod_fields_make(const clod_case_field *from)
{
    const clod_outlet region = clod_setup_domain_region(&from->region);
    clod_continuum made = clod_continuum_make(&region, from->cell, from->width);
    made.cylindrical = from->components == CLOD_COMPONENTS_CYLINDRICAL;
    return made;
}

/** Points of a grid; 0 of a mean. */
static size_t grid_points(const clod_case_field *field)
{
    const clod_continuum made = clod_fields_make(field);
    return field->cell > 0.0 ? (size_t)clod_continuum_points(&made) : 0;
}

static size_t fields_size(const clod_case *from)
{
    size_t points = 0;
    for (size_t k = 0; k < from->field_count; k++) {
        points += grid_points(&from->fields[k]);
    }
    return from->field_count * sizeof(clod_field_memory) +
           points * CLOD_CONTINUUM_SUMS * sizeof(double);
}

const clod_field_memory *clod_fields_memory(const void *memory, size_t number)
{
    return (const clod_field_memory *)memory + number;
}

const double (*clod_fields_grid(const void *memory, const clod_case *from,
                                size_t number))[CLOD_CONTINUUM_SUMS]
{
    double(*sums)[CLOD_CONTINUUM_SUMS] =
        (double(*)[CLOD_CONTINUUM_SUMS])clod_fields_memory(memory, from->field_count);
    for (size_t k = 0; k < number; k++) {
        sums += grid_points(&from->fields[k]);
    }
    return (const double(*)[CLOD_CONTINUUM_SUMS])sums;
}

int64_t clod_fields_samples(const clod_field_memory *self)
{
    int64_t samples = 0;
    for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
        samples += self->samples[b];
    }
    return samples;
}

static void fields_begin(void *memory, const clod_case *from, const clod_state *state,
                         const clod_free_start *bed)
{
    (void)bed;
    clod_field_memory *self = memory;
    for (size_t k = 0; k < from->field_count; k++) {
        self[k].next = state->step;
    }
}

void clod_fields_restart(void *memory, const clod_case *from, const clod_state *state)
{
    clod_field_memory *self = memory;
    double(*sums)[CLOD_CONTINUUM_SUMS] =
        (double(*)[CLOD_CONTINUUM_SUMS])clod_fields_grid(memory, from, 0);
    for (size_t k = 0; k < from->field_count; k++) {
        const size_t points = grid_points(&from->fields[k]);
        memset(self[k].samples, 0, sizeof self[k].samples);
        memset(self[k].block, 0, sizeof self[k].block);
        memset(sums, 0, points * sizeof *sums);
        sums += points;
        self[k].next = points > 0 ? state->step : self[k].next; // that of a mean goes on
    }
}

void clod_fields_leave_frames(void *memory, const clod_case *from)
{
    clod_field_memory *self = memory;
    for (size_t k = 0; k < from->field_count; k++) {
        self[k].frame_time = 0.0;
        self[k].frame_sum = 0;
    }
}

static int64_t fields_plan(const void *memory, const clod_case *from, const clod_state *state,
                           const clod_steady_time *steady)
{
    (void)steady;
    const clod_field_memory *self = memory;
    int64_t first = INT64_MAX;
    for (size_t k = 0; k < from->field_count; k++) {
        const int64_t steps = self[k].next - state->step;
        first = steps > 0 && steps < first ? steps : first;
    }
    return first;
}

// ---- samples

/** Whether field number k is to be sampled now. A test looks at its rows only: then it is the first
 *  one since. */
static bool is_due(const clod_field_memory *self, const clod_free_moment *now, size_t k)
{
    return now->state->step >= self[k].next &&
           (now->from->fields[k].cell == 0.0 ||
            clod_steady_time_block(&now->steady, now->state->time) >= 0);
}

static void add_sums(double *to, const double *sums)
{
    for (int k = 0; k < CLOD_CONTINUUM_SUMS; k++) {
        to[k] += sums[k];
    }
}

/** Note a sample; that of a mean has its sums. */
static void note(clod_field_memory *self, const double *sums, int block)
{
    if (self->row_told != 0) {
        memset(self->row, 0, sizeof self->row);
        self->row_samples = self->row_told = 0;
    }
    add_sums(self->row, sums);
    self->row_samples++;
    if (block >= 0) {
        add_sums(self->block[block], sums);
        self->samples[block]++;
    }
}

/** Sample all that are due in one pass. */
static bool sample(clod_field_memory *self, const clod_free_moment *now, clod_status *status)
{
    const clod_case *from = now->from;
    clod_continuum made[CLOD_CASE_FIELDS];
    clod_continuum_part parts[CLOD_CASE_FIELDS];
    double sums[CLOD_CASE_FIELDS][1][CLOD_CONTINUUM_SUMS] = {{{0.0}}};
    size_t count = 0;
    for (size_t k = 0; k < from->field_count; k++) {
        if (is_due(self, now, k)) {
            made[count] = clod_fields_make(&from->fields[k]);
            parts[count].field = &made[count];
            parts[count++].to =
                from->fields[k].cell > 0.0
                    ? (double(*)[CLOD_CONTINUUM_SUMS])clod_fields_grid(self, from, k)
                    : sums[k];
        }
    }
    if (count > 0 && !clod_continuum_pass(parts, count, now->survey, status)) {
        return false;
    }
    const int block = clod_steady_time_block(&now->steady, now->state->time);
    for (size_t k = 0; k < from->field_count; k++) {
        if (is_due(self, now, k)) {
            note(&self[k], sums[k][0], block);
        }
    }
    return true;
}

static bool fields_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_field_memory *self = memory;
    const clod_state *state = now->state;
    if (!sample(self, now, status)) {
        return false;
    }
    for (size_t k = 0; k < now->from->field_count; k++) {
        if (state->step >= self[k].next) {
            self[k].next =
                clod_outputs_next(now->from->fields[k].interval, state->dt, state->step);
        }
    }
    return true;
}

// ---- the series: means over regions

static size_t fields_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    size_t count = 0;
    for (size_t k = 0; k < from->field_count; k++) {
        count += from->fields[k].cell == 0.0 ? CLOD_CONTINUUM_NUMBERS : 0;
    }
    return count;
}

static void fields_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    (void)state;
    const clod_case_field *field = from->fields;
    for (; field->cell > 0.0 || k >= CLOD_CONTINUUM_NUMBERS; field++) {
        k -= field->cell > 0.0 ? 0 : CLOD_CONTINUUM_NUMBERS;
    }
    const clod_continuum_value *value = CLOD_CONTINUUM_VALUE;
    while ((int)k >= value->first + value->components) {
        value++;
    }
    const clod_continuum made = clod_fields_make(field);
    snprintf(text, size, "field_%s.%s%s [%s]", field->name, value->name,
             clod_continuum_component(&made, value->components, (int)k - value->first),
             value->unit);
}

static void fields_row(void *memory, const clod_free_moment *now, double *row)
{
    clod_field_memory *self = memory;
    for (size_t k = 0; k < now->from->field_count; k++) {
        const clod_case_field *field = &now->from->fields[k];
        if (field->cell == 0.0) {
            const clod_continuum made = clod_fields_make(field);
            clod_continuum_values(&made, self[k].row, (double)self[k].row_samples, row);
            self[k].row_told = 1;
            row += CLOD_CONTINUUM_NUMBERS;
        }
    }
}

static bool fields_told(const clod_case *from)
{
    return from->field_count > 0;
}

const clod_free_measure CLOD_MEASURE_FIELDS = {.key = "fields",
                                               .size = fields_size,
                                               .begin = fields_begin,
                                               .act = fields_act,
                                               .plan = fields_plan,
                                               .look = fields_act, // a row has its own moment
                                               .columns = fields_columns,
                                               .column = fields_column,
                                               .row = fields_row,
                                               .picture = clod_fields_picture,
                                               .report = clod_fields_report,
                                               .told = fields_told,
                                               .paths = clod_fields_paths,
                                               .json = clod_fields_json,
                                               .write = clod_fields_write};
