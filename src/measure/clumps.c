#include "measure/clumps.h"

#include <math.h>

#include "base/memory.h"
#include "measure/clumps_join.h"

/** What is known of a row. */
enum {
    COUNTS = 1,  ///< it is in the region, if there is one
    BETWEEN = 2, ///< the first by id of a bond across ranks
    OPEN = 4,    ///< of a root: some of its tree is
    WALLED = 8   ///< of a root: an own grain of its tree touches a wall
};

/** Rows that hang together, as trees: each is below a row before it, or a root. */
typedef struct forest {
    const clod_survey_part *here;
    const clod_bonds *bonds;
    int32_t *above; ///< [rows] a row before it in its tree; its own: a root
    int32_t *size;  ///< [rows] of a root: own grains of its tree that count
    int32_t *part;  ///< [rows] of a root: number of its part; -1: it is no clump
    uint8_t *is;    ///< [rows]
    clod_clump_parts parts;
    clod_clump_units units;
    clod_clump_sum mass; ///< of all own grains that count
} forest;

static void forest_fini(forest *self)
{
    clod_memory_free(self->above);
    clod_memory_free(self->size);
    clod_memory_free(self->part);
    clod_memory_free(self->is);
    clod_memory_free(self->parts.part);
    clod_memory_free(self->parts.link);
}

static double volume_of(double radius)
{
    return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

/** Every row by itself; false without memory. */
static bool forest_init(forest *self, const clod_survey_part *here, const clod_bonds *bonds,
                        const clod_clump_choice *choice)
{
    const clod_state *state = here->state;
    const size_t n = state->grains.count;
    *self = (forest){.here = here,
                     .bonds = bonds,
                     .above = clod_memory_alloc(n + 1, sizeof *self->above),
                     .size = clod_memory_alloc(n + 1, sizeof *self->size),
                     .part = clod_memory_alloc(n + 1, sizeof *self->part),
                     .is = clod_memory_alloc(n + 1, sizeof *self->is),
                     .units = {clod_clump_sum_unit(bonds->largest_mass),
                               clod_clump_sum_unit(volume_of(bonds->largest_radius))}};
    if (self->above == NULL || self->size == NULL || self->part == NULL || self->is == NULL) {
        return false;
    }
    for (size_t g = 0; g < n; g++) { // a ghost is where its owner has it: both see the same
        double place[4];
        clod_domain_place(&state->domain, state->grains.position[g], place);
        self->above[g] = (int32_t)g;
        self->part[g] = -1;
        self->is[g] = !choice->cuts || clod_outlet_has(&choice->region, place) ? COUNTS : 0;
    }
    return true;
}

/** Root of a row; the path to it gets shorter. */
static int32_t root_of(forest *self, int32_t row)
{
    int32_t *above = self->above;
    while (above[row] != row) {
        above[row] = above[above[row]];
        row = above[row];
    }
    return row;
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

static bool is_own(const forest *self, int32_t row)
{
    return clod_survey_has(self->here, (size_t)row);
}

/** Whether an own grain counts. */
static bool is_counted(const forest *self, size_t row)
{
    return (self->is[row] & COUNTS) != 0 && is_own(self, (int32_t)row);
}

/** Join what bonds join, and mark those across ranks. */
static void grow(forest *self)
{
    const uint64_t *id = self->here->state->grains.id;
    for (size_t k = 0; k < self->bonds->count; k++) {
        const int32_t a = self->bonds->bond[k].i, b = self->bonds->bond[k].j;
        if ((self->is[a] & self->is[b] & COUNTS) != 0) {
            join(self, a, b);
            if (!is_own(self, a) || !is_own(self, b)) {
                self->is[id[a] < id[b] ? a : b] |= BETWEEN;
            }
        }
    }
}

/** Let each root know its tree. */
static void measure_trees(forest *self)
{
    const clod_grains *grains = &self->here->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        const int32_t root = root_of(self, (int32_t)g);
        if ((self->is[g] & BETWEEN) != 0) {
            self->is[root] |= OPEN;
            self->parts.links++;
        }
        if (is_counted(self, g)) {
            self->size[root]++;
            self->is[root] |= self->bonds->on_wall[g] ? WALLED : 0;
            self->mass += clod_clump_sum_of(grains->velocity[g][3], self->units.mass);
        }
    }
}

/** Number the trees that are clumps, or may be with what other ranks have. */
static void number_parts(forest *self, const clod_clump_choice *choice)
{
    for (size_t g = 0; g < self->here->state->grains.count; g++) {
        const bool root = self->above[g] == (int32_t)g;
        const bool out = choice->free && (self->is[g] & WALLED) != 0;
        if (root && ((self->is[g] & OPEN) != 0 || (self->size[g] >= choice->least && !out))) {
            self->part[g] = (int32_t)self->parts.parts++;
        }
    }
}

static void add_grain(forest *self, clod_clump_part *part, size_t row)
{
    const clod_grains *grains = &self->here->state->grains;
    const uint64_t id = grains->id[row];
    part->id = part->grains == 0 || id < part->id ? id : part->id;
    part->grains++;
    part->walled |= self->bonds->on_wall[row];
    part->mass += clod_clump_sum_of(grains->velocity[row][3], self->units.mass);
    part->volume += clod_clump_sum_of(volume_of(grains->position[row][3]), self->units.volume);
}

/** Parts and links; false without memory. */
static bool fill_parts(forest *self)
{
    clod_clump_parts *to = &self->parts;
    const clod_grains *grains = &self->here->state->grains;
    to->part = clod_memory_alloc(to->parts + 1, sizeof *to->part);
    to->link = clod_memory_alloc(to->links + 1, sizeof *to->link);
    if (to->part == NULL || to->link == NULL) {
        return false;
    }
    to->links = 0;
    for (size_t g = 0; g < grains->count; g++) {
        const int32_t number = self->part[root_of(self, (int32_t)g)];
        if ((self->is[g] & BETWEEN) != 0) {
            to->link[to->links++] = (clod_clump_link){grains->id[g], (uint64_t)number};
        }
        if (number >= 0 && is_counted(self, g)) {
            add_grain(self, &to->part[number], g);
        }
    }
    return true;
}

static void add_mass(const void *context, void *into, const void *from)
{
    (void)context;
    clod_clump_sum *mine = into;
    *mine += *(const clod_clump_sum *)from;
}

/** Mass of all ranks' grains that count. */
static bool weigh(clod_clumps *self, forest *trees, clod_status *status)
{
    clod_ranks *ranks = trees->here->ranks;
    if (ranks != NULL) {
        if (!clod_ranks_reserve(ranks, sizeof trees->mass, status)) {
            return false;
        }
        clod_ranks_merge(ranks, &trees->mass, sizeof trees->mass, add_mass, NULL);
    }
    self->grains_mass = clod_clump_sum_value(trees->mass, trees->units.mass);
    return true;
}

/** Let own grains know the names of their parts. */
static void name_grains(clod_clumps *self, forest *trees)
{
    for (size_t g = 0; g < trees->here->state->grains.count; g++) {
        const int32_t number = trees->part[root_of(trees, (int32_t)g)];
        const bool named = number >= 0 && self->name[number].grains > 0 && is_counted(trees, g);
        self->of[g] = named ? number : -1;
    }
}

bool clod_clumps_find(clod_clumps *self, const clod_survey_part *here, const clod_bonds *bonds,
                      const clod_clump_choice *choice, clod_status *status)
{
    forest trees;
    const size_t n = here->state->grains.count;
    *self = (clod_clumps){.of = clod_memory_alloc(n + 1, sizeof *self->of)};
    bool good = forest_init(&trees, here, bonds, choice) && self->of != NULL;
    if (good) {
        grow(&trees);
        measure_trees(&trees);
        number_parts(&trees, choice);
        good = fill_parts(&trees);
    }
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the clumps of %zu grains", n);
    }
    good = clod_survey_agree(here, good, status) && weigh(self, &trees, status) &&
           clod_clumps_join(self, here->ranks, &trees.parts, &trees.units, choice, status);
    if (good) {
        name_grains(self, &trees);
    }
    forest_fini(&trees);
    return good;
}

void clod_clumps_fini(clod_clumps *self)
{
    clod_memory_free(self->clump);
    clod_memory_free(self->name);
    clod_memory_free(self->of);
    *self = (clod_clumps){0};
}
