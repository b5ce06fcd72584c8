#include "report/part_tables.h"

#include <stdio.h>

#include "report/html.h"
#include "report/summary_tables.h"

/** Whether it is a mean over a region, or an index: what is not a grid. */
static bool is_shown(const json_t *one)
{
    return json_is_object(one) && json_object_get(one, "cells") == NULL;
}

/** What each part has of this name, with the name of the part; a new list. */
static json_t *collect(const json_t *parts, const char *kind, const char *name)
{
    json_t *list = json_array();
    size_t k;
    json_t *part;
    json_array_foreach(parts, k, part)
    {
        json_t *one = json_object_get(json_object_get(part, kind), name);
        if (is_shown(one)) {
            json_t *copy = json_copy(one);
            json_object_set(copy, "part", json_object_get(part, "part"));
            json_array_append_new(list, copy);
        }
    }
    return list;
}

/** Tables of one kind. @param any  [in,out] whether the section has begun */
static void put_kind(FILE *out, const json_t *parts, const char *kind, const char *title,
                     bool *any)
{
    // all parts measure the same
    json_t *first = json_object_get(json_array_get(parts, 0), kind);
    const char *name;
    json_t *one;
    json_object_foreach(first, name, one)
    {
        if (is_shown(one)) {
            char heading[128];
            json_t *list = collect(parts, kind, name);
            snprintf(heading, sizeof heading, "%s %.96s", title, name);
            if (!*any) {
                clod_html_section(out, "part-means", "Fields and mixing of the parts");
                fputs("<p class=\"note\">&plusmn; one standard deviation of the means of ten "
                      "blocks. Means of fields, and mean of an index, are those of the rows in "
                      "the last third of the phase; the other numbers of an index are those at "
                      "the end of the part.</p>\n",
                      out);
                *any = true;
            }
            clod_summary_tables_put(out, heading, list);
            json_decref(list);
        }
    }
}

void clod_part_tables_put(clod_sheet *sheet, const clod_run_files *run)
{
    const json_t *parts = json_object_get(run->summary, "parts");
    bool any = false;
    put_kind(sheet->body, parts, "fields", "Field", &any);
    put_kind(sheet->body, parts, "mixing", "Mixing", &any);
}
