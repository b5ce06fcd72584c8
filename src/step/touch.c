#include "step/touch.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"

// ---- the lists

void clod_touch_begin(clod_touch_part *self)
{
    self->sites = self->lanes = self->nears = self->placed = 0;
    clod_touch_facets_begin(&self->table);
    self->lacks_memory = false;
}

/** The facets of a candidate that are near, behind those of its site. */
static void add_facets(const clod_near_job *job, clod_touch_part *part,
                       const clod_wall_candidate *candidate, const clod_surface *surface)
{
    const clod_wall_facet *facet = job->neighbour->walls.facet + candidate->facet;
    for (int32_t k = 0; k < candidate->facets; k++) {
        if (facet[k].near == 0) {
            continue;
        }
        if (!clod_room_for_one(&part->near, &part->near_room, part->nears,
                               sizeof *part->near) ||
            !clod_touch_facets_take(&part->table, surface, facet[k].number,
                                    &part->near[part->nears])) {
            part->lacks_memory = true;
            return;
        }
        part->nears++;
    }
}

/** A site for a grain and the meshes of a wall. */
static clod_touch_site *begin_site(const clod_near_job *job, clod_touch_part *part,
                                   const clod_wall_candidate *candidate)
{
    if (!clod_room_for_one(&part->site, &part->site_room, part->sites, sizeof *part->site)) {
        part->lacks_memory = true;
        return NULL;
    }
    const int32_t row = clod_wall_rows_shape(job->walls, candidate->wall, candidate->shape);
    clod_touch_site *site = &part->site[part->sites++];
    *site = (clod_touch_site){.i = candidate->i,
                              .wall = candidate->wall,
                              .pose = row,
                              .lane = part->lanes,
                              .near = part->nears};
    return site;
}

/** All facets of a site lie in one plane and no rim is near: the plane, or -1. */
static int32_t plane_of(const clod_touch_part *part, const clod_touch_site *site)
{
    if (site->lanes != 1 || site->facets == 0) {
        return -1;
    }
    const clod_surface_facet *facet = part->table.facet;
    const clod_surface_facet *first = &facet[part->near[site->near]];
    bool flat = first->cylinder == 0;
    for (size_t k = 1; flat && k < site->facets; k++) {
        const clod_surface_facet *other = &facet[part->near[site->near + k]];
        flat = other->plane == first->plane && other->surface == first->surface;
    }
    return flat ? (int32_t)first->plane : -1;
}

void clod_touch_add(const clod_near_job *job, int number, const clod_wall_candidate *candidate)
{
    clod_touch_part *part = &job->near->touch.part[number];
    const clod_wall_patch *at =
        clod_wall_rows_patch(job->walls, candidate->wall, candidate->shape);
    clod_touch_site *site = part->sites > 0 ? &part->site[part->sites - 1] : NULL;
    if (part->lacks_memory) {
        return;
    }
    if (site == NULL || site->i != candidate->i || site->wall != candidate->wall) {
        site = begin_site(job, part, candidate);
    }
    if (part->lacks_memory ||
        !clod_room_for_one(&part->lane, &part->lane_room, part->lanes, sizeof *part->lane)) {
        part->lacks_memory = true;
        return;
    }
    part->lane[part->lanes++] =
        (clod_touch_lane){.surface = at->surface, .patch = at->patch, .slot = at->slot};
    site->lanes = part->lanes - site->lane;
    if (at->slot == 0) {
        add_facets(job, part, candidate, at->surface);
        site->facets = part->nears - site->near;
    }
    if (part->lacks_memory ||
        !clod_room_for(&part->hit, &part->hit_room, site->facets, sizeof *part->hit)) {
        part->lacks_memory = true;
        return;
    }
    site->plane = plane_of(part, site);
}

bool clod_touch_layout(clod_near *near)
{
    clod_touch *touch = &near->touch;
    size_t rows = 1;
    for (int p = 0; p < near->parts; p++) {
        if (touch->part[p].lacks_memory) {
            return false;
        }
        touch->part[p].row = rows;
        rows += touch->part[p].lanes;
    }
    if (!clod_room_for(&touch->row, &touch->row_room, rows, sizeof *touch->row)) {
        return false;
    }
    if (near->wear &&
        !clod_room_for(&touch->facet, &touch->facet_room, rows, sizeof *touch->facet)) {
        return false;
    }
    memset(touch->row, 0, rows * sizeof *touch->row);
    touch->row[0][2] = 1.0;
    return true;
}

int32_t clod_touch_place(clod_near *near, int number, size_t block, int lane)
{
    clod_touch_part *part = &near->touch.part[number];
    clod_touch_lane *to = &part->lane[part->placed];
    to->block = block;
    to->lane = lane;
    return (int32_t)(part->row + part->placed++);
}

// ---- the closest points

/** The lanes of a site while its contacts are found. */
typedef struct lanes {
    const clod_touch_lane *lane;
    double (*row)[4];
    int32_t *facet; ///< of each, or NULL
    clod_wall_block *blocks;
    size_t count;
} lanes;

static clod_history *history_of(const lanes *self, size_t lane)
{
    return &self->blocks[self->lane[lane].block].history;
}

static bool has_history(const lanes *self, size_t lane)
{
    return clod_history_is_there(history_of(self, lane), self->lane[lane].lane);
}

static bool is_of_patch(const clod_touch_lane *lane, const clod_surface_hit *hit)
{
    return lane->patch == (int32_t)hit->patch && lane->surface == hit->of->surface;
}

/** Lane of a contact. */
static size_t lane_of(const lanes *self, const clod_surface_hit *hit)
{
    size_t lane = 0;
    while (lane < self->count &&
           (!is_of_patch(&self->lane[lane], hit) || self->lane[lane].slot != hit->slot)) {
        lane++;
    }
    CLOD_ASSERT(lane < self->count); // what touches was near when the list was made
    return lane;
}

static void put_row(double row[4], const clod_wall_pose *pose, clod_vec3 direction,
                    double distance)
{
    clod_vec3_put(row, clod_wall_to_space(pose, direction));
    row[3] = distance;
}

static void put_open(double row[4], double radius)
{
    row[0] = row[1] = 0.0;
    row[2] = 1.0;
    row[3] = 2.0 * radius;
}

/** Whether another contact of a lane's patch is there in a slot. */
static bool has_other(const lanes *self, size_t lane, int32_t slot)
{
    const clod_touch_lane *of = &self->lane[lane];
    for (size_t l = 0; l < self->count; l++) {
        const clod_touch_lane *other = &self->lane[l];
        if (l != lane && other->surface == of->surface && other->patch == of->patch &&
            other->slot == slot && has_history(self, l)) {
            return true;
        }
    }
    return false;
}

/** A contact of the step before that is open now: where its patch is. The energy ledger still books what it
 *  did on the way here; the row must not depend on which facets the lists have. On a rim the slot may be
 *  another one now: the nearest place is this contact's unless one in that slot has come loose too. */
static void put_parted(const lanes *self, size_t lane, const clod_wall_pose *pose,
                       clod_vec3 from, double radius)
{
    const clod_touch_lane *of = &self->lane[lane];
    int32_t slot;
    clod_surface_closest at =
        clod_surface_place_closest(of->surface, of->patch, from, 2.0 * radius, &slot);
    if (slot != of->slot && has_other(self, lane, slot)) {
        at = clod_surface_slot_closest(of->surface, of->patch, of->slot, from, 2.0 * radius);
    }
    if (isfinite(at.distance)) {
        put_row(self->row[lane], pose, at.direction, at.distance);
    }
}

/** The history of a lane that has lost its contact goes to that with which its nearest facet
 *  goes, if that is new. False: its patch touches no more. */
static bool hand_over(const lanes *self, const clod_surface_hit *hits, int32_t count,
                      size_t from)
{
    for (int32_t k = 0; k < count; k++) {
        if (!is_of_patch(&self->lane[from], &hits[k])) {
            continue;
        }
        const size_t to = lane_of(self, &hits[hits[k].root]);
        if (!has_history(self, to)) {
            double history[CLOD_HISTORY_NUMBERS];
            clod_history_get(history_of(self, from), self->lane[from].lane, history);
            clod_history_put(history_of(self, to), self->lane[to].lane, history);
        }
        return true;
    }
    return false;
}

/** Contacts of a grain with the facets near it. */
static void find_contacts(const clod_touch_part *part, const clod_touch_site *site,
                          const clod_wall_pose *pose, clod_vec3 from, double radius,
                          const lanes *at)
{
    clod_surface_hit *hits = part->hit;
    const int32_t count = clod_surface_touch(part->table.facet, part->near + site->near,
                                             (int32_t)site->facets, from, radius, hits);
    for (size_t l = 0; l < at->count; l++) {
        put_open(at->row[l], radius);
    }
    for (int32_t k = 0; k < count; k++) {
        if (hits[k].root == k) {
            const size_t lane = lane_of(at, &hits[k]);
            put_row(at->row[lane], pose, hits[k].at.direction, hits[k].at.distance);
            if (at->facet != NULL) {
                at->facet[lane] = (int32_t)hits[k].facet;
            }
        }
    }
    for (size_t l = 0; l < at->count; l++) {
        if (at->row[l][3] >= radius && has_history(at, l) && !hand_over(at, hits, count, l)) {
            put_parted(at, l, pose, from, radius);
        }
    }
}

/** The first facet by number, of those of a site, that holds a point of their plane; -1: none does. */
static int32_t holding_facet(const clod_touch_part *part, const clod_touch_site *site,
                             clod_vec3 at)
{
    uint32_t first = UINT32_MAX;
    for (size_t k = 0; k < site->facets; k++) {
        const clod_surface_facet *facet = &part->table.facet[part->near[site->near + k]];
        if (facet->number < first && clod_surface_facet_holds(facet, at)) {
            first = facet->number;
        }
    }
    return first == UINT32_MAX ? -1 : (int32_t)first;
}

/** The facet nearest to a point, of those of a site, which lie in one plane, where its foot is. */
static int32_t nearest_facet(const clod_touch_part *part, const clod_touch_site *site,
                             clod_vec3 from, clod_vec3 foot)
{
    const clod_surface_facet *nearest = &part->table.facet[part->near[site->near]];
    if (site->facets == 1) {
        return (int32_t)nearest->number;
    }
    const int32_t holding = holding_facet(part, site, foot);
    if (holding >= 0) {
        return holding;
    }
    double least = INFINITY;
    for (size_t k = 0; k < site->facets; k++) {
        const clod_surface_facet *facet = &part->table.facet[part->near[site->near + k]];
        const double d = clod_surface_facet_closest(facet, from).distance;
        const bool first = facet->number < nearest->number;
        nearest = d < least || (d == least && first) ? facet : nearest;
        least = fmin(least, d);
    }
    return (int32_t)nearest->number;
}

/** The contact of a grain with nothing but a plane near it. */
static void find_plane(const clod_touch_part *part, const clod_touch_site *site,
                       const clod_wall_pose *pose, clod_vec3 from, double radius,
                       const lanes *at)
{
    const clod_surface_facet *facet = // all have the plane's normal
        &part->table.facet[part->near[site->near]];
    const double height = clod_surface_facet_height(facet, from);
    if (fabs(height) < radius) {
        put_row(at->row[0], pose, clod_surface_facet_side(facet, height), fabs(height));
        if (at->facet != NULL) {
            const clod_vec3 foot = clod_vec3_axpy(from, -height, facet->normal);
            at->facet[0] = nearest_facet(part, site, from, foot);
        }
        return;
    }
    put_open(at->row[0], radius);
    if (has_history(at, 0)) {
        put_parted(at, 0, pose, from, radius);
    }
}

void clod_touch_find(clod_near *near, const clod_state *state, const clod_wall_rows *walls,
                     int number)
{
    const clod_touch_part *part = &near->touch.part[number];
    clod_wall_pose pose;
    for (size_t s = 0; s < part->sites; s++) {
        const clod_touch_site *site = &part->site[s];
        if (s == 0 || site->wall != part->site[s - 1].wall) {
            pose = clod_wall_facets_pose((const double(*)[4])walls->shape + site->pose);
        }
        const double *p = state->grains.position[site->i];
        const lanes at = {.lane = part->lane + site->lane,
                          .row = near->touch.row + part->row + site->lane,
                          .facet = near->touch.facet != NULL
                                       ? near->touch.facet + part->row + site->lane
                                       : NULL,
                          .blocks = near->walls.block,
                          .count = site->lanes};
        const clod_vec3 from = clod_wall_to_frame(&pose, clod_vec3_of(p));
        if (site->plane >= 0) {
            find_plane(part, site, &pose, from, p[3], &at);
        } else {
            find_contacts(part, site, &pose, from, p[3], &at);
        }
    }
}

void clod_touch_fini(clod_touch *self, int parts)
{
    for (int p = 0; self->part != NULL && p < parts; p++) {
        clod_memory_free(self->part[p].site);
        clod_memory_free(self->part[p].lane);
        clod_memory_free(self->part[p].near);
        clod_touch_facets_fini(&self->part[p].table);
        clod_memory_free(self->part[p].hit);
    }
    clod_memory_free(self->part);
    clod_memory_free(self->row);
    clod_memory_free(self->facet);
    *self = (clod_touch){0};
}
