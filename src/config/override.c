#include "config/override.h"

#include <stdio.h>
#include <string.h>

#include "config/yaml.h"

static void fail(clod_loader *loader, clod_place place, const char *format, const char *a,
                 const char *b)
{
    clod_report_add(loader->report, place, "", format, a, b);
}

/** Step down one key of the path, making the section when a map does not have it yet. */
static clod_node *descend(clod_loader *loader, clod_node *node, const char *key, size_t length,
                          clod_place place)
{
    clod_node *next = clod_tree_step(node, key, length);
    if (next != NULL) {
        return next;
    }
    char word[128];
    snprintf(word, sizeof word, "%.*s", (int)(length < 100 ? length : 100), key);
    if (node->kind == CLOD_NODE_LIST) {
        char count[32];
        snprintf(count, sizeof count, "%zu", node->count);
        fail(loader, place, "the list has no element \"%s\"; it has %s, counted from 0", word,
             count);
        return NULL;
    }
    if (node->kind == CLOD_NODE_SCALAR && node->text[0] != '\0') {
        fail(loader, place, "there is no key \"%s\" below the single value \"%s\"", word,
             node->text);
        return NULL;
    }
    node->kind = CLOD_NODE_MAP;
    next = clod_tree_node(loader->arena, CLOD_NODE_SCALAR, place);
    char *copy = clod_arena_text(loader->arena, key, length);
    if (next != NULL) {
        next->key = copy;
    }
    if (next == NULL || copy == NULL || !clod_tree_append(loader->arena, node, next)) {
        loader->report->lost = true;
        return NULL;
    }
    return next;
}

/**
 * The = behind the key of a setting; NULL: there is none. A name of a part may have one, too: each
 * step is the longest key that the tree has, and where it has none the next = ends the key.
 */
static const char *find_equal(const clod_node *node, const char *key)
{
    for (;;) {
        size_t found = 0;
        for (size_t end = strcspn(key, ".="); key[end] != '\0';
             end += 1 + strcspn(key + end + 1, ".=")) {
            found = clod_tree_step(node, key, end) != NULL ? end : found;
        }
        if (found == 0 || key[found] == '=') {
            return strchr(key + found, '=');
        }
        node = clod_tree_step(node, key, found);
        key += found + 1;
    }
}

void clod_override_apply(clod_loader *loader, size_t number)
{
    const char *text = loader->report->overrides[number];
    const clod_place place = {.source = (int)number + 1, .line = 1, .column = 1, .width = 1};
    const char *equal = find_equal(loader->root, text);
    if (equal == NULL || equal == text) {
        fail(loader, place, "write %s=%s", "key.path", "value, for instance seed=2");
        return;
    }
    const size_t before = loader->report->count;
    clod_node *value = clod_yaml_read(loader->arena, equal + 1, strlen(equal + 1),
                                      (int)number + 1, loader->report);
    if (value == NULL) {
        if (loader->report->count == before) {
            fail(loader, place, "has no value; write %s=%s", "key.path", "value");
        }
        return;
    }
    clod_node *node = loader->root;
    for (const char *key = text; key < equal;) {
        const size_t length = clod_tree_step_length(node, key, (size_t)(equal - key));
        node = length == 0 ? NULL : descend(loader, node, key, length, place);
        if (length == 0) {
            fail(loader, place, "the key %s%s", "has an empty part; write key.path=value", "");
        }
        if (node == NULL) {
            return;
        }
        key += length + 1;
    }
    const char *own = node->key;
    *node = *value;
    node->key = own;
    node->key_place = place;
}
