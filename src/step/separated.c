#include "step/separated.h"

/** Both lists ascend: one walk sees that contacts [begin, end) of some grains are among all pairs of
 *  these; the first that is not, or end. */
static size_t find_pairs(const clod_pairs *self, clod_chunk grains,
                         const clod_contact *contacts, size_t begin, size_t end)
{
    size_t k = begin;
    for (size_t i = grains.begin; i < grains.end; i++) {
        const size_t last = i + 1 < grains.end ? self->start[i + 1] : self->count;
        for (size_t p = self->start[i]; p < last && k < end; p++) {
            k += (size_t)contacts[k].i == i && (uint32_t)contacts[k].j == self->item[p].j;
        }
    }
    return k;
}

/** The same for contacts [begin, end) with walls. */
static size_t find_wall_pairs(const clod_wall_candidates *self, const clod_contact *contacts,
                              size_t begin, size_t end)
{
    size_t k = begin;
    for (size_t c = 0; c < self->count && k < end; c++) {
        const clod_wall_candidate *at = &self->item[c];
        k += at->i == contacts[k].i && at->wall == contacts[k].j &&
             at->shape == contacts[k].shape;
    }
    return k;
}

size_t clod_separated_first(const clod_pairs *pairs, const clod_wall_candidates *walls,
                            const clod_state *state, clod_chunk grains)
{
    const clod_contact *contacts = state->contacts;
    const size_t all = state->contact_count;
    size_t begin = 0, end = all - state->wall_contact_count;
    for (int list = 0; list < 2; list++) {
        const size_t first = clod_contacts_first_from(contacts, begin, end, grains.begin);
        const size_t last = clod_contacts_first_from(contacts, first, end, grains.end);
        const size_t left = list == 0 ? find_pairs(pairs, grains, contacts, first, last)
                                      : find_wall_pairs(walls, contacts, first, last);
        if (left < last) {
            return left;
        }
        begin = end;
        end = all;
    }
    return all;
}
