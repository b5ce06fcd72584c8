#pragma once
/**
 * @file continuum.h
 * Continuum fields from grains and contacts: density, velocity, stress and more at points, by
 * coarse-graining. A field is
 *
 * - a grid: at the middle of each cell, spread with Lucy's polynomial (lucy.h), or
 * - a mean over a region: spread with 1/V in the region and 0 beyond.
 *
 * With W for either, f the force on the end of a branch b from its start:
 *
 *     density      sum m W                       over grains
 *     contact      sum f b^T (mean of W along b) over contacts; positive in compression
 *     wall force   sum f W(point of contact)     over contacts with walls
 *
 * Between two grains b goes from centre to centre; at a wall from the point of contact to the
 * centre, so that the balance of momentum holds at walls too:
 *     density dv/dt = density g - div(stress) + wall force
 *
 * Source  I. Goldhirsch, Granular Matter 12 (2010) 239, doi:10.1007/s10035-010-0181-z; Weinhart et
 *         al., Granular Matter 14 (2012) 289, doi:10.1007/s10035-012-0317-4; docs/theory/fields.md.
 * Test    tests/measure/test_continuum.c
 */

#include <stdint.h>

#include "state/state.h"

/** What is added up at each point, in this order. */
enum {
    CLOD_CONTINUUM_MASS = 0,      ///< kg/m3
    CLOD_CONTINUUM_MOMENTUM = 1,  ///< kg/(m2 s), 3
    CLOD_CONTINUUM_FLUX = 4,      ///< Pa, m v v: xx yy zz xy xz yz
    CLOD_CONTINUUM_VOLUME = 10,   ///< 1, of solid
    CLOD_CONTINUUM_NUMBER = 11,   ///< grains, times clod_continuum.scale^3
    CLOD_CONTINUUM_PARTNERS = 12, ///< contacts of grains, likewise
    CLOD_CONTINUUM_RADIUS = 13,   ///< m, volume times radius
    CLOD_CONTINUUM_GRAIN_SUMS = 14,
    CLOD_CONTINUUM_CONTACT = 14,    ///< Pa, 9: force x branch, row by row
    CLOD_CONTINUUM_WALL_FORCE = 23, ///< Pa, 3: N/m3 times clod_continuum.scale
};
#define CLOD_CONTINUUM_SUMS 26

/** What is told of each point. */
enum {
    CLOD_CONTINUUM_OF_DENSITY,
    CLOD_CONTINUUM_OF_SOLID,
    CLOD_CONTINUUM_OF_VELOCITY,
    CLOD_CONTINUUM_OF_TEMPERATURE,
    CLOD_CONTINUUM_OF_PRESSURE,
    CLOD_CONTINUUM_OF_CONTACT,
    CLOD_CONTINUUM_OF_KINETIC,
    CLOD_CONTINUUM_OF_WALL_FORCE,
    CLOD_CONTINUUM_OF_COORDINATION,
    CLOD_CONTINUUM_OF_RADIUS,
    CLOD_CONTINUUM_VALUES
};

typedef struct clod_continuum_value {
    const char *name;
    const char *unit;
    const char *key; ///< name with unit, in JSON
    int first;       ///< of its numbers among all
    int components;  ///< 1, 3 or 9, row by row
} clod_continuum_value;

/** All there is to know of each value. */
extern const clod_continuum_value CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_VALUES];

/** Numbers of all values. */
#define CLOD_CONTINUUM_NUMBERS 30

typedef struct clod_continuum {
    clod_outlet region;
    double cell;      ///< m, edge; 0: one mean over the region
    double width;     ///< m, radius of the kernel of a grid
    int64_t cells[3]; ///< 1 1 1 without a grid
    double scale;     ///< m: width of the kernel, or the edge of a cube as large as the region
    bool cylindrical; ///< of a mean over an annulus: along r, t, z about its axis
} clod_continuum;

/** Name of a component: "" of a number, "_x" or "_r" of a vector, "_xy" or "_rt" of a tensor. */
const char *clod_continuum_component(const clod_continuum *self, int components, int number);

/** A vector that is at a place, along the directions of the field. Threads: pure. */
void clod_continuum_turn(const clod_continuum *self, const double at[3], const double vector[3],
                         double to[3]);

/**
 * A field of a region.
 *
 * @param cell   m; 0: one mean
 * @param width  m, > 0 with a cell
 * Threads  pure.
 */
clod_continuum clod_continuum_make(const clod_outlet *region, double cell, double width);

/** Number of points: cells, x fastest, or 1. Threads: pure. */
int64_t clod_continuum_points(const clod_continuum *self);

/** Volume of a region [m3]. Threads: pure. */
double clod_continuum_volume(const clod_outlet *region);

/** Least corner of a cell [m]. Threads: pure. */
void clod_continuum_corner(const clod_continuum *self, int64_t cell, double corner[3]);

/** Part of the straight line between two points that is in a region, 0 to 1. Threads: pure. */
double clod_continuum_share(const clod_outlet *region, const double from[3],
                            const double to[3]);

/**
 * What follows from sums. Those of several samples are added before anything is divided: the
 * velocity is a mean by mass, and fluctuations are those about that mean.
 *
 * @param sums     [CLOD_CONTINUUM_SUMS] over all samples
 * @param samples  how many, >= 1
 * @param values   [CLOD_CONTINUUM_NUMBERS] [out] velocity, temperature, coordination and radius are NAN
 *                 where no grain is
 * Threads  pure.
 */
void clod_continuum_values(const clod_continuum *self, const double *sums, double samples,
                           double *values);
