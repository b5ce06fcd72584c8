#include "report/series_groups.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

const char *clod_series_groups_quantity(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot != NULL ? dot + 1 : name;
}

/** Whether the texts of a column differ anywhere. */
static bool changes(const clod_table *series, size_t column)
{
    for (size_t r = 1; r < series->rows; r++) {
        if (strcmp(series->cells[r * series->columns + column], series->cells[column]) != 0) {
            return true;
        }
    }
    return false;
}

static bool is_left_out(const clod_table *series, size_t column)
{
    static const char *const OUT[] = {"time", "stage", "phase"};
    for (size_t k = 0; k < sizeof OUT / sizeof *OUT; k++) {
        if (strcmp(series->names[column], OUT[k]) == 0) {
            return true;
        }
    }
    return !changes(series, column);
}

static bool is_of(const clod_series_group *group, const clod_table *series, size_t column)
{
    return strcmp(group->quantity, clod_series_groups_quantity(series->names[column])) == 0 &&
           strcmp(group->unit, series->units[column]) == 0;
}

/** Number of the group of a column, a new one if need be. */
static size_t find_group(clod_series_groups *self, const clod_table *series, size_t column)
{
    size_t g = 0;
    while (g < self->count && !is_of(&self->group[g], series, column)) {
        g++;
    }
    if (g == self->count) {
        self->group[self->count++] =
            (clod_series_group){.quantity = clod_series_groups_quantity(series->names[column]),
                                .unit = series->units[column]};
    }
    return g;
}

bool clod_series_groups_make(clod_series_groups *self, const clod_table *series)
{
    const size_t room = series->columns > 0 ? series->columns : 1;
    *self = (clod_series_groups){.group = clod_memory_alloc(room, sizeof *self->group),
                                 .columns = clod_memory_alloc(room, sizeof(int))};
    if (self->group == NULL || self->columns == NULL) {
        return false;
    }
    for (size_t c = 0; c < series->columns; c++) {
        if (!is_left_out(series, c)) {
            self->group[find_group(self, series, c)].count++;
        }
    }
    int *next = self->columns;
    for (size_t g = 0; g < self->count; g++) {
        clod_series_group *group = &self->group[g];
        group->column = next;
        for (size_t c = 0; c < series->columns; c++) {
            if (is_of(group, series, c) && !is_left_out(series, c)) {
                *next++ = (int)c;
            }
        }
    }
    return true;
}

void clod_series_groups_fini(clod_series_groups *self)
{
    clod_memory_free(self->group);
    clod_memory_free(self->columns);
    *self = (clod_series_groups){0};
}

/** The beginning of a name with blanks for underscores. */
static void copy_words(const char *name, size_t length, char words[CLOD_FIGURE_NAME])
{
    clod_text_fit(words, CLOD_FIGURE_NAME, CLOD_FIGURE_NAME, name, length);
    for (char *at = strchr(words, '_'); at != NULL; at = strchr(at, '_')) {
        *at = ' ';
    }
}

void clod_series_groups_words(const char *name, char words[CLOD_FIGURE_NAME])
{
    copy_words(name, strlen(name), words);
}

void clod_series_groups_object(const char *name, char words[CLOD_FIGURE_NAME])
{
    const char *dot = strrchr(name, '.');
    copy_words(name, dot != NULL ? (size_t)(dot - name) : 0, words);
}

void clod_series_groups_title(const char *quantity, const char *whose,
                              char title[CLOD_SERIES_GROUPS_TITLE])
{
    char words[CLOD_FIGURE_NAME];
    clod_series_groups_words(quantity, words);
    if (words[0] >= 'a' && words[0] <= 'z') {
        words[0] = (char)(words[0] - 'a' + 'A');
    }
    snprintf(title, CLOD_SERIES_GROUPS_TITLE, "%s%s%s", words, whose[0] != '\0' ? ": " : "",
             whose);
}

/** The kind of object whose columns begin like this one, NULL: none that is known. */
static const char *kind_of(const char *name)
{
    static const char *const KINDS[][2] = {
        {"inlet_", "inlets"},     {"outlet_", "outlets"}, {"gauge_", "gauges"},
        {"surface_", "surfaces"}, {"field_", "fields"},   {"left_", "sides of the domain"},
        {"balance", "balance"},   {"clumps", "clumps"}};
    for (size_t k = 0; k < sizeof KINDS / sizeof *KINDS; k++) {
        if (strncmp(name, KINDS[k][0], strlen(KINDS[k][0])) == 0) {
            return KINDS[k][1];
        }
    }
    return NULL;
}

void clod_series_groups_whose(const clod_series_group *group, const clod_table *series,
                              char words[CLOD_FIGURE_NAME])
{
    words[0] = '\0';
    if (group->count == 1) {
        clod_series_groups_object(series->names[group->column[0]], words);
        return;
    }
    const char *kind = group->count > 0 ? kind_of(series->names[group->column[0]]) : NULL;
    for (size_t k = 1; kind != NULL && k < group->count; k++) {
        kind = kind_of(series->names[group->column[k]]) == kind ? kind : NULL;
    }
    if (kind != NULL) {
        snprintf(words, CLOD_FIGURE_NAME, "%s", kind);
    }
}
