#include "base/room.h"

#include <string.h>

#include "base/memory.h"

bool clod_room_for(void *array, size_t *capacity, size_t count, size_t size)
{
    if (count <= *capacity) {
        return true;
    }
    void *old;
    memcpy(&old, array, sizeof old);
    clod_memory_free(old);
    void *fresh = clod_memory_alloc(count + count / 8, size);
    memcpy(array, &fresh, sizeof fresh);
    *capacity = fresh != NULL ? count + count / 8 : 0;
    return fresh != NULL;
}

bool clod_room_for_one(void *array, size_t *capacity, size_t count, size_t size)
{
    if (count < *capacity) {
        return true;
    }
    const size_t more = *capacity + *capacity / 2 + 64;
    void *old;
    memcpy(&old, array, sizeof old);
    void *grown = clod_memory_grow(old, *capacity, more, size);
    if (grown == NULL) {
        return false;
    }
    memcpy(array, &grown, sizeof grown);
    *capacity = more;
    return true;
}
