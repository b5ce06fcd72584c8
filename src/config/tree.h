#pragma once
/**
 * @file tree.h
 * What a case file says, before anyone asks whether it makes sense: maps, lists and texts, each
 * knowing where it was written.
 */

#include <stdbool.h>
#include <stddef.h>

#include "config/arena.h"
#include "config/index.h"

#define CLOD_PLACE_INCLUDED (-1) ///< source of what the file that a case includes has

/** Where something was written. Columns count characters; lines and columns start at 1. */
typedef struct clod_place {
    int source; ///< 0: the case file; k > 0: override number k - 1; CLOD_PLACE_INCLUDED
    int line, column;
    int width; ///< characters, at least 1
} clod_place;

typedef enum clod_node_kind { CLOD_NODE_SCALAR, CLOD_NODE_LIST, CLOD_NODE_MAP } clod_node_kind;

typedef struct clod_node {
    clod_node_kind kind;
    clod_place place;     ///< of the value
    const char *key;      ///< its key in the map it stands in; NULL in a list and at the root
    clod_place key_place; ///< of the key; of the value when there is no key
    const char *text;     ///< of a scalar; never NULL there
    struct clod_node **items;
    size_t count, capacity;
    clod_index keys; ///< of a map: which item has a key
} clod_node;

/** New node of a kind at a place, or NULL without memory. */
clod_node *clod_tree_node(clod_arena *arena, clod_node_kind kind, clod_place place);

/** New scalar that was not written anywhere: a default. NULL without memory. */
clod_node *clod_tree_scalar(clod_arena *arena, const char *text);

/** Append an item to a map, with its key, or to a list; false without memory. */
bool clod_tree_append(clod_arena *arena, clod_node *self, clod_node *item);

/** Item of a map by key, or NULL; a NULL or other node has no items. */
clod_node *clod_tree_find(const clod_node *self, const char *key);

/** Item of a map by the first `length` bytes of a key, or of a list by its index in digits. */
clod_node *clod_tree_step(const clod_node *self, const char *key, size_t length);

/**
 * How many bytes of a path are the first step from a node: up to a point, or the longest key of the node
 * that they are, which may have points in it, as names of parts have: "Cube.001.speed".
 *
 * @param length  of the path
 */
size_t clod_tree_step_length(const clod_node *self, const char *path, size_t length);

/** The node at a path such as "grains.0.count", or NULL. */
clod_node *clod_tree_at(clod_node *root, const char *path);

/** The deepest node that exists along a path; the root at least. */
clod_node *clod_tree_nearest(clod_node *root, const char *path);

/** "a section", "a list" or "a value", for messages. */
const char *clod_tree_kind_name(clod_node_kind kind);
