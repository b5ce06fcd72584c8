#include "measure/clumps_join.h"

#include "base/memory.h"
#include "base/sort.h"
#include "parallel/ranks_collect.h"

// ---- where all parts are

/** Parts of all ranks, one behind the other, as trees: each is below one before it, or a root. */
typedef struct heap {
    clod_clump_part *part; ///< [parts] borrowed, as the next; roots get what belongs to them
    const clod_clump_link *link;
    size_t parts, links;
    size_t *above; ///< [parts] owned
} heap;

static size_t root_of(heap *self, size_t k)
{
    size_t *above = self->above;
    while (above[k] != k) {
        above[k] = above[above[k]];
        k = above[k];
    }
    return k;
}

/** Join parts that name the same grain; false without memory. */
static bool join_links(heap *self)
{
    clod_sort_item *item = clod_memory_alloc(2 * self->links + 1, sizeof *item);
    if (item == NULL) {
        return false;
    }
    for (size_t k = 0; k < self->links; k++) {
        item[k] = (clod_sort_item){self->link[k].id, self->link[k].part};
    }
    clod_sort(item, item + self->links, self->links);
    for (size_t k = 1; k < self->links; k++) {
        const size_t a = root_of(self, item[k - 1].index), b = root_of(self, item[k].index);
        if (item[k - 1].key == item[k].key) {
            self->above[a < b ? b : a] = a < b ? a : b;
        }
    }
    clod_memory_free(item);
    return true;
}

/** Parts onto their roots, which are before them. */
static void sum_up(heap *self)
{
    for (size_t k = 0; k < self->parts; k++) {
        const size_t root = root_of(self, k);
        const clod_clump_part *from = &self->part[k];
        clod_clump_part *to = &self->part[root];
        if (root != k) {
            to->id = from->id < to->id ? from->id : to->id;
            to->grains += from->grains;
            to->walled |= from->walled;
            to->mass += from->mass;
            to->volume += from->volume;
        }
    }
}

static bool is_clump(const clod_clump_part *part, const clod_clump_choice *choice)
{
    return part->grains >= choice->least && !(choice->free && part->walled != 0);
}

/** Clumps of the roots, ascending by id; false without memory. */
static bool list_clumps(clod_clumps *self, const heap *all, const clod_clump_units *units,
                        const clod_clump_choice *choice)
{
    clod_sort_item *item = clod_memory_alloc(2 * all->parts + 1, sizeof *item);
    size_t count = 0;
    for (size_t k = 0; item != NULL && k < all->parts; k++) {
        if (all->above[k] == k && is_clump(&all->part[k], choice)) {
            item[count++] = (clod_sort_item){all->part[k].id, k};
        }
    }
    self->clump = clod_memory_alloc(count + 1, sizeof *self->clump);
    if (item == NULL || self->clump == NULL) {
        clod_memory_free(item);
        return false;
    }
    clod_sort(item, item + count, count);
    self->count = count;
    for (size_t k = 0; k < count; k++) {
        const clod_clump_part *part = &all->part[item[k].index];
        self->clump[k] =
            (clod_clump){part->id, part->grains, clod_clump_sum_value(part->mass, units->mass),
                         clod_clump_sum_value(part->volume, units->volume)};
    }
    clod_memory_free(item);
    return true;
}

/**
 * Join all parts.
 *
 * @param name  [all->parts] [out] of each part
 * @return      false without memory
 */
static bool join_all(clod_clumps *self, heap *all, const clod_clump_units *units,
                     const clod_clump_choice *choice, clod_clump_name *name)
{
    all->above = clod_memory_alloc(all->parts + 1, sizeof *all->above);
    if (all->above == NULL || name == NULL) {
        return false;
    }
    for (size_t k = 0; k < all->parts; k++) {
        all->above[k] = k;
    }
    if (!join_links(all)) {
        return false;
    }
    sum_up(all);
    for (size_t k = 0; k < all->parts; k++) {
        const clod_clump_part *root = &all->part[root_of(all, k)];
        if (is_clump(root, choice)) {
            name[k] = (clod_clump_name){root->id, root->grains};
        }
    }
    return list_clumps(self, all, units, choice);
}

// ---- to and from there

/** What rank 0 gets. */
typedef struct post {
    clod_bytes parts, links;
    size_t *parts_begin, *links_begin; ///< [ranks + 1] bytes
    clod_clump_name *name;             ///< for all parts
} post;

static void post_fini(post *self)
{
    clod_bytes_fini(&self->parts);
    clod_bytes_fini(&self->links);
    clod_memory_free(self->parts_begin);
    clod_memory_free(self->links_begin);
    clod_memory_free(self->name);
}

static bool collect(clod_ranks *ranks, const clod_clump_parts *mine, post *all,
                    clod_status *status)
{
    const clod_bytes parts = {.data = (char *)mine->part,
                              .count = mine->parts * sizeof *mine->part};
    const clod_bytes links = {.data = (char *)mine->link,
                              .count = mine->links * sizeof *mine->link};
    return clod_ranks_collect(ranks, &parts, &all->parts, all->parts_begin, status) &&
           clod_ranks_collect(ranks, &links, &all->links, all->links_begin, status);
}

/** Numbers of parts among those of all ranks, in place of those of each. */
static void number_anew(const post *all, int ranks, clod_clump_link *link)
{
    for (int r = 0; r < ranks; r++) {
        const size_t before = all->parts_begin[r] / sizeof(clod_clump_part);
        const size_t end = all->links_begin[r + 1] / sizeof *link;
        for (size_t k = all->links_begin[r] / sizeof *link; k < end; k++) {
            link[k].part += before;
        }
    }
}

/** Of rank 0: join what has come, and where the names of each rank's parts begin [bytes]. */
static bool join_collected(clod_clumps *self, clod_ranks *ranks, post *all,
                           const clod_clump_units *units, const clod_clump_choice *choice,
                           clod_status *status)
{
    clod_clump_link *link = (void *)all->links.data;
    number_anew(all, ranks->size, link);
    heap parts = {.part = (void *)all->parts.data,
                  .link = link,
                  .parts = all->parts.count / sizeof(clod_clump_part),
                  .links = all->links.count / sizeof *link};
    all->name = clod_memory_alloc(parts.parts + 1, sizeof *all->name);
    const bool good =
        join_all(self, &parts, units, choice, all->name) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %zu parts of clumps", parts.parts);
    for (int r = 0; r <= ranks->size; r++) {
        all->parts_begin[r] = all->parts_begin[r] / sizeof(clod_clump_part) * sizeof *all->name;
    }
    clod_memory_free(parts.above);
    return good;
}

static bool join_ranks(clod_clumps *self, clod_ranks *ranks, const clod_clump_parts *mine,
                       const clod_clump_units *units, const clod_clump_choice *choice,
                       clod_status *status)
{
    const size_t size = (size_t)ranks->size;
    post all = {.parts_begin = clod_memory_alloc(size + 1, sizeof *all.parts_begin),
                .links_begin = clod_memory_alloc(size + 1, sizeof *all.links_begin)};
    bool good = (self->name != NULL && all.parts_begin != NULL && all.links_begin != NULL) ||
                clod_status_fail(status, CLOD_FAILED, "no memory for %zu clumps", mine->parts);
    good = clod_ranks_agree(ranks, good, status) && collect(ranks, mine, &all, status);
    if (good) {
        good = ranks->rank != 0 || join_collected(self, ranks, &all, units, choice, status);
        good = clod_ranks_agree(ranks, good, status);
    }
    if (good) {
        clod_ranks_return(ranks, all.name, all.parts_begin, self->name,
                          self->names * sizeof *self->name);
    }
    post_fini(&all);
    return good;
}

bool clod_clumps_join(clod_clumps *self, clod_ranks *ranks, const clod_clump_parts *mine,
                      const clod_clump_units *units, const clod_clump_choice *choice,
                      clod_status *status)
{
    self->names = mine->parts;
    self->name = clod_memory_alloc(mine->parts + 1, sizeof *self->name);
    if (ranks != NULL) {
        return join_ranks(self, ranks, mine, units, choice, status);
    }
    heap all = {.part = mine->part, .parts = mine->parts};
    const bool good =
        join_all(self, &all, units, choice, self->name) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %zu clumps", mine->parts);
    clod_memory_free(all.above);
    return good;
}
