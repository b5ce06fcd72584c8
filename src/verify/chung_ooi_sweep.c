// Tests 5-8 of Chung & Ooi 2011: slip by velocity or spin at a constant normal speed, on a
// rigid plane and between two spheres. Drawn as the slip after over mu v_n, and spin likewise.
#include <math.h>
#include <stdio.h>

#include "verify/chung_ooi.h"
#include "verify/suite.h"

#define POINTS_MOST 16
#define SLIDING "rigid body sliding, src/verify/hertz.h; " CLOD_VERIFY_CHUNG
#define LEVER_REASON                                                                           \
    "clod's contact is on the plane: friction acts at the lever R - <d>, <d> the mean "        \
    "overlap "                                                                                 \
    "of the impact, where rigid theory has R; the next row counts it"

// Materials as published (and repeated by the benchmark decks of PySPH and LIGGGHTS).
static const clod_verify_chung_material STEEL = {"steel", 7850.0, 208e9, 0.30};
static const clod_verify_chung_material POLYETHYLENE = {"polyethylene", 1400.0, 1e9, 0.40};
static const clod_verify_chung_material AL_ALLOY = {"al_alloy", 2700.0, 70e9, 0.33};
static const clod_verify_chung_material NYLON = {"nylon", 1000.0, 2.5e9, 0.40};
static const clod_verify_chung_material COPPER = {"copper", 8900.0, 120e9, 0.35};

/** Spins of tests 6-8 [rad/s]. */
static const double SPINS[] = {0.175, 0.3, 0.5, 0.7, 0.9,  1.3,  2.0, 3.0,
                               4.0,   5.0, 7.0, 9.0, 12.0, 16.0, 22.0};
#define SPIN_COUNT ((int)(sizeof SPINS / sizeof *SPINS))

/** One curve: a deck, and what is expected of it. */
typedef struct sweep {
    const char *name, *title;
    clod_verify_chung chung;
    clod_verify_chung_point points[POINTS_MOST];
    int count;
    bool lever; ///< elastic impacts on a plane, deep enough to see the overlap in the lever
} sweep;

static clod_verify_chung_after after_of(const clod_verify_impact *impact)
{
    return (clod_verify_chung_after){impact->v[0].x, impact->v[1].x, impact->w[0].y,
                                     impact->w[1].y};
}

/** Slip after, and spin of a, over mu v_n. */
static void put_point(const sweep *self, int k, const clod_verify_chung_after *after,
                      double row[2])
{
    const clod_verify_chung *chung = &self->chung;
    const double unit = chung->friction * self->points[k].normal;
    row[0] =
        clod_verify_chung_slip(chung, after->v_a, after->w_a, after->v_b, after->w_b) / unit;
    row[1] = chung->radius_a * after->w_a / unit;
}

static bool write_sweep(const clod_verify_bench *bench, const sweep *self,
                        const clod_verify_impact *impacts, clod_status *status)
{
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, self->name,
        "slip before over mu v_n [1],clod: slip after over mu v_n [1],"
        "clod: R spin after over mu v_n [1],closed form: slip (sliding) [1],"
        "closed form: R spin (sliding) [1]",
        status);
    for (int k = 0; curve != NULL && k < self->count; k++) {
        const clod_verify_chung_point *p = &self->points[k];
        const clod_verify_chung_after before = {.v_a = p->slip, 0.0, p->spin_a, p->spin_b};
        const clod_verify_chung_after got = after_of(&impacts[k]);
        double start[2];
        put_point(self, k, &before, start);
        double row[5] = {start[0], NAN, NAN, NAN, NAN};
        put_point(self, k, &got, &row[1]);
        if (clod_verify_chung_slides(&self->chung, p)) {
            const clod_verify_chung_after expected = clod_verify_chung_sliding(&self->chung, p);
            put_point(self, k, &expected, &row[3]);
        }
        clod_verify_curve_add(curve, row, 5);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

/** The sliding range of one quantity: the worst point. */
static bool check_quantity(const clod_verify_bench *bench, const sweep *self,
                           const clod_verify_worst *worst, const char *label,
                           const char *source, clod_status *status)
{
    const clod_verify_expect sliding = {worst->expected, 5e-3, true, source};
    return clod_verify_bench_check(bench, &sliding, worst->got, status,
                                   "%s: %s, sliding, worst at slip %.3g mu v_n", self->name,
                                   label, worst->at);
}

static bool check_sweep(const clod_verify_bench *bench, const sweep *self,
                        const clod_verify_impact *impacts, clod_status *status)
{
    clod_verify_worst v_a = CLOD_VERIFY_WORST, w_a = CLOD_VERIFY_WORST;
    clod_verify_worst v_b = CLOD_VERIFY_WORST, w_b = CLOD_VERIFY_WORST;
    clod_verify_worst w_levered = CLOD_VERIFY_WORST;
    for (int k = 0; k < self->count; k++) {
        const clod_verify_chung_point *p = &self->points[k];
        if (!clod_verify_chung_slides(&self->chung, p)) {
            continue;
        }
        const clod_verify_chung_after got = after_of(&impacts[k]);
        const clod_verify_chung_after expected = clod_verify_chung_sliding(&self->chung, p);
        const double at =
            clod_verify_chung_slip(&self->chung, p->slip, p->spin_a, 0.0, p->spin_b) /
            (self->chung.friction * p->normal);
        clod_verify_worst_offer(&v_a, at, expected.v_a, got.v_a);
        clod_verify_worst_offer(&w_a, at, expected.w_a, got.w_a);
        clod_verify_worst_offer(&w_levered, at, clod_verify_chung_levered(&self->chung, p).w_a,
                                got.w_a);
        clod_verify_worst_offer(&v_b, at, expected.v_b, got.v_b);
        clod_verify_worst_offer(&w_b, at, expected.w_b, got.w_b);
    }
    if (!check_quantity(bench, self, &v_a, "velocity along the plane [m/s]", SLIDING, status) ||
        !check_quantity(bench, self, &w_a, "spin [rad/s]", SLIDING, status)) {
        return false;
    }
    if (self->lever) {
        clod_verify_bench_record_miss(bench, LEVER_REASON);
    }
    return (!self->lever ||
            check_quantity(bench, self, &w_levered, "spin, with the lever [rad/s]",
                           CLOD_VERIFY_CHUNG_LEVER, status)) &&
           (self->chung.b == NULL ||
            (check_quantity(bench, self, &v_b, "velocity of the other [m/s]", SLIDING,
                            status) &&
             check_quantity(bench, self, &w_b, "spin of the other [rad/s]", SLIDING, status)));
}

static bool run_deck(const clod_verify_bench *bench, const sweep *self,
                     clod_verify_impact *impacts, clod_status *status)
{
    clod_verify_deck deck = {.name = self->name, .title = self->title};
    clod_verify_chung_deck(&self->chung, self->points, self->count, &deck, impacts);
    return clod_verify_impact_frames(bench, &deck, impacts, self->count, status);
}

static bool run_sweep(const clod_verify_bench *bench, const sweep *self, clod_status *status)
{
    clod_verify_impact impacts[POINTS_MOST];
    return run_deck(bench, self, impacts, status) &&
           write_sweep(bench, self, impacts, status) &&
           check_sweep(bench, self, impacts, status);
}

bool clod_verify_chung_ooi_5(const clod_verify_bench *bench, clod_status *status)
{
    static const double SLIPS[] = {0.5, 1.0, 2.0, 3.0, 4.0,  5.0,
                                   6.0, 6.5, 7.5, 9.0, 11.0, 14.0}; // over mu v_n
    const clod_verify_chung_material *spheres[] = {&STEEL, &POLYETHYLENE};
    const char *names[] = {"chung-ooi-5-steel", "chung-ooi-5-polyethylene"};
    bool ok = true;
    for (int m = 0; ok && m < 2; m++) {
        sweep one = {
            .name = names[m],
            .title = "Chung & Ooi 2011, test 5: oblique impacts, 5 m/s along the normal",
            .chung = {.a = spheres[m], .radius_a = 1e-5, .restitution = 1.0, .friction = 0.3},
            .count = sizeof SLIPS / sizeof *SLIPS,
            .lever = true};
        for (int k = 0; k < one.count; k++) {
            one.points[k] =
                (clod_verify_chung_point){.normal = 5.0, .slip = SLIPS[k] * 0.3 * 5.0};
        }
        ok = run_sweep(bench, &one, status);
    }
    return ok;
}

/** Spins of a sweep; the partner has `other` times the spin. */
static void put_spins(sweep *self, double normal, double other)
{
    self->count = SPIN_COUNT;
    for (int k = 0; k < SPIN_COUNT; k++) {
        self->points[k] = (clod_verify_chung_point){
            .normal = normal, .spin_a = SPINS[k], .spin_b = other * SPINS[k]};
    }
}

bool clod_verify_chung_ooi_6(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_chung_material *spheres[] = {&AL_ALLOY, &NYLON};
    const char *names[] = {"chung-ooi-6-al_alloy", "chung-ooi-6-nylon"};
    bool ok = true;
    for (int m = 0; ok && m < 2; m++) {
        sweep one = {
            .name = names[m],
            .title = "Chung & Ooi 2011, test 6: spinning spheres on a rigid plane",
            .chung = {.a = spheres[m], .radius_a = 0.1, .restitution = 0.5, .friction = 0.4}};
        put_spins(&one, 0.2, 0.0);
        ok = run_sweep(bench, &one, status);
    }
    return ok;
}

static sweep equal_pair(const clod_verify_chung_material *sphere, const char *name,
                        const char *title)
{
    return (sweep){.name = name,
                   .title = title,
                   .chung = {.a = sphere,
                             .b = sphere,
                             .radius_a = 0.1,
                             .radius_b = 0.1,
                             .share = 0.5,
                             .restitution = 0.5,
                             .friction = 0.4}};
}

/** Opposite spins do not slip: nothing but the normal velocity changes. */
static bool check_gears(const clod_verify_bench *bench, const sweep *self,
                        const clod_verify_impact *impacts, clod_status *status)
{
    double drift = 0.0;
    clod_verify_worst spin = CLOD_VERIFY_WORST;
    for (int k = 0; k < self->count; k++) {
        const clod_verify_chung_point *p = &self->points[k];
        drift = clod_verify_larger(drift, fabs(impacts[k].v[0].x));
        drift = clod_verify_larger(drift, fabs(impacts[k].v[1].x));
        clod_verify_worst_offer(&spin, p->spin_a, p->spin_a, impacts[k].w[0].y);
        clod_verify_worst_offer(&spin, p->spin_b, p->spin_b, impacts[k].w[1].y);
    }
    const clod_verify_expect none = {0.0, 1e-12, false,
                                     "opposite spins do not slip; " CLOD_VERIFY_CHUNG};
    const clod_verify_expect same = {spin.expected, 1e-12, true,
                                     "opposite spins do not slip; " CLOD_VERIFY_CHUNG};
    return clod_verify_bench_check(bench, &none, drift, status,
                                   "%s: velocity across the normal [m/s], largest",
                                   self->name) &&
           clod_verify_bench_check(bench, &same, spin.got, status, "%s: spin [rad/s], worst",
                                   self->name);
}

bool clod_verify_chung_ooi_7(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_chung_material *spheres[] = {&AL_ALLOY, &COPPER};
    const char *names[] = {"chung-ooi-7-al_alloy", "chung-ooi-7-copper"};
    const char *slip_names[] = {"chung-ooi-7-al_alloy-slip", "chung-ooi-7-copper-slip"};
    bool ok = true;
    for (int m = 0; ok && m < 2; m++) {
        clod_verify_impact impacts[POINTS_MOST];
        sweep gears = equal_pair(spheres[m], names[m],
                                 "Chung & Ooi 2011, test 7: equal spheres, opposite spins");
        put_spins(&gears, 0.4, -1.0);
        sweep slip = equal_pair(spheres[m], slip_names[m],
                                "As test 7 of Chung & Ooi 2011, but with equal spins");
        put_spins(&slip, 0.4, 1.0);
        ok = run_deck(bench, &gears, impacts, status) &&
             check_gears(bench, &gears, impacts, status) && run_sweep(bench, &slip, status);
    }
    return ok;
}

/** The other sphere as published: 5 times the radius, 1 000 times the density, and in case A
 *  1 000 times the modulus as well. */
static clod_verify_chung_material target_of(const clod_verify_chung_material *sphere,
                                            double stiffer)
{
    clod_verify_chung_material target = *sphere;
    target.name = "target";
    target.density = 1000.0 * sphere->density;
    target.youngs_modulus = stiffer * sphere->youngs_modulus;
    return target;
}

bool clod_verify_chung_ooi_8(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_chung_material *spheres[] = {&AL_ALLOY, &NYLON};
    const char *names[] = {"chung-ooi-8-al_alloy-a", "chung-ooi-8-al_alloy-b",
                           "chung-ooi-8-nylon-a", "chung-ooi-8-nylon-b"};
    bool ok = true;
    for (int m = 0; ok && m < 4; m++) {
        const clod_verify_chung_material target =
            target_of(spheres[m / 2], m % 2 == 0 ? 1000.0 : 1.0);
        sweep one = equal_pair(spheres[m / 2], names[m],
                               "Chung & Ooi 2011, test 8: spinning sphere on a larger one");
        one.chung.b = &target;
        one.chung.radius_b = 0.5;
        one.chung.share = 1.0;
        put_spins(&one, 0.2, 0.0);
        ok = run_sweep(bench, &one, status);
    }
    return ok;
}
