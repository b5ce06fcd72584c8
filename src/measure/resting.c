#include "measure/resting.h"

#include "base/memory.h"
#include "state/contact_walk.h"

/** What is known of a grain. Ranks tell it of their grains to those that have them as ghosts: no
 *  gaps. */
typedef struct known {
    double carrier[3]; ///< m/s, of the wall's material that it rests on
    clod_resting on;
    int32_t unused;
} known;

/** What the search works with. */
typedef struct search {
    const clod_survey_part *here;
    double square;    ///< m2/s2, of the speed
    known *of;        ///< [grains]
    uint64_t *from;   ///< [grains] id of the grain that it rests on; 0 on a wall
    size_t *first;    ///< [grains + 1] where the partners of each grain begin
    int32_t *partner; ///< [first[grains]]
    int32_t *row;     ///< [grains] own ones that rest, those of each step behind those before
    size_t rows;
    int32_t *ghost; ///< [ghosts] rows
    size_t ghosts;
} search;

static bool is_slow(const search *self, int32_t g, const double carrier[3])
{
    const double *v = self->here->state->grains.velocity[g];
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        square += (v[a] - carrier[a]) * (v[a] - carrier[a]);
    }
    return square < self->square;
}

/** A grain rests from now on: so many steps from a wall, or on another one as near. */
static void rest(search *self, int32_t g, clod_resting on, const double carrier[3])
{
    known *of = &self->of[g];
    if (of->on.steps == 0) {
        self->row[self->rows++] = g;
    }
    of->on = on;
    for (int a = 0; a < 3; a++) {
        of->carrier[a] = carrier[a];
    }
}

/** A contact with a wall: the grain rests on it if it is slow, and knows none before it. */
static void touch_wall(search *self, const clod_contact *contact)
{
    const clod_contact_source *contacts = self->here->contacts;
    const clod_resting *on = &self->of[contact->i].on;
    if (on->steps == 1 &&
        (on->wall < contact->j || (on->wall == contact->j && on->shape <= contact->shape))) {
        return;
    }
    double carrier[3];
    contacts->carrier(contacts->laws, contact, carrier);
    if (is_slow(self, contact->i, carrier)) {
        rest(self, contact->i, (clod_resting){contact->j, contact->shape, 1}, carrier);
    }
}

/** Go through all contacts: count partners, or note them and look at walls. */
static void read_contacts(search *self, size_t *next)
{
    const clod_contact_source *contacts = self->here->contacts;
    const clod_contact *contact;
    clod_contact_walk walk;
    clod_contact_walk_begin(&walk, contacts);
    while ((contact = clod_contact_walk_next(&walk)) != NULL) {
        if (contact->shape < 0 && self->partner == NULL) {
            next[contact->i]++;
            next[contact->j]++;
        } else if (contact->shape < 0) {
            self->partner[next[contact->i]++] = contact->j;
            self->partner[next[contact->j]++] = contact->i;
        } else if (self->partner != NULL && contacts->carrier != NULL) {
            touch_wall(self, contact);
        }
    }
}

/** Partners of all grains, and those that rest on walls themselves; false without memory. */
static bool make_graph(search *self)
{
    const size_t n = self->here->state->grains.count;
    size_t *next = clod_memory_alloc(n + 1, sizeof *next);
    self->first = clod_memory_alloc(n + 1, sizeof *self->first);
    bool good = next != NULL && self->first != NULL;
    if (good) {
        read_contacts(self, next);
        for (size_t g = 0; g < n; g++) {
            self->first[g + 1] = self->first[g] + next[g];
            next[g] = self->first[g];
        }
        self->partner = clod_memory_alloc(self->first[n] + 1, sizeof *self->partner);
        good = self->partner != NULL;
    }
    if (good) {
        read_contacts(self, next);
    }
    clod_memory_free(next);
    return good;
}

/** A grain that rests, of the step before, may carry its partner. */
static void carry(search *self, int32_t g, int32_t partner)
{
    const clod_resting *to = &self->of[partner].on, *under = &self->of[g].on;
    const uint64_t id = self->here->state->grains.id[g];
    const bool is_known = to->steps > 0;
    if (!clod_survey_has(self->here, (size_t)partner) ||
        (is_known && to->steps <= under->steps) ||
        (is_known &&
         (to->wall < under->wall || (to->wall == under->wall && self->from[partner] <= id))) ||
        !is_slow(self, partner, self->of[g].carrier)) {
        return;
    }
    rest(self, partner, (clod_resting){under->wall, under->shape, under->steps + 1},
         self->of[g].carrier);
    self->from[partner] = id;
}

static void carry_partners(search *self, int32_t g)
{
    for (size_t p = self->first[g]; p < self->first[g + 1]; p++) {
        carry(self, g, self->partner[p]);
    }
}

static void add_count(const void *context, void *into, const void *from)
{
    (void)context;
    uint64_t *mine = into;
    *mine += *(const uint64_t *)from;
}

/** Ghosts of this step are known too; whether any rank has come to grains in it. */
static bool meet(search *self, uint64_t come)
{
    const clod_survey_part *here = self->here;
    if (here->ranks != NULL) {
        here->share(here->context, self->of, sizeof *self->of);
        clod_ranks_merge(here->ranks, &come, sizeof come, add_count, NULL);
    }
    return come > 0;
}

/** Step by step from the walls. */
static void spread(search *self)
{
    size_t begin = 0, end = self->rows;
    for (int32_t steps = 1; meet(self, end - begin); steps++) {
        for (size_t k = begin; k < end; k++) {
            carry_partners(self, self->row[k]);
        }
        for (size_t k = 0; k < self->ghosts; k++) {
            if (self->of[self->ghost[k]].on.steps == steps) {
                carry_partners(self, self->ghost[k]);
            }
        }
        begin = end;
        end = self->rows;
    }
}

/** Nobody rests; false without memory. */
static bool init(search *self)
{
    const size_t n = self->here->state->grains.count;
    self->of = clod_memory_alloc(n + 1, sizeof *self->of);
    self->from = clod_memory_alloc(n + 1, sizeof *self->from);
    self->row = clod_memory_alloc(n + 1, sizeof *self->row);
    self->ghost = clod_memory_alloc(self->here->ranks != NULL ? n + 1 : 1, sizeof *self->ghost);
    if (self->of == NULL || self->from == NULL || self->row == NULL || self->ghost == NULL) {
        return false;
    }
    for (size_t g = 0; g < n; g++) {
        self->of[g].on = (clod_resting){.wall = -1, .shape = -1};
        if (!clod_survey_has(self->here, g)) {
            self->ghost[self->ghosts++] = (int32_t)g;
        }
    }
    return true;
}

bool clod_resting_find(clod_resting *to, const clod_survey_part *here, double speed,
                       clod_status *status)
{
    const size_t n = here->state->grains.count;
    search self = {.here = here, .square = speed * speed};
    bool good =
        (init(&self) && make_graph(&self)) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for what rests of %zu grains", n);
    good = clod_survey_agree(here, good, status) &&
           (here->ranks == NULL || clod_ranks_reserve(here->ranks, sizeof(uint64_t), status));
    if (good) {
        spread(&self);
    }
    for (size_t g = 0; good && g < n; g++) {
        to[g] = self.of[g].on;
    }
    clod_memory_free(self.of);
    clod_memory_free(self.from);
    clod_memory_free(self.row);
    clod_memory_free(self.ghost);
    clod_memory_free(self.first);
    clod_memory_free(self.partner);
    return good;
}
