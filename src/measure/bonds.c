#include "measure/bonds.h"

#include <math.h>

#include "base/memory.h"
#include "state/contact_walk.h"

#define MORE 256 // bonds

static bool add_bond(clod_bonds *self, const clod_contact *contact)
{
    if (self->count == self->room) {
        const size_t room = self->room + self->room / 2 + MORE;
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
static bool read_contacts(clod_bonds *self, const clod_survey_part *here, double weight)
{
    const clod_contact_source *contacts = here->contacts;
    const clod_grains *grains = &here->state->grains;
    const clod_contact *contact;
    clod_contact_walk walk;
    bool good = true;
    clod_contact_walk_begin(&walk, contacts);
    while (good && (contact = clod_contact_walk_next(&walk)) != NULL) {
        if (contact->shape >= 0) {
            self->on_wall[contact->i] = true;
        } else if (contacts->strength != NULL) {
            const double *a = grains->velocity[contact->i];
            const double *b = grains->velocity[contact->j];
            const double pull = contacts->strength(contacts->laws, contact).pull_off;
            good = !(pull > weight * fmin(a[3], b[3])) || add_bond(self, contact);
        }
    }
    return good;
}

static void keep_larger(const void *context, void *into, const void *from)
{
    (void)context;
    double *mine = into;
    const double *other = from;
    for (int k = 0; k < 2; k++) {
        mine[k] = fmax(mine[k], other[k]);
    }
}

/** Largest mass and radius of all ranks' grains. */
static bool find_largest(clod_bonds *self, const clod_survey_part *here, clod_status *status)
{
    const clod_grains *grains = &here->state->grains;
    double largest[2] = {0.0, 0.0};
    for (size_t g = 0; g < grains->count; g++) { // ghosts are others' grains: they may count
        const double own[2] = {grains->velocity[g][3], grains->position[g][3]};
        keep_larger(NULL, largest, own);
    }
    if (here->ranks != NULL) {
        if (!clod_ranks_reserve(here->ranks, sizeof largest, status)) {
            return false;
        }
        clod_ranks_merge(here->ranks, largest, sizeof largest, keep_larger, NULL);
    }
    self->largest_mass = largest[0];
    self->largest_radius = largest[1];
    return true;
}

bool clod_bonds_find(clod_bonds *self, const clod_survey_part *here, double number,
                     clod_status *status)
{
    *self = (clod_bonds){0};
    const double *g = here->state->gravity;
    const double weight = number * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const size_t grains = here->state->grains.count;
    self->on_wall = clod_memory_alloc(grains + 1, sizeof *self->on_wall);
    const bool good =
        (self->on_wall != NULL && read_contacts(self, here, weight)) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for the bonds of %zu grains", grains);
    return clod_survey_agree(here, good, status) && find_largest(self, here, status);
}

void clod_bonds_fini(clod_bonds *self)
{
    clod_memory_free(self->bond);
    clod_memory_free(self->on_wall);
    *self = (clod_bonds){0};
}
