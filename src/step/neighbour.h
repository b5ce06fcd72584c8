#pragma once
/**
 * @file neighbour.h
 * Who may touch whom: all pairs within a wide skin, found with cells and rebuilt rarely. At a
 * rebuild the grains are sorted by layers (layers.h), which fixes the order of sums.
 *
 * The candidates are a function of the positions at the rebuild (state->build_position) alone,
 * so a checkpoint restores exactly the same list and the same moment of the next rebuild.
 */

#include <stdbool.h>
#include <stdint.h>

#include "base/sort.h"
#include "geometry/wall_rows.h"
#include "law/law.h"
#include "parallel/threads.h"
#include "state/limits.h"
#include "state/state.h"
#include "step/kernel.h"

/** A later grain that a grain may touch before the next rebuild. */
typedef struct clod_partner {
    uint32_t j : 31;
    uint32_t near : 1; ///< the pair is on the near list
} clod_partner;

typedef struct clod_pairs {
    uint32_t *start;    ///< [grains + 1] first partner of each grain
    clod_partner *item; ///< [count], in ascending (i, j)
    size_t count, capacity;
    bool fixed; ///< part of another array: it cannot grow
} clod_pairs;

/** A grid of cells at least one reach wide, over the grains' bounding box or the period. */
typedef struct clod_cells_grid {
    double min[3], inverse_width[3]; ///< m, 1/m; 0 where all grains are at one place
    int32_t n[3];
    bool periodic[3];
} clod_cells_grid;

/** A grain and a shape of a wall that may touch. */
typedef struct clod_wall_candidate {
    int32_t i, wall;
    int32_t shape;  ///< of the wall
    int32_t law;    ///< row of clod_laws
    int32_t near;   ///< 1: it is on the near list
    int32_t facets; ///< of a mesh's patch, near its grain at the rebuild
    size_t facet;   ///< the first of them in the list
} clod_wall_candidate;

/** A facet of a mesh that a grain may touch before the next rebuild. */
typedef struct clod_wall_facet {
    uint32_t number : 31;
    uint32_t near : 1; ///< within the thin skin when the near list was made
} clod_wall_facet;

typedef struct clod_wall_facet_found clod_wall_facet_found;

/** A shape that may be near the grains of a cell. */
typedef struct clod_wall_entry {
    int32_t cell, wall, shape;
} clod_wall_entry;

/** Shapes by cell (wall_cells.h): scratch, kept between rebuilds. */
typedef struct clod_wall_cells {
    clod_wall_entry *entry;  ///< [count] in ascending (wall, shape)
    clod_wall_entry *sorted; ///< [count] the same by cell
    size_t *start;           ///< [cells + 1] first of each cell
    size_t count, entry_capacity, sorted_capacity, start_capacity;
} clod_wall_cells;

typedef struct clod_wall_candidates {
    clod_wall_candidate *item; ///< [count], in ascending (i, wall, shape)
    size_t count, capacity;
    clod_wall_facet *facet; ///< [facets] by candidate
    size_t facets, facet_capacity;
    clod_wall_facet_found *found; ///< scratch of a search (wall_mesh.c)
    size_t found_count, found_capacity;
} clod_wall_candidates;

/** What one part has found in a search; the array of its walls is kept. */
typedef struct clod_neighbour_found {
    clod_pairs pairs;           ///< in the part's share of the room for all
    clod_wall_candidates walls; ///< of the part's grains
    bool walls_fit;             ///< there was memory for them, and they are not too many
    size_t separated; ///< first contact of its grains that is no candidate; or their number
} clod_neighbour_found;

typedef struct clod_layer_order_part clod_layer_order_part; // layer_order.h

typedef struct clod_neighbour {
    double skin; ///< m
    bool brute_force;
    bool now; ///< the rebuild is now: its positions are not noted yet, but those of the grains
    const clod_kernel *kernel; ///< the machine's best, or what the step has
    double radius_min, radius_max;
    const struct clod_layers *layers; ///< of all ranks' grains; NULL: they follow from the rows
    size_t lead; ///< rows behind a grain among which are most of its partners
    clod_pairs pairs;
    clod_wall_candidates walls;
    clod_wall_rows build_rows; ///< of the walls at the last rebuild
    clod_wall_cells wall_cells;
    clod_cells_grid grid;        ///< of the search that is going on
    clod_neighbour_found *found; ///< [found_capacity]: what each part has found
    int parts;                   ///< of the search that is going on
    size_t found_capacity;
    // scratch, kept between rebuilds
    int32_t *cell_of, *cell_item; ///< [grains]; cell_of also counts contacts by grain
    int32_t *cell_start;          ///< [cells + 1], see cells.h
    int32_t *cell_last;           ///< [cells] last row in each; -1: none
    double *
        cell_place; ///< [4][place_stride] x, y, z and radius of grains in the order of cell_item
    size_t cell_capacity, grain_capacity, place_stride, place_capacity;
    clod_sort_item *sort, *sort_scratch; ///< [sort_capacity]; sort also has places of contacts
    size_t sort_capacity;
    int32_t *rank; ///< [grains] new row of each old one, or CLOD_NEIGHBOUR_GOES
    clod_layer_order_part *order_part; ///< [order_capacity]: what each part finds of an order
    clod_sort_part *sort_part;         ///< [order_capacity]: and what it counts in the sort
    size_t order_capacity;
} clod_neighbour;

/** Rank of a grain that goes at this rebuild. */
#define CLOD_NEIGHBOUR_GOES (-1)

/** Whether a row is one of the `going` that go at this rebuild. */
static inline bool clod_neighbour_goes(const clod_neighbour *self, size_t going, size_t row)
{
    return going > 0 && self->rank[row] < 0;
}

/** Items of sort_scratch that a row of four numbers takes. */
#define CLOD_NEIGHBOUR_ROW_ITEMS (4 * sizeof(double) / sizeof(clod_sort_item))

/** Scratch for a row of four numbers per grain, in sort_scratch: not while something is sorted.
 */
static inline double (*clod_neighbour_rows(const clod_neighbour *self))[4]
{
    return (double(*)[4])self->sort_scratch;
}

/** Positions of the grains at the last rebuild, [grains] x, y, z, radius [m]. */
static inline const double (*clod_neighbour_places(const clod_neighbour *self,
                                                   const clod_state *state))[4]
{
    return (const double(*)[4])(self->now ? state->grains.position : state->build_position);
}

/** Radii of the grains; nothing is built yet. */
void clod_neighbour_init(clod_neighbour *self, const clod_state *state, bool brute_force);

/** Radii anew: grains have come or gone. */
void clod_neighbour_size(clod_neighbour *self, const clod_state *state);

/**
 * The wide skin that costs least at a speed of now, for the rebuild that follows.
 *
 * @param speed  of the fastest grain or point of a wall [m/s]
 * Errors  none.   Threads  thread 0.   Source  docs/adr/0036.   Test  tests/step/test_thin_skin.c
 */
void clod_neighbour_choose_skin(clod_neighbour *self, const clod_state *state, double speed);

/**
 * Whether every period of a domain is long enough for grains up to a radius [m]: twice their
 * reach, so that a grain meets no neighbour twice.
 *
 * Errors  CLOD_USAGE with the axis and the least period.   Threads  pure.
 */
bool clod_neighbour_periods_fit(const clod_domain *domain, double radius_max,
                                clod_status *status);

/**
 * Wrap the grains into the domain, sort them by layers, carry state->contacts over and
 * note positions as those of the rebuild.
 *
 * @return  false: a grain has left an open domain (the text names it), or no memory
 */
bool clod_neighbour_sort(clod_neighbour *self, clod_state *state, clod_status *status);

/**
 * The same in steps, with those of layer_order.h and reorder.h between them. Wrap rows: false when
 * a grain of these has left the domain; inside then says which, the first of all. Give back what
 * the last rebuild left. Note when and where the rebuild is, without the positions of the grains:
 * until each thread notes its chunk of these, when the lists have been made and there is room
 * again, or have failed, `now` is set and the grains have not moved.
 *
 * @param going  so many grains go, wherever they are: their `rank` is CLOD_NEIGHBOUR_GOES
 */
bool clod_neighbour_wrap(const clod_neighbour *self, clod_state *state, size_t going,
                         clod_chunk rows);
bool clod_neighbour_inside(const clod_neighbour *self, const clod_state *state, size_t going,
                           clod_status *status);
void clod_neighbour_give_old_back(const clod_neighbour *self, const clod_state *state);
bool clod_neighbour_note(clod_neighbour *self, clod_state *state, clod_status *status);
void clod_neighbour_note_positions(clod_state *state, clod_chunk grains);

/** Rows of an array that go with the grains; `size` bytes of each, `stride` apart. */
typedef struct clod_row_column {
    char *array;
    size_t stride, size;
} clod_row_column;

#define CLOD_ROW_COLUMNS 11

/** All that goes with the grains; how many columns there are. */
int clod_neighbour_columns(const clod_grains *grains,
                           clod_row_column columns[CLOD_ROW_COLUMNS]);

/** Bring rows of a column into the order that was found: all of them out, then all back. */
void clod_neighbour_rows_out(const clod_neighbour *self, const clod_row_column *column,
                             clod_chunk rows);
void clod_neighbour_rows_back(const clod_neighbour *self, const clod_row_column *column,
                              clod_chunk rows);

/** Rename the grains of a contact; when their order turns, the contact is met the other way. */
void clod_neighbour_rename(const clod_neighbour *self, clod_contact *c);

/**
 * Put a state that nobody steps back into the order of its last rebuild, which follows from
 * state->build_position and the ids: whatever the order of its rows and contacts, the order of
 * forces is the same.
 *
 * @return  false without memory.   Test  tests/step/test_any_order.c
 */
bool clod_neighbour_sort_as_built(clod_neighbour *self, clod_state *state, clod_status *status);

/**
 * Candidates from the positions of the last rebuild and build_walls; every contact must be among them. In
 * steps: begin, add and end once; count, enter and part by each of the parts, at the same time.
 * Grains are counted by cell, the numbers added up to where each cell begins, the grains entered
 * there; then each part searches the cells around its grains.
 */
bool clod_neighbour_build_begin(clod_neighbour *self, const clod_state *state, int parts,
                                clod_status *status);
void clod_neighbour_build_count(clod_neighbour *self, const clod_state *state, int part);
void clod_neighbour_build_add(clod_neighbour *self, const clod_state *state);
void clod_neighbour_build_enter(clod_neighbour *self, const clod_state *state, int part);
void clod_neighbour_build_part(clod_neighbour *self, const clod_state *state,
                               const clod_laws *laws, int part);
bool clod_neighbour_build_end(clod_neighbour *self, const clod_state *state,
                              clod_status *status);

/** All of that by one thread. */
bool clod_neighbour_build(clod_neighbour *self, const clod_state *state, const clod_laws *laws,
                          clod_status *status);

/** Room for the grains there are in the arrays of the search; false without memory. */
bool clod_neighbour_reserve(clod_neighbour *self, const clod_state *state, clod_status *status);

/** Room for one more candidate; false without. */
bool clod_neighbour_grow(clod_pairs *self);

/** Add a pair at the end of the candidates; false without room, and beyond the limit. */
static inline bool clod_neighbour_add(clod_pairs *self, size_t j)
{
    if (self->count == CLOD_LIMITS_PAIRS || // start could not tell where they are
        (self->count >= self->capacity && !clod_neighbour_grow(self))) {
        return false;
    }
    self->item[self->count++] = (clod_partner){(uint32_t)j & 0x7fffffff, 0};
    return true;
}

/** Say that a grain is far from what it touched one step before; false. */
bool clod_neighbour_fail_separated(const clod_state *state, uint64_t id, clod_status *status);

/** Say why no more candidates could be added: beyond a limit, or without memory; false. */
bool clod_neighbour_fail_to_add(const clod_neighbour *self, size_t grains, clod_status *status);

/** Give the scratch of a large bed back to the system until it is next used: all of it, or what
 *  contacts were brought into order with. */
void clod_neighbour_give_back(clod_neighbour *self);
void clod_neighbour_give_ranks_back(clod_neighbour *self);

void clod_neighbour_fini(clod_neighbour *self);
