#include "step/crew_deal.h"

#include <string.h>

#include "base/memory.h"
#include "parallel/ranks_collect.h"
#include "step/crew_part.h"
#include "step/crew_shares.h"
#include "step/migrate.h"
#include "step/records.h"

/** How rank 0 begins to deal. */
typedef struct deal_begin {
    size_t rows; ///< of each rank at most, unless there are more than were told
    bool clumps; ///< grains have them
} deal_begin;

/** Where rank 0 looks. */
typedef struct deal_near {
    clod_domain domain;
    clod_domain_box box;
} deal_near;

void clod_crew_deal_drop(clod_state *state)
{
    clod_grains_fini(&state->grains);
    clod_memory_free(state->build_position);
    state->build_position = NULL;
    state->build_capacity = 0;
}

static void order(clod_ranks *ranks, clod_crew_order_kind what)
{
    clod_crew_order all = {.what = what};
    clod_ranks_tell(ranks, &all, sizeof all);
}

bool clod_crew_part_deal_begin(clod_ranks *ranks, clod_state *state, clod_status *status)
{
    deal_begin what = {0};
    clod_ranks_tell(ranks, &what, sizeof what);
    clod_crew_deal_drop(state);
    const bool good = clod_records_reserve(state, what.rows, status) &&
                      (!what.clumps || clod_grains_keep_clumps(&state->grains, status));
    return clod_ranks_agree(ranks, good, status);
}

bool clod_crew_deal_begin(clod_ranks *ranks, clod_state *state, size_t rows, size_t piece,
                          clod_status *status)
{
    const size_t size = (size_t)ranks->size;
    deal_begin what = {rows / size + 1, state->grains.clump != NULL};
    order(ranks, CLOD_CREW_DEAL_BEGIN);
    clod_ranks_tell(ranks, &what, sizeof what);
    const size_t mine = what.rows + piece;
    return clod_ranks_agree(
        ranks, clod_records_reserve(state, mine < rows ? mine : rows, status), status);
}

bool clod_crew_part_deal(clod_ranks *ranks, clod_state *state, clod_status *status)
{
    clod_crew_shares all;
    bool good = clod_crew_shares_init(&all, ranks, status) &&
                clod_crew_shares_swap(&all, ranks, status);
    if (good) {
        const bool mine = clod_records_get_grains(&all.in, state, status);
        good = clod_ranks_agree(ranks, mine, status);
    }
    clod_crew_shares_fini(&all, ranks);
    return good;
}

/** Every rank its share of some rows, which are in order. */
static void pack(const clod_state *state, size_t kept, int ranks, clod_bytes *out)
{
    const size_t rows = state->grains.count - kept, size = (size_t)ranks;
    for (size_t r = 0; r < size; r++) {
        for (size_t g = rows * r / size; g < rows * (r + 1) / size; g++) {
            clod_records_put_grain(&out[r], state, kept + g);
        }
    }
}

bool clod_crew_deal(clod_ranks *ranks, clod_state *state, size_t kept, clod_status *status)
{
    clod_crew_shares all;
    order(ranks, CLOD_CREW_DEAL);
    bool good = clod_crew_shares_init(&all, ranks, status);
    if (good && clod_records_reserve(state, state->grains.count, status)) {
        pack(state, kept, ranks->size, all.out); // every column is there
    } else if (good) {
        all.out[0].lacks_memory = true; // swap tells it to all
    }
    good = good && clod_crew_shares_swap(&all, ranks, status);
    state->grains.count = kept;
    if (good) {
        const bool mine = clod_records_get_grains(&all.in, state, status);
        clod_grains_pad(&state->grains);
        good = clod_ranks_agree(ranks, mine, status);
    }
    clod_crew_shares_fini(&all, ranks);
    return good;
}

void clod_crew_share_fini(clod_crew_share *self)
{
    clod_bytes_fini(&self->contacts);
}

/** Contacts that came, behind those that are there. */
static bool keep_contacts(clod_ranks *ranks, clod_crew_share *share,
                          const clod_crew_shares *all, clod_status *status)
{
    clod_bytes_put(&share->contacts, all->in.data, all->in.count);
    const bool good =
        !share->contacts.lacks_memory ||
        clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of a rank");
    return clod_ranks_agree(ranks, good, status);
}

bool clod_crew_part_deal_contacts(clod_ranks *ranks, clod_crew_share *share,
                                  clod_status *status)
{
    clod_crew_shares all;
    const bool good = clod_crew_shares_init(&all, ranks, status) &&
                      clod_crew_shares_swap(&all, ranks, status) &&
                      keep_contacts(ranks, share, &all, status);
    clod_crew_shares_fini(&all, ranks);
    return good;
}

bool clod_crew_deal_contacts(clod_ranks *ranks, clod_crew_share *share,
                             const clod_contact *contacts, const uint64_t (*partners)[2],
                             size_t count, clod_status *status)
{
    clod_crew_shares all;
    const size_t size = (size_t)ranks->size;
    order(ranks, CLOD_CREW_DEAL_CONTACTS);
    bool good = clod_crew_shares_init(&all, ranks, status);
    for (size_t r = 0; good && r < size; r++) {
        for (size_t c = count * r / size; c < count * (r + 1) / size; c++) {
            clod_records_put_known(&all.out[r], &contacts[c], partners[c]);
        }
    }
    good = good && clod_crew_shares_swap(&all, ranks, status) &&
           keep_contacts(ranks, share, &all, status);
    clod_crew_shares_fini(&all, ranks);
    return good;
}

/** Places of own rows that reach into a box, to rank 0. */
static bool collect_near(clod_ranks *ranks, const clod_state *state, const deal_near *where,
                         clod_bytes *all, clod_status *status)
{
    clod_bytes mine = {0};
    size_t *begin = clod_memory_alloc((size_t)ranks->size + 1, sizeof *begin);
    for (size_t g = 0; state != NULL && g < state->grains.count; g++) {
        const double *place = state->grains.position[g];
        if (clod_migrate_reaches(&where->domain, place, &where->box, 1)) {
            clod_bytes_put(&mine, place, sizeof *state->grains.position);
        }
    }
    bool good = begin != NULL ||
                clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", ranks->size);
    good = clod_ranks_agree(ranks, good, status) &&
           clod_ranks_collect(ranks, &mine, all, begin, status);
    clod_memory_free(begin);
    clod_bytes_fini(&mine);
    return good;
}

bool clod_crew_part_deal_near(clod_ranks *ranks, const clod_state *state, clod_status *status)
{
    deal_near where = {0};
    clod_bytes none = {0};
    clod_ranks_tell(ranks, &where, sizeof where);
    const bool good = collect_near(ranks, state, &where, &none, status);
    clod_bytes_fini(&none);
    return good;
}

bool clod_crew_deal_near(clod_ranks *ranks, const clod_domain *domain,
                         const clod_domain_box *box, clod_bytes *places, clod_status *status)
{
    deal_near where = {*domain, *box};
    order(ranks, CLOD_CREW_DEAL_NEAR);
    clod_ranks_tell(ranks, &where, sizeof where);
    clod_bytes_clear(places);
    return collect_near(ranks, NULL, &where, places, status);
}
