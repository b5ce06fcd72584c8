#include "measure/strength_grid.h"

#include <math.h>

#include "base/memory.h"
#include "state/contact_walk.h"

#define SMALL_BITS 40

int64_t clod_strength_grid_cells(const clod_strength_grid *self)
{
    return self->cells[0] * self->cells[1] * self->cells[2];
}

double clod_strength_force_value(const clod_strength_force *sum)
{
    return (double)sum->whole + ldexp((double)sum->small, -SMALL_BITS);
}

static void carry(clod_strength_force *sum)
{
    sum->whole += sum->small >> SMALL_BITS;
    sum->small &= ((int64_t)1 << SMALL_BITS) - 1;
}

static void add_force(clod_strength_force *to, double force)
{
    const double whole = floor(force);
    to->whole += (int64_t)whole;
    to->small += (int64_t)ldexp(force - whole, SMALL_BITS);
    carry(to);
}

static void merge_force(clod_strength_force *to, const clod_strength_force *from)
{
    to->whole += from->whole;
    to->small += from->small;
    carry(to);
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    clod_strength_cell *mine = into;
    const clod_strength_cell *other = from;
    mine->contacts += other->contacts;
    mine->gaining += other->gaining;
    merge_force(&mine->pull_off, &other->pull_off);
    merge_force(&mine->pressed, &other->pressed);
    merge_force(&mine->pull_off_gain, &other->pull_off_gain);
    merge_force(&mine->pressed_gain, &other->pressed_gain);
    mine->most_pull_off = fmax(mine->most_pull_off, other->most_pull_off);
    mine->most_pressed = fmax(mine->most_pressed, other->most_pressed);
}

/** Coordinate of a contact, seen from the grain with the smaller id, within the domain [m]. */
static double position_along(const clod_domain *domain, int axis, const double a[4],
                             const double b[4])
{
    const double way = clod_domain_separation(domain, axis, b[axis], a[axis]);
    const double position = a[axis] + way * (a[3] / (a[3] + b[3]));
    const double low = domain->min[axis], high = domain->max[axis];
    if (domain->periodic[axis] && (position < low || position >= high)) {
        return position < low ? position + (high - low) : position - (high - low);
    }
    return position;
}

/** Number of the cell of a contact; -1: outside. */
static int64_t cell_of(const clod_strength_grid *self, const clod_state *state,
                       const clod_contact *contact)
{
    const clod_grains *grains = &state->grains;
    const bool rises = grains->id[contact->i] < grains->id[contact->j];
    const double *a = grains->position[rises ? contact->i : contact->j];
    const double *b = grains->position[rises ? contact->j : contact->i];
    int64_t at[3];
    for (int c = 0; c < 3; c++) {
        const double position = position_along(&state->domain, c, a, b);
        const double k = floor((position - self->low[c]) / self->edge);
        if (!(k >= 0.0 && k < (double)self->cells[c])) {
            return -1;
        }
        at[c] = (int64_t)k;
    }
    return (at[2] * self->cells[1] + at[1]) * self->cells[0] + at[0];
}

static void add_contact(clod_strength_cell *cell, clod_contact_strength strength)
{
    cell->contacts++;
    add_force(&cell->pull_off, strength.pull_off);
    add_force(&cell->pressed, strength.pressed);
    cell->most_pull_off = fmax(cell->most_pull_off, strength.pull_off);
    cell->most_pressed = fmax(cell->most_pressed, strength.pressed);
}

static void add_gain(clod_strength_cell *cell, clod_contact_gain gain)
{
    if (gain.pressed > 0.0) {
        cell->gaining++;
        add_force(&cell->pull_off_gain, gain.pull_off);
        add_force(&cell->pressed_gain, gain.pressed);
    }
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    (void)status;
    const clod_strength_grid *self = question->asked;
    clod_strength_cell *cells = question->sums;
    const clod_contact_source *contacts = here->contacts;
    const clod_contact *contact;
    clod_contact_walk walk;
    clod_contact_walk_begin(&walk, contacts);
    while ((contact = clod_contact_walk_next(&walk)) != NULL && contact->shape < 0) {
        const int64_t cell = clod_survey_has(here, (size_t)contact->i)
                                 ? cell_of(self, here->state, contact)
                                 : -1;
        if (cell >= 0) {
            add_contact(&cells[cell], contacts->strength(contacts->laws, contact));
            add_gain(&cells[cell], contacts->gain(contacts->laws, contact));
        }
    }
    return true;
}

const clod_survey_way CLOD_STRENGTH_GRID_WAY = {
    .add = add, .merge = merge, .unit = sizeof(clod_strength_cell), .motions = true};

bool clod_strength_grid_add(const clod_strength_grid *self, const clod_survey *survey,
                            clod_strength_cell *cell, clod_status *status)
{
    const size_t cells = (size_t)clod_strength_grid_cells(self);
    clod_strength_cell *sums = clod_memory_alloc(cells, sizeof *sums);
    if (sums == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu cells of contacts",
                                cells);
    }
    const clod_survey_question question = {.kind = CLOD_SURVEY_STRENGTH,
                                           .asked = self,
                                           .asked_bytes = sizeof *self,
                                           .sums = sums,
                                           .sums_bytes = cells * sizeof *sums};
    const bool good = clod_survey_ask(survey, &question, status);
    for (size_t k = 0; good && k < cells; k++) {
        merge(&question, &cell[k], &sums[k]);
    }
    clod_memory_free(sums);
    return good;
}
