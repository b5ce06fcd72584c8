#include "sim/resting.h"

#include "base/memory.h"
#include "geometry/wall_rows.h"

#define AT_A_TIME 256 // contacts

/** What the search works with. */
typedef struct search {
    const clod_state *state;
    clod_resting *to;
    double square; ///< m2/s2, of the speed
    clod_wall_rows walls;
    double (*carrier)[3]; ///< [grains] m/s, of the wall's material that a grain rests on
    uint64_t *from;       ///< [grains] id of the grain that it rests on; 0 on a wall
    size_t *first;        ///< [grains + 1] where the partners of each grain begin
    int32_t *partner;     ///< [first[grains]]
    int32_t *row;         ///< [grains] that rest, those of each step behind those before
    size_t rows;
} search;

static bool is_slow(const search *self, int32_t g, const double carrier[3])
{
    const double *v = self->state->grains.velocity[g];
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        square += (v[a] - carrier[a]) * (v[a] - carrier[a]);
    }
    return square < self->square;
}

/** A contact with a wall: the grain rests on it if it is slow, and knows none before it. */
static void touch_wall(search *self, const clod_contact *contact)
{
    clod_resting *to = &self->to[contact->i];
    if (to->steps == 1 &&
        (to->wall < contact->j || (to->wall == contact->j && to->shape <= contact->shape))) {
        return;
    }
    const double *p = self->state->grains.position[contact->i];
    const clod_gap gap = clod_wall_rows_gap(&self->walls, contact->j, contact->shape, p);
    const clod_vec3 point = clod_vec3_axpy(clod_vec3_of(p), -gap.distance, gap.normal);
    double carrier[3];
    clod_vec3_put(carrier, clod_wall_material_velocity(&self->state->walls.wall[contact->j],
                                                       contact->shape, point, gap.normal));
    if (is_slow(self, contact->i, carrier)) {
        if (to->steps == 0) {
            self->row[self->rows++] = contact->i;
        }
        *to = (clod_resting){contact->j, contact->shape, 1};
        for (int a = 0; a < 3; a++) {
            self->carrier[contact->i][a] = carrier[a];
        }
    }
}

/** Go through all contacts: count partners, or note them and look at walls. */
static void read_contacts(search *self, const clod_contact_source *contacts, size_t *next)
{
    clod_contact some[AT_A_TIME];
    size_t pairs, walls, count;
    contacts->begin(contacts->context, &pairs, &walls);
    do {
        count = contacts->next(contacts->context, some, AT_A_TIME);
        for (size_t k = 0; k < count; k++) {
            const clod_contact *contact = &some[k];
            if (contact->shape < 0 && self->partner == NULL) {
                next[contact->i]++;
                next[contact->j]++;
            } else if (contact->shape < 0) {
                self->partner[next[contact->i]++] = contact->j;
                self->partner[next[contact->j]++] = contact->i;
            } else if (self->partner != NULL) {
                touch_wall(self, contact);
            }
        }
    } while (count == AT_A_TIME);
}

/** Partners of all grains, and those that rest on walls themselves; false without memory. */
static bool make_graph(search *self, const clod_contact_source *contacts)
{
    const size_t n = self->state->grains.count;
    size_t *next = clod_memory_alloc(n + 1, sizeof *next);
    self->first = clod_memory_alloc(n + 1, sizeof *self->first);
    bool good = next != NULL && self->first != NULL;
    if (good) {
        read_contacts(self, contacts, next);
        for (size_t g = 0; g < n; g++) {
            self->first[g + 1] = self->first[g] + next[g];
            next[g] = self->first[g];
        }
        self->partner = clod_memory_alloc(self->first[n] + 1, sizeof *self->partner);
        good = self->partner != NULL;
    }
    if (good) {
        read_contacts(self, contacts, next);
    }
    clod_memory_free(next);
    return good;
}

/** A grain that rests, of the step before, may carry its partner. */
static void carry(search *self, int32_t g, int32_t partner)
{
    clod_resting *to = &self->to[partner];
    const clod_resting *under = &self->to[g];
    const uint64_t id = self->state->grains.id[g];
    const bool known = to->steps > 0;
    if ((known && to->steps <= under->steps) ||
        (known &&
         (to->wall < under->wall || (to->wall == under->wall && self->from[partner] <= id))) ||
        !is_slow(self, partner, self->carrier[g])) {
        return;
    }
    if (!known) {
        self->row[self->rows++] = partner;
    }
    *to = (clod_resting){under->wall, under->shape, under->steps + 1};
    self->from[partner] = id;
    for (int a = 0; a < 3; a++) {
        self->carrier[partner][a] = self->carrier[g][a];
    }
}

/** Step by step from the walls. */
static void spread(search *self)
{
    for (size_t begin = 0; begin < self->rows;) {
        const size_t end = self->rows;
        for (size_t k = begin; k < end; k++) {
            const int32_t g = self->row[k];
            for (size_t p = self->first[g]; p < self->first[g + 1]; p++) {
                carry(self, g, self->partner[p]);
            }
        }
        begin = end;
    }
}

bool clod_resting_find(clod_resting *to, const clod_state *state,
                       const clod_contact_source *contacts, double speed, clod_status *status)
{
    const size_t n = state->grains.count;
    search self = {.state = state, .to = to, .square = speed * speed};
    for (size_t g = 0; g < n; g++) {
        to[g] = (clod_resting){.wall = -1, .shape = -1};
    }
    self.carrier = clod_memory_alloc(n + 1, sizeof *self.carrier);
    self.from = clod_memory_alloc(n + 1, sizeof *self.from);
    self.row = clod_memory_alloc(n + 1, sizeof *self.row);
    const bool good = self.carrier != NULL && self.from != NULL && self.row != NULL &&
                      clod_wall_rows_init(&self.walls, &state->walls) &&
                      make_graph(&self, contacts);
    if (good) {
        spread(&self);
    }
    clod_wall_rows_fini(&self.walls);
    clod_memory_free(self.carrier);
    clod_memory_free(self.from);
    clod_memory_free(self.row);
    clod_memory_free(self.first);
    clod_memory_free(self.partner);
    return good ||
           clod_status_fail(status, CLOD_FAILED, "no memory for what rests of %zu grains", n);
}
