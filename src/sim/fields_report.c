// What fields leave at the end: lines of the report, their object in the summary.

#include <inttypes.h>
#include <math.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "sim/fields.h"

// ---- means over regions

/** Means over the steady time, and the standard deviation of those of its blocks. */
typedef struct means {
    int64_t samples;
    double mean[CLOD_CONTINUUM_NUMBERS];
    double deviation[CLOD_CONTINUUM_NUMBERS];
} means;

static void fill(double *values, int count, double with)
{
    for (int k = 0; k < count; k++) {
        values[k] = with;
    }
}

static means means_of(const clod_continuum *field, const clod_field_memory *memory)
{
    means self = {.samples = clod_fields_samples(memory)};
    double whole[CLOD_CONTINUUM_SUMS] = {0};
    double values[CLOD_STEADY_BLOCKS][CLOD_CONTINUUM_NUMBERS];
    fill(self.mean, CLOD_CONTINUUM_NUMBERS, (double)NAN);
    for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
        for (int k = 0; k < CLOD_CONTINUUM_SUMS; k++) {
            whole[k] += memory->block[b][k];
        }
        fill(values[b], CLOD_CONTINUUM_NUMBERS, (double)NAN);
        if (memory->samples[b] > 0) {
            clod_continuum_values(field, memory->block[b], (double)memory->samples[b],
                                  values[b]);
        }
    }
    if (self.samples > 0) {
        clod_continuum_values(field, whole, (double)self.samples, self.mean);
    }
    for (int v = 0; v < CLOD_CONTINUUM_NUMBERS; v++) {
        double each[CLOD_STEADY_BLOCKS];
        for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
            each[b] = values[b][v];
        }
        self.deviation[v] = clod_steady_time_deviation(each, CLOD_STEADY_BLOCKS);
    }
    return self;
}

static void report_mean(FILE *out, const char *name, const means *self)
{
    const double *mean = self->mean;
    const double *v = mean + CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_VELOCITY].first;
    fprintf(out, "  field %-15s ", name);
    if (self->samples == 0) {
        fputs("no sample in the steady time\n", out);
        return;
    }
    fprintf(out, "%.4g kg/m3, solid fraction %.4g, ",
            mean[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_DENSITY].first],
            mean[CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_SOLID].first]);
    if (isnan(v[0])) {
        fputs("no velocity (no grain in the region), ", out);
    } else {
        fprintf(out, "velocity (%.4g, %.4g, %.4g) m/s, ", v[0], v[1], v[2]);
    }
    const int pressure = CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_OF_PRESSURE].first;
    char text[32];
    const char *spread = clod_prose_deviation(text, mean[pressure], self->deviation[pressure]);
    fprintf(out, "pressure %.4g%s Pa%s\n", mean[pressure], spread,
            spread[0] != '\0' ? " (+- standard deviation of ten blocks)" : "");
}

/** Numbers of one value, an array where it has several. */
static json_t *numbers_json(const double *numbers, const clod_continuum_value *value)
{
    if (value->components == 1) {
        return clod_json_number(numbers[value->first]);
    }
    json_t *array = json_array();
    for (int c = 0; c < value->components; c++) {
        json_array_append_new(array, clod_json_number(numbers[value->first + c]));
    }
    return array;
}

void clod_fields_put_means(json_t *object, const clod_case_field *asked, const double *mean,
                           const double *deviation)
{
    const clod_continuum field = clod_fields_make(asked);
    json_object_set_new(object, "volume_m3", json_real(clod_continuum_volume(&field.region)));
    for (int v = 0; v < CLOD_CONTINUUM_VALUES; v++) {
        const clod_continuum_value *value = &CLOD_CONTINUUM_VALUE[v];
        json_object_set_new(object, value->key,
                            json_pack("{s:o, s:o}", "mean", numbers_json(mean, value),
                                      "deviation", numbers_json(deviation, value)));
    }
}

// ---- the measure

void clod_fields_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    for (size_t k = 0; k < now->from->field_count; k++) {
        const clod_case_field *asked = &now->from->fields[k];
        const clod_continuum field = clod_fields_make(asked);
        const clod_field_memory *mine = clod_fields_memory(memory, k);
        if (asked->cell == 0.0) {
            const means of = means_of(&field, mine);
            report_mean(out, asked->name, &of);
        } else {
            fprintf(out,
                    "  field %-15s %" PRId64 " of %" PRId64
                    " cells have something, mean of %" PRId64 " samples (field_%s.hdf)\n",
                    asked->name,
                    clod_fields_used(&field, clod_fields_grid(memory, now->from, k)),
                    clod_continuum_points(&field), clod_fields_samples(mine), asked->name);
        }
    }
}

void clod_fields_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t f = 0; f < from->field_count; f++) {
        const clod_case_field *asked = &from->fields[f];
        const bool region = asked->cell == 0.0;
        for (int v = 0; region && v < CLOD_CONTINUUM_VALUES; v++) {
            const char *key = CLOD_CONTINUUM_VALUE[v].key;
            const int components = CLOD_CONTINUUM_VALUE[v].components;
            if (components == 1) {
                clod_free_paths_add(paths, asked->name, "%s.mean %s.deviation", key, key);
            } else {
                clod_free_paths_add(paths, asked->name, "%s.mean.[0-%d] %s.deviation.[0-%d]",
                                    key, components - 1, key, components - 1);
            }
        }
        clod_free_paths_add(paths, asked->name, "since_s samples");
        if (region) {
            clod_free_paths_add(paths, asked->name, "volume_m3");
        } else {
            clod_free_paths_add(paths, asked->name,
                                "cells.[0-2] corner_m.[0-2] used_cells cell_m width_m");
        }
    }
}

void clod_fields_put_grid(json_t *object, const void *memory, const clod_case *from,
                          size_t number)
{
    const clod_continuum field = clod_fields_make(&from->fields[number]);
    const int64_t used = clod_fields_used(&field, clod_fields_grid(memory, from, number));
    double corner[3];
    clod_continuum_corner(&field, 0, corner);
    json_object_set_new(object, "cells",
                        json_pack("[III]", (json_int_t)field.cells[0],
                                  (json_int_t)field.cells[1], (json_int_t)field.cells[2]));
    json_object_set_new(object, "corner_m",
                        json_pack("[fff]", corner[0], corner[1], corner[2]));
    json_object_set_new(object, "used_cells", json_integer((json_int_t)used));
    json_object_set_new(object, "cell_m", json_real(field.cell));
    json_object_set_new(object, "width_m", json_real(field.width));
}

json_t *clod_fields_json(const void *memory, const clod_free_moment *now)
{
    json_t *all = json_object();
    for (size_t k = 0; k < now->from->field_count; k++) {
        const clod_case_field *asked = &now->from->fields[k];
        const clod_continuum field = clod_fields_make(asked);
        const clod_field_memory *mine = clod_fields_memory(memory, k);
        json_t *one = json_pack("{s:f, s:I}", "since_s", now->steady.since, "samples",
                                (json_int_t)clod_fields_samples(mine));
        if (asked->cell == 0.0) {
            const means of = means_of(&field, mine);
            clod_fields_put_means(one, asked, of.mean, of.deviation);
        } else {
            clod_fields_put_grid(one, memory, now->from, k);
        }
        json_object_set_new(all, asked->name, one);
    }
    return all;
}
