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

// ---- random positions

static bool places_begin(void *context, const clod_state *state, const clod_domain_box *box,
                         double largest, size_t grains, clod_status *status)
{
    clod_deal *self = context;
    const clod_crew_places_what what = {state->domain, *box, largest, grains};
    return clod_crew_places_begin(&self->kept, self->ranks, state, &what, status);
}

static bool places_sizes(void *context, const double *radius, size_t count, clod_status *status)
{
    clod_deal *self = context;
    return clod_crew_places_sizes(&self->kept, self->ranks, radius, count, status);
}

static bool places_next(void *context, const clod_sort_item **grain, size_t *count,
                        clod_status *status)
{
    clod_deal *self = context;
    const size_t chunk = self->taker.piece / (size_t)self->ranks->size + 1;
    const bool good = clod_crew_places_next(&self->kept, self->ranks, chunk, status);
    *grain = self->kept.sizes.pool;
    *count = good ? self->kept.sizes.ready : 0;
    return good;
}

static bool places_ask(void *context, const double (*place)[4], size_t count, bool *clear,
                       clod_status *status)
{
    clod_deal *self = context;
    return clod_crew_places_ask(&self->kept, self->ranks, place, count, clear, status);
}

static bool places_put(void *context, const clod_placed_sphere *grain, size_t count,
                       clod_status *status)
{
    clod_deal *self = context;
    return clod_crew_places_put(&self->kept, self->ranks, grain, count, status);
}

static bool places_fetch(void *context, size_t first, size_t count, double (*place)[4],
                         clod_status *status)
{
    clod_deal *self = context;
    return clod_crew_places_fetch(&self->kept, self->ranks, first, count, place, status);
}

static void places_end(void *context)
{
    clod_deal *self = context;
    clod_crew_places_end(&self->kept, self->ranks);
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
    self->keeper = (clod_setup_keeper){.context = self,
                                       .begin = places_begin,
                                       .sizes = places_sizes,
                                       .next = places_next,
                                       .ask = places_ask,
                                       .put = places_put,
                                       .fetch = places_fetch,
                                       .end = places_end};
    self->taker = (clod_setup_taker){.context = self,
                                     .piece = PIECE,
                                     .keeper = &self->keeper,
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
