#include "config/include.h"

#include <stdio.h>
#include <string.h>

#include "base/input.h"
#include "base/memory.h"
#include "config/yaml.h"

/** Read the file into the report, where messages look for its lines. */
static bool read_text(clod_loader *self, const clod_node *node)
{
    const bool relative = node->text[0] != '/' && self->folder[0] != '\0';
    const size_t size = strlen(self->folder) + strlen(node->text) + 2;
    char *path = clod_arena_alloc(self->arena, size);
    if (path == NULL) {
        self->report->lost = true;
        return false;
    }
    snprintf(path, size, "%s%s%s", relative ? self->folder : "", relative ? "/" : "",
             node->text);
    char *text;
    size_t length;
    clod_status status = {CLOD_OK, ""};
    if (!clod_input_read_regular(path, CLOD_YAML_BYTES, &text, &length, &status)) {
        const char *hint = strstr(node->text, "card") != NULL
                               ? "; clod calibrate writes a card.yaml into its results folder"
                               : "; a path begins in the folder of this file";
        clod_report_add(self->report, node->place, "include", "%s%s", status.text, hint);
        return false;
    }
    self->report->included_name = path;
    self->report->included_text = clod_arena_text(self->arena, text, length);
    self->report->included_length = length;
    clod_memory_free(text);
    self->report->lost = self->report->lost || self->report->included_text == NULL;
    return !self->report->lost;
}

/** Put a value in place of another one, at the same key. */
static void replace(clod_node *there, const clod_node *item)
{
    const char *key = there->key;
    *there = *item;
    there->key = key;
}

static void merge(clod_loader *self, clod_node *to, const clod_node *from, bool wins);

/** One item of the included file, at the key of the same name in the case if there is one.
 *  @param wins  its value stands in place of the case's */
static void merge_item(clod_loader *self, clod_node *to, clod_node *item, bool wins)
{
    clod_node *there = clod_tree_step(to, item->key, strlen(item->key));
    const size_t length = clod_load_enter(self, item->key);
    if (there == NULL && to->kind == CLOD_NODE_MAP) {
        self->report->lost = !clod_tree_append(self->arena, to, item) || self->report->lost;
    } else if (there == NULL) {
        clod_report_add(self->report, item->key_place, self->path,
                        "the list of the case has no such element; it has %zu, counted from 0",
                        to->count);
    } else if (there->kind != CLOD_NODE_SCALAR && item->kind == CLOD_NODE_MAP) {
        merge(self, there, item, wins);
    } else if (clod_load_place(there).source == CLOD_PLACE_INCLUDED) {
        // twice there: was told
    } else if (wins) {
        replace(there, item);
    } else {
        clod_report_add(
            self->report, clod_load_place(there), self->path,
            "is given in %s too, in line %d; keep one of them, or name that file by --set "
            "include=FILE in place of the case: its values then count",
            self->report->included_name, item->place.line);
    }
    clod_load_leave(self, length);
}

static void merge(clod_loader *self, clod_node *to, const clod_node *from, bool wins)
{
    for (size_t i = 0; i < from->count && !self->report->lost; i++) {
        merge_item(self, to, from->items[i], wins);
    }
}

void clod_include_merge(clod_loader *self)
{
    const clod_node *node = clod_tree_find(self->root, "include");
    if (node == NULL || node->kind != CLOD_NODE_SCALAR || node->text[0] == '\0' ||
        self->report->lost || !read_text(self, node)) {
        return; // what is no path is told when the key is loaded
    }
    const clod_node *other =
        clod_yaml_read(self->arena, self->report->included_text, self->report->included_length,
                       CLOD_PLACE_INCLUDED, self->report);
    if (other == NULL || other->kind != CLOD_NODE_MAP) {
        if (other != NULL || self->report->count == 0) {
            clod_report_add(self->report, node->place, "include", "%s has no keys of a case",
                            self->report->included_name);
        }
        return;
    }
    const clod_node *again = clod_tree_find(other, "include");
    if (again != NULL) {
        clod_report_add(self->report, again->key_place, "include",
                        "an included file cannot include another");
        return;
    }
    merge(self, self->root, other, node->place.source > 0); // by --set
}
