#pragma once
/**
 * @file curve.h
 * A measured property over a stress: points with their errors, and the curve through them.
 */

#include <stdbool.h>
#include <stddef.h>

#define CLOD_CURVE_JOINT 4 ///< values of a yield locus whose errors go together

/** A measured point; standard errors, 0: not stated. */
typedef struct clod_curve_point {
    double x, y;
    double inside; ///< of a bulk density y: that away from the walls of the cell; 0: not known
    double x_error, y_error; ///< all of it, what specimens share too
    const double *
        spread; ///< [specimens] move of y per standard normal number of each specimen, the same
                ///< number at all points; NAN: it is not in this point; NULL: no specimens
    const double *x_spread; ///< likewise of x; NULL: specimens do not move it
    size_t
        freedom; ///< degrees of freedom of what specimens share, or of y's error from repeats or
                 ///< from the scatter about a line; 0: its size is known
    size_t set; ///< of specimens: points of one set have some in common, or a chain of them; of
                ///< errors with freedom: those of one set have one scale
    double
        by_line; ///< standard deviation of all points about their line, which y_error comes of; 0: it was stated
    size_t row; ///< of the table, from 1 on: curves of one row have one x; 0: none
    bool joint; ///< whether y moves with x and the others of its row
    double
        part[CLOD_CURVE_JOINT]; ///< then: move of y per standard normal number of its row, the
                                ///< first of which moves x; y_error is all of it
    bool
        unsure; ///< its errors come of the few points of a yield locus, which hardly tell a weight
    double weight; ///< in a line (line_fit.h); 0 at all points: they weigh alike
} clod_curve_point;

/** Whose specimens move a curve; those of one test move all its curves together. */
typedef enum clod_curve_test {
    CLOD_CURVE_SHEAR,
    CLOD_CURVE_WALL,
    CLOD_CURVE_TESTS,
} clod_curve_test;

/** How the curve goes. */
typedef enum clod_curve_way {
    CLOD_CURVE_HELD,     ///< straight between points, constant beyond them
    CLOD_CURVE_EXTENDED, ///< straight between points, beyond them on with the outer ones
    CLOD_CURVE_LINE, ///< least squares, weighted (line_fit.h); a single point: the line from the origin
} clod_curve_way;

/** y = a + b x. */
typedef struct clod_curve_line {
    double a, b;
} clod_curve_line;

/** How well a line fits its points (line_fit.h). */
typedef struct clod_curve_misfit {
    bool unsure;       ///< whether errors of some points hardly tell a weight
    bool weighted;     ///< whether points weigh by their errors
    double chi_square; ///< of what the points are off the line by; NAN: not all have errors
    size_t freedom;    ///< its degrees of freedom; 0: nothing is left to compare
    size_t specimens;  ///< degrees of freedom of the errors themselves; 0: they are known
    double chance;     ///< of so large a chi_square, or a larger one, on a line; NAN: not known
    double stretch;    ///< errors of the line are larger by this; 1 at least; 0: not looked at
    clod_curve_line line; ///< through the points as measured
} clod_curve_misfit;

typedef struct clod_curve {
    clod_curve_way way;
    clod_curve_point *points; ///< [count] in ascending order of x; owned by whoever made them
    size_t count;             ///< 0: the property is not known
    size_t specimens;         ///< whose scatter the points share; 0: none
    double *spread;           ///< that of the points; owned likewise, NULL: another curve's
    clod_curve_test test;     ///< of the specimens
    clod_curve_misfit misfit; ///< of a line
} clod_curve;

/** Whether all points have an error of y, or specimens that tell it, be it 0; a curve of no points has none. */
bool clod_curve_has_errors(const clod_curve *self);

/** The error of y that was stated, 0: none; not what points scatter by. */
double clod_curve_stated(const clod_curve_point *point);

/** Sort the points. */
void clod_curve_sort(clod_curve *self);

/** Free points and spread; a curve of zeros is fine. */
void clod_curve_fini(clod_curve *self);

/**
 * The line of least squares through the points, by their weights. With a misfit it lies off the measured one by
 * `stretch` times what the points say.
 *
 * @param self  two points at least
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_curve.c, test_line_fit.c
 */
clod_curve_line clod_curve_fit(const clod_curve *self);

/**
 * The property at x; not below 0.
 *
 * @return NAN when it is not known
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_curve.c
 */
double clod_curve_at(const clod_curve *self, double x);

/** Where a curve meets a ray from the origin. */
typedef enum clod_curve_meeting {
    CLOD_CURVE_BELOW, ///< nowhere: at no x is it above
    CLOD_CURVE_MEETS, ///< it comes down through the ray, and stays below
    CLOD_CURVE_ABOVE, ///< it ends above, or rises above and stays there
} clod_curve_meeting;

/**
 * The largest x > 0 at which a curve comes from above a ray y = slope x to below it: beyond, it is nowhere above.
 *
 * @param most  no larger x than this; it is the answer where the curve is above the ray there. INFINITY: any
 * @param x     [out] on CLOD_CURVE_MEETS
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_curve.c
 */
clod_curve_meeting clod_curve_meet(const clod_curve *self, double slope, double most,
                                   double *x);
