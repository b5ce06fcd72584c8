#include "picture/field.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

static const char *const AXES[] = {"x", "y", "z"};

/** Suffix of component k of a column with so many. */
static void name_component(char suffix[16], size_t components, size_t k)
{
    if (components == 3) {
        snprintf(suffix, 16, "%s", AXES[k]);
    } else {
        snprintf(suffix, 16, "%zu", k + 1);
    }
}

/** A column is to be read, and what of it. */
typedef struct request {
    const clod_vtkhdf *file;
    clod_vtkhdf_place place;
    const clod_vtkhdf_column *column;
    int component; ///< -1: the number itself, or the magnitude of several
} request;

/** Find the column that a name means; false: none. */
static bool find_column(request *self, const char *name)
{
    self->component = -1;
    self->column = clod_vtkhdf_find(self->file, self->place, name);
    for (size_t c = 0; self->column == NULL && c < self->file->column_count[self->place]; c++) {
        const clod_vtkhdf_column *column = &self->file->columns[self->place][c];
        for (size_t k = 0; column->components > 1 && k < column->components; k++) {
            char suffix[16], whole[96];
            name_component(suffix, column->components, k);
            snprintf(whole, sizeof whole, "%s_%s", column->name, suffix);
            if (strcmp(whole, name) == 0) {
                self->column = column;
                self->component = (int)k;
            }
        }
    }
    return self->column != NULL;
}

/** Add a name to a list of them. */
static void add_name(char *list, size_t size, const char *name, const char *more)
{
    const size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s%s", used > 0 ? ", " : "", name, more);
}

static bool has(const clod_vtkhdf *file, clod_vtkhdf_place place, const char *name)
{
    return clod_vtkhdf_find(file, place, name) != NULL;
}

static bool fail_unknown(const clod_vtkhdf *file, clod_vtkhdf_place place, const char *name,
                         clod_status *status)
{
    char list[4096] = "";
    for (size_t c = 0; c < file->column_count[place]; c++) {
        const clod_vtkhdf_column *column = &file->columns[place][c];
        add_name(list, sizeof list, column->name,
                 column->components == 3  ? " (_x, _y, _z)"
                 : column->components > 1 ? " (_1, _2 ...)"
                                          : "");
    }
    if (has(file, place, "velocity")) {
        add_name(list, sizeof list, "speed", "");
    }
    if (place == CLOD_VTKHDF_POINTS && has(file, place, "birth")) {
        add_name(list, sizeof list, "age", "");
    }
    if (place == CLOD_VTKHDF_POINTS && has(file, place, "velocity") &&
        has(file, place, "mass")) {
        add_name(list, sizeof list, "kinetic_energy", "");
    }
    return clod_status_fail(status, CLOD_USAGE, "%s: %s have no field %s. Fields: %s.",
                            file->path, place == CLOD_VTKHDF_POINTS ? "grains" : "walls", name,
                            list);
}

/** Owned numbers, one of each row, as a request says. */
static double *read_numbers(const request *self, clod_status *status)
{
    const size_t rows = self->file->rows[self->place];
    const size_t width = self->column->components;
    double *value = clod_vtkhdf_read(self->file, self->place, self->column, status);
    for (size_t r = 0; value != NULL && width > 1 && r < rows; r++) {
        double square = 0.0;
        for (size_t k = 0; k < width; k++) {
            square += value[r * width + k] * value[r * width + k];
        }
        value[r] =
            self->component < 0 ? sqrt(square) : value[r * width + (size_t)self->component];
    }
    return value;
}

/** Owned numbers of the field `name`, or NULL. */
static double *read_named(const clod_vtkhdf *file, clod_vtkhdf_place place, const char *name,
                          clod_status *status)
{
    request one = {.file = file, .place = place};
    if (!find_column(&one, name)) {
        fail_unknown(file, place, name, status);
        return NULL;
    }
    return read_numbers(&one, status);
}

/** Seconds since a grain came in. */
static bool make_age(clod_field *self, const clod_vtkhdf *file, clod_status *status)
{
    self->value = read_named(file, CLOD_VTKHDF_POINTS, "birth", status);
    for (size_t r = 0; self->value != NULL && r < self->count; r++) {
        self->value[r] = file->time - self->value[r];
    }
    return self->value != NULL;
}

/** m v^2 / 2 + I omega^2 / 2 of solid spheres, I = 2/5 m R^2. */
static bool make_kinetic_energy(clod_field *self, const clod_vtkhdf *file, clod_status *status)
{
    static const char *const NEED[] = {"mass", "velocity", "radius", "omega"};
    double *part[4] = {NULL, NULL, NULL, NULL};
    bool good = true;
    for (int k = 0; k < 4 && good; k++) {
        part[k] = read_named(file, CLOD_VTKHDF_POINTS, NEED[k], status);
        good = part[k] != NULL;
    }
    for (size_t r = 0; good && r < self->count; r++) {
        const double turning = part[2][r] * part[3][r];
        part[0][r] *= 0.5 * part[1][r] * part[1][r] + 0.2 * turning * turning;
    }
    for (int k = good ? 1 : 0; k < 4; k++) {
        clod_memory_free(part[k]);
    }
    self->value = good ? part[0] : NULL;
    return good;
}

static bool make_speed(clod_field *self, const clod_vtkhdf *file, clod_status *status)
{
    self->value = read_named(file, CLOD_VTKHDF_POINTS, "velocity", status);
    return self->value != NULL;
}

/** Quantities of grains that follow from columns. */
static const struct {
    const char *name, *units;
    bool (*make)(clod_field *self, const clod_vtkhdf *file, clod_status *status);
} DERIVED[] = {
    {"speed", "m s-1", make_speed},
    {"age", "s", make_age},
    {"kinetic_energy", "J", make_kinetic_energy},
};

/** What a field is called in a picture. */
static void make_title(clod_field *self, const request *of, const char *name)
{
    snprintf(self->title, sizeof self->title, "%s", name);
    if (of->column != NULL && of->component >= 0) {
        char suffix[16];
        name_component(suffix, of->column->components, (size_t)of->component);
        snprintf(self->title, sizeof self->title, "%s %s", of->column->name, suffix);
    }
    for (char *at = self->title; *at != '\0'; at++) {
        if (*at == '_') {
            *at = ' ';
        }
    }
}

bool clod_field_read(clod_field *self, const clod_vtkhdf *file, clod_vtkhdf_place place,
                     const char *name, clod_status *status)
{
    *self = (clod_field){.count = file->rows[place]};
    request one = {.file = file, .place = place};
    if (find_column(&one, name)) {
        self->value = read_numbers(&one, status);
        snprintf(self->units, sizeof self->units, "%s", one.column->units);
        make_title(self, &one, name);
        return self->value != NULL;
    }
    make_title(self, &one, name);
    for (size_t k = 0; place == CLOD_VTKHDF_POINTS && k < sizeof DERIVED / sizeof *DERIVED;
         k++) {
        if (strcmp(DERIVED[k].name, name) == 0) {
            snprintf(self->units, sizeof self->units, "%s", DERIVED[k].units);
            return DERIVED[k].make(self, file, status);
        }
    }
    if (place == CLOD_VTKHDF_CELLS && strcmp(name, "speed") == 0 &&
        has(file, place, "velocity")) {
        self->value = read_named(file, place, "velocity", status);
        snprintf(self->units, sizeof self->units, "m s-1");
        return self->value != NULL;
    }
    return fail_unknown(file, place, name, status);
}

void clod_field_fini(clod_field *self)
{
    clod_memory_free(self->value);
    *self = (clod_field){0};
}
