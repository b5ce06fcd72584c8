#include "base/memory.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static atomic_uint_fast64_t allocations;

void *clod_memory_alloc(size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - CLOD_MEMORY_ALIGNMENT) / size) {
        return NULL;
    }
    atomic_fetch_add_explicit(&allocations, 1, memory_order_relaxed);
    const size_t bytes = count * size + CLOD_MEMORY_ALIGNMENT;
    const size_t whole = bytes / CLOD_MEMORY_ALIGNMENT * CLOD_MEMORY_ALIGNMENT;
    void *memory = aligned_alloc(CLOD_MEMORY_ALIGNMENT, whole);
    if (memory != NULL) {
        memset(memory, 0, whole);
    }
    return memory;
}

void *clod_memory_grow(void *memory, size_t old_count, size_t new_count, size_t size)
{
    void *grown = clod_memory_alloc(new_count, size);
    if (grown != NULL && memory != NULL) {
        memcpy(grown, memory, old_count * size);
        clod_memory_free(memory);
    }
    return grown;
}

char *clod_memory_text(const char *text)
{
    if (text == NULL) {
        return NULL;
    }
    const size_t length = strlen(text) + 1;
    char *copy = clod_memory_alloc(length, 1);
    if (copy != NULL) {
        memcpy(copy, text, length);
    }
    return copy;
}

void clod_memory_free(void *memory)
{
    free(memory);
}

uint64_t clod_memory_count(void)
{
    return atomic_load_explicit(&allocations, memory_order_relaxed);
}
