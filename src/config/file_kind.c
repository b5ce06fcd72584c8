#include "config/file_kind.h"

#include <string.h>

/** A kind: what it is, the key that only it has, what to do with it, and who writes one. */
static const struct kind {
    const char *name, *key, *reader, *example;
} KINDS[CLOD_FILE_KINDS] = {
    [CLOD_FILE_CASE] = {"a simulation's case", "materials", "clod run reads it",
                        "clod new writes examples of a simulation's case"},
    [CLOD_FILE_HOPPER] = {"a hopper's case", "flow_function", "clod hopper reads it",
                          "clod new hopper writes an example of a hopper's case"},
    [CLOD_FILE_PLAN] = {"the plan of a calibration", "targets", "clod calibrate reads it",
                        "clod new calibrate writes an example of a plan"},
    [CLOD_FILE_CARD] = {"a material card", NULL,
                        "a simulation's case takes it in with include: FILE", NULL},
};

/** A card has contacts and nothing else, but for what the command line sets. */
static bool is_card(const clod_node *root)
{
    bool only = root->kind == CLOD_NODE_MAP && clod_tree_find(root, "contacts") != NULL;
    for (size_t k = 0; k < root->count && only; k++) {
        const clod_node *item = root->items[k];
        only = item->key_place.source != 0 || strcmp(item->key, "contacts") == 0;
    }
    return only;
}

static clod_file_kind kind_of(const clod_node *root)
{
    for (int k = 0; k < CLOD_FILE_CARD; k++) {
        if (clod_tree_find(root, KINDS[k].key) != NULL) {
            return (clod_file_kind)k;
        }
    }
    return is_card(root) ? CLOD_FILE_CARD : CLOD_FILE_UNKNOWN;
}

bool clod_file_kind_check(clod_loader *loader, clod_file_kind wanted)
{
    const clod_node *root = loader->root;
    const clod_file_kind found = kind_of(root);
    if (found == CLOD_FILE_UNKNOWN || clod_tree_find(root, KINDS[wanted].key) != NULL) {
        return true;
    }
    clod_report_add(loader->report, root->place, "", "is %s, not %s; %s, and %s",
                    KINDS[found].name, KINDS[wanted].name, KINDS[found].reader,
                    KINDS[wanted].example);
    return false;
}
