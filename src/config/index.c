#include "config/index.h"

#include <stdint.h>
#include <string.h>

#define FIRST_CAPACITY 16

/** FNV-1a, 64 bits (http://www.isthe.com/chongo/tech/comp/fnv). */
static uint64_t hash_of(const char *text, size_t length)
{
    uint64_t hash = 0xcbf29ce484222325U;
    for (size_t i = 0; i < length; i++) {
        hash = (hash ^ (unsigned char)text[i]) * 0x100000001b3U;
    }
    return hash ^ (hash >> 32);
}

/** The slot with the text, or the free one where it belongs. */
static clod_index_slot *slot_of(const clod_index *self, const char *text, size_t length)
{
    size_t at = hash_of(text, length) & (self->capacity - 1);
    for (;; at = (at + 1) & (self->capacity - 1)) { // a slot is always free
        clod_index_slot *slot = &self->slots[at];
        if (slot->text == NULL ||
            (slot->length == length && memcmp(slot->text, text, length) == 0)) {
            return slot;
        }
    }
}

/** Twice the slots; the old ones stay in the arena, which is half of the new ones at most. */
static bool grow(clod_index *self, clod_arena *arena)
{
    clod_index grown = {.count = self->count,
                        .capacity = self->capacity == 0 ? FIRST_CAPACITY : 2 * self->capacity};
    grown.slots = clod_arena_alloc(arena, grown.capacity * sizeof *grown.slots);
    if (grown.slots == NULL) {
        return false;
    }
    for (size_t s = 0; s < self->capacity; s++) {
        const clod_index_slot *old = &self->slots[s];
        if (old->text != NULL) {
            *slot_of(&grown, old->text, old->length) = *old;
        }
    }
    *self = grown;
    return true;
}

bool clod_index_add(clod_index *self, clod_arena *arena, const char *text, size_t length,
                    size_t value)
{
    if (2 * (self->count + 1) > self->capacity && !grow(self, arena)) {
        return false;
    }
    clod_index_slot *slot = slot_of(self, text, length);
    if (slot->text == NULL) {
        *slot = (clod_index_slot){text, length, value};
        self->count++;
    }
    return true;
}

bool clod_index_find(const clod_index *self, const char *text, size_t length, size_t *value)
{
    if (self->capacity == 0) {
        return false;
    }
    const clod_index_slot *slot = slot_of(self, text, length);
    if (slot->text != NULL && value != NULL) {
        *value = slot->value;
    }
    return slot->text != NULL;
}
