#include "state/contacts.h"

#include "base/lower_bound.h"

// Source: docs/theory (mepa, tangential, rolling)
const clod_history_field CLOD_HISTORY[CLOD_HISTORY_FIELDS] = {
    // name, unit, first number, components, turns its sign with the order of the pair
    [CLOD_HISTORY_PLASTIC] = {"plastic", "m^n", 0, 1, false},
    [CLOD_HISTORY_TANGENT] = {"tangent", "N m-1", 1, 1, false},
    [CLOD_HISTORY_SPRING] = {"spring", "m", 2, 3, true},
    [CLOD_HISTORY_ROLL] = {"roll", "rad", 5, 3, true},
};

void clod_contact_turn(clod_contact *self)
{
    const int32_t i = self->i;
    self->i = self->j;
    self->j = i;
    for (int f = 0; f < CLOD_HISTORY_FIELDS; f++) {
        const clod_history_field *field = &CLOD_HISTORY[f];
        for (int c = 0; field->turns && c < field->components; c++) {
            self->history[field->first + c] = -self->history[field->first + c];
        }
    }
}

void clod_contacts_ascend(clod_contact *contacts, size_t begin, size_t end)
{
    for (size_t k = begin + 1; k < end; k++) {
        const clod_contact moving = contacts[k];
        size_t at = k;
        for (; at > begin && clod_contact_compare(&contacts[at - 1], &moving) > 0; at--) {
            contacts[at] = contacts[at - 1];
        }
        contacts[at] = moving;
    }
}

size_t clod_contacts_first_from(const clod_contact *contacts, size_t low, size_t high,
                                size_t row)
{
    clod_lower_bound in = {low, high};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, (size_t)contacts[middle].i < row);
    }
    return in.low;
}
