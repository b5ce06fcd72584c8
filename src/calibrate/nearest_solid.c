/**
 * @file nearest_solid.c
 * Least squares over the solids that are possible, with coordinates from 0 to 1 whose whole cube is possible:
 * docs/theory/calibration.md, "What targets cannot be".
 */

#include "calibrate/nearest_solid.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

#include "analysis/mohr.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"

#define UNKNOWNS 3
#define ABOVE                                                                                  \
    1.25 ///< tau_p over the height of the locus, at most: a specimen of cases/lab-to-outlet has 1.15
#define STARTS 4         ///< along each coordinate
#define STEPS 80         ///< of one descent, at most
#define STIFF 1e12       ///< damping that no step comes through
#define SETTLED 1e-9     ///< relative, of chi-square
#define DIFFERENCE 1e-6  ///< of a coordinate, for derivatives
#define INDEPENDENT 1e-7 ///< square of how far a direction must be from those of other numbers

/** A possible solid; SI. */
typedef struct solid {
    double c, t, phi_lin; ///< t = tan(phi_lin)
    double stress, tau_p; ///< of preshear
    double centre, radius;
} solid;

/** Measured numbers that a solid is sought for. */
typedef struct search {
    double preshear;
    bool above; ///< preshear is on the locus or above it, else on it or below
    clod_nearest_number *numbers;
    size_t count;
} search;

/**
 * phi_lin from 0 to 80 deg; tau_p from 0 to where the circle that touches the locus in preshear begins at 0. Below the locus the centre of
 * the circle goes from that of the circle that begins at 0 to that of the one that touches in preshear, or whose locus has no
 * cohesion; above it this last circle stays, and its locus falls.
 */
static solid make(const search *self, const double *at)
{
    const double most = CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE;
    const double stress = self->preshear;
    solid made = {.phi_lin = at[0] * most, .stress = stress};
    made.t = tan(made.phi_lin);
    const double length = sqrt(1.0 + made.t * made.t);
    made.tau_p = at[1] * stress * fmin(made.t + length, tan(most));
    const double first = 0.5 * (stress + made.tau_p * made.tau_p / stress);
    const double last = clod_mohr_steady(0.0, made.t, stress, made.tau_p).centre;
    made.centre = self->above ? last : first + at[2] * (last - first);
    made.radius = hypot(made.centre - stress, made.tau_p);
    made.c = fmax(made.radius * length - made.t * made.centre, 0.0);
    if (self->above) {
        const double least = fmax(made.tau_p / ABOVE - made.t * stress, 0.0);
        made.c -= at[2] * fmax(made.c - least, 0.0);
    }
    return made;
}

// ---- its numbers

static double cohesion(const solid *of, double stress)
{
    (void)stress;
    return of->c;
}

static double slope(const solid *of, double stress)
{
    (void)stress;
    return of->phi_lin;
}

static double line_at(const solid *of, double stress)
{
    return of->c + of->t * stress;
}

static double preshear_shear(const solid *of, double stress)
{
    (void)stress;
    return of->tau_p;
}

static double steady_slope(const solid *of, double stress)
{
    (void)stress;
    return atan2(of->tau_p, of->stress);
}

static double effective_slope(const solid *of, double stress)
{
    (void)stress;
    return asin(fmin(of->radius / of->centre, 1.0));
}

static double major(const solid *of, double stress)
{
    (void)stress;
    return of->centre + of->radius;
}

static double minor(const solid *of, double stress)
{
    (void)stress;
    return of->centre - of->radius;
}

static double strength(const solid *of, double stress)
{
    (void)stress;
    return clod_mohr_unconfined(of->c, of->t);
}

static double flowability(const solid *of, double stress)
{
    return major(of, stress) / strength(of, stress);
}

typedef double (*formula)(const solid *of, double stress);

static formula find(const char *key)
{
    static const struct {
        const char *key;
        formula of;
    } ALL[] = {{"c", cohesion},           {"phi_lin", slope},       {"tau", line_at},
               {"tau_p", preshear_shear}, {"phi_sf", steady_slope}, {"phi_e", effective_slope},
               {"sigma_1", major},        {"sigma_2", minor},       {"sigma_c", strength},
               {"ffc", flowability}};
    for (size_t k = 0; k < sizeof ALL / sizeof ALL[0]; k++) {
        if (strcmp(ALL[k].key, key) == 0) {
            return ALL[k].of;
        }
    }
    return NULL;
}

bool clod_nearest_has(const char *key)
{
    return find(key) != NULL;
}

static double number_of(const clod_nearest_number *number, const solid *of)
{
    return find(number->key)(of, number->stress);
}

// ---- least squares

static double chi_square(const search *self, const double *at)
{
    const solid of = make(self, at);
    double sum = 0.0;
    for (size_t k = 0; k < self->count; k++) {
        const clod_nearest_number *one = &self->numbers[k];
        const double off = (number_of(one, &of) - one->value) / one->error;
        sum += off * off;
    }
    return sum;
}

/** Equations of a step: square times step = right. */
typedef struct equations {
    double square[UNKNOWNS][UNKNOWNS], right[UNKNOWNS];
} equations;

/** Derivatives of a number over the coordinates; `beside` are the solids next to `of`. */
static void derive(const clod_nearest_number *one, const solid *of, const solid *beside,
                   const double *difference, double *slopes)
{
    for (size_t k = 0; k < UNKNOWNS; k++) {
        slopes[k] = (number_of(one, &beside[k]) - number_of(one, of)) / difference[k];
    }
}

/** The solids next to one, inside the cube. */
static void look_beside(const search *self, const double *at, solid *beside, double *difference)
{
    for (size_t k = 0; k < UNKNOWNS; k++) {
        double there[UNKNOWNS];
        memcpy(there, at, sizeof there);
        difference[k] = at[k] < 0.5 ? DIFFERENCE : -DIFFERENCE;
        there[k] += difference[k];
        beside[k] = make(self, there);
    }
}

static void add(equations *to, const double *slopes, double off)
{
    for (size_t k = 0; k < UNKNOWNS; k++) {
        to->right[k] -= slopes[k] * off;
        for (size_t m = 0; m < UNKNOWNS; m++) {
            to->square[k][m] += slopes[k] * slopes[m];
        }
    }
}

static equations linearise(const search *self, const double *at)
{
    equations made = {0};
    solid beside[UNKNOWNS];
    double difference[UNKNOWNS], slopes[UNKNOWNS];
    const solid of = make(self, at);
    look_beside(self, at, beside, difference);
    for (size_t n = 0; n < self->count; n++) {
        const clod_nearest_number *one = &self->numbers[n];
        derive(one, &of, beside, difference, slopes);
        for (size_t k = 0; k < UNKNOWNS; k++) {
            slopes[k] /= one->error;
        }
        add(&made, slopes, (number_of(one, &of) - one->value) / one->error);
    }
    return made;
}

/** Whether a coordinate stays at an end of its range. */
static bool is_held(const equations *self, const double *at, size_t k)
{
    return (at[k] <= 0.0 && self->right[k] < 0.0) || (at[k] >= 1.0 && self->right[k] > 0.0);
}

static void drop(equations *self, size_t k)
{
    for (size_t m = 0; m < UNKNOWNS; m++) {
        self->square[k][m] = self->square[m][k] = 0.0;
    }
    self->right[k] = 0.0;
}

/** Solve in place, the largest pivot first; how many are above the least. */
static size_t solve(equations *self, double least)
{
    bool done[UNKNOWNS] = {false};
    size_t rank = 0;
    for (size_t p = 0; p < UNKNOWNS;) {
        p = UNKNOWNS;
        for (size_t k = 0; k < UNKNOWNS; k++) {
            const double pivot = self->square[k][k];
            p = !done[k] && pivot > least && (p == UNKNOWNS || pivot > self->square[p][p]) ? k
                                                                                           : p;
        }
        for (size_t k = 0; p < UNKNOWNS && k < UNKNOWNS; k++) {
            const double times = k != p ? self->square[k][p] / self->square[p][p] : 0.0;
            for (size_t m = 0; m < UNKNOWNS; m++) {
                self->square[k][m] -= times * self->square[p][m];
            }
            self->right[k] -= times * self->right[p];
        }
        if (p < UNKNOWNS) {
            done[p] = true;
            rank++;
        }
    }
    for (size_t k = 0; k < UNKNOWNS; k++) {
        self->right[k] = done[k] ? self->right[k] / self->square[k][k] : 0.0;
    }
    return rank;
}

/** Levenberg and Marquardt from a place, within the cube; the least chi-square. */
static double descend(const search *self, double *at)
{
    double damping = 1e-3;
    double least = chi_square(self, at);
    for (int step = 0; step < STEPS && damping < STIFF; step++) {
        equations of = linearise(self, at);
        for (size_t k = 0; k < UNKNOWNS; k++) {
            if (is_held(&of, at, k)) {
                drop(&of, k);
            }
            of.square[k][k] *= 1.0 + damping;
        }
        solve(&of, 0.0);
        double there[UNKNOWNS];
        for (size_t k = 0; k < UNKNOWNS; k++) {
            there[k] = fmin(fmax(at[k] + of.right[k], 0.0), 1.0);
        }
        const double found = chi_square(self, there);
        damping *= found < least ? 0.1 : 10.0;
        if (found < least) {
            const bool settled = least - found <= SETTLED * least;
            least = found;
            memcpy(at, there, sizeof there);
            if (settled) {
                break;
            }
        }
    }
    return least;
}

/** Degrees of freedom at the least chi-square: numbers less the directions in which the fit could still move them. */
static double freedom_of(const search *self, const double *at)
{
    equations sum = {0};
    solid beside[UNKNOWNS];
    double difference[UNKNOWNS], slopes[UNKNOWNS];
    const equations here = linearise(self, at);
    const solid of = make(self, at);
    look_beside(self, at, beside, difference);
    for (size_t n = 0; n < self->count; n++) {
        derive(&self->numbers[n], &of, beside, difference, slopes);
        double length = 0.0;
        for (size_t k = 0; k < UNKNOWNS; k++) {
            slopes[k] = is_held(&here, at, k) ? 0.0 : slopes[k];
            length = hypot(length, slopes[k]);
        }
        for (size_t k = 0; k < UNKNOWNS && length > 0.0; k++) {
            slopes[k] /= length;
        }
        add(&sum, slopes, 0.0);
    }
    return (double)self->count - (double)solve(&sum, INDEPENDENT);
}

/** Least chi-square from many places, and where it is. */
static double search_all(const search *self, double *best)
{
    double least = HUGE_VAL;
    for (int k = 0; k < STARTS * STARTS * STARTS; k++) {
        double at[UNKNOWNS];
        for (int m = 0, rest = k; m < UNKNOWNS; m++, rest /= STARTS) {
            at[m] = (rest % STARTS + 0.5) / STARTS;
        }
        const double found = descend(self, at);
        if (k == 0 || found < least) {
            least = found;
            memcpy(best, at, sizeof at);
        }
    }
    return least;
}

clod_nearest clod_nearest_fit(double preshear, clod_nearest_number *numbers, size_t count)
{
    const search below = {preshear, false, numbers, count};
    const search above = {preshear, true, numbers, count};
    double at[UNKNOWNS], there[UNKNOWNS];
    const double least = search_all(&below, at);
    const double other = search_all(&above, there);
    const bool up = other < least;
    const search *found = up ? &above : &below;
    const double *best = up ? there : at;
    const solid nearest = make(found, best);
    for (size_t k = 0; k < count; k++) {
        numbers[k].nearest = number_of(&numbers[k], &nearest);
    }
    return (clod_nearest){up ? other : least, freedom_of(found, best)};
}

double clod_nearest_limit(double freedom)
{
    return gsl_cdf_chisq_Pinv(erf(CLOD_PLAN_FIRM_ERRORS / sqrt(2.0)), fmax(freedom, 1.0));
}
