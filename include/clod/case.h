#pragma once
/**
 * @file case.h
 * A checked case: what a case file says, in SI units, with every default filled in.
 * The keys, units, ranges and help of every field stand in the tables of src/config.
 * A NULL where an argument is needed: see clod/status.h.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case_grains.h"
#include "clod/case_measures.h"
#include "clod/case_walls.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clod_law_kind {
    CLOD_LAW_MEPA,
    CLOD_LAW_HERTZ,
    CLOD_LAW_HOOKE,
    CLOD_LAW_LUDING,
    CLOD_LAW_EEPA,
    CLOD_LAW_KINDS, ///< how many there are
} clod_law_kind;

/** What the Coulomb limit multiplies the friction with (docs/theory/tangential.md). */
typedef enum clod_coulomb {
    CLOD_COULOMB_ADHESIVE,
    CLOD_COULOMB_FORCE,
    CLOD_COULOMB_PAPER
} clod_coulomb;

/** Tangential stiffness: from the tangent of the loading branch, or k1 taken in N/m. */
typedef enum clod_tangential {
    CLOD_TANGENTIAL_TANGENT,
    CLOD_TANGENTIAL_LITERAL
} clod_tangential;

typedef enum clod_rolling {
    CLOD_ROLLING_NONE,
    CLOD_ROLLING_CDT,
    CLOD_ROLLING_EPSD,
    CLOD_ROLLING_EPSD2,
} clod_rolling;

typedef struct clod_case_material {
    char *name;
    double density;        ///< kg/m3
    double youngs_modulus; ///< Pa; 0 when not given
    double poissons_ratio; ///< -
    double hardness;       ///< Pa, of walls that wear; 0 when not given
    double archard;        ///< -, wear coefficient
    double finnie;         ///< -, wear coefficient
} clod_case_material;

/** Contact law of a pair of materials, after inheritance from `default`. */
typedef struct clod_case_contact {
    int law; ///< clod_law_kind
    double exponent;
    double k1, k2, k_adh;    ///< N/m^exponent
    double plasticity_depth; ///< luding: phi_f
    double pull_off_force;   ///< N, eepa: -f0
    double surface_energy;   ///< J/m2, eepa; with it k_adh is 0
    double restitution;
    double friction;
    int coulomb;             ///< clod_coulomb
    int tangential;          ///< clod_tangential
    double tangential_ratio; ///< zeta
    int rolling;             ///< clod_rolling
    double rolling_friction;
    double rolling_damping; ///< fraction of critical, epsd only
    double soften; ///< soften of the case; every stiffness is divided by it; 0: not given
} clod_case_contact;

/** When a gauge counts as blocked. */
typedef struct clod_case_blocked {
    double mass_above;  ///< kg inside, at least
    double speed_below; ///< m/s, mean of what is inside, at most
    double duration;    ///< s for which both hold
} clod_case_blocked;

/** A region in which the stream is measured (docs/gauges.md). */
typedef struct clod_case_gauge {
    char *name;
    clod_case_region region;
    double direction[3]; ///< of the stream; 0: none
    double across[3];    ///< across the stream; 0: level and across `direction`
    char *belt;          ///< wall whose belt carries what is inside; NULL: none
    bool has_blocked;
    clod_case_blocked blocked;
    int64_t profile_bins;    ///< across; 0: no profile
    int64_t trajectory_bins; ///< along `direction`; 0: no trajectory
    bool has_plane;
    double plane_at; ///< m, along the axis nearest to `direction`: what passes it is counted
} clod_case_gauge;

/** Most gauges. */
#define CLOD_CASE_GAUGES 16
/** Most bins of a profile or a trajectory. */
#define CLOD_CASE_GAUGE_BINS 200

/** Clumps of which numbers of their own are told: those in a region, those in flight, or both. */
typedef struct clod_case_clump_count {
    char *name;
    bool has_region;
    clod_case_region region;
    bool free; ///< only clumps of which no grain touches a wall
} clod_case_clump_count;

/** Most counts. */
#define CLOD_CASE_CLUMP_COUNTS 8

/** Clumps: grains that hang together by adhesive contacts (docs/clumps.md). */
typedef struct clod_case_clumps {
    bool present;
    double bond;   ///< pull-off force as a multiple of the lighter grain's weight
    int64_t least; ///< grains of a clump
    clod_case_clump_count *counts;
    size_t count_count;
} clod_case_clumps;

/** Solid that rests on walls (docs/clumps.md). */
typedef struct clod_case_build_up {
    bool present;
    double speed; ///< m/s, below which a grain rests
} clod_case_build_up;

/** Map of what contacts remember (docs/clumps.md). */
typedef struct clod_case_history_map {
    bool present;
    double cell; ///< m
    bool has_region;
    clod_case_region region;
} clod_case_history_map;

/** Most cells of a map. */
#define CLOD_CASE_MAP_CELLS 100000

/** Change of one wall at the start of a stage; `has_` says which keys were given. */
typedef struct clod_case_wall_change {
    char *name; ///< wall
    double velocity[3];
    double spin;
    double surface_velocity[3];
    double force, stress;
    bool has_velocity, has_spin, has_surface_velocity, has_force, has_stress;
} clod_case_wall_change;

/** One stage of a free run. */
typedef struct clod_case_stage {
    char *name;
    double duration; ///< s
    double adhesion; ///< k_adh as a fraction of its final value
    double rest;     ///< m/s; stage ends early when no grain is faster; 0 = never
    clod_case_wall_change *walls;
    size_t wall_count;
} clod_case_stage;

typedef struct clod_case_output {
    double series_interval;     ///< s of simulated time
    double snapshot_interval;   ///< s of simulated time; 0 = none but the last of each stage
    double checkpoint_interval; ///< s of wall-clock time
    bool contacts;              ///< snapshots with contacts
    bool energy;                ///< keep the energy ledger
    bool surfaces;              ///< sum what grains do to the surfaces of walls
    bool leavers;               ///< a table with each grain that leaves
    double steady_since;   ///< s from the beginning of the run, of means; see has_steady_since
    bool has_steady_since; ///< else the last third of the stages counts
} clod_case_output;

/** Largest overlap_limit: at 1 nothing tells out of which side of a wall a grain is to go. */
#define CLOD_CASE_OVERLAP_MOST 0.9

typedef struct clod_case_time {
    double step;           ///< s; 0 = auto
    double safety;         ///< auto: fraction of the critical step of the stiffest pair
    double design_stress;  ///< Pa, to estimate overlap for auto; 0 = from loads and gravity
    double rayleigh_limit; ///< auto, hertz: largest fraction of the Rayleigh time
    double overlap_limit;  ///< fraction of the smaller radius at which a run stops
} clod_case_time;

/** Acceleration of shear to its speed, m/s2: below it the inertia of a bed stays below 1 % of its shear stress. */
#define CLOD_CASE_SHEAR_ACCELERATION 3.0

/** What the operator of a shear tester does with the specimen (docs/theory/ring-shear.md). */
typedef struct clod_case_programme {
    double preshear_stress; ///< Pa
    double *shear_stresses; ///< Pa
    size_t shear_stress_count;
    double speed;              ///< m/s, preshear; in a ring at r_m
    double block_displacement; ///< m of shear, one block average
    int64_t steady_blocks;     ///< blocks that must agree
    double steady_tolerance;   ///< relative
    double preshear_min;       ///< m of shear at least
    double preshear_max;       ///< m of shear at most; blocks end there
    double shear_max;          ///< m of shear at most, after reversal
    double beyond_peak;        ///< m of shear recorded beyond the peak
    double peak_window;        ///< m of shear over which the curve is smoothed
    int64_t seeds;             ///< number of repeats: seed, seed + 1, ...
} clod_case_programme;

/** Virtual Schulze ring shear test (docs/theory/ring-shear.md); absent when `present` is false.
 */
typedef struct clod_case_ring_shear {
    bool present;
    char *grain_material, *side_material, *base_material, *lid_material;
    double inner_radius, outer_radius, depth; ///< m; depth = aimed height of the specimen
    int64_t bar_count;                        ///< on the lid and on the base each
    double bar_height, bar_width;             ///< m
    double lid_mass;                          ///< kg
    double lid_damping;                       ///< fraction of critical
    double radius_mean, radius_sd, radius_min, radius_max; ///< m
    int64_t grain_count;                                   ///< 0 = as many as fill the depth
    double fill_fraction;          ///< solid fraction assumed while filling
    double fill_adhesion;          ///< fraction of k_adh during filling
    double fill_max, settle_max;   ///< s at most until grains, and lid, rest
    clod_case_programme programme; ///< displacements and speeds at r_m
} clod_case_ring_shear;

/** Virtual Jenike shear test: a ring on a base ring, sheared straight
 * (docs/theory/ring-shear.md). */
typedef struct clod_case_jenike {
    bool present;
    char *grain_material, *side_material, *base_material, *lid_material;
    double diameter;                                       ///< m, inside, of both rings
    double base_height, ring_height;                       ///< m, inside
    double rim;                                            ///< m, thickness of the rings' walls
    double offset;                                         ///< m of the ring behind the base
    int64_t twists;                                        ///< of the lid before preshear
    double twist_angle;                                    ///< rad to each side
    double lid_mass;                                       ///< kg
    double lid_damping;                                    ///< fraction of critical
    double radius_mean, radius_sd, radius_min, radius_max; ///< m
    int64_t grain_count;                                   ///< 0 = as many as fill the rings
    double fill_fraction;        ///< solid fraction assumed while filling
    double fill_adhesion;        ///< fraction of k_adh during filling
    double fill_max, settle_max; ///< s at most until grains, and lid, rest
    clod_case_programme programme;
} clod_case_jenike;

/** Uniaxial test: confined consolidation, then crushing without the mould. */
typedef struct clod_case_uniaxial {
    bool present;
    char *grain_material, *side_material, *base_material, *lid_material;
    double diameter, height; ///< m; height = aimed, of the specimen
    double lid_mass;         ///< kg
    double lid_damping;      ///< fraction of critical
    double radius_mean, radius_sd, radius_min, radius_max; ///< m
    int64_t grain_count;                                   ///< 0 = as many as fill the height
    double fill_fraction;           ///< solid fraction assumed while filling
    double fill_adhesion;           ///< fraction of k_adh during filling
    double fill_max, settle_max;    ///< s at most until grains, and lid, rest
    double *consolidation_stresses; ///< Pa
    size_t consolidation_stress_count;
    double speed;       ///< m/s of the lid, unloading and crushing
    double crush_max;   ///< strain at most
    double beyond_peak; ///< strain recorded beyond the peak
} clod_case_uniaxial;

#define CLOD_CASE_WALL_STRESSES 16 ///< of a wall friction test, at most

/** Cells of a wall friction test, in the order of the case's words. */
enum { CLOD_CASE_CELL_RING, CLOD_CASE_CELL_STRAIGHT };

/** Straight ridges on a plate, across its way, all alike; height 0: the plate is flat. */
typedef struct clod_case_ridges {
    double height;  ///< m, of a crest above the floor
    double spacing; ///< m, from crest to crest; in a ring at r_m, to a whole number of ridges
    double width;   ///< m, of a ridge at its foot; 0: as wide as there is room
    double crest;   ///< m, width of its flat top; 0: an edge
} clod_case_ridges;

/** Wall friction test: a specimen on a plate of the wall's material (docs/theory/wall-friction.md). */
typedef struct clod_case_wall_friction {
    bool present;
    char *grain_material, *side_material, *plate_material, *lid_material;
    int cell;                                 ///< CLOD_CASE_CELL_RING ...
    double inner_radius, outer_radius, depth; ///< m; straight: inner_radius has no meaning
    int64_t bar_count;                        ///< ring: on the lid
    double bar_height, bar_width;             ///< m
    clod_case_ridges plate_ridges;            ///< on the plate
    double lid_mass;                          ///< kg
    double lid_damping;                       ///< fraction of critical
    double radius_mean, radius_sd, radius_min, radius_max; ///< m
    int64_t grain_count;                                   ///< 0 = as many as fill the depth
    double fill_fraction;        ///< solid fraction assumed while filling
    double fill_adhesion;        ///< fraction of k_adh during filling
    double fill_max, settle_max; ///< s at most until grains, and lid, rest
    double *wall_stresses;       ///< Pa, in any order
    size_t wall_stress_count;
    double speed;              ///< m/s at the largest stress; in a ring at r_m
    double block_displacement; ///< m of shear, one block average
    int64_t steady_blocks;     ///< blocks that must agree
    double steady_tolerance;   ///< relative
    double shear_min;          ///< m of shear at each stress at least
    double shear_max;          ///< m of shear at each stress at most
    int64_t seeds;             ///< number of repeats: seed, seed + 1, ...
} clod_case_wall_friction;

/** One leg of the contact bench: linear from the values before to these in `steps` steps. */
typedef struct clod_case_leg {
    double overlap;  ///< m at the end of the leg
    double slip[2];  ///< m of added tangential displacement along the two tangents
    double roll;     ///< rad of added rolling about the second tangent
    double twist;    ///< rad of added twist about the normal
    double duration; ///< s
    int64_t steps;
} clod_case_leg;

typedef struct clod_case_contact_bench {
    bool present;
    char *material_1, *material_2;
    bool wall; ///< the second partner is a wall
    double radius_1, radius_2;
    double adhesion; ///< fraction of k_adh
    clod_case_leg *legs;
    size_t leg_count;
} clod_case_contact_bench;

/** What happens to a grain that crosses an open side of the domain. */
typedef enum clod_open {
    CLOD_OPEN_STOP,   ///< the run stops and names it
    CLOD_OPEN_DELETE, ///< it is removed and counted
} clod_open;

typedef struct clod_case {
    char *path;                      ///< file it came from
    struct clod_case_source *source; ///< where its keys were written (src/config/source.h)
    char *text; ///< its whole text, for the copy in the results folder and the checkpoint
    char *title;
    char *include; ///< file whose keys were taken over (in all fields); NULL: none
    struct clod_setting *calibrated_with; ///< of an included card (src/config/settings.h)
    size_t calibrated_with_count;
    int64_t seed;
    bool periodic[3];
    bool has_domain;
    double domain_min[3], domain_max[3]; ///< m
    int open;                            ///< clod_open: what happens to a grain that leaves
    double gravity[3];                   ///< m/s2
    clod_case_time time;
    clod_case_material *materials;
    size_t material_count;
    double soften;            ///< every stiffness of a contact is divided by it; 0: not given
    clod_case_contact *pairs; ///< [material_count * material_count], symmetric
    clod_case_grains *grains;
    size_t grains_count;
    clod_case_wall *walls;
    size_t wall_count;
    clod_case_outlet *outlets;
    size_t outlet_count;
    clod_case_gauge *gauges;
    size_t gauge_count;
    clod_case_field *fields;
    size_t field_count;
    clod_case_mixing *mixings;
    size_t mixing_count;
    clod_case_repose *reposes;
    size_t repose_count;
    clod_case_stage *stages;
    size_t stage_count;
    clod_case_output output;
    clod_case_clumps clumps;
    clod_case_build_up build_up;
    clod_case_history_map history_map;
    clod_case_ring_shear ring_shear;
    clod_case_jenike jenike;
    clod_case_uniaxial uniaxial;
    clod_case_wall_friction wall_friction;
    clod_case_contact_bench contact_bench;
} clod_case;

/**
 * Read, check and complete a case file.
 *
 * @param path            YAML file
 * @param overrides       [override_count] texts "key.path=value" of --set, applied first; may
 *                        be NULL when there are none
 * @param override_count  how many
 * @param status          [out] on failure: every error found, each with file:line:column, the
 *                        line, a caret, the value, the allowed range and what to do
 * @return                owned case, or NULL
 * Errors  CLOD_USAGE for anything wrong in the file, a NULL.   Threads  one at a time.
 * Test    tests/config/
 */
clod_case *clod_case_load(const char *path, const char *const *overrides, size_t override_count,
                          clod_status *status);

/** The same from a text; `path` is only the name used in messages and for relative files. */
clod_case *clod_case_parse(const char *path, const char *text, size_t length,
                           const char *const *overrides, size_t override_count,
                           clod_status *status);

/** Free a case and null the pointer; NULL is fine. */
void clod_case_destroy(clod_case **self);

/** Index of a material by name, or -1. */
int clod_case_material_index(const clod_case *self, const char *name);

/** Contact law of materials a and b; symmetric. */
const clod_case_contact *clod_case_pair(const clod_case *self, int a, int b);

/** What a case is for: a free run has its own grains, walls and stages; a tester makes them;
 *  the contact bench needs none. */
typedef enum clod_case_kind {
    CLOD_CASE_FREE,
    CLOD_CASE_RING_SHEAR,
    CLOD_CASE_JENIKE,
    CLOD_CASE_UNIAXIAL,
    CLOD_CASE_WALL_FRICTION,
    CLOD_CASE_CONTACT_BENCH,
    CLOD_CASE_KINDS ///< how many there are
} clod_case_kind;

/** The kind of a case: its tester if it has one; the contact bench if nothing else is there. */
clod_case_kind clod_case_kind_of(const clod_case *self);

/** Whether a case has the section of this kind, or grains or stages of its own: a contact bench
 *  may stand beside a run. */
bool clod_case_has(const clod_case *self, clod_case_kind kind);

/** Key of the tester that makes its own grains, walls and stages in this case, or NULL. */
const char *clod_case_tester(const clod_case *self);

/** Programme of the case's shear test, or NULL when its tester shears nothing. */
const clod_case_programme *clod_case_shear(const clod_case *self);

/** Largest normal stress of the case's tester [Pa]; 0 without one. */
double clod_case_tester_stress(const clod_case *self);

/**
 * The complete case with every default and unit written out, as YAML that loads again.
 * @return owned text (clod_schema_free), or NULL without memory
 */
char *clod_case_echo(const clod_case *self);

#ifdef __cplusplus
}
#endif
