#include "config/tree.h"

#include <string.h>

#define NO_INDEX ((size_t)-1)
#define LARGEST_INDEX 1000000

clod_node *clod_tree_node(clod_arena *arena, clod_node_kind kind, clod_place place)
{
    clod_node *node = clod_arena_alloc(arena, sizeof *node);
    if (node != NULL) {
        node->kind = kind;
        node->place = place;
        node->key_place = place;
        node->text = "";
    }
    return node;
}

clod_node *clod_tree_scalar(clod_arena *arena, const char *text)
{
    const clod_place nowhere = {.line = 1, .column = 1, .width = 1};
    clod_node *node = clod_tree_node(arena, CLOD_NODE_SCALAR, nowhere);
    if (node != NULL) {
        node->text = text;
    }
    return node;
}

bool clod_tree_append(clod_arena *arena, clod_node *self, clod_node *item)
{
    if (self->count == self->capacity) {
        const size_t capacity = self->capacity == 0 ? 8 : 2 * self->capacity;
        clod_node **items = clod_arena_alloc(arena, capacity * sizeof *items);
        if (items == NULL) {
            return false;
        }
        if (self->count > 0) {
            memcpy(items, self->items, self->count * sizeof *items);
        }
        self->items = items;
        self->capacity = capacity;
    }
    if (item->key != NULL &&
        !clod_index_add(&self->keys, arena, item->key, strlen(item->key), self->count)) {
        return false;
    }
    self->items[self->count++] = item;
    return true;
}

clod_node *clod_tree_find(const clod_node *self, const char *key)
{
    return clod_tree_step(self, key, strlen(key));
}

static size_t index_of(const char *text, size_t length)
{
    size_t index = 0;
    for (size_t i = 0; i < length; i++) {
        if (text[i] < '0' || text[i] > '9' || index > LARGEST_INDEX) {
            return NO_INDEX;
        }
        index = 10 * index + (size_t)(text[i] - '0');
    }
    return length == 0 ? NO_INDEX : index;
}

clod_node *clod_tree_step(const clod_node *self, const char *key, size_t length)
{
    if (self == NULL || self->kind == CLOD_NODE_SCALAR) {
        return NULL;
    }
    if (self->kind == CLOD_NODE_LIST) {
        const size_t index = index_of(key, length);
        return index < self->count ? self->items[index] : NULL;
    }
    size_t at;
    return clod_index_find(&self->keys, key, length, &at) ? self->items[at] : NULL;
}

size_t clod_tree_step_length(const clod_node *self, const char *path, size_t length)
{
    size_t found = strcspn(path, ".");
    found = found < length ? found : length;
    for (size_t end = found; end <= length; end++) {
        if ((end == length || path[end] == '.') && clod_tree_step(self, path, end) != NULL) {
            found = end;
        }
    }
    return found;
}

static clod_node *walk(clod_node *root, const char *path, bool nearest)
{
    clod_node *node = root;
    while (node != NULL && *path != '\0') {
        const size_t length = clod_tree_step_length(node, path, strlen(path));
        clod_node *next = clod_tree_step(node, path, length);
        if (next == NULL) {
            return nearest ? node : NULL;
        }
        node = next;
        path += length;
        path += *path == '.';
    }
    return node;
}

clod_node *clod_tree_at(clod_node *root, const char *path)
{
    return walk(root, path, false);
}

clod_node *clod_tree_nearest(clod_node *root, const char *path)
{
    return walk(root, path, true);
}

const char *clod_tree_kind_name(clod_node_kind kind)
{
    switch (kind) {
    case CLOD_NODE_LIST:
        return "a list";
    case CLOD_NODE_MAP:
        return "a section";
    default:
        return "a single value";
    }
}
