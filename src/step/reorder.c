#include "step/reorder.h"

#include <string.h>

#include "step/near_cursor.h"
#include "step/near_walk.h"

/** Where the next contact of each grain goes: pairs, and those with walls. */
static int32_t *next_of(const clod_reorder *self, bool pairs)
{
    return pairs ? self->neighbour->cell_of : self->neighbour->cell_item;
}

void clod_reorder_begin(const clod_reorder *self, int part)
{
    const clod_chunk mine = clod_threads_chunk(self->grains, part, self->near->parts);
    const size_t bytes = (mine.end - mine.begin) * sizeof(int32_t);
    memset(next_of(self, true) + mine.begin, 0, bytes);
    memset(next_of(self, false) + mine.begin, 0, bytes);
}

/** Whether a contact, by its old rows, touches where its grains and walls are now. */
static bool touches(const clod_reorder *self, const clod_contact *contact)
{
    const clod_state *state = self->state;
    const double *a = state->grains.position[contact->i];
    if (contact->shape >= 0) {
        return clod_wall_rows_gap(self->walls, contact->j, contact->shape, a).distance < a[3];
    }
    const double *b = state->grains.position[contact->j];
    double square = 0.0;
    for (int c = 0; c < 3; c++) {
        const double s = clod_domain_separation(&state->domain, c, a[c], b[c]);
        square += s * s;
    }
    return square < (a[3] + b[3]) * (a[3] + b[3]);
}

/** Earlier grain in the new order of a contact by its old rows; below 0: it stays behind. */
static int32_t first_of(const clod_reorder *self, const clod_contact *contact)
{
    const int32_t *rank = self->neighbour->rank;
    const bool wall = contact->shape >= 0;
    const int32_t i = rank[contact->i];
    const int32_t *partner_rank = wall ? self->wall_rank : rank;
    const int32_t j = partner_rank != NULL ? partner_rank[contact->j] : contact->j;
    if (i < 0 || j < 0 || (self->moved && !touches(self, contact))) {
        return -1;
    }
    return wall || i < j ? i : j;
}

static void count_list(const clod_reorder *self, bool pairs, int part)
{
    const clod_near *near = self->near;
    int32_t *next = next_of(self, pairs);
    clod_contact contact;
    clod_near_cursor cursor =
        clod_near_cursor_begin(near, pairs ? &near->pairs : &near->walls, part);
    while (clod_near_cursor_next(&cursor)) {
        clod_near_cursor_name(&cursor, self->walls, &contact);
        const int32_t first = first_of(self, &contact);
        if (first >= 0) {
            __atomic_fetch_add(&next[first], 1, __ATOMIC_RELAXED);
        }
    }
}

void clod_reorder_count(const clod_reorder *self, int part)
{
    count_list(self, true, part);
    count_list(self, false, part);
}

/** From numbers to where each grain's contacts begin; the end of the last. */
static size_t sum_up(int32_t *next, size_t grains, size_t begin)
{
    for (size_t g = 0; g < grains; g++) {
        const int32_t count = next[g];
        next[g] = (int32_t)begin;
        begin += (size_t)count;
    }
    return begin;
}

bool clod_reorder_room(const clod_reorder *self, clod_status *status)
{
    const size_t pairs = sum_up(next_of(self, true), self->grains, 0);
    const size_t all = sum_up(next_of(self, false), self->grains, pairs);
    return clod_near_gather_reserve(self->near, self->state, pairs, all - pairs, status);
}

static void copy_list(const clod_reorder *self, bool pairs, int part)
{
    const clod_near *near = self->near;
    int32_t *next = next_of(self, pairs);
    size_t count = 0;
    clod_contact contact;
    clod_near_cursor cursor =
        clod_near_cursor_begin(near, pairs ? &near->pairs : &near->walls, part);
    while (clod_near_cursor_next(&cursor)) {
        clod_near_cursor_copy(&cursor, self->walls, &contact);
        const int32_t first = first_of(self, &contact);
        if (first >= 0) {
            clod_neighbour_rename(self->neighbour, &contact);
            if (!pairs && self->wall_rank != NULL) {
                contact.j = self->wall_rank[contact.j];
            }
            self->state->contacts[__atomic_fetch_add(&next[first], 1, __ATOMIC_RELAXED)] =
                contact;
        }
        if (pairs && ++count % CLOD_NEAR_GIVE_BACK == 0) {
            clod_near_cursor_release(&cursor);
        }
    }
}

void clod_reorder_copy(const clod_reorder *self, int part)
{
    copy_list(self, true, part);
    copy_list(self, false, part);
}

void clod_reorder_ascend(const clod_reorder *self, int part)
{
    clod_state *state = self->state;
    const clod_chunk mine = clod_threads_chunk(self->grains, part, self->near->parts);
    for (int list = 0; list < 2; list++) {
        const int32_t *end = next_of(self, list == 0); // by now the contacts of each end there
        const size_t base = list == 0 ? 0 : state->contact_count - state->wall_contact_count;
        for (size_t g = mine.begin; g < mine.end; g++) {
            const size_t begin = g == 0 ? base : (size_t)end[g - 1];
            clod_contacts_ascend(state->contacts, begin, (size_t)end[g]);
        }
    }
}
