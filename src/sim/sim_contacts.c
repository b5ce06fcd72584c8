// Closed contacts with their history: all of them, one by its identity, and what one is made of.
#include <string.h>

#include "base/memory.h"
#include "sim/sim.h"

#define CONTACT clod_sim_contact

/** Which contact it is; what it remembers follows, as in CLOD_HISTORY. */
static const clod_sim_contact_field WHICH[] = {
    // clang-format off
    {"id_1",  "1", CLOD_SIM_U64, 1, offsetof(CONTACT, id_1),  false},
    {"id_2",  "1", CLOD_SIM_U64, 1, offsetof(CONTACT, id_2),  false},
    {"row_1", "1", CLOD_SIM_U64, 1, offsetof(CONTACT, row_1), false},
    {"row_2", "1", CLOD_SIM_U64, 1, offsetof(CONTACT, row_2), false},
    {"wall",  "1", CLOD_SIM_I32, 1, offsetof(CONTACT, wall),  false},
    {"shape", "1", CLOD_SIM_I32, 1, offsetof(CONTACT, shape), false},
    // clang-format on
};
#define WHICH_COUNT (sizeof WHICH / sizeof *WHICH)

/** Where the numbers of a history begin, in the order of CLOD_HISTORY up to the end. */
#define HISTORY offsetof(CONTACT, plastic)
_Static_assert(sizeof(CONTACT) - HISTORY == CLOD_HISTORY_NUMBERS * sizeof(double),
               "clod_sim_contact ends with the numbers of a history");
_Static_assert(sizeof(size_t) == sizeof(uint64_t), "rows are told as CLOD_SIM_U64");

/** A quantity has the same name, place and size in clod_history and in clod_sim_contact. */
#define SAME(name)                                                                             \
    _Static_assert(                                                                            \
        offsetof(CONTACT, name) - HISTORY == offsetof(clod_history, name) / CLOD_LANES &&      \
            sizeof((CONTACT *)NULL)->name == sizeof((clod_history *)NULL)->name / CLOD_LANES,  \
        #name " is where clod_history has it")
SAME(plastic);
SAME(tangent);
SAME(spring);
SAME(roll);

size_t clod_sim_contact_field_count(void)
{
    return WHICH_COUNT + CLOD_HISTORY_FIELDS;
}

bool clod_sim_contact_field_look(size_t index, clod_sim_contact_field *field,
                                 clod_status *status)
{
    if (!CLOD_GIVEN(field, status)) {
        return false;
    }
    if (index >= clod_sim_contact_field_count()) {
        return clod_status_fail(status, CLOD_USAGE, "%s: there is no field %zu; there are %zu",
                                __func__, index, clod_sim_contact_field_count());
    }
    if (index < WHICH_COUNT) {
        *field = WHICH[index];
        return true;
    }
    const clod_history_field *from = &CLOD_HISTORY[index - WHICH_COUNT];
    *field = (clod_sim_contact_field){.name = from->name,
                                      .unit = from->unit,
                                      .type = CLOD_SIM_F64,
                                      .components = (size_t)from->components,
                                      .offset = HISTORY + (size_t)from->first * sizeof(double),
                                      .turns = from->turns};
    return true;
}

/** A contact of the step as the caller sees it. */
static clod_sim_contact make(const clod_grains *grains, const clod_contact *from)
{
    const bool wall = from->shape >= 0;
    clod_sim_contact made = {.id_1 = grains->id[from->i],
                             .id_2 = wall ? 0 : grains->id[from->j],
                             .row_1 = (size_t)from->i,
                             .row_2 = wall ? 0 : (size_t)from->j,
                             .wall = wall ? from->j : -1,
                             .shape = from->shape};
    memcpy((char *)&made + HISTORY, from->history, sizeof from->history);
    return made;
}

bool clod_sim_contacts(clod_sim *self, const clod_sim_contact **contacts, size_t *count,
                       clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(contacts, status) ||
        !CLOD_GIVEN(count, status) || !clod_sim_hold(self, status)) {
        return false;
    }
    const size_t needed = self->state.contact_count;
    if (needed > self->contact_capacity) {
        clod_memory_free(self->contacts);
        self->contact_capacity = 0;
        self->contacts = clod_memory_alloc(needed, sizeof *self->contacts);
        if (self->contacts == NULL) {
            return clod_status_fail(status, CLOD_FAILED, "no memory for %zu contacts", needed);
        }
        self->contact_capacity = needed;
    }
    for (size_t c = 0; c < needed; c++) {
        self->contacts[c] = make(&self->state.grains, &self->state.contacts[c]);
    }
    *contacts = self->contacts;
    *count = needed;
    return true;
}

/** Changes are made, and the state has all grains and contacts, or the lists of the step. */
static bool see(clod_sim *self, clod_status *status)
{
    return clod_sim_settle(self, status) && clod_step_see(&self->step, status);
}

bool clod_sim_contact_of(clod_sim *self, uint64_t id_1, uint64_t id_2,
                         clod_sim_contact *contact, bool *found, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(contact, status) ||
        !CLOD_GIVEN(found, status) || !see(self, status)) {
        return false;
    }
    clod_contact there;
    *found = clod_step_contact_of(&self->step, (const uint64_t[2]){id_1, id_2}, &there);
    if (*found) {
        *contact = make(&self->state.grains, &there);
    }
    return true;
}

bool clod_sim_wall_contact_of(clod_sim *self, uint64_t id, int32_t wall, int32_t shape,
                              clod_sim_contact *contact, bool *found, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(contact, status) ||
        !CLOD_GIVEN(found, status) || !see(self, status) ||
        !clod_sim_has_shape(self, wall, shape, __func__, status)) {
        return false;
    }
    clod_contact there;
    *found = clod_step_wall_contact_of(&self->step, id, wall, shape, &there);
    if (*found) {
        *contact = make(&self->state.grains, &there);
    }
    return true;
}
