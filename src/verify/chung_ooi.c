#include "verify/chung_ooi.h"

#include <math.h>
#include <stdio.h>

/** Steps in the shortest elastic contact of a deck. */
#define CONTACT_STEPS 4000.0
/** Steps before the first touch; the half keeps it between two steps. */
#define STEPS_BEFORE 20.5
/** Length of a run over the longest elastic contact; damped ones are longer. */
#define RUN_LENGTH 3.0

static double compliance(const clod_verify_chung_material *of)
{
    return (1.0 - of->poissons_ratio * of->poissons_ratio) / of->youngs_modulus;
}

clod_verify_pair clod_verify_chung_pair(const clod_verify_chung *self, double speed)
{
    clod_verify_pair pair = {.radius_a = self->radius_a,
                             .mass_a =
                                 clod_verify_hertz_sphere(self->a->density, self->radius_a),
                             .young_star = 1.0 / compliance(self->a),
                             .speed = speed};
    if (self->b != NULL) {
        pair.radius_b = self->radius_b;
        pair.mass_b = clod_verify_hertz_sphere(self->b->density, self->radius_b);
        pair.young_star = 1.0 / (compliance(self->a) + compliance(self->b));
    }
    return pair;
}

double clod_verify_chung_slip(const clod_verify_chung *self, double v_a, double w_a, double v_b,
                              double w_b)
{
    return v_a - self->radius_a * w_a - (v_b + self->radius_b * w_b);
}

static double slip_before(const clod_verify_chung *self, const clod_verify_chung_point *point)
{
    return clod_verify_chung_slip(self, point->slip, point->spin_a, 0.0, point->spin_b);
}

/** (1 + e) v, the change of the normal speed [m/s]. */
static double change(const clod_verify_chung *self, const clod_verify_chung_point *point)
{
    return (1.0 + self->restitution) * point->normal;
}

bool clod_verify_chung_slides(const clod_verify_chung *self,
                              const clod_verify_chung_point *point)
{
    return fabs(slip_before(self, point)) > 3.5 * self->friction * change(self, point);
}

clod_verify_chung_after clod_verify_chung_sliding(const clod_verify_chung *self,
                                                  const clod_verify_chung_point *point)
{
    const clod_verify_pair pair = clod_verify_chung_pair(self, point->normal);
    const double side = copysign(1.0, slip_before(self, point));
    const double impulse =
        side * self->friction * clod_verify_hertz_mass(&pair) * change(self, point);
    clod_verify_chung_after after = {.v_a = point->slip - impulse / pair.mass_a,
                                     .w_a = point->spin_a +
                                            2.5 * impulse / (pair.mass_a * pair.radius_a)};
    if (self->b != NULL) {
        after.v_b = impulse / pair.mass_b;
        after.w_b = point->spin_b + 2.5 * impulse / (pair.mass_b * pair.radius_b);
    }
    return after;
}

clod_verify_chung_after clod_verify_chung_levered(const clod_verify_chung *self,
                                                  const clod_verify_chung_point *point)
{
    const clod_verify_pair pair = clod_verify_chung_pair(self, point->normal);
    const double part = 1.0 - clod_verify_hertz_mean_overlap(&pair) / pair.radius_a;
    clod_verify_chung_after after = clod_verify_chung_sliding(self, point);
    after.w_a = point->spin_a + part * (after.w_a - point->spin_a);
    return after;
}

static void put_materials(const clod_verify_chung *self, clod_verify_deck *deck)
{
    const clod_verify_chung_material *a = self->a;
    const clod_verify_chung_material *b = self->b;
    const double stiffer = b == NULL ? 2.0 : 1.0; // a rigid plane: see the head of chung_ooi.h
    clod_verify_deck_material(deck, a->name, a->density, stiffer * a->youngs_modulus,
                              a->poissons_ratio);
    if (b != NULL && b != a) {
        clod_verify_deck_material(deck, b->name, b->density, b->youngs_modulus,
                                  b->poissons_ratio);
    } else if (b == NULL) {
        clod_verify_deck_wall(deck, "plane", a->name, 0.0, 1.0);
    }
    clod_verify_deck_contact(deck, "default",
                             "law: hertz, restitution: %.17g, friction: %.17g, rolling: none",
                             self->restitution, self->friction);
}

/** Partners of one impact; they touch after `wait` [s]. */
static clod_verify_impact put_impact(const clod_verify_chung *self,
                                     const clod_verify_chung_point *point, double across,
                                     double wait, clod_verify_deck *deck)
{
    clod_verify_impact impact = {.a = deck->grain_count, .b = CLOD_VERIFY_ON_WALL};
    const double share = self->b != NULL ? self->share : 1.0;
    const double before = wait * point->normal;
    clod_verify_grain *a =
        clod_verify_deck_grain(deck, self->a->name, self->radius_a,
                               (clod_vec3){0.0, across, self->radius_a + share * before});
    a->velocity = (clod_vec3){point->slip, 0.0, -share * point->normal};
    a->spin.y = point->spin_a;
    if (self->b != NULL) {
        const double away = (1.0 - share) * before;
        impact.b = deck->grain_count;
        clod_verify_grain *b =
            clod_verify_deck_grain(deck, self->b->name, self->radius_b,
                                   (clod_vec3){0.0, across, -self->radius_b - away});
        b->velocity.z = (1.0 - share) * point->normal;
        b->spin.y = point->spin_b;
    }
    return impact;
}

void clod_verify_chung_deck(const clod_verify_chung *self,
                            const clod_verify_chung_point *points, int count,
                            clod_verify_deck *deck, clod_verify_impact *impacts)
{
    double shortest = HUGE_VAL;
    double longest = 0.0;
    for (int k = 0; k < count; k++) {
        const clod_verify_pair pair = clod_verify_chung_pair(self, points[k].normal);
        const double duration = clod_verify_hertz_duration(&pair);
        shortest = fmin(shortest, duration);
        longest = fmax(longest, duration);
    }
    deck->step = shortest / CONTACT_STEPS;
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = RUN_LENGTH * longest});
    put_materials(self, deck);
    const double spacing = 4.0 * fmax(self->radius_a, self->radius_b);
    for (int k = 0; k < count; k++) {
        const double across = spacing * (k - 0.5 * (count - 1));
        impacts[k] = put_impact(self, &points[k], across, STEPS_BEFORE * deck->step, deck);
    }
}
