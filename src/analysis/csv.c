#include "analysis/csv.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/assert.h"
#include "base/input.h"
#include "base/memory.h"
#include "config/suggest.h"
#include "config/unit.h"

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
static size_t split(char *line, char separator, char *cells[CLOD_CSV_COLUMNS])
{
    size_t count = 0;
    for (char *at = line; at != NULL; count++) {
        char *end = strchr(at, separator);
        if (end != NULL) {
            *end = '\0';
        }
        if (count < CLOD_CSV_COLUMNS) {
            cells[count] = trim(at);
        }
        at = end == NULL ? NULL : end + 1;
    }
    return count;
}

/** Cells of a line without the empty ones behind the `least`-th, which a spreadsheet writes of empty columns. */
static size_t drop_empty(char *const cells[CLOD_CSV_COLUMNS], size_t count, size_t least)
{
    while (count > least && count <= CLOD_CSV_COLUMNS && cells[count - 1][0] == '\0') {
        count--;
    }
    return count;
}

/** Columns of reports that tell nothing of the solid, in small or capital letters. */
static const char *const REMARKS[] = {"point",   "no",      "no.",      "number", "remark",
                                      "remarks", "comment", "comments", "note",   "notes"};

static bool is_skipped(const clod_csv_kind *kind, const char *name)
{
    for (size_t i = 0; i < sizeof REMARKS / sizeof REMARKS[0]; i++) {
        if (strcasecmp(REMARKS[i], name) == 0) {
            return true;
        }
    }
    for (size_t i = 0; kind->skipped != NULL && kind->skipped[i] != NULL; i++) {
        if (strcmp(kind->skipped[i], name) == 0) {
            return true;
        }
    }
    return false;
}

static const clod_csv_column *find_column(const clod_csv_kind *kind, const char *name)
{
    for (size_t i = 0; i < kind->count; i++) {
        for (size_t k = 0; k < 3 && kind->columns[i].names[k] != NULL; k++) {
            if (strcmp(kind->columns[i].names[k], name) == 0) {
                return &kind->columns[i];
            }
        }
    }
    return NULL;
}

const char *clod_csv_stop(const char *text)
{
    const size_t length = strlen(text);
    return length > 0 && text[length - 1] == '?' ? "" : ".";
}

static bool fail_unknown(const clod_csv *self, const char *name)
{
    char hint[64];
    clod_suggest near = clod_suggest_start(name);
    for (size_t i = 0; i < self->kind->count; i++) {
        clod_suggest_offer(&near, self->kind->columns[i].names[0]);
    }
    clod_suggest_text(&near, hint, sizeof hint);
    return clod_status_fail(
        self->status, CLOD_USAGE, "%s:%zu: there is no column \"%.64s\"%s%s Known are %s.",
        self->path, self->line, name, hint, clod_csv_stop(hint), self->kind->known);
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

/** Whether a column has numbers without unit, which may have a fraction; [1] is no unit, [%] is one. */
static bool is_pure(const clod_csv_column *column)
{
    return strcmp(column->unit, "1") == 0;
}

/** Check the unit of a column by converting 1. */
static bool check_unit(const clod_csv *self, const clod_csv_column *column, const char *unit)
{
    if (column->unit[0] == '\0') {
        return unit[0] == '\0' || strcmp(unit, "1") == 0 ||
               clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %s is a number without unit, not in \"%.64s\".",
                                self->path, self->line, column->names[0], unit);
    }
    const char *example = clod_unit_describe(column->unit)->example;
    if (unit[0] == '\0' && !is_pure(column)) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %s has no unit; write it behind the name, for "
                                "instance %s [%s].",
                                self->path, self->line, column->names[0], column->names[0],
                                example);
    }
    char message[CLOD_UNIT_MESSAGE];
    double one = 1.0;
    return clod_unit_convert(unit, column->unit, &one, message) ||
           clod_status_fail(self->status, CLOD_USAGE, "%s:%zu: column %s [%.64s]: %s%s",
                            self->path, self->line, column->names[0], unit, message,
                            clod_csv_stop(message));
}

bool clod_csv_has(const clod_csv *self, size_t column)
{
    for (size_t c = 0; c < self->width; c++) {
        if (self->column[c] == &self->kind->columns[column]) {
            return true;
        }
    }
    return false;
}

static bool check_header(const clod_csv *self)
{
    const clod_csv_kind *kind = self->kind;
    for (size_t i = 0; i < kind->count; i++) {
        if (kind->columns[i].required && !clod_csv_has(self, i)) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: the header has no column %s. It may look like: %s",
                                    self->path, self->line, kind->columns[i].names[0],
                                    kind->example);
        }
    }
    return kind->check_header == NULL || kind->check_header(self);
}

/** What the cell of a header says; one that is skipped has neither column nor unit. */
static bool read_name(clod_csv *self, char *cell)
{
    const char *unit = cut_unit(cell);
    const clod_csv_column *column = find_column(self->kind, cell);
    if (cell[0] == '\0') {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %zu of the header has no name; give it one, or "
                                "remove the column.",
                                self->path, self->line, self->width + 1);
    }
    if (column == NULL) {
        if (!is_skipped(self->kind, cell)) {
            return fail_unknown(self, cell);
        }
    } else if (clod_csv_has(self, (size_t)(column - self->kind->columns))) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: column %s is there twice; keep one.", self->path,
                                self->line, column->names[0]);
    } else {
        unit = is_pure(column) && strcmp(unit, "1") == 0 ? "" : unit;
        if (!check_unit(self, column, unit)) {
            return false;
        }
    }
    self->column[self->width] = column;
    self->unit[self->width++] = unit;
    return true;
}

static bool read_header(clod_csv *self, char *line)
{
    self->separator = ',';
    if (strchr(line, ';') != NULL) {
        self->separator = ';';
    } else if (strchr(line, '\t') != NULL) {
        self->separator = '\t';
    }
    char *cells[CLOD_CSV_COLUMNS];
    const size_t width = drop_empty(cells, split(line, self->separator, cells), 1);
    if (width > CLOD_CSV_COLUMNS) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: %zu columns are more than %d; is this a file of %ss?",
                                self->path, self->line, width, CLOD_CSV_COLUMNS,
                                self->kind->item);
    }
    for (size_t c = 0; c < width; c++) {
        if (!read_name(self, cells[c])) {
            return false;
        }
    }
    return check_header(self);
}

bool clod_csv_fail(const clod_csv *self, const clod_csv_column *column, const char *cell,
                   const char *fault)
{
    return clod_status_fail(self->status, CLOD_USAGE, "%s:%zu: column %s: \"%.64s\" %s",
                            self->path, self->line, column->names[0], cell, fault);
}

static bool read_whole(const clod_csv *self, const clod_csv_column *column, const char *cell,
                       char *row)
{
    const size_t digits = strspn(cell, "0123456789");
    if (digits == 0 || digits > 18 || cell[digits] != '\0') {
        return clod_csv_fail(self, column, cell, "is not a whole number, 0 or more.");
    }
    const int64_t value = strtoll(cell, NULL, 10);
    memcpy(row + column->offset, &value, sizeof value);
    return true;
}

/** Whether a value, in the unit of its column, is allowed. */
static bool check_range(const clod_csv *self, const clod_csv_column *column, const char *cell,
                        double value, double si)
{
    char fault[96];
    if (column->most > 0.0 && (si < column->least || si > column->most)) {
        snprintf(fault, sizeof fault, "must be %.6g to %.6g.", column->least, column->most);
        return clod_csv_fail(self, column, cell, fault);
    }
    if (si < column->least || (column->positive && value == 0.0)) {
        return clod_csv_fail(self, column, cell,
                             column->positive ? "must be above 0." : "must be 0 or more.");
    }
    if (column->below > 0.0 && si >= column->below) {
        snprintf(fault, sizeof fault, "must be below %.6g in the unit of the column.",
                 value / si * column->below);
        return clod_csv_fail(self, column, cell, fault);
    }
    return true;
}

static bool read_cell(clod_csv *self, size_t c, const char *cell, char *row)
{
    const clod_csv_column *column = self->column[c];
    if (column == NULL) {
        return true;
    }
    if (cell[0] == '\0') {
        self->gap[column - self->kind->columns] = true;
        return !column->required ||
               clod_csv_fail(self, column, cell,
                             "is empty; every row needs it, or delete the row.");
    }
    if (column->unit[0] == '\0') {
        return read_whole(self, column, cell, row);
    }
    double value;
    const char *rest = clod_unit_number(cell, &value);
    if (rest == NULL || *rest != '\0') {
        const bool comma = rest != NULL && *rest == ',';
        return clod_csv_fail(self, column, cell,
                             comma ? "has a decimal comma; write a point."
                                   : "is not a number; units stand in the header only.");
    }
    double si = value;
    char message[CLOD_UNIT_MESSAGE];
    if (!clod_unit_convert(self->unit[c], column->unit, &si, message)) {
        return clod_csv_fail(self, column, cell, message);
    }
    if (!check_range(self, column, cell, value, si)) {
        return false;
    }
    memcpy(row + column->offset, &si, sizeof si);
    return true;
}

/** Room for one more row; its bytes, or NULL. */
static char *add_row(clod_csv *self)
{
    if (self->count == self->capacity) {
        const size_t capacity = self->capacity == 0 ? 64 : 2 * self->capacity;
        void *grown = clod_memory_grow(self->rows, self->count, capacity, self->kind->row);
        if (grown == NULL) {
            clod_status_fail(self->status, CLOD_FAILED, "No memory for %zu points.", capacity);
            return NULL;
        }
        self->rows = grown;
        self->capacity = capacity;
    }
    char *row = (char *)self->rows + self->count++ * self->kind->row;
    if (self->first != NULL) {
        memcpy(row, self->first, self->kind->row);
    }
    return row;
}

static bool read_row(clod_csv *self, char *line)
{
    char *cells[CLOD_CSV_COLUMNS];
    const size_t width = drop_empty(cells, split(line, self->separator, cells), self->width);
    if (width != self->width) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s:%zu: %zu cell%s, but the header has %zu column%s.",
                                self->path, self->line, width, width == 1 ? "" : "s",
                                self->width, self->width == 1 ? "" : "s");
    }
    char *row = add_row(self);
    if (row == NULL) {
        return false;
    }
    if (self->kind->line != NULL) {
        memcpy(row + *self->kind->line, &self->line, sizeof self->line);
    }
    for (size_t c = 0; c < width; c++) {
        if (!read_cell(self, c, cells[c], row)) {
            return false;
        }
    }
    return self->kind->check_row == NULL || self->kind->check_row(self, row);
}

static bool read_lines(clod_csv *self, char *text)
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
                                self->path, self->width == 0 ? "header" : self->kind->item);
    }
    return true;
}

bool clod_csv_parse(clod_csv *self, const char *text, size_t length)
{
    CLOD_ASSERT(self->kind->count <= CLOD_CSV_KINDS);
    if (memchr(text, '\0', length) != NULL) {
        return clod_status_fail(self->status, CLOD_USAGE,
                                "%s: this is no text file; save the table as CSV.", self->path);
    }
    char *copy = clod_memory_alloc(length + 1, 1);
    if (copy == NULL) {
        return clod_status_fail(self->status, CLOD_FAILED, "No memory for %zu bytes.", length);
    }
    memcpy(copy, text, length);
    const bool done = read_lines(self, copy + clod_input_mark(copy));
    clod_memory_free(copy);
    if (!done) {
        clod_memory_free(self->rows);
        self->rows = NULL;
        self->count = 0;
    }
    return done;
}
