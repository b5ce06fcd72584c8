#include <stdio.h>

#include "config/check.h"
#include "config/param.h"

/** A section of the tree and the struct that was filled from it. */
typedef struct section {
    const clod_table *table;
    const clod_node *node;
    const void *target;
} section;

static const void *at(const section *self, size_t offset)
{
    return (const char *)self->target + offset;
}

static void visit(clod_loader *loader, const clod_case *whole, const section *self);

/** The sections below a row; those of contacts inherit and are checked in contacts.c. */
static void visit_below(clod_loader *loader, const clod_case *whole, const section *above,
                        const clod_param *row, const clod_node *node)
{
    const void *value = at(above, row->offset);
    if (row->kind == CLOD_PARAM_SECTION) {
        visit(loader, whole, &(section){row->table, node, value});
    } else if (row->kind == CLOD_PARAM_LIST || row->kind == CLOD_PARAM_MAP) {
        const char *items = *(const char *const *)value;
        for (size_t i = 0; items != NULL && i < node->count; i++) {
            char index[24];
            snprintf(index, sizeof index, "%zu", i);
            const clod_node *item = node->items[i];
            const size_t length =
                clod_load_enter(loader, item->key == NULL ? index : item->key);
            visit(loader, whole, &(section){row->table, item, items + i * row->table->size});
            clod_load_leave(loader, length);
        }
    }
}

static void visit(clod_loader *loader, const clod_case *whole, const section *self)
{
    for (size_t i = 0; i < self->table->count; i++) {
        const clod_param *row = &self->table->params[i];
        const clod_node *node = clod_tree_find(self->node, row->key);
        if (node == NULL) {
            continue;
        }
        const size_t length = clod_load_enter(loader, row->key);
        if (row->unused != NULL && !row->used(whole, self->target)) {
            clod_report_add(loader->report, clod_load_place(node), loader->path, "%s",
                            row->unused);
        }
        visit_below(loader, whole, self, row, node);
        clod_load_leave(loader, length);
    }
}

void clod_check_unused(clod_loader *loader, const clod_case *self)
{
    if (loader->report->count == 0) { // else structs may lack what decides
        visit(loader, self, &(section){&CLOD_TABLE_CASE, loader->root, self});
    }
}
