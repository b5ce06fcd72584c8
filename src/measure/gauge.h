#pragma once
/**
 * @file gauge.h
 * The stream in a region: sums over the grains whose centre is in it, and what follows from
 * them. Means over time are those of sums: samples are added before anything is divided.
 */

#include "base/vec3.h"
#include "parallel/exact.h"
#include "state/state.h"

/** A region with its directions. */
typedef struct clod_gauge {
    clod_outlet region;
    clod_vec3 middle;    ///< m, of the region
    clod_vec3 direction; ///< unit, of the stream; 0: none
    clod_vec3 across;    ///< unit; 0: none
    clod_vec3 up;        ///< unit, across both, upwards; 0: none
    int flow_axis;       ///< the axis of space that is nearest to direction
    double flow_length;  ///< m, of the region along it; below 0 where direction is against it
} clod_gauge;

/** Sums over the grains inside, added up over samples. */
enum {
    CLOD_GAUGE_SAMPLES,
    CLOD_GAUGE_GRAINS,
    CLOD_GAUGE_MASS,                            ///< kg
    CLOD_GAUGE_MOMENTUM,                        ///< kg m/s, x y z
    CLOD_GAUGE_SPEED = CLOD_GAUGE_MOMENTUM + 3, ///< kg m/s, of m |v|
    CLOD_GAUGE_SCATTER,                         ///< kg m2/s2, of m |v - mean of the sample|^2
    CLOD_GAUGE_MOMENT,                          ///< kg m, x y z from the middle
    CLOD_GAUGE_SPREAD = CLOD_GAUGE_MOMENT + 3,  ///< kg m2, of m (s - mean of the sample)^2
    CLOD_GAUGE_RADIUS,                          ///< kg m, of m r
    CLOD_GAUGE_RADIUS_SPREAD,                   ///< kg m2, of m (r - mean of the sample)^2
    CLOD_GAUGE_SORTING,                         ///< kg m2, of m (r - mean)(s - mean)
    CLOD_GAUGE_ENERGY,                          ///< J, kinetic, of rotation too
    CLOD_GAUGE_LIFTING,                         ///< W, - m g.v
    CLOD_GAUGE_ACCELERATION,                    ///< W, F.v + T.w with all forces
    CLOD_GAUGE_BLOCKED,                         ///< samples at which there was an alarm
    CLOD_GAUGE_ALL_MASS,                        ///< kg, of all grains of the run
    CLOD_GAUGE_ALL_RADIUS,                      ///< kg m, of m r of all grains
    CLOD_GAUGE_WORK,                            ///< J, of the belt
    CLOD_GAUGE_TIME,                            ///< s, in which it was done
    CLOD_GAUGE_BELT_SPEED, ///< kg m/s, of the mass inside times the belt's speed at that moment
    CLOD_GAUGE_SUMS
};

/** Values of a gauge. */
enum {
    CLOD_GAUGE_OF_GRAINS,
    CLOD_GAUGE_OF_MASS,
    CLOD_GAUGE_OF_FLOW,
    CLOD_GAUGE_OF_VELOCITY,
    CLOD_GAUGE_OF_SPEED = CLOD_GAUGE_OF_VELOCITY + 3,
    CLOD_GAUGE_OF_ANGLE,
    CLOD_GAUGE_OF_FLUCTUATION,
    CLOD_GAUGE_OF_CENTER,
    CLOD_GAUGE_OF_OFFSET = CLOD_GAUGE_OF_CENTER + 3,
    CLOD_GAUGE_OF_WIDTH,
    CLOD_GAUGE_OF_SORTING,
    CLOD_GAUGE_OF_RADIUS,
    CLOD_GAUGE_OF_RADIUS_RATIO,
    CLOD_GAUGE_OF_ENERGY,
    CLOD_GAUGE_OF_BLOCKED,
    CLOD_GAUGE_OF_POWER,
    CLOD_GAUGE_OF_LIFTING,
    CLOD_GAUGE_OF_ACCELERATION,
    CLOD_GAUGE_OF_HEAT,
    CLOD_GAUGE_VALUES
};

/** What a gauge must have for a value. */
typedef enum clod_gauge_need {
    CLOD_GAUGE_ALWAYS,
    CLOD_GAUGE_DIRECTION,
    CLOD_GAUGE_ACROSS,
    CLOD_GAUGE_ALARM,
    CLOD_GAUGE_BELT,
} clod_gauge_need;

typedef struct clod_gauge_value {
    const char *name;
    const char *unit;
    const char *key; ///< name with unit, in JSON
    clod_gauge_need need;
} clod_gauge_value;

/** All there is to know of each value. */
extern const clod_gauge_value CLOD_GAUGE_VALUE[CLOD_GAUGE_VALUES];

/**
 * A gauge of a region.
 *
 * @param direction  of any length; 0: none
 * @param across     the same; 0: level and at right angles to direction, where there is one
 * @param gravity    m/s2
 * Threads  pure.   Test  tests/measure/test_gauge.c
 */
clod_gauge clod_gauge_of(const clod_outlet *region, const double direction[3],
                         const double across[3], const double gravity[3]);

/** Least and largest of x.axis over the region [m]; `axis` is a unit vector. Threads: pure. */
void clod_gauge_extent(const clod_gauge *self, clod_vec3 axis, double *low, double *high);

/** Exact sums over grains; all zero: of none. */
typedef struct clod_gauge_exact {
    double count;
    clod_exact mass, momentum[3], speed, speed2, moment[3], across2;
    clod_exact radius, radius2, radius_across, energy, acceleration;
} clod_gauge_exact;

/** Add a grain that is inside. @param row  of the grain  @param place  [4] in the domain */
void clod_gauge_add(clod_gauge_exact *self, const clod_gauge *gauge, const clod_grains *grains,
                    size_t row, const double place[4]);

/** Add other sums. */
void clod_gauge_merge(clod_gauge_exact *self, const clod_gauge_exact *other);

/**
 * The sums of one sample.
 * @param sums  [CLOD_GAUGE_SUMS] [out] of alarm, all grains and work none
 */
void clod_gauge_sums_of(const clod_gauge_exact *self, const clod_gauge *gauge,
                        const clod_state *state, double *sums);

/**
 * What follows from sums.
 *
 * @param sums    [CLOD_GAUGE_SUMS] of any number of samples
 * @param values  [CLOD_GAUGE_VALUES] [out] NAN where there is none: of nothing, or without need
 * Threads  pure.   Test  tests/measure/test_gauge.c
 */
void clod_gauge_values(const clod_gauge *self, const double *sums, double *values);
