#include "sim/deal.h"

#include <string.h>

#include "setup/grains.h"

/** Grains that are made before they are dealt. */
#define PIECE 65536

static bool begin(void *context, clod_state *state, size_t grains, clod_status *status)
{
    const clod_deal *self = context;
    return clod_crew_deal_begin(self->ranks, state, grains, self->taker.piece, status);
}

static bool take(void *context, clod_state *state, size_t kept, clod_status *status)
{
    const clod_deal *self = context;
    return clod_crew_deal(self->ranks, state, kept, status);
}

static bool near(void *context, const clod_domain *domain, const clod_domain_box *box,
                 clod_setup_places *found, clod_status *status)
{
    clod_deal *self = context;
    const bool good = clod_crew_deal_near(self->ranks, domain, box, &self->places, status);
    *found = (clod_setup_places){.place = (const double(*)[4])(const void *)self->places.data,
                                 .count = good ? self->places.count / sizeof *found->place : 0};
    return good;
}

// ---- of a checkpoint

static bool begin_again(void *context, clod_state *state, size_t grains, bool *takes,
                        clod_status *status)
{
    const clod_deal *self = context;
    *takes = *self->finished == 0;
    return !*takes || clod_crew_deal_begin(self->ranks, state, grains, PIECE, status);
}

static bool take_contacts(void *context, const clod_contact *contacts,
                          const uint64_t (*partners)[2], size_t count, clod_status *status)
{
    const clod_deal *self = context;
    return clod_crew_deal_contacts(self->ranks, self->share, contacts, partners, count, status);
}

const clod_bed_taker *clod_deal_again(clod_deal *self, clod_ranks *ranks,
                                      clod_crew_share *share, const int64_t *finished)
{
    *self = (clod_deal){.ranks = ranks, .share = share, .finished = finished};
    self->again = (clod_bed_taker){
        .context = self, .begin = begin_again, .grains = take, .contacts = take_contacts};
    return ranks != NULL && ranks->size > 1 ? &self->again : NULL;
}

// ---- of a case

/** What of a bed is on the host of rank 0, which has as many ranks as any when hosts are alike. */
static double share_of(const clod_ranks *ranks)
{
    clod_rank_host host;
    if (ranks->place == NULL ||
        !clod_rank_places_host(ranks->place, ranks->size, ranks->rank, &host)) {
        return 1.0;
    }
    return (double)host.ranks / (double)ranks->size;
}

const clod_setup_taker *clod_deal_begin(clod_deal *self, clod_ranks *ranks,
                                        const clod_case *from)
{
    *self = (clod_deal){.ranks = ranks};
    if (ranks == NULL || ranks->size == 1 || !clod_setup_grains_in_pieces(from)) {
        return NULL;
    }
    self->taker = (clod_setup_taker){.context = self,
                                     .piece = PIECE,
                                     .share = share_of(ranks),
                                     .begin = begin,
                                     .take = take,
                                     .near = near};
    return &self->taker;
}

void clod_deal_fini(clod_deal *self)
{
    clod_bytes_fini(&self->places);
}
