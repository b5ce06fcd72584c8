#include "measure/contacts.h"

#include <math.h>

#include "state/contact_walk.h"

// ---- contacts

/** Their sums. */
typedef struct contacts_sums {
    clod_exact overlap;
    double max_overlap;
    int64_t pairs, walls, grains;
} contacts_sums;

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
static void add_contact(contacts_sums *self, const clod_state *state,
                        const clod_contact *contact)
{
    if (contact->shape >= 0) {
        self->walls++;
        return;
    }
    const double *a = state->grains.position[contact->i];
    const double *b = state->grains.position[contact->j];
    const double overlap = (a[3] + b[3] - pair_distance(state, a, b)) / fmin(a[3], b[3]);
    self->pairs++;
    self->max_overlap = fmax(self->max_overlap, overlap);
    clod_exact_add(&self->overlap, overlap);
}

static bool add_contacts(const clod_survey_question *question, const clod_survey_part *here,
                         clod_status *status)
{
    (void)status;
    contacts_sums *sums = question->sums;
    const clod_contact *contact;
    clod_contact_walk walk;
    for (size_t g = 0; g < here->state->grains.count; g++) {
        sums->grains += clod_survey_has(here, g);
    }
    clod_contact_walk_begin(&walk, here->contacts);
    while ((contact = clod_contact_walk_next(&walk)) != NULL) {
        if (clod_survey_has(here, (size_t)contact->i)) {
            add_contact(sums, here->state, contact);
        }
    }
    return true;
}

static void merge_contacts(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    contacts_sums *mine = into;
    const contacts_sums *other = from;
    clod_exact_merge(&mine->overlap, &other->overlap);
    mine->max_overlap = fmax(mine->max_overlap, other->max_overlap);
    mine->pairs += other->pairs;
    mine->walls += other->walls;
    mine->grains += other->grains;
}

const clod_survey_way CLOD_MEASURE_CONTACTS_WAY = {.add = add_contacts,
                                                   .merge = merge_contacts};

bool clod_measure_contacts_from(const clod_survey *survey, clod_measure_contacts *found,
                                clod_status *status)
{
    contacts_sums sums = {.pairs = 0};
    const clod_survey_question question = {
        .kind = CLOD_SURVEY_CONTACTS, .sums = &sums, .sums_bytes = sizeof sums};
    const bool good = clod_survey_ask(survey, &question, status);
    const double pairs = (double)sums.pairs;
    *found = (clod_measure_contacts){.pairs = (size_t)sums.pairs,
                                     .walls = (size_t)sums.walls,
                                     .max_overlap = sums.max_overlap};
    found->mean_overlap = sums.pairs > 0 ? clod_exact_value(&sums.overlap) / pairs : 0.0;
    found->coordination = 2.0 * pairs / (double)(sums.grains + !sums.grains);
    return good;
}

clod_measure_contacts clod_measure_contacts_of(const clod_state *state)
{
    clod_contact_list list;
    clod_measure_contacts found;
    const clod_contact_source contacts = clod_contact_source_of(&list, state);
    const clod_survey survey = clod_survey_of(state, &contacts);
    clod_measure_contacts_from(&survey, &found, &(clod_status){0}); // needs no memory
    return found;
}

// ---- motion

/** Its sums. */
typedef struct motion_sums {
    clod_exact mass, kinetic_energy;
    double max_speed2;
    int64_t grains, loaded;
} motion_sums;

static bool carries_load(const clod_state *state, size_t g)
{
    const double *load = state->grains.load[g];
    const double mass = state->grains.velocity[g][3];
    bool free = true;
    for (int a = 0; a < 3; a++) { // a sum to which nothing was added is the weight itself
        free = free && load[a] == mass * state->gravity[a];
    }
    return !free;
}

static bool add_motion(const clod_survey_question *question, const clod_survey_part *here,
                       clod_status *status)
{
    (void)status;
    motion_sums *sums = question->sums;
    const clod_grains *grains = &here->state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        if (!clod_survey_has(here, g)) {
            continue;
        }
        const double *v = grains->velocity[g], *w = grains->angular_velocity[g];
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const double w2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        sums->grains++;
        sums->loaded += carries_load(here->state, g);
        sums->max_speed2 = fmax(sums->max_speed2, v2);
        clod_exact_add(&sums->mass, v[3]);
        clod_exact_add(&sums->kinetic_energy, 0.5 * v[3] * v2);
        clod_exact_add(&sums->kinetic_energy, 0.5 / w[3] * w2);
    }
    return true;
}

static void merge_motion(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    motion_sums *mine = into;
    const motion_sums *other = from;
    clod_exact_merge(&mine->mass, &other->mass);
    clod_exact_merge(&mine->kinetic_energy, &other->kinetic_energy);
    mine->max_speed2 = fmax(mine->max_speed2, other->max_speed2);
    mine->grains += other->grains;
    mine->loaded += other->loaded;
}

const clod_survey_way CLOD_MEASURE_MOTION_WAY = {.add = add_motion, .merge = merge_motion};

clod_measure_motion clod_measure_motion_from(const clod_survey *survey)
{
    motion_sums sums = {.grains = 0};
    const clod_survey_question question = {
        .kind = CLOD_SURVEY_MOTION, .sums = &sums, .sums_bytes = sizeof sums};
    if (!clod_survey_ask(survey, &question, &(clod_status){0})) {
        return (clod_measure_motion){
            .mass = (double)NAN, .kinetic_energy = (double)NAN, .max_speed = (double)NAN};
    }
    return (clod_measure_motion){.grains = sums.grains,
                                 .loaded = sums.loaded,
                                 .mass = clod_exact_value(&sums.mass),
                                 .kinetic_energy = clod_exact_value(&sums.kinetic_energy),
                                 .max_speed = sqrt(sums.max_speed2)};
}

clod_measure_motion clod_measure_motion_of(const clod_state *state)
{
    const clod_survey survey = clod_survey_of(state, NULL);
    return clod_measure_motion_from(&survey);
}
