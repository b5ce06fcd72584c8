#include "picture/channel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "picture/scene.h"

#define SAMPLE 400000 ///< values of all frames at most
#define FEWEST 2000   ///< of a frame

/** Whether the numbers are names: materials. */
static bool has_kinds(const clod_channel *self)
{
    return self->field != NULL && strcmp(self->field, "type") == 0;
}

static bool note(clod_channel *self, double value)
{
    if (self->count == self->capacity) {
        const size_t more = 2 * self->capacity + 1024;
        double *grown =
            clod_memory_grow(self->sample, self->capacity, more, sizeof *self->sample);
        if (grown == NULL) {
            return false;
        }
        self->sample = grown;
        self->capacity = more;
    }
    self->sample[self->count++] = value;
    return true;
}

bool clod_channel_add(clod_channel *self, const clod_vtkhdf *file, size_t frames,
                      clod_status *status)
{
    clod_field field;
    bool good = clod_field_read(&field, file, self->place, self->field, status);
    const double most = fmax(FEWEST, (double)SAMPLE / (double)frames);
    const size_t every = 1 + (size_t)((double)field.count / most);
    if (self->count == 0) {
        self->low = HUGE_VAL;
        self->high = -HUGE_VAL;
        snprintf(self->units, sizeof self->units, "%s", field.units);
        snprintf(self->bar.axis.title, sizeof self->bar.axis.title, "%s", field.title);
    }
    for (size_t k = 0; good && k < field.count; k++) {
        const double value = field.value[k];
        self->low = fmin(self->low, value);
        self->high = fmax(self->high, value);
        if (has_kinds(self) && value >= 0.0 && value < CLOD_CHANNEL_KINDS) {
            self->used[(int)value] = true;
        }
        if (k % every == 0 && isfinite(value) && !note(self, value)) {
            good = clod_status_fail(status, CLOD_FAILED, "No memory for the colours.");
        }
    }
    clod_field_fini(&field);
    return good;
}

static void list_kinds(clod_channel *self, const clod_film *film)
{
    for (size_t k = 0; k < CLOD_CHANNEL_KINDS; k++) {
        if (self->used[k]) {
            const char *name = clod_film_material_name(film, k);
            snprintf(self->text[k], sizeof self->text[k], "%zu", k);
            self->name[self->bar.kinds] = name != NULL ? name : self->text[k];
            clod_colour_map_kind(k, self->colour[self->bar.kinds++]);
        }
    }
    for (size_t k = 0; k < CLOD_COLOUR_MAP_SIZE; k++) {
        clod_colour_map_kind(k % CLOD_CHANNEL_KINDS, self->bar.map.colour[k]);
    }
    self->bar.name = self->name;
    self->bar.colour = self->colour;
    snprintf(self->bar.axis.title, sizeof self->bar.axis.title, "material");
}

bool clod_channel_settle(clod_channel *self, const double *range, const char *map,
                         const clod_film *film, clod_status *status)
{
    double min, max;
    if (range != NULL) {
        min = range[0];
        max = range[1];
    } else {
        clod_axis_range(self->sample, self->count, &min, &max);
    }
    char title[96];
    snprintf(title, sizeof title, "%.95s", self->bar.axis.title);
    clod_axis_make(&self->bar.axis, min, max, title, self->units);
    self->bar.below = self->low < min;
    self->bar.above = self->high > max;
    const char *usual = self->place == CLOD_VTKHDF_CELLS ? "ember" : "sea";
    usual = min == -max ? "balance" : usual;
    const bool good = clod_colour_map_make(&self->bar.map, map != NULL ? map : usual, status);
    if (good && has_kinds(self)) {
        list_kinds(self, film);
    }
    return good;
}

int clod_channel_colour(const clod_channel *self, double value)
{
    if (isnan(value)) {
        return CLOD_SCENE_NONE;
    }
    const int first = self->place == CLOD_VTKHDF_CELLS ? CLOD_SCENE_WALL : CLOD_SCENE_GRAIN;
    if (has_kinds(self)) {
        return first + (int)fmin(fmax(value, 0.0), CLOD_CHANNEL_KINDS - 1);
    }
    return first + clod_colour_map_index(value, self->bar.axis.min, self->bar.axis.max);
}

void clod_channel_fini(clod_channel *self)
{
    clod_memory_free(self->sample);
    self->sample = NULL;
    self->count = self->capacity = 0;
}
