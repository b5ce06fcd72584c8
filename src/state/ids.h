#pragma once
/**
 * @file ids.h
 * Rows of grains by their ids.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/sort.h"
#include "clod/status.h"

typedef struct clod_ids {
    clod_sort_item *item; ///< [count] id and row, ascending by id; owned
    size_t count;
} clod_ids;

/** An index of these ids; false without memory. */
bool clod_ids_init(clod_ids *self, const uint64_t *id, size_t count, clod_status *status);

/** Row of an id; -1: no grain has it. */
int64_t clod_ids_row(const clod_ids *self, uint64_t id);

/** Whether no two grains have the same id. */
bool clod_ids_are_different(const clod_ids *self);

void clod_ids_fini(clod_ids *self);
