#include "report/field_axes.h"

#include <string.h>

#include "config/yaml.h"

/** Set it in the objects of fields, by their names, of the summary or a part. */
static void set(const clod_node *asked, const json_t *of)
{
    const char *name;
    json_t *field;
    json_object_foreach(json_object_get(of, "fields"), name, field)
    {
        const clod_node *components = clod_tree_find(clod_tree_find(asked, name), "components");
        if (components != NULL && components->kind == CLOD_NODE_SCALAR) {
            json_object_set_new(field, "components", json_string(components->text));
        }
    }
}

void clod_field_axes_set(const clod_run_files *run)
{
    clod_arena arena = {0};
    clod_report errors = {.name = "case-complete.yaml"};
    const clod_node *asked = clod_tree_find(
        clod_yaml_read(&arena, run->complete, strlen(run->complete), 0, &errors), "fields");
    size_t k;
    const json_t *part;
    set(asked, run->summary);
    json_array_foreach(json_object_get(run->summary, "parts"), k, part)
    {
        set(asked, part);
    }
    clod_report_fini(&errors);
    clod_arena_fini(&arena);
}
