#pragma once
/**
 * @file case_grains.h
 * The grains of a checked case: sizes, where they begin or come in, where they leave (case.h).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clod_size_kind {
    CLOD_SIZE_NORMAL,  ///< truncated normal, by number
    CLOD_SIZE_UNIFORM, ///< uniform between min and max, by number
    CLOD_SIZE_SIEVE,   ///< sieve table, by mass
} clod_size_kind;

/** One row of a sieve table. */
typedef struct clod_case_sieve {
    double size;    ///< sieve opening = grain diameter [m]
    double passing; ///< cumulative mass fraction that passes, rising from 0 to 1
} clod_case_sieve;

/** The last two are faces, through which grains come; only the region of an inlet is one. */
typedef enum clod_region_kind {
    CLOD_REGION_BOX,
    CLOD_REGION_ANNULUS,
    CLOD_REGION_DISC,
    CLOD_REGION_RECTANGLE,
} clod_region_kind;

/** Where grains are put: a box, an upright annulus (inner_radius 0: a cylinder), a face. */
typedef struct clod_case_region {
    int kind; ///< clod_region_kind
    double min[3], max[3];
    double center[3];                  ///< of the bottom of an annulus, or of a face [m]
    double inner_radius, outer_radius; ///< m, of an annulus; outer_radius of a disc
    double height;                     ///< m, of an annulus
    double edge_1[3], edge_2[3];       ///< m, of a rectangle
    double normal[3]; ///< of a face, to where grains come: of a disc as it is given, of a
                      ///< rectangle found at load
    double depth;     ///< m, of a face: way of the grains from one insertion to the next
} clod_case_region;

/** How a group of grains comes in during a run. Exactly one of the flows is given. */
typedef struct clod_case_inlet {
    double mass_flow;   ///< kg/s
    double number_flow; ///< 1/s
    double start;       ///< s
    double end;         ///< s; 0 = until the run ends
} clod_case_inlet;

/** Simulated time from one insertion of an inlet to the next [s]. */
#define CLOD_CASE_INLET_INTERVAL 1e-3
/** Most groups with an inlet. */
#define CLOD_CASE_INLETS 16

/** One group of grains. Exactly one of count, mass, fill_height, file is given; of a group with
 *  an inlet at most one of count, mass: what comes in at most. */
typedef struct clod_case_grains {
    char *material;
    int sizes; ///< clod_size_kind
    double radius_mean, radius_sd, radius_min, radius_max;
    clod_case_sieve *sieve;
    size_t sieve_count;
    int64_t count;        ///< 0 when not given
    double mass;          ///< kg; 0 when not given
    double fill_height;   ///< m, settled height aimed at; 0 when not given
    double fill_fraction; ///< solid fraction assumed for fill_height
    clod_case_region region;
    double velocity[3]; ///< m/s
    char *file;         ///< path of a CSV with grains one by one, resolved against the case
    bool comes;         ///< through the inlet, during the run
    clod_case_inlet inlet;
} clod_case_grains;

/** Where grains are removed and counted: in a region, or when they touch a wall. */
typedef struct clod_case_outlet {
    char *name;
    bool has_region; ///< else `wall` is given
    clod_case_region region;
    char *wall;    ///< all of its surfaces, or
    char *part;    ///< those of this part of its meshes; NULL: all
    bool spillage; ///< what leaves here has missed its way
} clod_case_outlet;

/** Most outlets. */
#define CLOD_CASE_OUTLETS 8

#ifdef __cplusplus
}
#endif
