#pragma once
/**
 * @file room.h
 * Arrays that grow and are kept: nothing is allocated once they are large enough.
 */

#include <stdbool.h>
#include <stddef.h>

/**
 * Room for `count` items of an array, contents lost.
 *
 * @param array     where the pointer to the array is
 * @param capacity  [in,out] items that it has room for
 * @return          false without memory
 */
bool clod_room_for(void *array, size_t *capacity, size_t count, size_t size);

/** Room for one more item than the `count` that are there, which stay; false without memory. */
bool clod_room_for_one(void *array, size_t *capacity, size_t count, size_t size);
