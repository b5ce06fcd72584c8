#include "step/wall_mesh.h"

#include "base/room.h"
#include "mesh/surface_touch.h"
#include "state/limits.h"

/** A facet near a grain at a rebuild. */
struct clod_wall_facet_found {
    uint32_t number, patch;
    bool near; ///< within the reach; else it is no farther than the weld distance beyond
    bool rim;  ///< a rim of it is
};

int32_t clod_wall_mesh_first(const clod_wall_rows *rows, int32_t wall, int32_t shape)
{
    const clod_wall_patch *at = clod_wall_rows_patch(rows, wall, shape);
    return shape - CLOD_SURFACE_SLOTS * at->patch - at->slot;
}

/** Place of a grain in the frame of a mesh. */
static clod_vec3 place_in(const clod_wall_rows *rows, int32_t wall, int32_t shape,
                          const double p[3])
{
    const int32_t row = clod_wall_rows_shape(rows, wall, shape);
    const clod_wall_pose pose = clod_wall_facets_pose((const double(*)[4])rows->shape + row);
    return clod_wall_to_frame(&pose, clod_vec3_of(p));
}

/** What a facet may be farther away than the reach and still hold the closest point of one
 *  within it: corners may be off their plane. */
static double slack_of(const clod_surface *surface)
{
    return 2.0 * surface->weld;
}

/** How far a facet is; `listed`: whether it is within reach for a list. The distance from a piece
 *  of a cylinder may jump as the place moves, that from the box about it does not. */
static double distance_of(const clod_surface *surface, const clod_surface_facet *facet,
                          clod_vec3 from, double reach, bool *listed)
{
    *listed = !clod_surface_facet_is_beyond(surface, facet, from, reach);
    if (!*listed) {
        return INFINITY;
    }
    const double distance = clod_surface_facet_closest(facet, from).distance;
    *listed = facet->cylinder != 0 || distance < reach + slack_of(surface);
    return distance;
}

// ---- at a rebuild

typedef struct walk {
    const clod_surface *surface;
    clod_vec3 from;
    double reach;
    clod_wall_candidates *to;
    bool lacks_memory;
} walk;

static double take(void *context, uint32_t number, double most)
{
    walk *self = context;
    clod_wall_candidates *to = self->to;
    const clod_surface_facet facet = clod_surface_facet_of(self->surface, number);
    bool listed;
    const double distance =
        distance_of(self->surface, &facet, self->from, self->reach, &listed);
    if (!listed) {
        return most;
    }
    if (!clod_room_for_one(&to->found, &to->found_capacity, to->found_count,
                           sizeof *to->found)) {
        self->lacks_memory = true;
        return -1.0;
    }
    size_t at = to->found_count++;
    for (; at > 0 && to->found[at - 1].patch > facet.patch; at--) { // few are out of order
        to->found[at] = to->found[at - 1];
    }
    to->found[at] = (clod_wall_facet_found){
        number, facet.patch, distance < self->reach,
        clod_surface_facet_rim_is_near(&facet, self->from, self->reach)};
    return most;
}

/** Put facets [begin, end) of those found, or only those with a rim near, into the list. */
static bool put_facets(clod_wall_candidates *to, size_t begin, size_t end, bool rims,
                       clod_wall_candidate *c)
{
    c->facet = to->facets;
    for (size_t k = begin; k < end; k++) {
        if (rims && !to->found[k].rim) {
            continue;
        }
        if (!clod_room_for_one(&to->facet, &to->facet_capacity, to->facets,
                               sizeof *to->facet)) {
            return false;
        }
        to->facet[to->facets++] = (clod_wall_facet){to->found[k].number & 0x7fffffff, 0};
    }
    c->facets = (int32_t)(to->facets - c->facet);
    return true;
}

/** Add the slots of one patch, whose facets are [begin, end) of those found. */
static bool put_patch(const clod_state *state, const clod_laws *laws, clod_wall_mesh_place at,
                      size_t begin, size_t end, clod_wall_candidates *to)
{
    bool near = false, rim = false;
    for (size_t k = begin; k < end; k++) {
        near |= to->found[k].near;
        rim |= to->found[k].rim;
    }
    const int32_t first = at.shape + CLOD_SURFACE_SLOTS * (int32_t)to->found[begin].patch;
    const clod_wall *wall = &state->walls.wall[at.wall];
    if (wall->shapes[first].outlet > 0) { // it removes grains, and pushes none
        return true;
    }
    clod_wall_candidate c = {.i = (int32_t)at.grain, .wall = at.wall};
    for (int32_t slot = near ? 0 : 1; slot < (rim ? CLOD_SURFACE_SLOTS : 1); slot++) {
        c.shape = first + slot;
        c.law = clod_laws_index(laws, state->grains.material[at.grain],
                                clod_wall_material(wall, c.shape));
        if ((slot <= 1 && !put_facets(to, begin, end, slot == 1, &c)) ||
            to->count == CLOD_LIMITS_WALL_PAIRS ||
            !clod_room_for_one(&to->item, &to->capacity, to->count, sizeof *to->item)) {
            return false;
        }
        to->item[to->count++] = c;
    }
    return true;
}

bool clod_wall_mesh_find(const clod_neighbour *self, const clod_state *state,
                         const clod_laws *laws, clod_wall_mesh_place at,
                         clod_wall_candidates *to)
{
    const double *p = clod_neighbour_places(self, state)[at.grain];
    const clod_wall_rows *rows = &self->build_rows;
    walk all = {.surface = clod_wall_rows_patch(rows, at.wall, at.shape)->surface,
                .from = place_in(rows, at.wall, at.shape, p),
                .reach = p[3] + self->skin,
                .to = to};
    to->found_count = 0;
    clod_surface_near(all.surface, all.from, all.reach + slack_of(all.surface), take, &all);
    bool good = !all.lacks_memory;
    size_t end = 0;
    for (size_t begin = 0; good && begin < to->found_count; begin = end) {
        while (end < to->found_count && to->found[end].patch == to->found[begin].patch) {
            end++;
        }
        good = put_patch(state, laws, at, begin, end, to);
    }
    return good;
}

// ---- at a near list

bool clod_wall_mesh_mark(clod_wall_candidates *self, const clod_wall_candidate *c,
                         const clod_wall_rows *rows, const double p[3], double reach)
{
    const clod_wall_patch *at = clod_wall_rows_patch(rows, c->wall, c->shape);
    const clod_surface *surface = at->surface;
    const clod_vec3 from = place_in(rows, c->wall, c->shape, p);
    clod_wall_facet *list = self->facet + c->facet;
    const double most = reach + slack_of(surface);
    bool near = false;
    for (int32_t k = 0; k < c->facets; k++) {
        const uint32_t number = list[k].number;
        if (at->slot > 0) { // the list belongs to all slots but the first: nothing is noted
            const clod_surface_facet facet = clod_surface_facet_of(surface, number);
            near = near || clod_surface_facet_rim_is_near(&facet, from, reach);
            continue;
        }
        bool listed = false;
        double distance = INFINITY;
        if (!clod_surface_facet_box_is_far(surface, number, from, most)) {
            const clod_surface_facet facet = clod_surface_facet_of(surface, number);
            distance = distance_of(surface, &facet, from, reach, &listed);
        }
        list[k].near = listed;
        near = near || distance < reach;
    }
    return near;
}
