#pragma once
/**
 * @file yaml.h
 * YAML 1.2 text -> tree, through libfyaml; everything odd is refused with an error in the
 * report.
 */

#include "config/report.h"
#include "config/tree.h"

#define CLOD_YAML_BYTES ((size_t)1 << 20)
#define CLOD_YAML_DEPTH 16

/**
 * Read a text into a tree.
 *
 * @param arena   [in,out] where the tree lives
 * @param text    [length] UTF-8
 * @param source  number of the source for the places in the tree (clod_place)
 * @param report  [in,out] errors: size, UTF-8, syntax, depth, duplicate keys, anchors, tags
 * @return        root of the tree; NULL when there is none, or after any error but a duplicate
 * key Errors  in the report.   Threads  safe.   Test  tests/config/, tests/fuzz/fuzz_case.c
 */
clod_node *clod_yaml_read(clod_arena *arena, const char *text, size_t length, int source,
                          clod_report *report);
