#include "measure/continuum_pass.h"

#include <math.h>

#include "base/memory.h"
#include "measure/continuum_sums.h"
#include "state/contact_walk.h"

#define IMAGES 27

/** What a pass works with. */
typedef struct pass {
    const clod_survey_part *here;
    const clod_state *state;
    clod_continuum_sums *sums; ///< [count] owned
    size_t count;
    int32_t *partners; ///< [grains] owned, contacts of each
    int images;
    double image[IMAGES][3]; ///< m, by which images of the domain are shifted; the first by 0
} pass;

static void list_images(pass *self)
{
    const clod_domain *domain = &self->state->domain;
    self->images = 1;
    for (int k = 0; k < IMAGES; k++) {
        const int at[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        bool real = at[0] != 0 || at[1] != 0 || at[2] != 0;
        for (int a = 0; a < 3; a++) {
            real = real && (at[a] == 0 || domain->periodic[a]);
        }
        for (int a = 0; real && a < 3; a++) {
            self->image[self->images][a] = at[a] * (domain->max[a] - domain->min[a]);
        }
        self->images += real;
    }
}

/** Moves a place to an image of it. */
static void to_image(const pass *self, int image, const double at[3], double to[3])
{
    for (int a = 0; a < 3; a++) {
        to[a] = at[a] + self->image[image][a];
    }
}

/** Whether what lies in a box, moved to an image, reaches a field. A mean has no kernel: what is at
 *  one place along a periodic direction is there in the domain, and in no image. So what is on a
 *  side counts once. */
static bool reaches(const pass *self, size_t f, int image, const double low[3],
                    const double high[3])
{
    bool real = true;
    for (int a = 0; a < 3; a++) {
        real = real && (self->image[image][a] == 0.0 || low[a] < high[a] ||
                        self->sums[f].field->cell > 0.0);
    }
    return real && clod_continuum_sums_reached(&self->sums[f], low, high);
}

/** A branch with all its images that reach a field; `to` is in the domain. */
static void spread_branch(const pass *self, const double from[3], const double to[3],
                          const double force[3])
{
    for (int k = 0; k < self->images; k++) {
        double begin[3], end[3], low[3], high[3];
        to_image(self, k, from, begin);
        to_image(self, k, to, end);
        for (int a = 0; a < 3; a++) {
            low[a] = fmin(begin[a], end[a]);
            high[a] = fmax(begin[a], end[a]);
        }
        for (size_t f = 0; f < self->count; f++) {
            if (reaches(self, f, k, low, high)) {
                clod_continuum_sums_branch(&self->sums[f], begin, end, force);
            }
        }
    }
}

/** The force of a wall at a point in the domain, likewise. */
static void spread_push(const pass *self, const double at[3], const double force[3])
{
    for (int k = 0; k < self->images; k++) {
        double there[3];
        to_image(self, k, at, there);
        for (size_t f = 0; f < self->count; f++) {
            if (reaches(self, f, k, there, there)) {
                clod_continuum_sums_push(&self->sums[f], there, force);
            }
        }
    }
}

static void spread_contact(const pass *self, const double end[3],
                           const clod_contact_force *told, bool wall)
{
    const clod_domain *domain = &self->state->domain;
    double from[3], to[3], at[3];
    for (int a = 0; a < 3; a++) {
        to[a] = clod_domain_within(domain, a, end[a]);
        from[a] = to[a] - (end[a] - told->from[a]);
        at[a] = clod_domain_within(domain, a, told->from[a]);
    }
    spread_branch(self, from, to, told->force);
    if (wall) {
        spread_push(self, at, told->force);
    }
}

/** A contact, seen from the grain with the smaller id whatever the order of the rows. */
static void add_contact(pass *self, const clod_contact_source *contacts,
                        const clod_contact *contact)
{
    const clod_grains *grains = &self->state->grains;
    const bool wall = contact->shape >= 0;
    clod_contact seen = *contact;
    self->partners[contact->i]++;
    if (!wall) {
        self->partners[contact->j]++;
        if (grains->id[contact->i] > grains->id[contact->j]) {
            clod_contact_turn(&seen);
        }
    }
    if (contacts->force != NULL && clod_survey_has(self->here, (size_t)contact->i)) {
        const clod_contact_force told = contacts->force(contacts->laws, &seen);
        spread_contact(self, grains->position[seen.i], &told, wall);
    }
}

static void add_contacts(pass *self, const clod_contact_source *contacts)
{
    const clod_contact *contact;
    clod_contact_walk walk;
    clod_contact_walk_begin(&walk, contacts);
    while ((contact = clod_contact_walk_next(&walk)) != NULL) {
        add_contact(self, contacts, contact);
    }
}

/** Sums of a grain or an image of it at `at`, for a kernel of 1/m3; numbers of grains times the
 *  field's scale cubed. */
static void sums_of(const pass *self, size_t g, const clod_continuum *field, const double at[3],
                    double sum[CLOD_CONTINUUM_GRAIN_SUMS])
{
    const clod_grains *grains = &self->state->grains;
    const double mass = grains->velocity[g][3], radius = grains->position[g][3];
    const double volume = 4.0 / 3.0 * M_PI * radius * radius * radius;
    const double number = field->scale * field->scale * field->scale;
    double v[3];
    clod_continuum_turn(field, at, grains->velocity[g], v);
    sum[CLOD_CONTINUUM_MASS] = mass;
    for (int a = 0; a < 3; a++) {
        sum[CLOD_CONTINUUM_MOMENTUM + a] = mass * v[a];
        sum[CLOD_CONTINUUM_FLUX + a] = mass * v[a] * v[a];
    }
    sum[CLOD_CONTINUUM_FLUX + 3] = mass * v[0] * v[1];
    sum[CLOD_CONTINUUM_FLUX + 4] = mass * v[0] * v[2];
    sum[CLOD_CONTINUUM_FLUX + 5] = mass * v[1] * v[2];
    sum[CLOD_CONTINUUM_VOLUME] = volume;
    sum[CLOD_CONTINUUM_NUMBER] = number;
    sum[CLOD_CONTINUUM_PARTNERS] = number * self->partners[g];
    sum[CLOD_CONTINUUM_RADIUS] = volume * radius;
}

static void add_grain(const pass *self, size_t g)
{
    const clod_grains *grains = &self->state->grains;
    double place[4];
    clod_domain_place(&self->state->domain, grains->position[g], place);
    for (int k = 0; k < self->images; k++) {
        double at[3];
        to_image(self, k, place, at);
        for (size_t f = 0; f < self->count; f++) {
            if (reaches(self, f, k, at, at)) {
                double sum[CLOD_CONTINUUM_GRAIN_SUMS];
                sums_of(self, g, self->sums[f].field, at, sum);
                clod_continuum_sums_grain(&self->sums[f], at, sum);
            }
        }
    }
}

static size_t points_of(const clod_continuum *fields, size_t count)
{
    size_t points = 0;
    for (size_t f = 0; f < count; f++) {
        points += (size_t)clod_continuum_points(&fields[f]);
    }
    return points;
}

/** Sums of each field, in points that lie one behind the other. */
static bool open(pass *self, const clod_continuum *fields, clod_continuum_point *point)
{
    self->sums = clod_memory_alloc(self->count + 1, sizeof *self->sums);
    self->partners = clod_memory_alloc(self->state->grains.count + 1, sizeof *self->partners);
    for (size_t f = 0; self->sums != NULL && f < self->count; f++) {
        self->sums[f] = clod_continuum_sums_of(&fields[f], point);
        point += clod_continuum_points(&fields[f]);
    }
    return self->sums != NULL && self->partners != NULL;
}

static bool fail(size_t count, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for a sample of %zu fields", count);
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    const clod_continuum *fields = question->asked;
    pass self = {
        .here = here, .state = here->state, .count = question->asked_bytes / sizeof *fields};
    const bool good = open(&self, fields, question->sums);
    if (good) {
        list_images(&self);
        add_contacts(&self, here->contacts);
        for (size_t g = 0; g < self.state->grains.count; g++) {
            if (clod_survey_has(here, g)) {
                add_grain(&self, g);
            }
        }
        for (size_t f = 0; f < self.count; f++) {
            clod_continuum_sums_end(&self.sums[f]);
        }
    }
    clod_memory_free(self.sums);
    clod_memory_free(self.partners);
    return good || fail(self.count, status);
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    clod_continuum_sums_merge(into, from);
}

const clod_survey_way CLOD_CONTINUUM_PASS_WAY = {
    .add = add, .merge = merge, .unit = sizeof(clod_continuum_point), .motions = true};

bool clod_continuum_pass(const clod_continuum_part *parts, size_t count,
                         const clod_survey *survey, clod_status *status)
{
    clod_continuum *fields = clod_memory_alloc(count + 1, sizeof *fields); // all zero
    for (size_t f = 0; fields != NULL && f < count; f++) {
        fields[f] = *parts[f].field;
    }
    const size_t points = fields != NULL ? points_of(fields, count) : 0;
    clod_continuum_point *point = clod_memory_alloc(points + 1, sizeof *point);
    const clod_survey_question question = {.kind = CLOD_SURVEY_CONTINUUM,
                                           .asked = fields,
                                           .asked_bytes = count * sizeof *fields,
                                           .sums = point,
                                           .sums_bytes = points * sizeof *point};
    bool good = (fields != NULL && point != NULL) || fail(count, status);
    good = good && clod_survey_ask(survey, &question, status);
    const clod_continuum_point *next = point;
    for (size_t f = 0; good && f < count; f++) {
        clod_continuum_sums_take(next, clod_continuum_points(parts[f].field), parts[f].to);
        next += clod_continuum_points(parts[f].field);
    }
    clod_memory_free(fields);
    clod_memory_free(point);
    return good;
}
