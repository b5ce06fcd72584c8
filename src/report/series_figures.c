#include "report/series_figures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/series_groups.h"

/** Quantities that are shown first, in this order. */
static const char *const MAIN[] = {"kinetic_energy", "max_speed",  "grains",  "mass",
                                   "mass_flow",      "speed",      "power",   "force_z",
                                   "resting_mass",   "mass_share", "largest", "impact_power",
                                   "density",        "pressure",   "lacey",   "repose_angle"};
#define MAIN_COUNT (sizeof MAIN / sizeof MAIN[0])

/** The x axis of figures, and its numbers from row `first` on. */
typedef struct over {
    clod_figure_axis axis;
    double *x; ///< [rows] owned; NULL: no such column, or no memory
    size_t first;
} over;

static over over_time(const clod_table *series)
{
    over self = {.first = 0};
    const int at = clod_table_find(series, "time");
    clod_figure_axis_set(&self.axis, "time", "s", 1.0);
    self.x = at >= 0 ? clod_table_numbers(series, at) : NULL;
    return self;
}

/** The way of a test from where it begins; its time where it has none. */
static over over_way(const clod_table *part)
{
    static const struct {
        const char *column, *unit;
        double factor;
    } WAYS[] = {{"displacement", "mm", 1e3}, {"strain", "%", 100.0}};
    for (size_t k = 0; k < sizeof WAYS / sizeof *WAYS; k++) {
        const int at = clod_table_find(part, WAYS[k].column);
        if (at >= 0) {
            over self = {.x = clod_table_numbers(part, at)};
            clod_figure_axis_set(&self.axis, WAYS[k].column, WAYS[k].unit, WAYS[k].factor);
            self.first = self.x != NULL ? clod_figure_begin(self.x, part->rows) : 0;
            return self;
        }
    }
    return over_time(part);
}

static void add_column(clod_figure *figure, const clod_table *series, const over *along,
                       int column, const char *name, int number)
{
    double *value = clod_table_numbers(series, column);
    if (value == NULL) {
        figure->lost = true;
        return;
    }
    clod_figure_add(figure, name, CLOD_FIGURE_LINE, number, series->rows - along->first,
                    along->x + along->first, value + along->first, NULL);
    clod_memory_free(value);
}

/** Name of a group's figure: the quantity, and the unit if an earlier group has the same quantity. */
static void name_figure(const clod_series_groups *groups, size_t g, char name[160])
{
    const clod_series_group *group = &groups->group[g];
    bool taken = false;
    for (size_t k = 0; k < g; k++) {
        taken = taken || strcmp(groups->group[k].quantity, group->quantity) == 0;
    }
    snprintf(name, 160, "%s%s%s", group->quantity, taken ? "-" : "", taken ? group->unit : "");
}

/** One figure with the columns of a group. */
static void put_group(clod_sheet *sheet, const clod_table *series, const over *along,
                      const clod_series_groups *groups, size_t g)
{
    const clod_series_group *group = &groups->group[g];
    char name[160], title[CLOD_SERIES_GROUPS_TITLE], words[CLOD_FIGURE_NAME];
    name_figure(groups, g, name);
    clod_series_groups_whose(group, series, words);
    clod_series_groups_title(group->quantity, words, title);
    clod_figure figure;
    clod_figure_init(&figure, name, title);
    figure.x = along->axis;
    clod_series_groups_words(group->quantity, words);
    clod_figure_axis_set(&figure.y, words, group->unit, 1.0);
    for (size_t k = 0; k < group->count; k++) {
        char of[CLOD_FIGURE_NAME];
        clod_series_groups_object(series->names[group->column[k]], of);
        if (of[0] == '\0' && group->count > 1) {
            snprintf(of, sizeof of, "all");
        }
        add_column(&figure, series, along, group->column[k], of, (int)k);
    }
    clod_sheet_figure(sheet, &figure);
}

static bool is_main(const clod_series_group *group, size_t k)
{
    return strcmp(group->quantity, MAIN[k]) == 0;
}

static bool is_any_main(const clod_series_group *group)
{
    for (size_t k = 0; k < MAIN_COUNT; k++) {
        if (is_main(group, k)) {
            return true;
        }
    }
    return false;
}

void clod_series_figures_put(clod_sheet *sheet, const clod_table *series, bool main)
{
    const over time = over_time(series);
    clod_series_groups groups;
    if (!clod_series_groups_make(&groups, series)) {
        sheet->lost = true;
    }
    for (size_t k = 0; time.x != NULL && main && k < MAIN_COUNT; k++) {
        for (size_t g = 0; g < groups.count; g++) {
            if (is_main(&groups.group[g], k)) {
                put_group(sheet, series, &time, &groups, g);
            }
        }
    }
    for (size_t g = 0; time.x != NULL && !main && g < groups.count; g++) {
        if (!is_any_main(&groups.group[g])) {
            put_group(sheet, series, &time, &groups, g);
        }
    }
    clod_memory_free(time.x);
    clod_series_groups_fini(&groups);
}

/** Whether a field measured any column of the group. */
static bool is_of_fields(const clod_series_group *group, const clod_table *series)
{
    static const char BEGIN[] = "field_";
    for (size_t k = 0; k < group->count; k++) {
        if (strncmp(series->names[group->column[k]], BEGIN, strlen(BEGIN)) == 0) {
            return true;
        }
    }
    return false;
}

void clod_series_figures_fields(clod_sheet *sheet, const clod_table *part)
{
    const over way = over_way(part);
    clod_series_groups groups;
    if (!clod_series_groups_make(&groups, part)) {
        sheet->lost = true;
    }
    for (size_t g = 0; way.x != NULL && g < groups.count; g++) {
        if (is_of_fields(&groups.group[g], part)) {
            put_group(sheet, part, &way, &groups, g);
        }
    }
    clod_memory_free(way.x);
    clod_series_groups_fini(&groups);
}

void clod_series_figures_all(clod_sheet *sheet, const clod_table *table, const char *name,
                             const char *title, const char *unit)
{
    const over time = over_time(table);
    clod_figure figure;
    int number = 0;
    clod_figure_init(&figure, name, title);
    figure.x = time.axis;
    clod_figure_axis_set(&figure.y, title, unit, 1.0);
    for (size_t c = 0; time.x != NULL && c < table->columns; c++) {
        if (strcmp(table->units[c], unit) == 0) {
            char words[CLOD_FIGURE_NAME];
            clod_series_groups_words(table->names[c], words);
            add_column(&figure, table, &time, (int)c, words, number++);
        }
    }
    clod_memory_free(time.x);
    clod_sheet_figure(sheet, &figure);
}
