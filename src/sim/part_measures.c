#include "sim/part_measures.h"

#include <math.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "sim/fields.h"
#include "sim/mixing.h"
#include "sim/part_means.h"

#define COLUMN_TEXT 128

/** In the order of their columns, and of what they remember. */
static const clod_free_measure *const MEASURES[] = {&CLOD_MEASURE_FIELDS, &CLOD_MEASURE_MIXING};
enum { COUNT = sizeof MEASURES / sizeof *MEASURES };

/** What a part with grids remembers behind all measures; plain data. */
typedef struct part_notes {
    double since;   ///< s, when the phase of the sums began
    char phase[24]; ///< its name, known at its end; the bytes behind it are zero
} part_notes;

static bool has_grids(const clod_case *from)
{
    bool any = false;
    for (size_t k = 0; k < from->field_count; k++) {
        any = any || from->fields[k].cell > 0.0;
    }
    return any;
}

/** Bytes before what measure number k remembers; all of them have numbers of eight bytes. */
static size_t offset_of(const clod_case *from, int k)
{
    size_t bytes = 0;
    for (int m = 0; m < k; m++) {
        bytes += MEASURES[m]->told(from) ? MEASURES[m]->size(from) : 0;
    }
    return bytes;
}

size_t clod_part_measures_size(const clod_case *from)
{
    return offset_of(from, COUNT) + (has_grids(from) ? sizeof(part_notes) : 0);
}

/** What a part's measures remember: behind the data of its tester. */
static unsigned char *memory_of(const clod_part_measures *self, void *data)
{
    return (unsigned char *)data + self->tester->size;
}

/** NULL: the part has no grids. */
static part_notes *notes_of(const clod_part_measures *self, void *data)
{
    return has_grids(self->from)
               ? (part_notes *)(void *)(memory_of(self, data) + offset_of(self->from, COUNT))
               : NULL;
}

/** A test has no steady time of the whole run: all samples are one block. Of the sums over it
 *  those of grids are told, which begin anew with each phase. */
static clod_free_moment moment_of(const clod_case *from, clod_state *state,
                                  const clod_survey *survey)
{
    return (clod_free_moment){
        .from = from, .state = state, .survey = survey, .steady = {0.0, HUGE_VAL}};
}

static bool measure(void *data, const void *context, clod_state *state,
                    const clod_survey *survey, clod_status *status)
{
    const clod_part_measures *self = context;
    const clod_free_moment now = moment_of(self->from, state, survey);
    bool good = true;
    for (int m = 0; good && m < COUNT; m++) {
        good =
            !MEASURES[m]->told(self->from) ||
            MEASURES[m]->look(memory_of(self, data) + offset_of(self->from, m), &now, status);
    }
    return good;
}

/** Sums of grids begin anew: the next row is the first of a phase. */
static void begin_phase(const clod_part_measures *self, void *data, const clod_state *state)
{
    part_notes *notes = notes_of(self, data);
    if (notes != NULL) {
        *notes = (part_notes){.since = state->time};
        clod_fields_restart(memory_of(self, data), self->from, state);
    }
}

static bool sample(void *data, const void *context, clod_state *state,
                   const clod_survey *survey, double *row)
{
    const clod_part_measures *self = context;
    const clod_procedure *tester = self->tester;
    const clod_free_moment now = moment_of(self->from, state, survey);
    double *to = row + tester->column_count;
    for (int m = 0; m < COUNT; m++) {
        if (MEASURES[m]->told(self->from)) {
            MEASURES[m]->row(memory_of(self, data) + offset_of(self->from, m), &now, to);
            to += MEASURES[m]->columns(self->from, state);
        }
    }
    const char *before = tester->phase(data, tester->context);
    const bool finished = tester->sample(data, tester->context, state, survey, row);
    part_notes *notes = notes_of(self, data);
    if (finished && notes != NULL) {
        strncpy(notes->phase, before, sizeof notes->phase - 1);
    } else if (tester->phase(data, tester->context) != before) {
        begin_phase(self, data, state);
    }
    return finished;
}

static bool picture(void *data, const void *context, clod_state *state,
                    const clod_survey *survey, const clod_frame *frame, clod_status *status)
{
    const clod_part_measures *self = context;
    const clod_free_moment now = moment_of(self->from, state, survey);
    return clod_fields_picture(memory_of(self, data), &now, frame, status);
}

static bool write(const void *data, const void *context, clod_state *state,
                  const clod_frame *frame, clod_status *status)
{
    const clod_part_measures *self = context;
    const clod_free_moment now = moment_of(self->from, state, NULL);
    const void *memory = (const unsigned char *)data + self->tester->size;
    return clod_fields_write_part(frame, memory, &now, status);
}

/** Header texts behind those of the tester. */
static void name_columns(clod_part_measures *self)
{
    size_t at = 0;
    for (int m = 0; m < COUNT; m++) {
        const size_t made =
            MEASURES[m]->told(self->from) ? MEASURES[m]->columns(self->from, NULL) : 0;
        for (size_t k = 0; k < made; k++) {
            char *text = self->text + at++ * COLUMN_TEXT;
            MEASURES[m]->column(self->from, NULL, k, text, COLUMN_TEXT);
            self->columns[self->tester->column_count + at - 1] = text;
        }
    }
}

bool clod_part_measures_init(clod_part_measures *self, const clod_case *from,
                             const clod_procedure *tester, clod_status *status)
{
    *self = (clod_part_measures){.from = from, .tester = tester};
    if (clod_part_measures_size(from) == 0) {
        return true;
    }
    const size_t own = tester->column_count;
    size_t made = 0;
    for (int m = 0; m < COUNT; m++) {
        made += MEASURES[m]->told(from) ? MEASURES[m]->columns(from, NULL) : 0;
    }
    self->columns = clod_memory_alloc(own + made, sizeof *self->columns);
    self->text = clod_memory_alloc(made + 1, COLUMN_TEXT); // grids have no columns
    if (self->columns == NULL || self->text == NULL) {
        clod_part_measures_fini(self);
        return clod_status_fail(status, CLOD_FAILED,
                                "no memory for the columns of fields and mixing");
    }
    self->count = own + made;
    memcpy(self->columns, tester->columns, own * sizeof *self->columns);
    name_columns(self);
    return true;
}

void clod_part_measures_fini(clod_part_measures *self)
{
    clod_memory_free(self->columns);
    clod_memory_free(self->text);
    *self = (clod_part_measures){0};
}

void clod_part_measures_join(const clod_part_measures *self, clod_procedure *procedure)
{
    if (self->count > 0) {
        procedure->context = self;
        procedure->measures_size = clod_part_measures_size(self->from);
        procedure->columns = self->columns;
        procedure->column_count = self->count;
        procedure->measure = measure;
        procedure->sample = sample;
        procedure->picture = has_grids(self->from) ? picture : NULL;
        procedure->write = has_grids(self->from) ? write : NULL;
    }
}

void clod_part_measures_begin(const clod_part_measures *self, void *data,
                              const clod_state *state)
{
    if (self->count > 0 && has_grids(self->from)) {
        clod_fields_leave_frames(memory_of(self, data), self->from);
        begin_phase(self, data, state);
    }
}

/** The object of the grid of field k. */
static json_t *grid_json(const clod_case *from, size_t k, const char *part, const void *memory)
{
    const part_notes *notes =
        (const void *)((const unsigned char *)memory + offset_of(from, COUNT));
    json_t *one = json_pack("{s:o, s:s, s:f, s:I}", "file",
                            json_sprintf("%s_field_%s.hdf", part, from->fields[k].name),
                            "phase", notes->phase, "since_s", notes->since, "samples",
                            (json_int_t)clod_fields_samples(clod_fields_memory(memory, k)));
    clod_fields_put_grid(one, memory, from, k);
    return one;
}

/** Put what means are of into an object. */
static void put_steady(json_t *one, const char *phase, const clod_part_means *means)
{
    json_object_set_new(one, "phase", json_string(phase));
    json_object_set_new(one, "since_s", json_real(means->steady.since));
    json_object_set_new(one, "rows", json_integer((json_int_t)means->rows));
}

/** Put the fields; the number of their columns. */
static size_t put_fields(json_t *object, const clod_case *from, const char *part,
                         const void *memory, const char *phase, const clod_part_means *means)
{
    size_t columns = 0;
    json_t *all = json_object();
    for (size_t k = 0; k < from->field_count; k++) {
        json_t *one;
        if (from->fields[k].cell > 0.0) {
            one = grid_json(from, k, part, memory);
        } else {
            one = json_object();
            put_steady(one, phase, means);
            clod_fields_put_means(one, &from->fields[k], means->mean + columns,
                                  means->deviation + columns);
            columns += CLOD_CONTINUUM_NUMBERS;
        }
        json_object_set_new(all, from->fields[k].name, one);
    }
    json_object_set_new(object, "fields", all);
    return columns;
}

/** Put the mixing indices: what a free run tells of them, with the means of the part. */
static void put_mixings(json_t *object, const clod_case *from, const void *memory,
                        const char *phase, const clod_part_means *means, size_t columns)
{
    const clod_free_moment now = moment_of(from, NULL, NULL);
    json_t *all =
        CLOD_MEASURE_MIXING.json((const unsigned char *)memory + offset_of(from, 1), &now);
    for (size_t k = 0; k < from->mixing_count; k++) {
        json_t *one = json_object_get(all, from->mixings[k].name);
        const size_t lacey = columns + k * CLOD_MIXING_COLUMNS;
        put_steady(one, phase, means);
        json_object_set_new(one, "mean", clod_json_number(means->mean[lacey]));
        json_object_set_new(one, "deviation", clod_json_number(means->deviation[lacey]));
    }
    json_object_set_new(object, "mixing", all);
}

bool clod_part_measures_put(json_t *object, const clod_case *from, const clod_procedure *tester,
                            const clod_folder *folder, const char *part, const void *memory,
                            clod_status *status)
{
    size_t columns = 0, behind = 0;
    for (int m = 0; m < COUNT; m++) {
        columns += MEASURES[m]->told(from) ? MEASURES[m]->columns(from, NULL) : 0;
    }
    if (clod_part_measures_size(from) == 0) {
        return true;
    }
    clod_part_means means;
    bool good =
        clod_part_means_read(&means, folder, part, tester->column_count, columns, status);
    const char *phase = good ? tester->phase_name(means.phase) : NULL;
    if (good && phase == NULL) {
        good = clod_status_fail(status, CLOD_FAILED, "%s/%s.csv: no phase %d", folder->path,
                                part, means.phase);
    }
    if (good && from->field_count > 0) {
        behind = put_fields(object, from, part, memory, phase, &means);
    }
    if (good && from->mixing_count > 0) {
        put_mixings(object, from, memory, phase, &means, behind);
    }
    clod_part_means_fini(&means);
    return good;
}
