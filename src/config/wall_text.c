#include "config/wall_text.h"

#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "config/check.h"
#include "config/load.h"
#include "config/yaml.h"

/** Of a case only its walls. */
static clod_table walls_only(void)
{
    const clod_param *walls = clod_param_find(&CLOD_TABLE_CASE, "walls");
    CLOD_ASSERT(walls != NULL);
    return (clod_table){.params = walls, .count = 1};
}

/** A section with one key; NULL without memory. */
static clod_node *section_of(clod_arena *arena, const char *key, clod_node *below)
{
    clod_node *section = clod_tree_node(arena, CLOD_NODE_MAP, below->place);
    below->key = clod_arena_text(arena, key, strlen(key));
    below->key_place = below->place;
    if (section == NULL || below->key == NULL || !clod_tree_append(arena, section, below)) {
        return NULL;
    }
    return section;
}

/** The wall's section as it would stand in a case: walls: {NAME: ...}; NULL after an error. */
static clod_node *read_tree(clod_loader *loader, const char *name)
{
    clod_report *report = loader->report;
    clod_node *wall = clod_yaml_read(loader->arena, report->text, report->length, 0, report);
    if (wall == NULL) {
        if (report->count == 0 && !report->lost) {
            const clod_place start = {.line = 1, .column = 1, .width = 1};
            clod_report_add(report, start, "",
                            "is empty; write a wall as in a case, for instance {material: "
                            "steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}");
        }
        return NULL;
    }
    clod_node *named = section_of(loader->arena, name, wall);
    clod_node *root = named != NULL ? section_of(loader->arena, "walls", named) : NULL;
    report->lost = report->lost || root == NULL;
    return root;
}

clod_case_wall *clod_wall_text_read(const clod_case *from, const char *name, const char *text,
                                    clod_status *status)
{
    char title[64];
    snprintf(title, sizeof title, "wall '%.40s'", name);
    clod_report report = {.name = title, .text = text, .length = strlen(text)};
    clod_arena arena = {0};
    clod_loader loader = {.report = &report, .arena = &arena, .folder = ""};
    clod_case whole = {.materials = from->materials, .material_count = from->material_count};
    const clod_table table = walls_only();
    loader.root = read_tree(&loader, name);
    if (loader.root != NULL) {
        clod_load_section(&loader, &table, loader.root, loader.root->place, &whole);
        if (!report.lost) {
            clod_check_walls(&loader, &whole);
            clod_check_unused(&loader, &whole);
        }
    }
    if (!clod_report_finish(&report, status)) {
        clod_wall_text_destroy(&whole.walls);
    }
    clod_report_fini(&report);
    clod_arena_fini(&arena);
    return whole.walls;
}

void clod_wall_text_destroy(clod_case_wall **self)
{
    if (self != NULL && *self != NULL) {
        clod_case whole = {.walls = *self, .wall_count = 1};
        const clod_table table = walls_only();
        clod_load_free(&table, &whole);
        *self = NULL;
    }
}
