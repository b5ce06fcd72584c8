// Contacts that ranks were dealt, to the owners of their grains. Nobody knows who has a grain of some id; so
// each id has a rank that is told (a directory), and a contact goes there, on to the owner of its
// first grain, and from there to that of its second, which is a ghost with the first.
#include <string.h>

#include "base/memory.h"
#include "state/ids.h"
#include "step/crew_part.h"
#include "step/migrate.h"

/** On its way. */
typedef struct route {
    clod_crew *crew;
    clod_bytes *out;     ///< [ranks]
    clod_bytes in;       ///< what came last
    size_t *begin;       ///< [ranks + 1] of each rank in it
    clod_ids known;      ///< ids that this rank is told of, with their places in what came
    size_t *known_begin; ///< [ranks + 1] places of each owner
    bool lost;           ///< two grains of one id, or a contact without its grain
} route;

static bool route_init(route *self, clod_crew *crew, clod_status *status)
{
    const size_t size = (size_t)crew->ranks->size;
    *self = (route){.crew = crew,
                    .out = clod_memory_alloc(size, sizeof *self->out),
                    .begin = clod_memory_alloc(size + 1, sizeof *self->begin),
                    .known_begin = clod_memory_alloc(size + 1, sizeof *self->known_begin)};
    const bool good = (self->out != NULL && self->begin != NULL && self->known_begin != NULL) ||
                      clod_status_fail(status, CLOD_FAILED, "no memory for %zu ranks", size);
    return clod_ranks_agree(crew->ranks, good, status);
}

static void empty(route *self)
{
    for (int r = 0; self->out != NULL && r < self->crew->ranks->size; r++) {
        clod_bytes_fini(&self->out[r]);
    }
}

static void route_fini(route *self)
{
    empty(self);
    clod_bytes_fini(&self->in);
    clod_ids_fini(&self->known);
    clod_memory_free(self->out);
    clod_memory_free(self->begin);
    clod_memory_free(self->known_begin);
}

/** All that is to be sent arrives. False on all alike. */
static bool swap(route *self, clod_status *status)
{
    const bool good =
        clod_ranks_swap(self->crew->ranks, self->out, &self->in, self->begin, status);
    empty(self);
    return good;
}

/** The rank that is told who has the grain of an id. */
static size_t directory(const route *self, uint64_t id)
{
    return (size_t)(id % (uint64_t)self->crew->ranks->size);
}

static int owner_of(const route *self, size_t row)
{
    return clod_partition_owner(&self->crew->spread.partition,
                                self->crew->state.build_position[row]);
}

/** Every rank tells the directories which grains it owns. */
static bool tell_ids(route *self, clod_status *status)
{
    const clod_grains *grains = &self->crew->state.grains;
    clod_ranks *ranks = self->crew->ranks;
    for (size_t g = 0; g < grains->count; g++) {
        if (owner_of(self, g) == ranks->rank) {
            clod_bytes_put(&self->out[directory(self, grains->id[g])], &grains->id[g],
                           sizeof *grains->id);
        }
    }
    if (!swap(self, status)) {
        return false;
    }
    for (int r = 0; r <= ranks->size; r++) {
        self->known_begin[r] = self->begin[r] / sizeof *grains->id;
    }
    const bool good = clod_ids_init(&self->known, (const uint64_t *)(const void *)self->in.data,
                                    self->in.count / sizeof *grains->id, status);
    self->lost = good && !clod_ids_are_different(&self->known);
    return clod_ranks_agree(ranks, good, status);
}

/** Owner of a place in what the directory was told. */
static int owner_of_place(const route *self, size_t place)
{
    int first = 0, last = self->crew->ranks->size;
    while (last - first > 1) {
        const int middle = first + (last - first) / 2;
        *(place < self->known_begin[middle] ? &last : &first) = middle;
    }
    return first;
}

/** Contacts that lie here to the directories of their first grains. */
static bool to_directories(route *self, clod_status *status)
{
    const clod_bytes *from = &self->crew->share.contacts;
    for (size_t at = 0; at < from->count; at += CLOD_RECORDS_CONTACT) {
        clod_contact contact;
        uint64_t partners[2];
        clod_records_get_contact(from->data + at, &contact, partners);
        clod_bytes_put(&self->out[directory(self, partners[0])], from->data + at,
                       CLOD_RECORDS_CONTACT);
    }
    clod_crew_share_fini(&self->crew->share);
    return swap(self, status);
}

/** From there to the owners of these. */
static bool to_first(route *self, clod_status *status)
{
    for (size_t at = 0; at < self->in.count; at += CLOD_RECORDS_CONTACT) {
        clod_contact contact;
        uint64_t partners[2];
        clod_records_get_contact(self->in.data + at, &contact, partners);
        const int64_t place = clod_ids_row(&self->known, partners[0]);
        self->lost = self->lost || place < 0;
        if (place >= 0) {
            clod_bytes_put(&self->out[owner_of_place(self, (size_t)place)], self->in.data + at,
                           CLOD_RECORDS_CONTACT);
        }
    }
    return swap(self, status);
}

/** From there, where they stay, to the owners of their second grains too. */
static bool to_second(route *self, clod_status *status)
{
    const clod_grains *grains = &self->crew->state.grains;
    clod_ranks *ranks = self->crew->ranks;
    clod_ids rows = {0};
    const bool good = clod_ids_init(&rows, grains->id, grains->count, status);
    for (size_t at = 0; good && at < self->in.count; at += CLOD_RECORDS_CONTACT) {
        clod_contact contact;
        uint64_t partners[2];
        clod_records_get_contact(self->in.data + at, &contact, partners);
        const int64_t j = contact.shape < 0 ? clod_ids_row(&rows, partners[1]) : 0;
        const int owner = contact.shape < 0 && j >= 0 ? owner_of(self, (size_t)j) : ranks->rank;
        self->lost = self->lost || j < 0;
        clod_bytes_put(&self->out[ranks->rank], self->in.data + at, CLOD_RECORDS_CONTACT);
        if (owner != ranks->rank) {
            clod_bytes_put(&self->out[owner], self->in.data + at, CLOD_RECORDS_CONTACT);
        }
    }
    clod_ids_fini(&rows);
    return clod_ranks_agree(ranks, good, status) && swap(self, status);
}

/** Contacts with the rows of this rank. */
static bool take(route *self, clod_status *status)
{
    clod_crew *crew = self->crew;
    const bool good =
        (!self->lost ||
         clod_status_fail(status, CLOD_FAILED,
                          "the checkpoint holds two grains of one id, or contacts of grains "
                          "that it does not have, or that are far from each other. Start over "
                          "with --fresh.")) &&
        clod_records_get_contacts(&self->in, &crew->state, &crew->spread.separated, status);
    return clod_ranks_agree(crew->ranks, good, status);
}

bool clod_crew_part_route(clod_crew *self, clod_status *status)
{
    route way;
    const bool good = route_init(&way, self, status) && tell_ids(&way, status) &&
                      to_directories(&way, status) && to_first(&way, status) &&
                      to_second(&way, status) && take(&way, status);
    route_fini(&way);
    return good;
}
