#include "mesh/surface_touch.h"

#include <math.h>

static bool is_on_rim(const clod_surface_hit *hit)
{
    return (hit->at.edges & hit->of->rims) != 0;
}

/** Slot of a contact in its patch. */
static int32_t slot_of(const clod_surface_hit *hit)
{
    if (!is_on_rim(hit)) {
        return 0;
    }
    const clod_vec3 *axis = hit->of->surface->patches[hit->patch].axis;
    const double x = -clod_vec3_dot(hit->at.direction, axis[0]);
    const double y = -clod_vec3_dot(hit->at.direction, axis[1]);
    return x >= 0.0 ? (y >= 0.0 ? 0 : 3) : (y >= 0.0 ? 1 : 2);
}

/** Distance of a point from the facet of a hit [m]. */
static double apart(const clod_surface_hit *hit, clod_vec3 point)
{
    return clod_surface_facet_closest(hit->of, point).distance;
}

/** Distance up to which a point is on a facet [m]. */
static double touching(const clod_surface_hit *a, const clod_surface_hit *b)
{
    const double first = a->of->surface->weld, second = b->of->surface->weld;
    return 2.0 * (first > second ? first : second);
}

static bool is_one_bend(const clod_surface_hit *contact, const clod_surface_hit *hit)
{
    const clod_surface *surface = hit->of->surface;
    return surface == contact->of->surface &&
           surface->piece[contact->facet] == surface->piece[hit->facet] &&
           clod_vec3_dot(contact->at.direction, hit->at.direction) > surface->smooth_cosine;
}

static bool is_same_place(const clod_surface_hit *contact, const clod_surface_hit *hit)
{
    return contact->of->surface == hit->of->surface && contact->patch == hit->patch &&
           contact->slot == hit->slot;
}

/** Distance between two facets, beside the closest point of the first [m]. */
static double gap(const clod_surface_hit *from, const clod_surface_hit *to)
{
    const clod_vec3 over = clod_surface_facet_closest(to->of, from->at.point).point;
    return apart(from, over);
}

/** Whether a facet goes on from a nearer one over a crack: `contact` is that of the nearer one. */
static bool is_over_crack(const clod_surface_hit *nearer, const clod_surface_hit *contact,
                          const clod_surface_hit *hit, double radius)
{
    const clod_surface *a = nearer->of->surface, *b = hit->of->surface;
    const bool rim = is_on_rim(nearer) || is_on_rim(hit);
    const bool pieces = a != b || a->piece[nearer->facet] != b->piece[hit->facet];
    const double cosine =
        rim ? CLOD_SURFACE_CRACK_COSINE : fmax(a->smooth_cosine, b->smooth_cosine);
    const double most = CLOD_SURFACE_CRACK * radius;
    return (rim || pieces) &&
           clod_vec3_dot(contact->at.direction, hit->at.direction) > cosine &&
           (gap(hit, nearer) <= most || gap(nearer, hit) <= most);
}

/** Whether a nearer facet lies between a closest point and the centre. */
static bool hides(const clod_surface_hit *nearer, const clod_surface_hit *hit, clod_vec3 p)
{
    const clod_surface *surface = nearer->of->surface;
    const clod_surface_plane *plane = &surface->planes[nearer->of->plane];
    const double from = clod_vec3_dot(clod_vec3_sub(p, plane->point), plane->normal);
    const double to = clod_vec3_dot(clod_vec3_sub(hit->at.point, plane->point), plane->normal);
    if (from * to >= 0.0 || fabs(to) <= touching(nearer, hit)) {
        return false;
    }
    const clod_vec3 way = clod_vec3_sub(hit->at.point, p);
    const clod_vec3 across = clod_vec3_axpy(p, from / (from - to), way);
    return apart(nearer, across) <= touching(nearer, hit);
}

/** The contact with which a hit goes among the nearer ones, or its own number. */
static int32_t root_of(const clod_surface_hit *hits, int32_t number, clod_vec3 p, double radius)
{
    const clod_surface_hit *hit = &hits[number];
    for (int32_t k = 0; k < number; k++) {
        const clod_surface_hit *nearer = &hits[k];
        const bool contact = nearer->root == k;
        if (contact && (is_one_bend(nearer, hit) || is_same_place(nearer, hit))) {
            return k;
        }
        if (apart(nearer, hit->at.point) <= touching(nearer, hit) || hides(nearer, hit, p) ||
            is_over_crack(nearer, &hits[nearer->root], hit, radius)) {
            return nearer->root;
        }
    }
    return number;
}

/** The nearest comes first; of equals one inside a face. Surfaces are taken in the order of the list. */
static bool is_before(const clod_surface_hit *a, const clod_surface_hit *b)
{
    if (a->at.distance != b->at.distance || a->of->surface != b->of->surface) {
        return a->at.distance < b->at.distance;
    }
    const bool a_inside = a->at.edges == 0, b_inside = b->at.edges == 0;
    return a_inside != b_inside ? a_inside : a->facet < b->facet;
}

/** The last hit to its place among the nearer ones. Most are in order: those are not copied. */
static void sort_last(clod_surface_hit *hits, int32_t last)
{
    if (last == 0 || !is_before(&hits[last], &hits[last - 1])) {
        return;
    }
    const clod_surface_hit hit = hits[last];
    int32_t at = last;
    for (; at > 0 && is_before(&hit, &hits[at - 1]); at--) {
        hits[at] = hits[at - 1];
    }
    hits[at] = hit;
}

int32_t clod_surface_touch(const clod_surface_facet *facets, const uint32_t *near,
                           int32_t count, clod_vec3 p, double radius, clod_surface_hit *hits)
{
    int32_t found = 0;
    for (int32_t k = 0; k < count; k++) {
        const clod_surface_facet *facet = &facets[near[k]];
        if (clod_surface_facet_is_beyond(facet->surface, facet, p, radius)) {
            continue;
        }
        clod_surface_hit *hit = &hits[found];
        clod_surface_facet_find(facet, p, &hit->at);
        if (hit->at.distance >= radius) {
            continue;
        }
        hit->of = facet;
        hit->facet = facet->number;
        hit->patch = facet->patch;
        hit->slot = slot_of(hit);
        sort_last(hits, found++);
    }
    for (int32_t k = 0; k < found; k++) {
        hits[k].root = root_of(hits, k, p, radius);
    }
    return found;
}

#define ANY_SLOT (-1)

/** A search for the closest point of a patch, in one slot or in any. */
typedef struct slot_search {
    const clod_surface *surface;
    clod_vec3 from;
    int32_t patch, slot;
    clod_surface_closest best;
    int32_t best_slot;
} slot_search;

static double look_at_slot(void *context, uint32_t number, double reach)
{
    slot_search *self = context;
    if (self->surface->patch[number] != (uint32_t)self->patch) {
        return reach;
    }
    const clod_surface_facet facet = clod_surface_facet_of(self->surface, number);
    clod_surface_hit hit = {.of = &facet, .facet = number, .patch = facet.patch};
    if (clod_surface_facet_is_beyond(self->surface, &facet, self->from, reach)) {
        return reach;
    }
    clod_surface_facet_find(&facet, self->from, &hit.at);
    const int32_t slot = slot_of(&hit);
    if ((self->slot == ANY_SLOT || slot == self->slot) &&
        hit.at.distance < self->best.distance) {
        self->best = hit.at;
        self->best_slot = slot;
    }
    return reach;
}

clod_surface_closest clod_surface_slot_closest(const clod_surface *self, int32_t patch,
                                               int32_t slot, clod_vec3 p, double most)
{
    slot_search search = {self, p, patch, slot, {.distance = INFINITY}, slot};
    clod_surface_near(self, p, most, look_at_slot, &search);
    return search.best;
}

clod_surface_closest clod_surface_place_closest(const clod_surface *self, int32_t patch,
                                                clod_vec3 p, double most, int32_t *slot)
{
    slot_search search = {self, p, patch, ANY_SLOT, {.distance = INFINITY}, 0};
    clod_surface_near(self, p, most, look_at_slot, &search);
    *slot = search.best_slot;
    return search.best;
}
