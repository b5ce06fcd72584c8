#include "mesh/surface_touch.h"

#include <math.h>

/** Slot of a contact in its patch. */
static int32_t slot_of(const clod_surface *self, const clod_surface_facet *facet,
                       const clod_surface_closest *at)
{
    if ((at->edges & facet->rims) == 0) {
        return 0;
    }
    const clod_vec3 *axis = self->patches[facet->patch].axis;
    const double x = -clod_vec3_dot(at->direction, axis[0]);
    const double y = -clod_vec3_dot(at->direction, axis[1]);
    return x >= 0.0 ? (y >= 0.0 ? 0 : 3) : (y >= 0.0 ? 1 : 2);
}

/** Whether a nearer facet holds the closest point of another. */
static bool holds(const clod_surface *self, const clod_surface_hit *nearer,
                  const clod_surface_hit *hit)
{
    return clod_surface_closest_of(self, nearer->facet, hit->at.point).distance <=
           2.0 * self->weld;
}

static bool is_one_bend(const clod_surface *self, const clod_surface_hit *contact,
                        const clod_surface_hit *hit)
{
    return self->piece[contact->facet] == self->piece[hit->facet] &&
           clod_vec3_dot(contact->at.direction, hit->at.direction) > self->smooth_cosine;
}

/** Whether a nearer facet lies between a closest point and the centre. */
static bool hides(const clod_surface *self, const clod_surface_hit *nearer,
                  const clod_surface_hit *hit, clod_vec3 p)
{
    const clod_surface_plane *plane = &self->planes[self->plane[nearer->facet]];
    const double from = clod_vec3_dot(clod_vec3_sub(p, plane->point), plane->normal);
    const double to = clod_vec3_dot(clod_vec3_sub(hit->at.point, plane->point), plane->normal);
    if (from * to >= 0.0 || fabs(to) <= 2.0 * self->weld) {
        return false;
    }
    const clod_vec3 way = clod_vec3_sub(hit->at.point, p);
    const clod_vec3 across = clod_vec3_axpy(p, from / (from - to), way);
    return clod_surface_closest_of(self, nearer->facet, across).distance <= 2.0 * self->weld;
}

/** The contact with which a hit goes among the nearer ones, or its own number. */
static int32_t root_of(const clod_surface *self, const clod_surface_hit *hits, int32_t number,
                       clod_vec3 p)
{
    const clod_surface_hit *hit = &hits[number];
    for (int32_t k = 0; k < number; k++) {
        const clod_surface_hit *nearer = &hits[k];
        const bool contact = nearer->root == k;
        if ((contact && is_one_bend(self, nearer, hit)) || holds(self, nearer, hit) ||
            hides(self, nearer, hit, p) ||
            (contact && nearer->patch == hit->patch && nearer->slot == hit->slot)) {
            return nearer->root;
        }
    }
    return number;
}

static bool is_before(const clod_surface_hit *a, const clod_surface_hit *b)
{
    return a->at.distance < b->at.distance ||
           (a->at.distance == b->at.distance && a->facet < b->facet);
}

int32_t clod_surface_touch(const clod_surface *self, const clod_surface_facet *facets,
                           int32_t count, clod_vec3 p, double radius, clod_surface_hit *hits)
{
    int32_t found = 0;
    for (int32_t k = 0; k < count; k++) {
        const clod_surface_facet *facet = &facets[k];
        if (clod_surface_facet_is_beyond(self, facet, p, radius)) {
            continue;
        }
        clod_surface_hit hit = {.at = clod_surface_facet_closest(self, facet, p),
                                .facet = facet->number,
                                .patch = facet->patch};
        if (hit.at.distance >= radius) {
            continue;
        }
        hit.slot = slot_of(self, facet, &hit.at);
        int32_t at = found++;
        for (; at > 0 && is_before(&hit, &hits[at - 1]); at--) {
            hits[at] = hits[at - 1];
        }
        hits[at] = hit;
    }
    for (int32_t k = 0; k < found; k++) {
        hits[k].root = root_of(self, hits, k, p);
    }
    return found;
}
