/**
 * @file points.c
 * Shear points from a CSV file, simulated or measured, with units in its header.
 */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/locus.h"
#include "config/suggest.h"
#include "config/unit.h"

#define MOST_COLUMNS 64

/** What a column means. */
typedef struct column {
    const char *names[3]; ///< the first is the name in messages
    const char *unit;     ///< SI; "" for a whole number
    bool positive;        ///< 0 is not allowed
    bool required;
    size_t offset; ///< of the double in clod_locus_point
} column;

enum { SEED, SIGMA_PRE, TAU_PRE, SIGMA_SH, TAU_SH, COLUMN_COUNT = 9 };

static const column COLUMNS[COLUMN_COUNT] = {
    [SEED] = {{"seed"}, "", false, false, offsetof(clod_locus_point, seed)},
    [SIGMA_PRE] =
        {{"sigma_pre", "sigma_p"}, "Pa", true, false, offsetof(clod_locus_point, sigma_p)},
    [TAU_PRE] = {{"tau_pre", "tau_p"}, "Pa", true, false, offsetof(clod_locus_point, tau_p)},
    [SIGMA_SH] = {{"sigma_sh", "sigma_s", "sigma"},
                  "Pa",
                  false,
                  true,
                  offsetof(clod_locus_point, sigma_s)},
    [TAU_SH] =
        {{"tau_sh", "tau_s", "tau"}, "Pa", false, true, offsetof(clod_locus_point, tau_s)},
    {{"rho_b", "rho"}, "kg/m3", true, false, offsetof(clod_locus_point, rho_b)},
    {{"tau_pre_error"}, "Pa", false, false, offsetof(clod_locus_point, tau_p_error)},
    {{"tau_sh_error"}, "Pa", false, false, offsetof(clod_locus_point, tau_s_error)},
    {{"rho_b_error"}, "kg/m3", false, false, offsetof(clod_locus_point, rho_b_error)},
};

/** A file that is being read. */
typedef struct reader {
    const char *path;
    size_t line; ///< number of the line at hand
    char separator;
    size_t width;                     ///< columns in the header
    const column *kind[MOST_COLUMNS]; ///< of each
    const char *unit[MOST_COLUMNS];   ///< as written in the header
    double sigma_p, tau_p;            ///< defaults, 0 = none
    bool gap[COLUMN_COUNT];           ///< whether a cell of this column is empty in some row
    clod_locus_point *points;         ///< owned
    size_t count, capacity;
    clod_status *status;
} reader;

/** Cut blanks, and one pair of quotes, off a text. */
static char *trim(char *text)
{
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t\r", text[length - 1]) != NULL) {
        text[--length] = '\0';
    }
    if (length > 1 && text[0] == '"' && text[length - 1] == '"') {
        text[length - 1] = '\0';
        return trim(text + 1);
    }
    return text;
}

/** Cut a line at its separators; the number of cells, all of them counted. */
static size_t split(char *line, char separator, char *cells[MOST_COLUMNS])
{
    size_t count = 0;
    for (char *at = line; at != NULL; count++) {
        char *end = strchr(at, separator);
        if (end != NULL) {
            *end = '\0';
        }
        if (count < MOST_COLUMNS) {
            cells[count] = trim(at);
        }
        at = end == NULL ? NULL : end + 1;
    }
    return count;
}

static const column *find_column(const char *name)
{
    for (size_t i = 0; i < COLUMN_COUNT; i++) {
        for (size_t k = 0; k < 3 && COLUMNS[i].names[k] != NULL; k++) {
            if (strcmp(COLUMNS[i].names[k], name) == 0) {
                return &COLUMNS[i];
            }
        }
    }
    return NULL;
}

/** What ends a sentence behind a text that may be a question already. */
static const char *full_stop(const char *text)
{
    const size_t length = strlen(text);
    return length > 0 && text[length - 1] == '?' ? "" : ".";
}

static bool fail_unknown(const reader *self, const char *name)
{
    char hint[64];
    clod_suggest near = clod_suggest_start(name);
    for (size_t i = 0; i < COLUMN_COUNT; i++) {
        clod_suggest_offer(&near, COLUMNS[i].names[0]);
    }
    clod_suggest_text(&near, hint, sizeof hint);
    return clod_status_fail(
        self->status, CLOD_USAGE,
        "%s:%zu: there is no column \"%.64s\"%s%s Known are sigma_sh, tau_sh, sigma_pre, "
        "tau_pre, seed, rho_b, tau_pre_error, tau_sh_error, rho_b_error.",
        self->path, self->line, name, hint, full_stop(hint));
}

/** "sigma_pre [kPa]" or "sigma_pre (kPa)": cut off the unit, "" when there is none. */
static const char *cut_unit(char *cell)
{
    char *open = strpbrk(cell, "[(");
    if (open == NULL) {
        return "";
    }
    char *close = strpbrk(open, "])");
    if (close != NULL) {
        *close = '\0';
    }
    *open = '\0';
    trim(cell);
    return trim(open + 1);
}

/** Check the unit of a column by converting 1. */
static bool check_unit(const reader *self, const column *kind, const char *unit)
{
    if (kind->unit[0] == '\0') {
        return unit[0] == '\0' ||
               clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %s is a number without unit, not in \"%.64s\".",
                                self->path, self->line, kind->names[0], unit);
    }
    const char *example = clod_unit_describe(kind->unit)->example;
    if (unit[0] == '\0') {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %s has no unit; write it behind the name, for "
                                "instance %s [%s].",
                                self->path, self->line, kind->names[0], kind->names[0],
                                example);
    }
    char message[CLOD_UNIT_MESSAGE];
    double one = 1.0;
    return clod_unit_convert(unit, kind->unit, &one, message) ||
           clod_status_fail(self->status, CLOD_USAGE, "%s:%zu: column %s [%.64s]: %s%s",
                            self->path, self->line, kind->names[0], unit, message,
                            full_stop(message));
}

static bool has_column(const reader *self, size_t index)
{
    for (size_t c = 0; c < self->width; c++) {
        if (self->kind[c] == &COLUMNS[index]) {
            return true;
        }
    }
    return false;
}

/** The option of `clod locus` that gives a column's value to all rows. */
static const char *option_of(size_t index)
{
    return index == SIGMA_PRE ? "sigma-pre" : "tau-pre";
}

static bool check_header(const reader *self)
{
    for (size_t i = 0; i < COLUMN_COUNT; i++) {
        if (COLUMNS[i].required && !has_column(self, i)) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: the header has no column %s. It may look like: "
                                    "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]",
                                    self->path, self->line, COLUMNS[i].names[0]);
        }
    }
    const double defaults[] = {[SIGMA_PRE] = self->sigma_p, [TAU_PRE] = self->tau_p};
    for (size_t i = SIGMA_PRE; i <= TAU_PRE; i++) {
        if (!has_column(self, i) && defaults[i] == 0.0) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: the header has no column %s and no value for all "
                                    "rows was given; add the column, or give --%s.",
                                    self->path, self->line, COLUMNS[i].names[0], option_of(i));
        }
    }
    return true;
}

static bool read_header(reader *self, char *line)
{
    self->separator = ',';
    if (strchr(line, ';') != NULL) {
        self->separator = ';';
    } else if (strchr(line, '\t') != NULL) {
        self->separator = '\t';
    }
    char *cells[MOST_COLUMNS];
    const size_t width = split(line, self->separator, cells);
    if (width > MOST_COLUMNS) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: %zu columns are more than %d; is this a file of shear "
                                "points?",
                                self->path, self->line, width, MOST_COLUMNS);
    }
    for (size_t c = 0; c < width; c++) {
        const char *unit = cut_unit(cells[c]);
        const column *kind = find_column(cells[c]);
        if (kind == NULL) {
            return fail_unknown(self, cells[c]);
        }
        if (has_column(self, (size_t)(kind - COLUMNS))) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: column %s is there twice; keep one.", self->path,
                                    self->line, kind->names[0]);
        }
        if (!check_unit(self, kind, unit)) {
            return false;
        }
        self->kind[c] = kind;
        self->unit[c] = unit;
        self->width = c + 1;
    }
    return check_header(self);
}

/** Record what is wrong with a cell, with its place and value. */
static bool fail_cell(const reader *self, const column *kind, const char *cell,
                      const char *fault)
{
    return clod_status_fail(self->status, CLOD_USAGE, "%s:%zu: column %s: \"%.64s\" %s",
                            self->path, self->line, kind->names[0], cell, fault);
}

static bool read_seed(const reader *self, const char *cell, clod_locus_point *point)
{
    const size_t digits = strspn(cell, "0123456789");
    if (digits == 0 || digits > 18 || cell[digits] != '\0') {
        return fail_cell(self, &COLUMNS[SEED], cell, "is not a whole number, 0 or more.");
    }
    point->seed = strtoll(cell, NULL, 10);
    return true;
}

static bool read_cell(reader *self, size_t c, const char *cell, clod_locus_point *point)
{
    const column *kind = self->kind[c];
    if (cell[0] == '\0') {
        self->gap[kind - COLUMNS] = true;
        return !kind->required ||
               fail_cell(self, kind, cell, "is empty; every row needs it, or delete the row.");
    }
    if (kind == &COLUMNS[SEED]) {
        return read_seed(self, cell, point);
    }
    double value;
    const char *rest = clod_unit_number(cell, &value);
    if (rest == NULL || *rest != '\0') {
        const bool comma = rest != NULL && *rest == ',';
        return fail_cell(self, kind, cell,
                         comma ? "has a decimal comma; write a point."
                               : "is not a number; units stand in the header only.");
    }
    if (value < 0.0 || (kind->positive && value == 0.0)) {
        return fail_cell(self, kind, cell,
                         kind->positive ? "must be above 0." : "must be 0 or more.");
    }
    char message[CLOD_UNIT_MESSAGE];
    if (!clod_unit_convert(self->unit[c], kind->unit, &value, message)) {
        return fail_cell(self, kind, cell, message);
    }
    memcpy((char *)point + kind->offset, &value, sizeof value);
    return true;
}

static bool add_point(reader *self, const clod_locus_point *point)
{
    if (self->count == self->capacity) {
        const size_t capacity = self->capacity == 0 ? 64 : 2 * self->capacity;
        clod_locus_point *grown =
            clod_memory_grow(self->points, self->count, capacity, sizeof *grown);
        if (grown == NULL) {
            return clod_status_fail(self->status, CLOD_FAILED, "No memory for %zu points.",
                                    capacity);
        }
        self->points = grown;
        self->capacity = capacity;
    }
    self->points[self->count++] = *point;
    return true;
}

static bool read_row(reader *self, char *line)
{
    char *cells[MOST_COLUMNS];
    const size_t width = split(line, self->separator, cells);
    if (width != self->width) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: %zu cell%s, but the header has %zu column%s.",
                                self->path, self->line, width, width == 1 ? "" : "s",
                                self->width, self->width == 1 ? "" : "s");
    }
    clod_locus_point point = {.sigma_p = self->sigma_p, .tau_p = self->tau_p};
    for (size_t c = 0; c < width; c++) {
        if (!read_cell(self, c, cells[c], &point)) {
            return false;
        }
    }
    if (point.sigma_p == 0.0 || point.tau_p == 0.0) {
        const bool sigma = point.sigma_p == 0.0;
        return fail_cell(self, &COLUMNS[sigma ? SIGMA_PRE : TAU_PRE], "",
                         sigma ? "is empty; fill it in, or give --sigma-pre."
                               : "is empty; fill it in, or give --tau-pre.");
    }
    return add_point(self, &point);
}

static bool read_lines(reader *self, char *text)
{
    for (char *line = text; line != NULL;) {
        char *end = strchr(line, '\n');
        if (end != NULL) {
            *end = '\0';
        }
        self->line++;
        const size_t blank = strspn(line, " \t\r");
        const bool content = line[blank] != '\0' && line[blank] != '#';
        if (content && !(self->width == 0 ? read_header(self, line) : read_row(self, line))) {
            return false;
        }
        line = end == NULL ? NULL : end + 1;
    }
    if (self->count == 0) {
        return clod_status_fail(self->status, CLOD_USAGE, "%s: there is no %s in it.",
                                self->path, self->width == 0 ? "header" : "shear point");
    }
    return true;
}

/** A default that no row needs is a mistake: the column would silently win. */
static bool check_defaults(const reader *self, const clod_locus_defaults *defaults)
{
    const char *const given[] = {
        [SIGMA_PRE] = defaults->sigma_pre, [TAU_PRE] = defaults->tau_pre};
    for (size_t i = SIGMA_PRE; i <= TAU_PRE; i++) {
        if (given[i] != NULL && has_column(self, i) && !self->gap[i]) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s: column %s has a value in every row, so --%s=\"%.64s\" "
                                    "would change nothing; leave the option out, or remove the "
                                    "column.",
                                    self->path, COLUMNS[i].names[0], option_of(i), given[i]);
        }
    }
    return true;
}

/** A default such as "54.8 kPa"; NULL gives 0. */
static bool read_default(const char *text, size_t index, double *value, clod_status *status)
{
    *value = 0.0;
    if (text == NULL) {
        return true;
    }
    char message[CLOD_UNIT_MESSAGE] = "is not a number with a unit, such as 54.8 kPa";
    const char *unit = clod_unit_number(text, value);
    if (unit == NULL || !clod_unit_convert(unit, "Pa", value, message)) {
        return clod_status_fail(status, CLOD_USAGE, "%s for all rows, \"%.64s\": %s%s",
                                COLUMNS[index].names[0], text, message, full_stop(message));
    }
    return *value > 0.0 ||
           clod_status_fail(status, CLOD_USAGE, "%s for all rows, \"%.64s\": must be above 0.",
                            COLUMNS[index].names[0], text);
}

bool clod_locus_parse(const char *path, const char *text, size_t length,
                      const clod_locus_defaults *defaults, clod_locus_point **points,
                      size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    const clod_locus_defaults given = defaults != NULL ? *defaults : (clod_locus_defaults){0};
    *points = NULL;
    *count = 0;
    reader self = {.path = path, .status = status};
    if (!read_default(given.sigma_pre, SIGMA_PRE, &self.sigma_p, status) ||
        !read_default(given.tau_pre, TAU_PRE, &self.tau_p, status)) {
        return false;
    }
    if (memchr(text, '\0', length) != NULL) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: this is no text file; save the table as CSV.", path);
    }
    char *copy = clod_memory_alloc(length + 1, 1);
    if (copy == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu bytes.", length);
    }
    memcpy(copy, text, length);
    const bool done =
        read_lines(&self, copy + clod_input_mark(copy)) && check_defaults(&self, &given);
    clod_memory_free(copy);
    if (!done) {
        clod_memory_free(self.points);
        return false;
    }
    *points = self.points;
    *count = self.count;
    return true;
}

bool clod_locus_read(const char *path, const clod_locus_defaults *defaults,
                     clod_locus_point **points, size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    *points = NULL;
    *count = 0;
    char *text;
    size_t size;
    const bool standard = strcmp(path, "-") == 0;
    if (!clod_input_read(standard ? NULL : path, SIZE_MAX, &text, &size, status)) {
        return false;
    }
    const bool done = clod_locus_parse(standard ? CLOD_INPUT_STANDARD : path, text, size,
                                       defaults, points, count, status);
    clod_memory_free(text);
    return done;
}
