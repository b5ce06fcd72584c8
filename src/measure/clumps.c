#include "measure/clumps.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

#define AT_A_TIME 256 // contacts

static bool lacks_memory(clod_status *status, size_t grains)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for the clumps of %zu grains",
                            grains);
}

// ---- bonds

static bool add_bond(clod_bonds *self, const clod_contact *contact)
{
    if (self->count == self->room) {
        const size_t room = self->room + self->room / 2 + AT_A_TIME;
        void *bond = clod_memory_grow(self->bond, self->room, room, sizeof *self->bond);
        if (bond == NULL) {
            return false;
        }
        self->bond = bond;
        self->room = room;
    }
    self->bond[self->count++] = (clod_bond){contact->i, contact->j};
    return true;
}

/** Bonds and touched walls of all contacts; `weight` is N for each kg. */
static bool read_contacts(clod_bonds *self, const clod_state *state,
                          const clod_contact_source *contacts, double weight)
{
    clod_contact some[AT_A_TIME];
    size_t pairs, walls, count;
    bool good = true;
    contacts->begin(contacts->context, &pairs, &walls);
    do {
        count = contacts->next(contacts->context, some, AT_A_TIME);
        for (size_t k = 0; good && k < count; k++) {
            if (some[k].shape >= 0) {
                self->on_wall[some[k].i] = true;
            } else if (contacts->strength != NULL) {
                const double *a = state->grains.velocity[some[k].i];
                const double *b = state->grains.velocity[some[k].j];
                const double pull = contacts->strength(contacts->laws, &some[k]).pull_off;
                good = !(pull > weight * fmin(a[3], b[3])) || add_bond(self, &some[k]);
            }
        }
    } while (good && count == AT_A_TIME);
    return good;
}

bool clod_bonds_find(clod_bonds *self, const clod_state *state,
                     const clod_contact_source *contacts, double number, clod_status *status)
{
    *self = (clod_bonds){0};
    const double *g = state->gravity;
    const double weight = number * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    self->on_wall = clod_memory_alloc(state->grains.count + 1, sizeof *self->on_wall);
    if (!clod_ids_init(&self->ids, state->grains.id, state->grains.count, status)) {
        return false;
    }
    return (self->on_wall != NULL && read_contacts(self, state, contacts, weight)) ||
           lacks_memory(status, state->grains.count);
}

void clod_bonds_fini(clod_bonds *self)
{
    clod_memory_free(self->bond);
    clod_memory_free(self->on_wall);
    clod_ids_fini(&self->ids);
    *self = (clod_bonds){0};
}

// ---- clumps

/** Grains that hang together, as a tree over each grain's index in the order of ids: its root is the
 *  first of them. */
typedef struct forest {
    int32_t *above; ///< [grains] index of a grain before it in its tree; its own: a root
    int32_t *size;  ///< [grains] of the tree of a root
    int32_t *clump; ///< [grains] number of the clump of a root; -1: none
    bool *walled;   ///< [grains] whether any of the tree of a root touches a wall
    bool *in;       ///< [grains] whether it counts
    int32_t *index; ///< [grains] of each row
} forest;

static void forest_fini(forest *self)
{
    clod_memory_free(self->above);
    clod_memory_free(self->size);
    clod_memory_free(self->clump);
    clod_memory_free(self->walled);
    clod_memory_free(self->in);
    clod_memory_free(self->index);
}

static bool forest_init(forest *self, const clod_state *state, const clod_bonds *bonds,
                        const clod_outlet *region)
{
    const size_t n = state->grains.count;
    *self = (forest){.above = clod_memory_alloc(n + 1, sizeof *self->above),
                     .size = clod_memory_alloc(n + 1, sizeof *self->size),
                     .clump = clod_memory_alloc(n + 1, sizeof *self->clump),
                     .walled = clod_memory_alloc(n + 1, sizeof *self->walled),
                     .in = clod_memory_alloc(n + 1, sizeof *self->in),
                     .index = clod_memory_alloc(n + 1, sizeof *self->index)};
    if (self->above == NULL || self->size == NULL || self->clump == NULL ||
        self->walled == NULL || self->in == NULL || self->index == NULL) {
        return false;
    }
    for (size_t k = 0; k < n; k++) {
        const size_t row = bonds->ids.item[k].index;
        self->above[k] = (int32_t)k;
        self->clump[k] = -1;
        self->index[row] = (int32_t)k;
        double place[4];
        clod_domain_place(&state->domain, state->grains.position[row], place);
        self->in[k] = region == NULL || clod_outlet_has(region, place);
    }
    return true;
}

/** Root of an index; the path to it gets shorter. */
static int32_t root_of(forest *self, int32_t k)
{
    int32_t *above = self->above;
    while (above[k] != k) {
        above[k] = above[above[k]];
        k = above[k];
    }
    return k;
}

static void join(forest *self, int32_t a, int32_t b)
{
    const int32_t first = root_of(self, a), second = root_of(self, b);
    if (first < second) {
        self->above[second] = first;
    } else {
        self->above[first] = second;
    }
}

/** Join what bonds join, and let each root know its tree. */
static void grow(forest *self, const clod_state *state, const clod_bonds *bonds)
{
    for (size_t k = 0; k < bonds->count; k++) {
        const int32_t a = self->index[bonds->bond[k].i], b = self->index[bonds->bond[k].j];
        if (self->in[a] && self->in[b]) {
            join(self, a, b);
        }
    }
    for (size_t k = 0; k < state->grains.count; k++) {
        const int32_t root = root_of(self, (int32_t)k);
        self->size[root]++;
        self->walled[root] = self->walled[root] || bonds->on_wall[bonds->ids.item[k].index];
    }
}

/** Number the clumps in the order of their first grains; how many there are. */
static size_t number_clumps(forest *self, size_t grains, const clod_clump_choice *choice)
{
    size_t count = 0;
    for (size_t k = 0; k < grains; k++) {
        if (self->above[k] == (int32_t)k && self->size[k] >= choice->least &&
            !(choice->free && self->walled[k])) {
            self->clump[k] = (int32_t)count++;
        }
    }
    return count;
}

/** Put every grain into its clump. */
static void fill_clumps(clod_clumps *self, forest *trees, const clod_state *state,
                        const clod_bonds *bonds)
{
    for (size_t k = 0; k < state->grains.count; k++) {
        const size_t row = bonds->ids.item[k].index;
        const int32_t number = trees->clump[root_of(trees, (int32_t)k)];
        const double mass = state->grains.velocity[row][3];
        const double r = state->grains.position[row][3];
        self->of[row] = number;
        self->grains_mass += trees->in[k] ? mass : 0.0;
        if (number >= 0) {
            clod_clump *clump = &self->clump[number];
            clump->id = clump->grains == 0 ? state->grains.id[row] : clump->id;
            clump->grains++;
            clump->mass += mass;
            clump->volume += 4.0 / 3.0 * M_PI * r * r * r;
        }
    }
}

bool clod_clumps_find(clod_clumps *self, const clod_state *state, const clod_bonds *bonds,
                      const clod_clump_choice *choice, clod_status *status)
{
    forest trees;
    const size_t n = state->grains.count;
    *self = (clod_clumps){.of = clod_memory_alloc(n + 1, sizeof *self->of)};
    bool good = forest_init(&trees, state, bonds, choice->region) && self->of != NULL;
    if (good) {
        grow(&trees, state, bonds);
        self->count = number_clumps(&trees, n, choice);
        self->clump = clod_memory_alloc(self->count + 1, sizeof *self->clump);
        good = self->clump != NULL;
    }
    if (good) {
        fill_clumps(self, &trees, state, bonds);
    }
    forest_fini(&trees);
    return good || lacks_memory(status, n);
}

void clod_clumps_fini(clod_clumps *self)
{
    clod_memory_free(self->clump);
    clod_memory_free(self->of);
    *self = (clod_clumps){0};
}

// ---- what they are

static double diameter(double volume)
{
    return cbrt(6.0 / M_PI * volume);
}

/** Diameters below which shares of the mass are: clumps from small to large. */
static bool find_quantiles(const clod_clumps *self, clod_clump_stats *stats)
{
    static const double SHARE[3] = {0.1, 0.5, 0.9};
    double *const at[3] = {&stats->d10, &stats->d50, &stats->d90};
    clod_sort_item *item = clod_memory_alloc(2 * self->count + 1, sizeof *item);
    if (item == NULL) {
        return false;
    }
    for (size_t k = 0; k < self->count; k++) {
        item[k].index = k;
        memcpy(&item[k].key, &self->clump[k].volume, sizeof item[k].key); // ascends as > 0
    }
    clod_sort(item, item + self->count, self->count);
    double mass = 0.0;
    int next = 0;
    for (size_t k = 0; k < self->count; k++) {
        const clod_clump *clump = &self->clump[item[k].index];
        mass += clump->mass;
        const bool last = k + 1 == self->count;
        for (; next < 3 && (last || mass >= SHARE[next] * stats->mass); next++) {
            *at[next] = diameter(clump->volume);
        }
    }
    clod_memory_free(item);
    return true;
}

bool clod_clumps_sum_up(const clod_clumps *self, clod_clump_stats *stats,
                        clod_clump_sizes *sizes, clod_status *status)
{
    *stats = (clod_clump_stats){.number = (double)self->count};
    *sizes = (clod_clump_sizes){0};
    double by_mass = 0.0;
    for (size_t k = 0; k < self->count; k++) {
        const clod_clump *clump = &self->clump[k];
        const int at = clod_clump_class(clump->grains);
        stats->grains += clump->grains;
        stats->mass += clump->mass;
        by_mass += clump->mass * clump->grains;
        stats->largest = fmax(stats->largest, clump->grains);
        stats->largest_mass = fmax(stats->largest_mass, clump->mass);
        sizes->number[at] += 1.0;
        sizes->mass[at] += clump->mass;
    }
    if (self->count == 0) {
        return true;
    }
    stats->share = stats->mass / self->grains_mass;
    stats->mean = stats->grains / stats->number;
    stats->mean_by_mass = by_mass / stats->mass;
    return find_quantiles(self, stats) || lacks_memory(status, self->count);
}
