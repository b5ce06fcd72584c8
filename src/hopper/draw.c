#include "hopper/draw.h"

#include <math.h>

#include "base/memory.h"
#include "base/random.h"
#include "hopper/line_fit.h"

#define LEAST_ANGLE 0.02 // rad: what a drawn angle is kept within
#define MOST_ANGLE 1.5
#define LEAST_PART 0.01 // of a measured stress or density: what a drawn one is at least
#define ROUND_OFF 1e-12 // of a variance

// Draws of one sample: those of points from 0 on, the others far behind them.
#define OF_ROW (UINT64_C(1) << 40)
#define OF_PART(part) ((uint64_t)(part) << 36) ///< of a row
#define OF_TEST(test) ((UINT64_C(2) + (uint64_t)(test)) << 44)
#define OF_LIMIT (UINT64_C(1) << 50)
#define OF_STRETCH (UINT64_C(1) << 51)
#define OF_SET(set) ((UINT64_C(1) + (uint64_t)(set)) << 20)

bool clod_draw_init(clod_draw *self, const clod_solid *measured, uint64_t seed)
{
    *self = (clod_draw){.measured = measured, .seed = seed};
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const clod_curve *curve = &measured->curves[k];
        if (curve->specimens > 0) {
            size_t *sets = &self->sets[curve->test];
            self->specimens[curve->test] = curve->specimens;
            *sets = curve->count > *sets ? curve->count : *sets;
        }
    }
    size_t count = 1;
    for (size_t t = 0; t < CLOD_CURVE_TESTS; t++) {
        count += self->specimens[t] + self->sets[t];
    }
    self->numbers = clod_memory_alloc(count, sizeof *self->numbers);
    return self->numbers != NULL;
}

void clod_draw_fini(clod_draw *self)
{
    clod_memory_free(self->numbers);
    self->numbers = NULL;
}

static double normal(const clod_draw *self, uint64_t item, uint64_t draw)
{
    return clod_random_normal(self->seed, CLOD_RANDOM_MEASURED, item, draw);
}

static double *numbers_of(const clod_draw *self, size_t test)
{
    double *at = self->numbers;
    for (size_t t = 0; t < test; t++) {
        at += self->specimens[t] + self->sets[t];
    }
    return at;
}

/** sqrt(n/chi-square) of n degrees of freedom; 1: the scatter is known. */
static double scale_of(const clod_draw *self, uint64_t item, uint64_t first, size_t freedom)
{
    double squares = 0.0;
    for (size_t k = 0; k < freedom; k++) {
        const double z = normal(self, item, first + 2 * k);
        squares += z * z;
    }
    return freedom > 0 ? sqrt((double)freedom / squares) : 1.0;
}

/** The numbers of all specimens, and the scales of their sets. */
static void draw_specimens(clod_draw *self, uint64_t item)
{
    for (size_t t = 0; t < CLOD_CURVE_TESTS; t++) {
        double *numbers = numbers_of(self, t);
        for (size_t s = 0; s < self->specimens[t]; s++) {
            numbers[s] = normal(self, item, OF_TEST(t) + 2 * s);
        }
    }
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const clod_curve *curve = &self->measured->curves[k];
        for (size_t i = 0; i < curve->count && curve->specimens > 0; i++) {
            const clod_curve_point *point = &curve->points[i];
            double *scales = numbers_of(self, curve->test) + curve->specimens;
            scales[point->set] =
                scale_of(self, item, OF_TEST(curve->test) + OF_SET(point->set), point->freedom);
        }
    }
}

/** What is left of an error beside what specimens share. */
static double unshared(double error, const double *spread, size_t specimens)
{
    double shared = 0.0;
    for (size_t s = 0; s < specimens && spread != NULL; s++) {
        shared += isnan(spread[s]) ? 0.0 : spread[s] * spread[s];
    }
    const double left = error * error - shared;
    return left > ROUND_OFF * error * error ? sqrt(left) : 0.0;
}

/** What the specimens move. */
static double together(const clod_draw *self, const clod_curve *curve, size_t set,
                       const double *spread)
{
    const double *numbers = numbers_of(self, curve->test);
    double sum = 0.0;
    for (size_t s = 0; s < curve->specimens && spread != NULL; s++) {
        sum += isnan(spread[s]) ? 0.0 : spread[s] * numbers[s];
    }
    return sum != 0.0 ? sum * numbers[curve->specimens + set] : 0.0;
}

/** What moves y of a point together with the others of its row. */
static double joint(const clod_draw *self, uint64_t item, const clod_curve_point *from)
{
    double sum = 0.0;
    for (size_t k = 0; k < CLOD_CURVE_JOINT; k++) {
        sum += from->part[k] * normal(self, item, OF_ROW + OF_PART(k) + 2 * from->row);
    }
    return sum;
}

/** What errors of a point are larger by than their size as estimated; 1: it is known, or specimens have it. */
static double scale_by_itself(const clod_draw *self, uint64_t item, const clod_curve *curve,
                              const clod_curve_point *from)
{
    const uint64_t of_scale = OF_TEST(curve->test) + OF_SET(from->set);
    return from->spread == NULL ? scale_of(self, item, of_scale, from->freedom) : 1.0;
}

/** Draw the points of a curve; `draw` is the next number of points. */
static void draw_curve(const clod_draw *self, uint64_t item, const clod_curve *measured,
                       clod_curve *curve, uint64_t *draw)
{
    for (size_t i = 0; i < measured->count; i++, *draw += 4) {
        const clod_curve_point *from = &measured->points[i];
        const uint64_t of_x = from->row > 0 ? OF_ROW + 2 * from->row : *draw;
        const double scale = scale_by_itself(self, item, measured, from);
        const double x = unshared(from->x_error, from->x_spread, measured->specimens) *
                         (from->row > 0 && from->by_line == 0.0 ? scale : 1.0);
        const double alone = unshared(from->y_error, from->spread, measured->specimens);
        const double y = scale * (from->joint ? joint(self, item, from)
                                              : alone * normal(self, item, *draw + 2));
        curve->points[i].x =
            fmax(LEAST_PART * from->x, from->x + x * normal(self, item, of_x) +
                                           together(self, measured, from->set, from->x_spread));
        curve->points[i].y =
            fmax(0.0, from->y + y + together(self, measured, from->set, from->spread));
        curve->points[i].weight = from->weight; // points were sorted
    }
}

/** How far the line of a sample lies off the measured one: misses that chance hardly makes have the scatter that they show. */
static double stretch_of(const clod_draw *self, uint64_t item)
{
    const clod_curve_misfit *misfit = &self->measured->strength.misfit;
    const bool shown = misfit->specimens == 0 && clod_line_fit_misses(misfit);
    return misfit->stretch * (shown ? scale_of(self, item, OF_STRETCH, misfit->freedom) : 1.0);
}

void clod_draw_solid(clod_draw *self, uint64_t item, clod_solid *to)
{
    const clod_solid *measured = self->measured;
    uint64_t draw = 0;
    draw_specimens(self, item);
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        draw_curve(self, item, &measured->curves[k], &to->curves[k], &draw);
    }
    to->strength.misfit.stretch = stretch_of(self, item);
    for (size_t i = 0; i < to->phi_e.count; i++) {
        clod_curve_point *point = &to->phi_e.points[i];
        point->y = fmin(MOST_ANGLE, fmax(LEAST_ANGLE, point->y));
    }
    for (size_t i = 0; i < to->rho.count; i++) {
        clod_curve_point *point = &to->rho.points[i];
        point->y = fmax(LEAST_PART * measured->rho.points[i].y, point->y);
    }
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_sort(&to->curves[k]);
    }
}

double clod_draw_limit(const clod_draw *self, uint64_t item, double limit, double error)
{
    return error > 0.0 ? fmin(MOST_ANGLE,
                              fmax(LEAST_ANGLE, limit + error * normal(self, item, OF_LIMIT)))
                       : limit;
}
