#include "step/touch_facets.h"

#include <string.h>

#include "base/memory.h"
#include "base/room.h"

#define FIRST_SLOTS 256

void clod_touch_facets_begin(clod_touch_facets *self)
{
    self->count = 0;
    if (self->slots > 0) {
        memset(self->slot, 0, self->slots * sizeof *self->slot);
    }
}

/** The slot of a facet, or the free one where it belongs. */
static uint32_t *slot_of(const clod_touch_facets *self, const clod_surface *surface,
                         uint32_t number)
{
    const uint64_t key = ((uint64_t)(uintptr_t)surface >> 4) + number;
    size_t k = (size_t)(key * 0x9e3779b97f4a7c15U >> 32) & (self->slots - 1);
    for (; self->slot[k] != 0; k = (k + 1) & (self->slots - 1)) {
        const clod_surface_facet *there = &self->facet[self->slot[k] - 1];
        if (there->number == number && there->surface == surface) {
            break;
        }
    }
    return &self->slot[k];
}

/** Slots for one facet more. */
static bool has_slots(clod_touch_facets *self)
{
    if (2 * (self->count + 1) <= self->slots) {
        return true;
    }
    const size_t slots = self->slots == 0 ? FIRST_SLOTS : 2 * self->slots;
    uint32_t *slot = clod_memory_alloc(slots, sizeof *slot);
    if (slot == NULL) {
        return false;
    }
    clod_memory_free(self->slot);
    self->slot = slot;
    self->slots = slots;
    for (size_t k = 0; k < self->count; k++) {
        *slot_of(self, self->facet[k].surface, self->facet[k].number) = (uint32_t)k + 1;
    }
    return true;
}

bool clod_touch_facets_take(clod_touch_facets *self, const clod_surface *surface,
                            uint32_t number, uint32_t *at)
{
    if (!has_slots(self)) {
        return false;
    }
    uint32_t *slot = slot_of(self, surface, number);
    if (*slot == 0) {
        if (!clod_room_for_one(&self->facet, &self->room, self->count, sizeof *self->facet)) {
            return false;
        }
        self->facet[self->count] = clod_surface_facet_of(surface, number);
        *slot = (uint32_t)++self->count;
    }
    *at = *slot - 1;
    return true;
}

void clod_touch_facets_fini(clod_touch_facets *self)
{
    clod_memory_free(self->facet);
    clod_memory_free(self->slot);
    *self = (clod_touch_facets){0};
}
