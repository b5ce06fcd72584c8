#include "step/migrate.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "state/ids.h"

/** What is on its way. */
typedef struct parcels {
    clod_bytes *out; ///< [ranks]
    clod_bytes in;
    size_t *begin; ///< [ranks + 1]
    int ranks;
} parcels;

static bool parcels_init(parcels *self, clod_ranks *ranks, clod_status *status)
{
    *self = (parcels){.ranks = ranks->size};
    self->out = clod_memory_alloc((size_t)ranks->size, sizeof *self->out);
    self->begin = clod_memory_alloc((size_t)ranks->size + 1, sizeof *self->begin);
    const bool good =
        (self->out != NULL && self->begin != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", ranks->size);
    return clod_ranks_agree(ranks, good, status);
}

/** Nothing is to be sent any more: a whole bed may have been in it. */
static void parcels_empty(parcels *self)
{
    for (int r = 0; self->out != NULL && r < self->ranks; r++) {
        clod_bytes_fini(&self->out[r]);
    }
}

/** What is to be sent, and what came, is gone. */
static void parcels_clear(parcels *self)
{
    parcels_empty(self);
    clod_bytes_fini(&self->in);
}

static void parcels_fini(parcels *self)
{
    parcels_clear(self);
    clod_memory_free(self->out);
    clod_memory_free(self->begin);
}

/** All that is to be sent arrives; only what came is kept. False on all alike. */
static bool swap(clod_spread *self, parcels *way, clod_status *status)
{
    const bool good = clod_ranks_swap(self->ranks, way->out, &way->in, way->begin, status);
    parcels_empty(way);
    return good;
}

static bool is_nobodys(const clod_spread *self, size_t row)
{
    return self->owner != NULL && self->owner[row] == CLOD_SPREAD_NOBODY;
}

static int new_owner(const clod_spread *self, const clod_state *state, int32_t row)
{
    return clod_partition_owner(&self->partition, state->build_position[row]);
}

// ---- what goes where

/** Contacts whose earlier grain is own, to the new owners of both. */
static void pack_contacts(const clod_spread *self, const clod_state *state, clod_bytes *out)
{
    for (size_t k = 0; k < state->contact_count; k++) {
        const clod_contact *contact = &state->contacts[k];
        const bool leaves = contact->shape < 0 && is_nobodys(self, (size_t)contact->j);
        if (!clod_spread_has(self, (size_t)contact->i) || leaves) {
            continue;
        }
        const int first = new_owner(self, state, contact->i);
        const int second = contact->shape < 0 ? new_owner(self, state, contact->j) : first;
        clod_records_put_contact(&out[first], &state->grains, contact);
        if (second != first) {
            clod_records_put_contact(&out[second], &state->grains, contact);
        }
    }
}

/** Own grains to their new owners, and to the ranks that they matter to as ghosts. */
static void pack_grains(clod_spread *self, const clod_state *state, double skin,
                        clod_bytes *out)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        if (!clod_spread_has(self, g)) {
            continue;
        }
        const double *p = state->build_position[g];
        const int owner = new_owner(self, state, (int32_t)g);
        const int count = clod_spread_reach(self, &state->domain, p, skin, self->reached);
        clod_records_put_grain(&out[owner], state, g);
        for (int k = 0; k < count; k++) {
            if (self->reached[k] != owner) {
                clod_records_put_grain(&out[self->reached[k]], state, g);
            }
        }
        self->balance.moved += owner != self->ranks->rank;
    }
}

/** Grains to their owners, and as ghosts to others. */
static bool move_grains(clod_spread *self, const clod_state *from, clod_state *to, double skin,
                        parcels *way, clod_status *status)
{
    pack_grains(self, from, skin, way->out);
    if (!swap(self, way, status)) {
        return false;
    }
    self->adrift = true;
    to->grains.count = 0;
    const bool good = clod_records_get_grains(&way->in, to, status);
    clod_bytes_fini(&way->in);
    return clod_ranks_agree(self->ranks, good, status);
}

bool clod_migrate(clod_spread *self, const clod_state *from, clod_state *to,
                  double (*skin)(const void *context, const clod_layers_extent *bed),
                  const void *context, clod_status *status)
{
    parcels grains, contacts;
    bool good = parcels_init(&grains, self->ranks, status);
    good = parcels_init(&contacts, self->ranks, status) && good;
    if (good) {
        clod_spread_cut(self, from);
        pack_contacts(self, from, contacts.out); // while the rows are there
        const double wide = skin(context, &self->bed);
        good =
            swap(self, &contacts, status) && // while nothing is lost by a failure
            move_grains(self, from, to, wide, &grains, status) &&
            clod_ranks_agree(
                self->ranks,
                clod_records_get_contacts(&contacts.in, to, &self->separated, status), status);
    }
    parcels_fini(&grains);
    parcels_fini(&contacts);
    return good;
}

/** Everything own to rank 0: grains, or contacts. */
static bool to_first(clod_spread *self, const clod_state *state, parcels *way, bool grains,
                     clod_status *status)
{
    parcels_clear(way);
    for (size_t g = 0; grains && g < state->grains.count; g++) {
        if (clod_spread_has(self, g)) {
            clod_records_put_grain(&way->out[0], state, g);
        }
    }
    for (size_t k = 0; !grains && k < state->contact_count; k++) {
        if (clod_spread_has(self, (size_t)state->contacts[k].i)) {
            clod_records_put_contact(&way->out[0], &state->grains, &state->contacts[k]);
        }
    }
    return swap(self, way, status);
}

/** Grains that left this rank, to rank 0; the list is empty then. */
static bool gather_gone(clod_spread *self, clod_state *state, clod_state *whole, parcels *way,
                        clod_status *status)
{
    clod_gone *gone = &state->gone;
    parcels_clear(way);
    clod_bytes_put(&way->out[0], gone->rows, gone->count * sizeof *gone->rows);
    way->out[0].lacks_memory |= gone->lacks_memory;
    gone->count = 0;
    if (!swap(self, way, status)) {
        return false;
    }
    for (size_t at = 0; whole != NULL && at < way->in.count; at += sizeof *gone->rows) {
        clod_gone_grain grain;
        memcpy(&grain, way->in.data + at, sizeof grain);
        clod_gone_add(&whole->gone, &grain); // it notes itself when it lacks memory
    }
    return true;
}

bool clod_migrate_gone(clod_spread *self, clod_state *state, clod_state *whole,
                       clod_status *status)
{
    parcels way;
    const bool good = parcels_init(&way, self->ranks, status) &&
                      gather_gone(self, state, whole, &way, status);
    parcels_fini(&way);
    return good;
}

bool clod_migrate_gather(clod_spread *self, clod_state *state, clod_state *whole,
                         clod_status *status)
{
    parcels way;
    bool good =
        parcels_init(&way, self->ranks, status) && to_first(self, state, &way, true, status);
    if (good) {
        bool mine = true;
        if (whole != NULL) {
            whole->grains.count = 0;
            mine = clod_records_get_grains(&way.in, whole, status);
        }
        good = clod_ranks_agree(self->ranks, mine, status);
    }
    if (good && to_first(self, state, &way, false, status)) {
        clod_memory_give_back(state->contacts, state->contact_count * sizeof *state->contacts,
                              state->contact_capacity * sizeof *state->contacts);
        state->contact_count = state->wall_contact_count = 0;
        clod_separated separated = {0}; // all grains are there
        const bool mine =
            whole == NULL || clod_records_get_contacts(&way.in, whole, &separated, status);
        CLOD_ASSERT(!separated.any);
        good = clod_ranks_agree(self->ranks, mine, status) &&
               gather_gone(self, state, whole, &way, status);
    } else {
        good = false;
    }
    parcels_fini(&way);
    return good;
}

bool clod_migrate_reaches(const clod_domain *domain, const double place[4],
                          const clod_domain_box *box, int count)
{
    bool near = false;
    for (int k = 0; k < count && !near; k++) {
        near = true;
        for (int a = 0; a < 3; a++) {
            const double half = 0.5 * (box[k].high[a] - box[k].low[a]);
            const double middle = box[k].low[a] + half;
            const double off = fabs(clod_domain_separation(domain, a, place[a], middle)) - half;
            near = near && off <= place[3];
        }
    }
    return near;
}

bool clod_migrate_near(clod_spread *self, const clod_state *state, const clod_domain_box *box,
                       int count, clod_state *whole, clod_status *status)
{
    parcels way;
    bool good = parcels_init(&way, self->ranks, status);
    for (size_t g = 0; good && g < state->grains.count; g++) {
        if (clod_spread_has(self, g) &&
            clod_migrate_reaches(&state->domain, state->grains.position[g], box, count)) {
            clod_records_put_grain(&way.out[0], state, g);
        }
    }
    good = good && swap(self, &way, status);
    if (good) {
        bool mine = true;
        if (whole != NULL) {
            whole->grains.count = whole->contact_count = whole->wall_contact_count = 0;
            mine = clod_records_get_grains(&way.in, whole, status);
        }
        good = clod_ranks_agree(self->ranks, mine, status);
    }
    parcels_fini(&way);
    return good;
}
