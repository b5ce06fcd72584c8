#pragma once
/**
 * @file case_walls.h
 * The walls of a checked case: shapes, belts, motion, load (case.h).
 */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clod_shape_kind {
    CLOD_SHAPE_PLANE,
    CLOD_SHAPE_DISC,
    CLOD_SHAPE_ANNULUS,
    CLOD_SHAPE_CYLINDER,
    CLOD_SHAPE_CONE,
    CLOD_SHAPE_BOX,
    CLOD_SHAPE_BAR,
    CLOD_SHAPE_MESH,
    CLOD_SHAPE_CONVEYOR,
    CLOD_SHAPE_KINDS, ///< how many there are
} clod_shape_kind;

typedef enum clod_side { CLOD_SIDE_INSIDE, CLOD_SIDE_OUTSIDE } clod_side;

/** What a surface of a wall is made of, and how its material moves while it stays: a belt. */
typedef struct clod_case_surface {
    char *name;           ///< of a part of a mesh; else NULL
    char *material;       ///< NULL: that of the wall
    double velocity[3];   ///< m/s
    double speed;         ///< m/s along the projection of `direction` onto the surface
    double direction[3];  ///< not zero when there is a speed
    double spin;          ///< rad/s about spin_axis through spin_point
    double spin_axis[3];  ///< not zero when there is a spin
    double spin_point[3]; ///< m
} clod_case_surface;

/** How shapes are turned before a run. */
typedef struct clod_case_rotation {
    double axis[3];  ///< not zero when there is an angle
    double angle;    ///< rad, by the right-hand rule
    double point[3]; ///< m, on the axis
} clod_case_rotation;

/** A straight run of a conveyor belt. */
typedef struct clod_case_belt_run {
    double length; ///< m, along the run
    double rise;   ///< rad, above the horizontal; below 0 it falls
} clod_case_belt_run;

/** Pulley at the end of a conveyor belt's last run. */
typedef struct clod_case_belt_pulley {
    double radius;        ///< m, to the belt's outer side; 0 = no pulley
    double wrap;          ///< rad, from the end of the run
    double return_length; ///< m, straight on from the end of the wrap
} clod_case_belt_pulley;

/** Upright plates along both sides of a conveyor belt. */
typedef struct clod_case_belt_skirts {
    char *material;  ///< NULL: that of the wall
    double from, to; ///< m, along the belt; equal = no skirts
    double distance; ///< m, between the plates
    double gap;      ///< m, from the belt to the lower edges
    double height;   ///< m, of the plates
} clod_case_belt_skirts;

/** A conveyor belt: what of it carries (docs/belts.md). */
typedef struct clod_case_belt {
    double from[3];    ///< m, middle of the belt where it begins
    double heading[3]; ///< in which it runs, seen from above
    clod_case_belt_run *runs;
    size_t run_count;
    double width;       ///< m, of the belt laid flat
    double idler_angle; ///< rad, of the wing rolls; 0 = a flat belt
    double middle_roll; ///< m, length of the middle roll; 0 = two rolls, a V
    double transition;  ///< m before the end over which the trough flattens
    double facet;       ///< m, longest side of a piece, of two facets each; 0: no limit
    double speed;       ///< m/s
    clod_case_belt_pulley pulley;
    clod_case_belt_skirts skirts;
} clod_case_belt;

/** One surface of a wall. Which fields count depends on `kind`. */
typedef struct clod_case_shape {
    int kind; ///< clod_shape_kind
    clod_case_surface surface;
    double point[3];  ///< plane: a point; disc, annulus, box: centre; shells: foot of the axis
    double normal[3]; ///< plane, disc, annulus: normal towards the grains
    double axis[3];   ///< cylinder, cone: direction of the axis
    double radius;    ///< disc, cylinder
    double inner_radius, outer_radius; ///< annulus
    double foot_radius, top_radius;    ///< cone: where its axis begins, and where it ends
    double length;                     ///< cylinder, cone: along the axis
    int side;                          ///< cylinder, cone: where the grains are (clod_side)
    double size[3];                    ///< box: edge lengths along x, y, z
    double from[3], to[3];             ///< bar: ends of its centre line
    double width, height;              ///< bar: across, and along `up`
    double up[3];                      ///< bar: direction of its height
    char *file;                        ///< mesh: path, resolved against the case
    double unit;                       ///< mesh: m, one unit of the file
    double scale;                      ///< mesh: of its numbers
    clod_case_rotation rotate;         ///< mesh: of the scaled mesh
    double move[3];                    ///< mesh: m, after rotate
    double smooth_angle;               ///< mesh: rad, bends below it are smooth
    clod_case_surface *parts;          ///< mesh: of parts by name, in place of `surface`
    size_t part_count;
    clod_case_belt belt; ///< belt
} clod_case_shape;

typedef enum clod_load_kind {
    CLOD_LOAD_NONE,
    CLOD_LOAD_FORCE,
    CLOD_LOAD_STRESS
} clod_load_kind;

/** Harmonic motion of a wall about the pose in which it was given. */
typedef struct clod_case_oscillation {
    double direction[3]; ///< of the translation
    double amplitude;    ///< m along direction; 0 = none
    double angle;        ///< rad, amplitude of the rotation about spin_axis; 0 = none
    double frequency;    ///< Hz; 0 = the wall does not oscillate
    double phase;        ///< rad, at time 0
} clod_case_oscillation;

/** Start of the belts of a wall's shapes: they stand, then reach their speed linearly. */
typedef struct clod_case_start_up {
    double at, duration; ///< s
} clod_case_start_up;

/** A wall: a rigid body of one or more shapes. */
typedef struct clod_case_wall {
    char *name;
    char *material; ///< of the shapes that have none of their own
    clod_case_shape *shapes;
    size_t shape_count;
    clod_case_rotation rotate; ///< of all shapes, before the run
    double move[3];            ///< m, of all shapes, after that
    double velocity[3];        ///< m/s
    double spin;               ///< rad/s about spin_axis through spin_point
    double spin_axis[3];
    double spin_point[3];       ///< m
    double surface_velocity[3]; ///< m/s, the shape stays where it is (belt)
    int load;                   ///< clod_load_kind
    double load_axis[3];        ///< direction in which the load pushes the wall
    double force;               ///< N
    double stress;              ///< Pa
    double area;                ///< m2, for stress
    double mass;                ///< kg, of the loaded wall
    double damping;             ///< fraction of critical against the bed's stiffness estimate
    clod_case_oscillation oscillation;
    clod_case_start_up start_up;
} clod_case_wall;

#ifdef __cplusplus
}
#endif
