#include "mesh/surface_parts.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/sort.h"
#include "mesh/mesh.h"

#define NOBODY UINT32_MAX
/** Times that a plane is fitted to its facets, at most: each finds several times as many as the one before. */
#define FITS 16

// ---- links

/** A pair of facets that are linked. */
typedef void (*link_use)(clod_surface_links *self, uint32_t a, uint32_t b);

/** Give every pair to `use`, in the same order each time. */
static void for_pairs(clod_surface_links *self, const clod_mesh *mesh, link_use use)
{
    for (size_t f = 0; f < mesh->view.facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint32_t other = mesh->view.neighbours[f][e];
            if (other != CLOD_MESH_NONE) {
                use(self, (uint32_t)f, other);
            }
        }
    }
    for (size_t p = 0; p < mesh->overlap_count; p++) {
        use(self, mesh->overlaps[p][0], mesh->overlaps[p][1]);
    }
}

static void count_pair(clod_surface_links *self, uint32_t a, uint32_t b)
{
    self->start[a + 2]++;
    self->start[b + 2]++;
}

static void put_pair(clod_surface_links *self, uint32_t a, uint32_t b)
{
    self->item[self->start[a + 1]++] = b;
    self->item[self->start[b + 1]++] = a;
}

bool clod_surface_links_make(clod_surface_links *self, const clod_mesh *mesh)
{
    const size_t facets = mesh->view.facet_count;
    *self = (clod_surface_links){0};
    self->start = clod_memory_alloc(facets + 2, sizeof *self->start);
    self->item =
        clod_memory_alloc(6 * facets + 2 * mesh->overlap_count + 1, sizeof *self->item);
    self->work = clod_memory_alloc(facets + 1, sizeof *self->work);
    if (self->start == NULL || self->item == NULL || self->work == NULL) {
        return false;
    }
    for_pairs(self, mesh, count_pair);
    for (size_t f = 0; f < facets; f++) {
        self->start[f + 2] += self->start[f + 1];
    }
    for_pairs(self, mesh, put_pair); // afterwards start[f] is where facet f begins
    return true;
}

void clod_surface_links_fini(clod_surface_links *self)
{
    clod_memory_free(self->start);
    clod_memory_free(self->item);
    clod_memory_free(self->work);
    *self = (clod_surface_links){0};
}

// ---- regions that grow over links

/** Whether a region that began with `seed` takes a facet next to one of its own. */
typedef bool (*take)(const clod_surface *self, uint32_t seed, uint32_t from, uint32_t facet);

/** Give number `region` to the seed and to all that it reaches: those are the first in links->work.
 *  @return  how many */
static size_t grow(const clod_surface *self, const clod_surface_links *links, take takes,
                   uint32_t seed, uint32_t region, uint32_t *region_of)
{
    uint32_t *work = links->work;
    size_t count = 0;
    work[count++] = seed;
    region_of[seed] = region;
    for (size_t next = 0; next < count; next++) {
        const uint32_t from = work[next];
        for (uint32_t k = links->start[from]; k < links->start[from + 1]; k++) {
            const uint32_t facet = links->item[k];
            if (region_of[facet] == NOBODY && takes(self, seed, from, facet)) {
                region_of[facet] = region;
                work[count++] = facet;
            }
        }
    }
    return count;
}

static clod_vec3 corner(const clod_surface *self, uint32_t facet, int c)
{
    return clod_vec3_of(self->vertex[self->facet[facet][c]]);
}

/** Twice the area of a facet, along its normal [m2]. */
static clod_vec3 area_of(const clod_surface *self, uint32_t facet)
{
    const clod_vec3 a = corner(self, facet, 0);
    return clod_vec3_cross(clod_vec3_sub(corner(self, facet, 1), a),
                           clod_vec3_sub(corner(self, facet, 2), a));
}

static clod_vec3 normal_of(const clod_surface *self, uint32_t facet)
{
    return self->planes[self->plane[facet]].normal;
}

/** All corners lie in the plane of the seed, which is the newest. */
static bool is_in_plane(const clod_surface *self, uint32_t seed, uint32_t from, uint32_t facet)
{
    (void)seed;
    (void)from;
    const clod_surface_plane *plane = &self->planes[self->plane_count];
    for (int c = 0; c < 3; c++) {
        const clod_vec3 arm = clod_vec3_sub(corner(self, facet, c), plane->point);
        if (fabs(clod_vec3_dot(arm, plane->normal)) > self->weld) {
            return false;
        }
    }
    return true;
}

static bool bends_little(const clod_surface *self, uint32_t seed, uint32_t from, uint32_t facet)
{
    (void)seed;
    return clod_vec3_dot(normal_of(self, from), normal_of(self, facet)) > self->smooth_cosine;
}

static bool is_of_patch(const clod_surface *self, uint32_t seed, uint32_t from, uint32_t facet)
{
    (void)from;
    const double half = cos(0.5 * self->smooth);
    return self->piece[facet] == self->piece[seed] && self->part[facet] == self->part[seed] &&
           clod_vec3_dot(normal_of(self, seed), normal_of(self, facet)) >= half;
}

// ---- planes, pieces, patches

/** Facets by descending area. */
static void sort_by_area(const clod_surface *self, clod_sort_item *items)
{
    for (size_t f = 0; f < self->facet_count; f++) {
        const clod_vec3 area = area_of(self, (uint32_t)f);
        const double square = clod_vec3_dot(area, area);
        uint64_t key; // of a positive double: ascends with it
        memcpy(&key, &square, sizeof key);
        items[f] = (clod_sort_item){UINT64_MAX - key, f};
    }
    clod_sort(items, items + self->facet_count, self->facet_count);
}

/** The plane of some facets, on the side of a normal: that of the sum of their areas, in which all edges but those
 *  of the outline cancel, at their mean height. */
static clod_surface_plane fit(const clod_surface *self, const uint32_t *facet, size_t count,
                              clod_vec3 side)
{
    clod_vec3 sum = {0.0, 0.0, 0.0};
    for (size_t k = 0; k < count; k++) {
        const clod_vec3 area = area_of(self, facet[k]);
        sum = clod_vec3_axpy(sum, clod_vec3_dot(area, side) < 0.0 ? -1.0 : 1.0, area);
    }
    const double all =
        clod_vec3_length(sum); // divided by, so that an axis stays one to the bit
    const clod_vec3 normal = {sum.x / all, sum.y / all, sum.z / all};
    clod_surface_plane plane = {normal, corner(self, facet[0], 0), 0};
    double height = 0.0, weight = 0.0;
    for (size_t k = 0; k < count; k++) {
        const double area = clod_vec3_length(area_of(self, facet[k]));
        for (int c = 0; c < 3; c++) {
            const clod_vec3 arm = clod_vec3_sub(corner(self, facet[k], c), plane.point);
            height += area * clod_vec3_dot(arm, plane.normal);
            weight += area;
        }
    }
    plane.point = clod_vec3_axpy(plane.point, height / weight, plane.normal);
    return plane;
}

/** Facets in one plane with the seed, by number of the newest plane. That of a sliver is not known well: the
 *  plane of those that were found tells which more there are, until there are no more. */
static void find_plane(clod_surface *self, const clod_surface_links *links, uint32_t seed)
{
    clod_surface_plane *plane = &self->planes[self->plane_count];
    const clod_vec3 side = clod_vec3_unit(area_of(self, seed));
    *plane = (clod_surface_plane){side, corner(self, seed, 0), 0};
    size_t before = 0, count = 1;
    for (int turn = 0; turn < FITS && count > before; turn++) {
        before = count;
        for (size_t k = 0; count > 1 && k < count; k++) {
            self->plane[links->work[k]] = NOBODY;
        }
        count = grow(self, links, is_in_plane, seed, (uint32_t)self->plane_count, self->plane);
        if (count > 1) {
            *plane = fit(self, links->work, count, side);
        }
    }
    self->plane_count++;
}

static bool find_planes(clod_surface *self, const clod_surface_links *links)
{
    clod_sort_item *items = clod_memory_alloc(2 * self->facet_count + 1, sizeof *items);
    if (items == NULL) {
        return false;
    }
    sort_by_area(self, items);
    for (size_t k = 0; k < self->facet_count; k++) {
        const uint32_t seed = (uint32_t)items[k].index;
        if (self->plane[seed] == NOBODY) {
            find_plane(self, links, seed);
        }
    }
    clod_memory_free(items);
    return true;
}

/** Whether the facet over an edge lies in the same plane, on the same side of the edge: the other side
 *  of a sheet. */
static bool is_folded_back(const clod_surface *self, uint32_t facet, int e, uint32_t other)
{
    if (self->plane[facet] != self->plane[other]) {
        return false;
    }
    const clod_vec3 from = corner(self, facet, e);
    const clod_vec3 edge = clod_vec3_sub(corner(self, facet, (e + 1) % 3), from);
    const clod_vec3 inward = clod_vec3_cross(area_of(self, facet), edge);
    double in = 0.0;
    for (int c = 0; c < 3; c++) {
        in += clod_vec3_dot(clod_vec3_sub(corner(self, other, c), from), inward);
    }
    return in > 0.0;
}

/** Edges at which the surface ends, folds back, or bends by the smooth angle or more. */
static void find_rims(clod_surface *self, const clod_mesh *mesh)
{
    for (uint32_t f = 0; f < self->facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint32_t other = mesh->view.neighbours[f][e];
            const uint8_t kind = mesh->view.edges[f][e];
            const bool ends = other == CLOD_MESH_NONE || kind == CLOD_MESH_EDGE_OPEN ||
                              kind == CLOD_MESH_EDGE_NONMANIFOLD || (mesh->ends[f] >> e & 1);
            if (ends || self->piece[other] != self->piece[f] ||
                !bends_little(self, 0, f, other) || is_folded_back(self, f, e, other)) {
                self->rims[f] |= (uint8_t)(1 << e);
            }
        }
    }
}

/** Mark the facets of connected pieces that have an open edge; false without memory. */
static bool find_sheets(clod_surface *self, const clod_mesh *mesh)
{
    bool *open = clod_memory_alloc(mesh->view.shell_count + 1, sizeof *open);
    for (size_t f = 0; open != NULL && f < self->facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            open[mesh->view.shell[f]] |= mesh->view.edges[f][e] == CLOD_MESH_EDGE_OPEN;
        }
    }
    for (size_t f = 0; open != NULL && f < self->facet_count; f++) {
        self->rims[f] |= open[mesh->view.shell[f]] ? CLOD_SURFACE_SHEET : 0;
    }
    const bool done = open != NULL;
    clod_memory_free(open);
    return done;
}

/** A patch and its box from its facets. */
static void include(clod_surface *self, uint32_t facet)
{
    clod_surface_patch *patch = &self->patches[self->patch[facet]];
    for (int c = 0; c < 3; c++) {
        const double *v = self->vertex[self->facet[facet][c]];
        for (int a = 0; a < 3; a++) {
            patch->low[a] = fmin(patch->low[a], v[a]);
            patch->high[a] = fmax(patch->high[a], v[a]);
            const double along = clod_vec3_dot(patch->axis[a], clod_vec3_of(v));
            patch->from[a] = fmin(patch->from[a], along);
            patch->to[a] = fmax(patch->to[a], along);
        }
    }
    patch->rims = patch->rims || (self->rims[facet] & (CLOD_SURFACE_SHEET - 1)) != 0;
}

static void find_patches(clod_surface *self, const clod_surface_links *links)
{
    for (size_t f = 0; f < self->facet_count; f++) {
        if (self->patch[f] != NOBODY) {
            continue;
        }
        clod_surface_patch patch = {.part = self->part[f]};
        patch.axis[2] = normal_of(self, (uint32_t)f);
        clod_vec3_complete(patch.axis);
        for (int a = 0; a < 3; a++) {
            patch.low[a] = patch.from[a] = INFINITY;
            patch.high[a] = patch.to[a] = -INFINITY;
        }
        self->patches[self->patch_count] = patch;
        grow(self, links, is_of_patch, (uint32_t)f, (uint32_t)self->patch_count, self->patch);
        self->patch_count++;
    }
    for (size_t f = 0; f < self->facet_count; f++) {
        include(self, (uint32_t)f);
    }
}

bool clod_surface_parts_find(clod_surface *self, const clod_mesh *mesh,
                             const clod_surface_links *links)
{
    const size_t bytes = self->facet_count * sizeof(uint32_t);
    memset(self->plane, 0xff, bytes);
    memset(self->piece, 0xff, bytes);
    memset(self->patch, 0xff, bytes);
    if (!find_planes(self, links)) {
        return false;
    }
    uint32_t pieces = 0;
    for (size_t f = 0; f < self->facet_count; f++) {
        if (self->piece[f] == NOBODY) {
            grow(self, links, bends_little, (uint32_t)f, pieces++, self->piece);
        }
    }
    if (!find_sheets(self, mesh)) {
        return false;
    }
    find_rims(self, mesh);
    find_patches(self, links);
    return true;
}
