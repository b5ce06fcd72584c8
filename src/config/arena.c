#include "config/arena.h"

#include <string.h>

#include "base/memory.h"

#define BLOCK_SIZE 16384
#define ALIGNMENT 16

typedef struct clod_arena_block {
    struct clod_arena_block *before;
    size_t used, size;
    _Alignas(ALIGNMENT) char bytes[];
} clod_arena_block;

static clod_arena_block *add_block(clod_arena *self, size_t size)
{
    const size_t room = size > BLOCK_SIZE ? size : BLOCK_SIZE;
    clod_arena_block *block = clod_memory_alloc(1, sizeof *block + room);
    if (block != NULL) {
        block->before = self->last;
        block->size = room;
        self->last = block;
    }
    return block;
}

void *clod_arena_alloc(clod_arena *self, size_t size)
{
    const size_t whole = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    clod_arena_block *block = self->last;
    if (block == NULL || block->size - block->used < whole) {
        block = add_block(self, whole);
    }
    if (block == NULL) {
        return NULL;
    }
    void *memory = block->bytes + block->used;
    block->used += whole;
    return memory;
}

char *clod_arena_text(clod_arena *self, const char *text, size_t length)
{
    char *copy = clod_arena_alloc(self, length + 1);
    if (copy != NULL) {
        memcpy(copy, text, length);
    }
    return copy;
}

void clod_arena_fini(clod_arena *self)
{
    while (self->last != NULL) {
        clod_arena_block *before = self->last->before;
        clod_memory_free(self->last);
        self->last = before;
    }
}
