#include "measure/contacts.h"

#include <math.h>

#include "parallel/exact.h"

#define AT_A_TIME 256 // contacts

static double pair_distance(const clod_state *state, const double a[4], const double b[4])
{
    double sum = 0.0;
    for (int c = 0; c < 3; c++) {
        const double s = clod_domain_separation(&state->domain, c, a[c], b[c]);
        sum += s * s;
    }
    return sqrt(sum);
}

/** A contact's share. */
static void add_contact(clod_measure_contacts *self, clod_exact *sum, const clod_state *state,
                        const clod_contact *contact)
{
    const double *a = state->grains.position[contact->i];
    const double *b = state->grains.position[contact->j];
    const double overlap = (a[3] + b[3] - pair_distance(state, a, b)) / fmin(a[3], b[3]);
    self->max_overlap = fmax(self->max_overlap, overlap);
    clod_exact_add(sum, overlap);
}

clod_measure_contacts clod_measure_contacts_from(const clod_state *state,
                                                 const clod_contact_source *contacts)
{
    clod_measure_contacts m = {0};
    clod_contact some[AT_A_TIME];
    clod_exact sum = {0};
    contacts->begin(contacts->context, &m.pairs, &m.walls);
    for (size_t first = 0; first < m.pairs; first += AT_A_TIME) { // pairs come first
        const size_t count = contacts->next(contacts->context, some, AT_A_TIME);
        for (size_t k = 0; k < count && first + k < m.pairs; k++) {
            add_contact(&m, &sum, state, &some[k]);
        }
    }
    m.mean_overlap = m.pairs > 0 ? clod_exact_value(&sum) / (double)m.pairs : 0.0;
    m.coordination =
        2.0 * (double)m.pairs / (double)(state->grains.count + !state->grains.count);
    return m;
}

clod_measure_contacts clod_measure_contacts_of(const clod_state *state)
{
    clod_contact_list list;
    const clod_contact_source contacts = clod_contact_source_of(&list, state);
    return clod_measure_contacts_from(state, &contacts);
}

size_t clod_measure_loaded_grains(const clod_state *state)
{
    size_t loaded = 0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *load = state->grains.load[g];
        const double mass = state->grains.velocity[g][3];
        bool free = true;
        for (int a = 0; a < 3; a++) { // a sum to which nothing was added is the weight itself
            free = free && load[a] == mass * state->gravity[a];
        }
        loaded += free ? 0 : 1;
    }
    return loaded;
}

double clod_measure_kinetic_energy(const clod_state *state)
{
    clod_exact sum = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *v = state->grains.velocity[g];
        const double *w = state->grains.angular_velocity[g];
        clod_exact_add(&sum, 0.5 * v[3] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        clod_exact_add(&sum, 0.5 / w[3] * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    }
    return clod_exact_value(&sum);
}

double clod_measure_max_speed(const clod_state *state)
{
    double most = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *v = state->grains.velocity[g];
        most = fmax(most, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sqrt(most);
}
