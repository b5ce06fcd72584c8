#pragma once
/**
 * @file contact_walk.h
 * A walk over all contacts of a source, one after the other. Whoever reads contacts for more than
 * a copy of them walks.
 *
 * Test  tests/state/test_contact_walk.c
 */

#include "state/contact_source.h"

/** Contacts that are read at a time. */
#define CLOD_CONTACT_WALK_SOME 64

typedef struct clod_contact_walk {
    const clod_contact_source *from; ///< borrowed
    size_t pairs, walls; ///< how many contacts there are of two grains and with walls
    clod_contact some[CLOD_CONTACT_WALK_SOME];
    size_t at, count; ///< place in `some`, how many are there
} clod_contact_walk;

/** Go before the first contact. */
static inline void clod_contact_walk_begin(clod_contact_walk *self,
                                           const clod_contact_source *from)
{
    self->from = from;
    self->at = self->count = 0;
    from->begin(from->context, &self->pairs, &self->walls);
}

/** The next contact, borrowed until the next call; NULL: at the end, where it stays. */
static inline const clod_contact *clod_contact_walk_next(clod_contact_walk *self)
{
    if (self->at == self->count) {
        const clod_contact_source *from = self->from;
        self->at = 0;
        self->count = from->next(from->context, self->some, CLOD_CONTACT_WALK_SOME);
    }
    return self->at < self->count ? &self->some[self->at++] : NULL;
}
