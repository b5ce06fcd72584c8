// Test 4 of Chung & Ooi 2011: oblique impacts on a rigid plane.
#include <math.h>
#include <stdio.h>

#include "verify/chung_ooi.h"
#include "verify/suite.h"

// Materials as published (and repeated by the benchmark decks of Yade and LIGGGHTS).
static const clod_verify_chung_material AL_OXIDE = {"al_oxide", 4000.0, 380e9, 0.23};
static const clod_verify_chung_material AL_ALLOY = {"al_alloy", 2700.0, 70e9, 0.33};

#define DEGREE (M_PI / 180.0)
#define SPEED_4 3.9 ///< m/s

#define SLIDING "rigid body sliding, src/verify/hertz.h; " CLOD_VERIFY_CHUNG
#define LEVER_REASON                                                                           \
    "clod's contact is on the plane: friction acts at the lever R - <d>, <d> the mean "        \
    "overlap "                                                                                 \
    "of the impact, where rigid theory has R; here the two terms of the angle nearly cancel; " \
    "the next row counts it"
#define DIGITISED                                                                              \
    CLOD_VERIFY_CHUNG ", curve of test 4 as digitised in the test data of Kratos Multiphysics"

#define UNEXPLAINED                                                                            \
    "the published points are sharp to 0.3 deg (6 %), which explains half at most; the rest "  \
    "is taken for the spring and step of the programs that made them. Kratos is off by "       \
    "17.7 %; docs/theory/tangential.md"

/**
 * Test 4, aluminium oxide, read off the published curves: digitised points of the Kratos
 * Multiphysics test data (BSD). The marks are at these angles; the abscissae as digitised are
 * at most 0.26 deg off.
 */
typedef struct digitised {
    double angle;       ///< deg, from the normal
    double restitution; ///< v_t'/v_t
    double spin;        ///< rad/s
    double rebound;     ///< deg, of the contact patch
} digitised;

static const digitised DIGITISED_4[] = {
    {5, 0.948105, -19.2661, 3.76133},   {10, 0.686985, -212.997, -1.55589},
    {15, 0.624382, -377.829, -5.54381}, {20, 0.616145, -510.55, -7.53776},
    {25, 0.634267, -599.388, -7.53776}, {30, 0.68369, -616.514, -3.54985},
    {35, 0.737232, -582.263, 3.429},    {40, 0.78089, -544.801, 11.571},
    {50, 0.84514, -457.034, 29.3505},   {60, 0.892916, -357.492, 47.7946},
    {70, 0.931631, -246.177, 64.577},   {80, 0.966227, -126.3, 78.7009},
    {85, 0.982702, -63.1498, 84.5166},
};
#define ANGLES ((int)(sizeof DIGITISED_4 / sizeof *DIGITISED_4))

/** The three quantities of a point of test 4. */
enum { RESTITUTION, SPIN, REBOUND, QUANTITIES };

typedef struct oblique {
    double of[QUANTITIES]; ///< as in digitised
} oblique;

/**
 * Of the rebound angle phi a difference is judged twice, over its own size and over what its
 * two terms would turn it by, (v_t' + R w)/v_n' cos^2(phi) [deg]: tan(phi) = (v_t' - R w)/v_n',
 * and while the sphere sticks the two nearly cancel. The first is a recorded miss: what the
 * published curve can tell is in docs/theory/tangential.md.
 */
static double terms_of_rebound(const clod_verify_chung *chung, const digitised *known)
{
    const double angle = known->angle * DEGREE;
    const double terms =
        fabs(known->restitution) * SPEED_4 * sin(angle) + chung->radius_a * fabs(known->spin);
    const double c = cos(known->rebound * DEGREE);
    return terms / (chung->restitution * SPEED_4 * cos(angle)) * c * c / DEGREE;
}

static oblique oblique_of(const clod_verify_chung *chung, const clod_verify_chung_point *point,
                          double v_t, double w, double v_n)
{
    const double slip = clod_verify_chung_slip(chung, v_t, w, 0.0, 0.0);
    return (oblique){{v_t / point->slip, -w, atan(slip / v_n) / DEGREE}};
}

/** What clod found, what sliding throughout gives (NAN: no sliding) and what was published. */
typedef struct oblique_point {
    double angle;
    oblique got, sliding, levered, published; ///< levered: sliding with the lever of clod
    double terms; ///< of the rebound angle, see terms_of_rebound [deg]
} oblique_point;

static oblique_point oblique_point_of(const clod_verify_chung *chung,
                                      const clod_verify_chung_point *point,
                                      const clod_verify_impact *impact, const digitised *known)
{
    const oblique none = {{NAN, NAN, NAN}};
    oblique_point p = {.angle = known->angle, .sliding = none, .levered = none};
    p.got = oblique_of(chung, point, impact->v[0].x, impact->w[0].y, impact->v[0].z);
    p.published = (oblique){{known->restitution, known->spin, known->rebound}};
    p.terms = terms_of_rebound(chung, known);
    if (clod_verify_chung_slides(chung, point)) {
        const double v_n = chung->restitution * point->normal;
        clod_verify_chung_after after = clod_verify_chung_sliding(chung, point);
        p.sliding = oblique_of(chung, point, after.v_a, after.w_a, v_n);
        after = clod_verify_chung_levered(chung, point);
        p.levered = oblique_of(chung, point, after.v_a, after.w_a, v_n);
    }
    return p;
}

/** One of the three quantities. */
typedef struct oblique_quantity {
    const char *file, *label;
} oblique_quantity;

static const oblique_quantity QUANTITY[QUANTITIES] = {
    [RESTITUTION] = {"restitution", "tangential restitution [1]"},
    [SPIN] = {"spin", "spin after [rad/s]"},
    [REBOUND] = {"rebound", "rebound angle of the contact patch [deg]"},
};

static bool write_oblique(const clod_verify_bench *bench, const char *sphere, int quantity,
                          const oblique_point *points, bool published, clod_status *status)
{
    char name[96];
    char header[256];
    snprintf(name, sizeof name, "%s-%s-%s", bench->test, sphere, QUANTITY[quantity].file);
    snprintf(header, sizeof header,
             "angle of impact from the normal [deg],clod: %s,closed form (sliding)%s",
             QUANTITY[quantity].label, published ? ",published curve (digitised)" : "");
    clod_verify_curve *curve = clod_verify_curve_open(bench, name, header, status);
    for (int k = 0; curve != NULL && k < ANGLES; k++) {
        const double row[] = {points[k].angle, points[k].got.of[quantity],
                              points[k].sliding.of[quantity], points[k].published.of[quantity]};
        clod_verify_curve_add(curve, row, published ? 4 : 3);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

/** The sliding range against one of the closed forms: the worst angle. */
static bool check_form(const clod_verify_bench *bench, const char *sphere, int quantity,
                       const oblique_point *points, bool levered, clod_status *status)
{
    clod_verify_worst worst = CLOD_VERIFY_WORST;
    double from = 90.0;
    for (int k = 0; k < ANGLES; k++) {
        const oblique *form = levered ? &points[k].levered : &points[k].sliding;
        if (!isnan(form->of[quantity])) {
            clod_verify_worst_offer(&worst, points[k].angle, form->of[quantity],
                                    points[k].got.of[quantity]);
            from = fmin(from, points[k].angle);
        }
    }
    const clod_verify_expect sliding = {worst.expected, 5e-3, true,
                                        levered ? CLOD_VERIFY_CHUNG_LEVER : SLIDING};
    return clod_verify_bench_check(bench, &sliding, worst.got, status,
                                   "%s: %s, sliding%s (%.0f-85 deg), worst at %.0f deg", sphere,
                                   QUANTITY[quantity].label, levered ? " with the lever" : "",
                                   from, worst.at);
}

/** The sliding range; the rebound angle, where terms cancel, is a recorded miss and judged
 *  beside the form with clod's lever, too. */
static bool check_sliding(const clod_verify_bench *bench, const char *sphere, int quantity,
                          const oblique_point *points, clod_status *status)
{
    if (!check_form(bench, sphere, quantity, points, false, status)) {
        return false;
    }
    if (quantity != REBOUND) {
        return true;
    }
    clod_verify_bench_record_miss(bench, LEVER_REASON);
    return check_form(bench, sphere, quantity, points, true, status);
}

/** The sticking range against the published curve: mean difference over mean size. */
static bool check_published(const clod_verify_bench *bench, const char *sphere, int quantity,
                            const oblique_point *points, clod_status *status)
{
    double off = 0.0;
    double size = 0.0;
    double terms = 0.0;
    double to = 0.0;
    int count = 0;
    for (int k = 0; k < ANGLES; k++) {
        if (isnan(points[k].sliding.of[quantity])) {
            off += fabs(points[k].got.of[quantity] - points[k].published.of[quantity]);
            size += fabs(points[k].published.of[quantity]);
            terms += points[k].terms;
            count++;
            to = fmax(to, points[k].angle);
        }
    }
    const clod_verify_expect none = {0.0, 0.05, false, DIGITISED};
    const char *label = QUANTITY[quantity].label;
    if (!clod_verify_bench_check(bench, &none, off / size, status,
                                 "%s: %s, sticking (5-%.0f deg), off by %.3g, over mean value",
                                 sphere, label, to, off / count)) {
        return false;
    }
    if (quantity != REBOUND) {
        return true;
    }
    clod_verify_bench_record_miss(bench, UNEXPLAINED);
    return clod_verify_bench_check(bench, &none, off / terms, status,
                                   "%s: %s, sticking (5-%.0f deg), off by %.3g, over mean of "
                                   "its two terms",
                                   sphere, label, to, off / count);
}

static bool report_4(const clod_verify_bench *bench, const char *sphere,
                     const oblique_point *points, bool published, clod_status *status)
{
    bool ok = true;
    for (int q = 0; ok && q < QUANTITIES; q++) {
        ok = write_oblique(bench, sphere, q, points, published, status) &&
             check_sliding(bench, sphere, q, points, status) &&
             (!published || check_published(bench, sphere, q, points, status));
    }
    return ok;
}

static bool run_4(const clod_verify_bench *bench, const clod_verify_chung_material *sphere,
                  bool published, clod_status *status)
{
    char name[64];
    snprintf(name, sizeof name, "%s-%s", bench->test, sphere->name);
    const clod_verify_chung chung = {
        .a = sphere, .radius_a = 2.5e-3, .restitution = 0.98, .friction = 0.092};
    clod_verify_deck deck = {
        .name = name, .title = "Chung & Ooi 2011, test 4: oblique impacts, 3.9 m/s, 5-85 deg"};
    clod_verify_chung_point points[ANGLES];
    clod_verify_impact impacts[ANGLES];
    oblique_point found[ANGLES];
    for (int k = 0; k < ANGLES; k++) {
        const double angle = DIGITISED_4[k].angle * DEGREE;
        points[k] = (clod_verify_chung_point){.normal = SPEED_4 * cos(angle),
                                              .slip = SPEED_4 * sin(angle)};
    }
    clod_verify_chung_deck(&chung, points, ANGLES, &deck, impacts);
    if (!clod_verify_impact_frames(bench, &deck, impacts, ANGLES, status)) {
        return false;
    }
    for (int k = 0; k < ANGLES; k++) {
        found[k] = oblique_point_of(&chung, &points[k], &impacts[k], &DIGITISED_4[k]);
    }
    return report_4(bench, sphere->name, found, published, status);
}

bool clod_verify_chung_ooi_4(const clod_verify_bench *bench, clod_status *status)
{
    return run_4(bench, &AL_OXIDE, true, status) && run_4(bench, &AL_ALLOY, false, status);
}
