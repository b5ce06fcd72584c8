#include "report/part_curves.h"

#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "report/table.h"

static void begin(clod_figure *figures, const clod_part_curves *curves)
{
    for (size_t q = 0; q < curves->count; q++) {
        const clod_part_column *y = &curves->columns[q];
        char title[128];
        snprintf(title, sizeof title, "%c%s%s", y->text[0] - 'a' + 'A', y->text + 1,
                 curves->behind);
        clod_figure_init(&figures[q], curves->named_by_title ? title : y->column, title);
        clod_figure_axis_set(&figures[q].x, curves->over.text, curves->over.unit,
                             curves->over.factor);
        clod_figure_axis_set(&figures[q].y, y->text, y->unit, y->factor);
    }
}

/** Add a part's curves to the figures; false: its table is damaged. */
static bool add_part(clod_figure *figures, const clod_run_files *run,
                     const clod_part_curves *curves, const char *part, int number,
                     clod_status *status)
{
    clod_table table;
    char name[256];
    snprintf(name, sizeof name, "%s.csv", part);
    const bool good = clod_table_read(&table, run->folder, name, status);
    const int at = good ? clod_table_find(&table, curves->over.column) : -1;
    double *x = at >= 0 ? clod_table_numbers(&table, at) : NULL;
    const size_t first = x != NULL ? clod_figure_begin(x, table.rows) : 0;
    for (size_t q = 0; x != NULL && q < curves->count; q++) {
        const int column = clod_table_find(&table, curves->columns[q].column);
        double *y = column >= 0 ? clod_table_numbers(&table, column) : NULL;
        if (y != NULL) {
            clod_figure_add(&figures[q], part, CLOD_FIGURE_LINE, number, table.rows - first,
                            x + first, y + first, NULL);
        }
        clod_memory_free(y);
    }
    clod_memory_free(x);
    clod_table_fini(&table);
    return good;
}

/** Marks lie over all curves. */
static void mark_parts(clod_figure *figure, const clod_run_files *run,
                       const clod_part_curves *curves)
{
    const size_t before = figure->count;
    int number = 0;
    const char *part;
    for (size_t p = 0; (part = clod_run_files_part(run, p)) != NULL; p++) {
        if (strstr(part, curves->part) != NULL) {
            curves->mark(figure, run, part, number++);
        }
    }
    if (figure->count > before) {
        snprintf(figure->note, sizeof figure->note, "%s", curves->marks);
    }
}

bool clod_part_curves_put(clod_sheet *sheet, const clod_run_files *run,
                          const clod_part_curves *curves, clod_status *status)
{
    CLOD_ASSERT(curves->count <= CLOD_PART_CURVES_MOST);
    clod_figure figures[CLOD_PART_CURVES_MOST];
    begin(figures, curves);
    bool good = true;
    int number = 0;
    const char *part;
    for (size_t p = 0; good && (part = clod_run_files_part(run, p)) != NULL; p++) {
        good = strstr(part, curves->part) == NULL ||
               add_part(figures, run, curves, part, number++, status);
    }
    if (curves->mark != NULL) {
        mark_parts(&figures[0], run, curves);
    }
    for (size_t q = 0; q < curves->count; q++) {
        clod_sheet_figure(sheet, &figures[q]);
    }
    return good;
}
