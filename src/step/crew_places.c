#include "step/crew_places.h"

#include <string.h>

#include "base/lower_bound.h"
#include "base/memory.h"
#include "base/room.h"
#include "step/crew_bricks.h"
#include "step/crew_part.h"
#include "step/crew_shares.h"
#include "step/migrate.h"

/** How much farther than it must a rank looks beyond its brick, in radii of the largest grain, for
 *  rounding. */
#define MARGIN 0.01

typedef enum places_act { BEGIN, SIZES, NEXT, ASK, PUT, FETCH, END } places_act;

/** What rank 0 wants. */
typedef struct places_order {
    places_act act;
    size_t count, first;
} places_order;

static void give(clod_ranks *ranks, places_act act, size_t count, size_t first)
{
    clod_crew_order all = {.what = CLOD_CREW_PLACES};
    places_order order = {.act = act, .count = count, .first = first};
    clod_ranks_tell(ranks, &all, sizeof all);
    clod_ranks_tell(ranks, &order, sizeof order);
}

static bool agree(clod_ranks *ranks, bool good, clod_status *status)
{
    good = good || clod_status_fail(status, CLOD_FAILED, "no memory for the places of grains");
    return clod_ranks_agree(ranks, good, status);
}

// ---- what every rank does

/** Where grains reach that a grain in the brick of a rank may touch. */
static clod_domain_box reach_of(const clod_crew_places *self, int rank)
{
    clod_domain_box box = clod_crew_brick(&self->what.box, self->bricks, rank);
    for (int a = 0; a < 3; a++) {
        box.low[a] -= (1.0 + MARGIN) * self->what.largest;
        box.high[a] += (1.0 + MARGIN) * self->what.largest;
    }
    return box;
}

/** Own rows to the ranks in whose reach they are. */
static bool send_rows(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                      clod_status *status)
{
    clod_crew_shares all;
    bool good = clod_crew_shares_init(&all, ranks, status);
    for (int r = 0; good && r < ranks->size; r++) {
        const clod_domain_box reach = reach_of(self, r);
        for (size_t g = 0; g < state->grains.count; g++) {
            const double *place = state->grains.position[g];
            if (clod_migrate_reaches(&self->what.domain, place, &reach, 1)) {
                clod_bytes_put(&all.out[r], place, sizeof *state->grains.position);
            }
        }
    }
    good = good && clod_crew_shares_swap(&all, ranks, status);
    if (good) {
        const double(*place)[4] = (const double(*)[4])(const void *)all.in.data;
        bool kept = true;
        for (size_t k = 0; kept && k < all.in.count / sizeof *place; k++) {
            kept = clod_sphere_grid_add(&self->grid, place[k], status);
        }
        good = clod_ranks_agree(ranks, kept, status);
    }
    clod_crew_shares_fini(&all, ranks);
    return good;
}

static bool begin(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                  clod_crew_places_what what, clod_status *status)
{
    clod_crew_places_fini(self);
    clod_ranks_tell(ranks, &what, sizeof what);
    self->what = what;
    clod_crew_bricks(&what.box, ranks->size, self->bricks);
    self->reach = reach_of(self, ranks->rank);
    const clod_domain_box brick = clod_crew_brick(&what.box, self->bricks, ranks->rank);
    double period[3];
    for (int a = 0; a < 3; a++) {
        period[a] = what.domain.periodic[a] ? what.domain.max[a] - what.domain.min[a] : 0.0;
    }
    const size_t share = what.grains / (size_t)ranks->size + 1;
    const bool good = clod_sphere_grid_begin(&self->grid, brick.low, brick.high, period,
                                             what.largest, share, status);
    return clod_ranks_agree(ranks, good, status) && send_rows(self, ranks, state, status);
}

/** Answer which of the places that came are free. */
static void answer(const clod_crew_places *self, const clod_bytes *in, clod_bytes *out)
{
    const double(*place)[4] = (const double(*)[4])(const void *)in->data;
    for (size_t k = 0; k < in->count / sizeof *place; k++) {
        const char clear = clod_sphere_grid_clear(&self->grid, place[k]) ? 1 : 0;
        clod_bytes_put(out, &clear, 1);
    }
}

/** Places from rank 0 to the ranks in whose bricks they are, and answers back: `all` has them, in the
 *  order of ranks. */
static bool ask(const clod_crew_places *self, clod_ranks *ranks, clod_crew_shares *all,
                clod_status *status)
{
    clod_crew_shares back = {0};
    bool good = clod_crew_shares_swap(all, ranks, status) &&
                clod_crew_shares_init(&back, ranks, status);
    if (good) {
        answer(self, &all->in, &back.out[0]);
        good = clod_crew_shares_collect(&back, ranks, status);
    }
    clod_crew_shares_fini(all, ranks);
    *all = back;
    return good;
}

/** Keep a grain that was put, if it matters here. False without memory. */
static bool keep(clod_crew_places *self, int rank, const clod_placed_sphere *grain,
                 clod_status *status)
{
    if (!clod_migrate_reaches(&self->what.domain, grain->place, &self->reach, 1)) {
        return true;
    }
    const size_t at = self->grid.sphere_count;
    if (clod_crew_brick_of(&self->what.box, self->bricks, grain->place) == rank) {
        if (!clod_room_for_one(&self->home, &self->home_room, self->homes,
                               sizeof *self->home)) {
            return false;
        }
        self->home[self->homes++] = (clod_sort_item){.key = grain->number, .index = at};
    }
    return clod_sphere_grid_add(&self->grid, grain->place, status);
}

static bool put(clod_crew_places *self, clod_ranks *ranks, const clod_placed_sphere *placed,
                size_t count, clod_status *status)
{
    bool good =
        clod_room_for(&self->placed, &self->placed_room, count + 1, sizeof *self->placed);
    if (!agree(ranks, good, status)) {
        return false;
    }
    if (placed != NULL && count > 0) {
        memcpy(self->placed, placed, count * sizeof *placed);
    }
    clod_ranks_tell(ranks, self->placed, count * sizeof *self->placed);
    for (size_t k = 0; good && k < count; k++) {
        good = keep(self, ranks->rank, &self->placed[k], status);
    }
    return agree(ranks, good, status);
}

static bool sort_homes(clod_crew_places *self)
{
    clod_crew_sizes_fini(&self->sizes); // nobody asks for the next any more
    clod_sort_item *scratch = clod_memory_alloc(self->homes + 1, sizeof *scratch);
    if (scratch == NULL) {
        return false;
    }
    clod_sort(self->home, scratch, self->homes);
    clod_memory_free(scratch);
    self->in_order = true;
    return true;
}

static size_t homes_below(const clod_crew_places *self, uint64_t number)
{
    clod_lower_bound in = {0, self->homes};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, self->home[middle].key < number);
    }
    return in.low;
}

/** Own grains with numbers in a range, to rank 0. */
static bool fetch(clod_crew_places *self, clod_ranks *ranks, size_t first, size_t count,
                  clod_crew_shares *all, clod_status *status)
{
    if (!agree(ranks, self->in_order || sort_homes(self), status) ||
        !clod_crew_shares_init(all, ranks, status)) {
        return false;
    }
    for (size_t k = homes_below(self, first);
         k < self->homes && self->home[k].key < first + count; k++) {
        clod_placed_sphere grain = {.number = self->home[k].key};
        memcpy(grain.place, self->grid.sphere[self->home[k].index], sizeof grain.place);
        clod_bytes_put(&all->out[0], &grain, sizeof grain);
    }
    return clod_crew_shares_collect(all, ranks, status);
}

void clod_crew_places_fini(clod_crew_places *self)
{
    clod_sphere_grid_fini(&self->grid);
    clod_crew_sizes_fini(&self->sizes);
    clod_memory_free(self->home);
    clod_memory_free(self->placed);
    *self = (clod_crew_places){0};
}

// ---- rank 0

bool clod_crew_places_begin(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                            const clod_crew_places_what *what, clod_status *status)
{
    give(ranks, BEGIN, 0, 0);
    return begin(self, ranks, state, *what, status);
}

bool clod_crew_places_sizes(clod_crew_places *self, clod_ranks *ranks, const double *radius,
                            size_t count, clod_status *status)
{
    give(ranks, SIZES, count, 0);
    return clod_crew_sizes_give(&self->sizes, ranks, radius, count, status);
}

bool clod_crew_places_next(clod_crew_places *self, clod_ranks *ranks, size_t chunk,
                           clod_status *status)
{
    give(ranks, NEXT, chunk, 0);
    return clod_crew_sizes_next(&self->sizes, ranks, chunk, status);
}

bool clod_crew_places_ask(clod_crew_places *self, clod_ranks *ranks, const double (*place)[4],
                          size_t count, bool *clear, clod_status *status)
{
    clod_crew_shares all;
    give(ranks, ASK, count, 0);
    bool good = clod_crew_shares_init(&all, ranks, status);
    for (size_t k = 0; good && k < count; k++) {
        const int to = clod_crew_brick_of(&self->what.box, self->bricks, place[k]);
        clod_bytes_put(&all.out[to], place[k], sizeof *place);
    }
    good = good && ask(self, ranks, &all, status);
    for (size_t k = 0; good && k < count; k++) { // those of a rank lie in the order of asking
        const int from = clod_crew_brick_of(&self->what.box, self->bricks, place[k]);
        clear[k] = all.in.data[all.begin[from]++] != 0;
    }
    clod_crew_shares_fini(&all, ranks);
    return good;
}

bool clod_crew_places_put(clod_crew_places *self, clod_ranks *ranks,
                          const clod_placed_sphere *placed, size_t count, clod_status *status)
{
    give(ranks, PUT, count, 0);
    return put(self, ranks, placed, count, status);
}

bool clod_crew_places_fetch(clod_crew_places *self, clod_ranks *ranks, size_t first,
                            size_t count, double (*place)[4], clod_status *status)
{
    clod_crew_shares all = {0};
    give(ranks, FETCH, count, first);
    const bool good = fetch(self, ranks, first, count, &all, status);
    const clod_placed_sphere *grain = (const clod_placed_sphere *)(const void *)all.in.data;
    for (size_t k = 0; good && k < all.in.count / sizeof *grain; k++) {
        memcpy(place[grain[k].number - first], grain[k].place, sizeof *place);
    }
    clod_crew_shares_fini(&all, ranks);
    return good;
}

void clod_crew_places_end(clod_crew_places *self, clod_ranks *ranks)
{
    give(ranks, END, 0, 0);
    clod_crew_places_fini(self);
}

// ---- the others

static bool part_ask(const clod_crew_places *self, clod_ranks *ranks, clod_status *status)
{
    clod_crew_shares all;
    const bool good =
        clod_crew_shares_init(&all, ranks, status) && ask(self, ranks, &all, status);
    clod_crew_shares_fini(&all, ranks);
    return good;
}

static bool part_fetch(clod_crew_places *self, clod_ranks *ranks, const places_order *order,
                       clod_status *status)
{
    clod_crew_shares all = {0};
    const bool good = fetch(self, ranks, order->first, order->count, &all, status);
    clod_crew_shares_fini(&all, ranks);
    return good;
}

bool clod_crew_part_places(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                           clod_status *status)
{
    places_order order = {0};
    clod_ranks_tell(ranks, &order, sizeof order);
    switch (order.act) {
    case BEGIN:
        return begin(self, ranks, state, (clod_crew_places_what){0}, status);
    case SIZES:
        return clod_crew_sizes_give(&self->sizes, ranks, NULL, order.count, status);
    case NEXT:
        return clod_crew_sizes_next(&self->sizes, ranks, order.count, status);
    case ASK:
        return part_ask(self, ranks, status);
    case PUT:
        return put(self, ranks, NULL, order.count, status);
    case FETCH:
        return part_fetch(self, ranks, &order, status);
    case END:
        clod_crew_places_fini(self);
        return true;
    }
    return false;
}
