#include "setup/grains_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/input.h"
#include "base/memory.h"
#include "base/plural.h"
#include "config/unit.h"

typedef enum column {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_RADIUS,
    COLUMN_VX,
    COLUMN_VY,
    COLUMN_VZ,
    COLUMN_WX,
    COLUMN_WY,
    COLUMN_WZ,
    COLUMN_ID,
    COLUMN_MATERIAL,
    COLUMNS,
} column;

static const char *const NAMES[COLUMNS] = {"x",  "y",  "z",  "radius", "vx", "vy",
                                           "vz", "wx", "wy", "wz",     "id", "material"};
static const char *const UNITS[COLUMNS] = {"m",   "m",     "m",     "m",     "m/s", "m/s",
                                           "m/s", "rad/s", "rad/s", "rad/s", "1",   ""};

/** A header as it may stand in a file, for messages. */
#define HEADER "id, x [mm], y [mm], z [mm], radius [mm]"

#define FIELDS_MOST 32

/** A piece of the file between two separators, blanks cut off. */
typedef struct field {
    const char *text;
    size_t length;
} field;

/** What is known of the file while it is read. */
typedef struct reader {
    const clod_case *from;
    const clod_case_grains *group;
    clod_status *status;
    const char *line; ///< start of the line
    size_t line_number;
    field fields[FIELDS_MOST];
    size_t field_count;
    column columns[FIELDS_MOST]; ///< of the header
    double scale[FIELDS_MOST];   ///< to SI
    size_t column_count;
    bool has[COLUMNS];
} reader;

static bool read_fail(const reader *r, field at, const char *problem)
{
    return clod_status_fail(r->status, CLOD_USAGE, "%s:%zu:%td: \"%.*s\": %s", r->group->file,
                            r->line_number, at.text - r->line + 1, (int)at.length, at.text,
                            problem);
}

static field trim(const char *text, size_t length)
{
    while (length > 0 && strchr(" \t\r", text[length - 1]) != NULL) {
        length--;
    }
    while (length > 0 && strchr(" \t", *text) != NULL) {
        text++;
        length--;
    }
    return (field){text, length};
}

static bool split(reader *r, size_t length)
{
    const char *at = r->line;
    size_t left = length;
    r->field_count = 0;
    for (;;) {
        const char *comma = memchr(at, ',', left);
        const size_t here = comma != NULL ? (size_t)(comma - at) : left;
        if (r->field_count == FIELDS_MOST) {
            return read_fail(r, trim(at, here), "too many columns");
        }
        r->fields[r->field_count++] = trim(at, here);
        if (comma == NULL) {
            return true;
        }
        left -= here + 1;
        at = comma + 1;
    }
}

static bool same(field f, const char *word)
{
    return strlen(word) == f.length && memcmp(f.text, word, f.length) == 0;
}

/** Factor to SI of the unit in brackets behind a column's name. */
static bool read_unit(const reader *r, field cell, field unit, column c, double *scale)
{
    char written[32];
    char message[CLOD_UNIT_MESSAGE];
    if (unit.length >= sizeof written || c >= COLUMN_ID) {
        return read_fail(r, cell, "this column takes no such unit");
    }
    memcpy(written, unit.text, unit.length);
    written[unit.length] = '\0';
    return clod_unit_convert(written, UNITS[c], scale, message) || read_fail(r, cell, message);
}

/** A column without brackets: right for an id and a material, for a quantity it is refused. */
static bool accept_bare(const reader *r, field cell, column c)
{
    if (c >= COLUMN_ID) {
        return true;
    }
    char problem[96];
    snprintf(problem, sizeof problem,
             "the unit is missing; write %.*s [%s], or whichever unit the numbers have",
             (int)cell.length, cell.text, c <= COLUMN_RADIUS ? "mm" : UNITS[c]);
    return read_fail(r, cell, problem);
}

static bool read_column(reader *r, size_t f)
{
    const field cell = r->fields[f];
    field name = cell;
    const char *bracket = memchr(cell.text, '[', cell.length);
    if (bracket != NULL) {
        name = trim(cell.text, (size_t)(bracket - cell.text));
    }
    column c = COLUMN_X;
    while (c < COLUMNS && !same(name, NAMES[c]) && !(c == COLUMN_RADIUS && same(name, "r"))) {
        c++;
    }
    if (c == COLUMNS) {
        return read_fail(r, cell,
                         "unknown column; there are x, y, z, radius (or r), and optional id, "
                         "vx, vy, vz, wx, wy, wz, material");
    }
    if (r->has[c]) {
        return read_fail(r, cell, "this column is there twice");
    }
    r->has[c] = true;
    r->columns[f] = c;
    r->scale[f] = 1.0;
    if (bracket == NULL) {
        return accept_bare(r, cell, c);
    }
    if (cell.text[cell.length - 1] != ']') {
        return read_fail(r, cell,
                         "the unit's bracket is not closed; write for instance x [mm]");
    }
    const size_t skip = (size_t)(bracket - cell.text) + 1;
    return read_unit(r, cell, trim(bracket + 1, cell.length - skip - 1), c, &r->scale[f]);
}

static bool read_header(reader *r)
{
    r->column_count = r->field_count;
    for (size_t f = 0; f < r->field_count; f++) {
        if (!read_column(r, f)) {
            return false;
        }
    }
    for (int c = COLUMN_X; c <= COLUMN_RADIUS; c++) {
        if (!r->has[c]) {
            return clod_status_fail(r->status, CLOD_USAGE,
                                    "%s:%zu:1: there is no column \"%s\"", r->group->file,
                                    r->line_number, NAMES[c]);
        }
    }
    if (!r->has[COLUMN_MATERIAL] && r->group->material == NULL) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s:%zu:1: there is no column \"material\", and the group of "
                                "grains names no material either",
                                r->group->file, r->line_number);
    }
    return true;
}

static bool read_number(const reader *r, size_t f, double *value)
{
    char text[64];
    const field cell = r->fields[f];
    if (cell.length == 0 || cell.length >= sizeof text) {
        return read_fail(r, cell, "a number is expected");
    }
    memcpy(text, cell.text, cell.length);
    text[cell.length] = '\0';
    const char *end = clod_unit_number(text, value);
    if (end == NULL || *end != '\0') {
        return read_fail(r, cell, "a number is expected; units belong into the header: x [mm]");
    }
    *value *= r->scale[f];
    return true;
}

static bool read_material(const reader *r, size_t f, int *material)
{
    for (size_t m = 0; m < r->from->material_count; m++) {
        if (same(r->fields[f], r->from->materials[m].name)) {
            *material = (int)m;
            return true;
        }
    }
    return read_fail(r, r->fields[f], "no material of the case has this name");
}

// As the keys of a case allow for radii and places.
#define RADIUS_LEAST 1e-9 ///< m
#define RADIUS_MOST 10.0
#define PLACE_MOST 1e4

/** Largest id that a double holds together with all smaller ones. */
#define ID_MOST 9007199254740992.0

static bool read_row(reader *r, uint64_t *next_id, clod_grains *grains)
{
    const double *v = r->group->velocity;
    double value[COLUMNS] = {[COLUMN_VX] = v[0],
                             [COLUMN_VY] = v[1],
                             [COLUMN_VZ] = v[2],
                             [COLUMN_ID] = (double)*next_id};
    int material =
        r->group->material != NULL ? clod_case_material_index(r->from, r->group->material) : -1;
    if (r->field_count != r->column_count) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s:%zu:1: %zu value%s, but the header has %zu columns",
                                r->group->file, r->line_number, r->field_count,
                                clod_plural((double)r->field_count), r->column_count);
    }
    for (size_t f = 0; f < r->field_count; f++) {
        const column c = r->columns[f];
        if (!(c == COLUMN_MATERIAL ? read_material(r, f, &material)
                                   : read_number(r, f, &value[c]))) {
            return false;
        }
        if (c == COLUMN_RADIUS && !(value[c] >= RADIUS_LEAST && value[c] <= RADIUS_MOST)) {
            return read_fail(r, r->fields[f], "a radius must be from 1 nm to 10 m");
        }
        if (c < COLUMN_RADIUS && !(fabs(value[c]) <= PLACE_MOST)) {
            return read_fail(r, r->fields[f], "a position must be within 10 km of the origin");
        }
        if (c == COLUMN_ID && !(value[c] >= 0.0 && value[c] < ID_MOST &&
                                value[c] == (double)(uint64_t)value[c])) {
            return read_fail(r, r->fields[f], "an id must be a whole number, 0 or more");
        }
    }
    if (material < 0) {
        return clod_status_fail(r->status, CLOD_USAGE, "grains: no material is called \"%s\"",
                                r->group->material);
    }
    const uint64_t id = (uint64_t)value[COLUMN_ID];
    *next_id = id >= *next_id ? id + 1 : *next_id;
    return clod_grains_add(grains, &value[COLUMN_X], &value[COLUMN_VX], &value[COLUMN_WX],
                           r->from->materials[material].density, (uint16_t)material, id,
                           r->status);
}

static bool read_lines(reader *r, const char *text, uint64_t *next_id, clod_grains *grains)
{
    const char *end = text + strlen(text);
    for (r->line = text; r->line < end; r->line_number++) {
        const char *stop = memchr(r->line, '\n', (size_t)(end - r->line));
        stop = stop != NULL ? stop : end;
        const size_t length = (size_t)(stop - r->line);
        const field whole = trim(r->line, length);
        if (whole.length > 0 && whole.text[0] != '#') {
            const bool header = r->column_count == 0;
            if (!split(r, length) ||
                !(header ? read_header(r) : read_row(r, next_id, grains))) {
                return false;
            }
        }
        r->line = stop + 1;
    }
    return r->column_count > 0 || clod_status_fail(r->status, CLOD_USAGE,
                                                   "%s:1:1: the file is empty; its first line "
                                                   "names the columns and their units: " HEADER,
                                                   r->group->file);
}

/** The whole file with a closing 0; owned, NULL with a status. */
static char *load(const char *path, clod_status *status)
{
    char *text;
    size_t size;
    if (!clod_input_read(path, SIZE_MAX, &text, &size, status)) {
        return NULL;
    }
    if (strlen(text) != size) {
        clod_status_fail(status, CLOD_USAGE, "%s: it is no text file", path);
        clod_memory_free(text);
        return NULL;
    }
    return text;
}

bool clod_grains_file_read(const clod_case *from, const clod_case_grains *group,
                           uint64_t *next_id, clod_grains *grains, clod_status *status)
{
    char *text = load(group->file, status);
    if (text == NULL) {
        return false;
    }
    reader r = {.from = from, .group = group, .status = status, .line_number = 1};
    const bool good = read_lines(&r, text + clod_input_mark(text), next_id, grains);
    clod_memory_free(text);
    return good;
}
