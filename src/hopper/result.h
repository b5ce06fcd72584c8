#pragma once
/**
 * @file result.h
 * What a design found, for the writers of tables, JSON and the chart.
 */

#include "base/warning_list.h"
#include "clod/hopper.h"
#include "hopper/case.h"
#include "hopper/design.h"
#include "hopper/ranges.h"
#include "hopper/rathole.h"

#define CLOD_HOPPER_SHAPES 2
#define CLOD_HOPPER_OUTCOMES 6
#define CLOD_HOPPER_QUANTILES 101 ///< of the critical outlet: 0, 1, ... 100 % of the samples

/** Numbers of one shape. */
typedef enum clod_hopper_number {
    CLOD_HOPPER_LIMIT,        ///< rad; 0: funnel flow
    CLOD_HOPPER_HALF_ANGLE,   ///< rad: as given, or 0: funnel flow
    CLOD_HOPPER_OUTLET,       ///< m; 0: no arch; INFINITY: none is large enough
    CLOD_HOPPER_FLOW_FACTOR,  ///< NAN: funnel flow
    CLOD_HOPPER_SIGMA_1,      ///< Pa; this to rho: NAN where there is no critical state
    CLOD_HOPPER_STRENGTH,     ///< Pa
    CLOD_HOPPER_PHI_E,        ///< rad
    CLOD_HOPPER_PHI_W,        ///< rad
    CLOD_HOPPER_RHO,          ///< kg/m3
    CLOD_HOPPER_ARCH,         ///< H; NAN: funnel flow
    CLOD_HOPPER_MARGIN,       ///< NAN: no outlet is given, or funnel flow
    CLOD_HOPPER_DESIGN_PHI_W, ///< rad, at the design state; NAN: funnel flow
    CLOD_HOPPER_NUMBERS,
} clod_hopper_number;

/** A number and its interval; NAN: not known, then all three, or the interval alone. */
typedef struct clod_hopper_value {
    double value, low, high;
    double low_error, high_error; ///< standard errors of the ends, by the number of samples
} clod_hopper_value;

/** Where the rathole diameters stand behind the numbers of the shapes. */
enum { CLOD_HOPPER_EMPTYING, CLOD_HOPPER_FILLING, CLOD_HOPPER_HOLES };

typedef struct clod_hopper_found {
    clod_hopper_wish wish;
    clod_hopper_design design;
    clod_ranges lower;  ///< outlets below the critical one without an arch over them
    double planned;     ///< m: outlet that is given; 0: none
    double limit_error; ///< rad: standard error of the wish's limit
    clod_hopper_value number[CLOD_HOPPER_NUMBERS];
    double share[CLOD_HOPPER_OUTCOMES]; ///< of the samples; this, arching and held: NAN if
                                        ///< nothing tells how sure they are (told.h)
    double arched_low,
        arched_high;   ///< m: interval of the outlet of those that have a critical one;
                       ///< NAN: none has
    double arching;    ///< share of the samples that do not flow through the planned outlet
    double held;       ///< share of those that the wall holds there, the rest arches
    double mechanical; ///< m: outlet at which large particles do not arch; 0: not known
    double
        quantile[CLOD_HOPPER_QUANTILES]; ///< m: outlets of the samples, as CLOD_HOPPER_OUTLET;
                                         ///< NAN: no sample has one
    double cause[CLOD_SOLID_CURVES]; ///< share of the spread of the outlet that each measured
                                     ///< curve tells alone (samples.h); NAN: not known
    double untold; ///< share that all curves together do not tell; NAN: not known
} clod_hopper_found;

/** What a specimen that is in all yield loci makes of the design, alone; the wall as measured. */
typedef struct clod_hopper_specimen {
    int64_t seed;
    double half_angle[CLOD_HOPPER_SHAPES]; ///< rad: as given, or 0: funnel flow
    double outlet[CLOD_HOPPER_SHAPES];     ///< m; 0: no arch; INFINITY: none is large enough
} clod_hopper_specimen;

struct clod_hopper {
    clod_hopper_case from; ///< owned content
    char *path;            ///< owned, of the case
    char **overrides;      ///< [override_count] owned
    size_t override_count;
    clod_solid solid;                            ///< owned points
    clod_hopper_found shape[CLOD_HOPPER_SHAPES]; ///< by clod_radial_shape
    clod_rathole_silo silo;
    clod_hopper_value rathole[CLOD_HOPPER_HOLES];
    double
        holed[CLOD_HOPPER_HOLES]; ///< share of the samples in which G of that rathole is known
    clod_rathole hole;
    clod_rathole_slot slot;       ///< in funnel flow
    clod_hopper_value slot_width; ///< m, of that
    clod_ranges lower_holes;      ///< diameters below that of emptying at which none stands
    clod_hopper_specimen
        *specimens; ///< [specimen_count] owned; NULL: fewer than two such specimens
    size_t specimen_count;
    clod_warning_list warnings;
};
