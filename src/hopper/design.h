#pragma once
/**
 * @file design.h
 * A hopper for a bulk solid: half angle for mass flow, smallest outlet without an arch, rathole.
 * Equations and sources: docs/theory/hopper.md.
 */

#include "hopper/radial.h"
#include "hopper/solid.h"

#define CLOD_HOPPER_GRAVITY 9.80665 ///< m/s2

/** Fit of Jenike's function H(theta) for the thickness of an arch. */
typedef enum clod_hopper_arch {
    CLOD_HOPPER_ARCH_ARNOLD, ///< (130 + theta)/65, (200 + theta)/200
    CLOD_HOPPER_ARCH_RHODES, ///< 2 + theta/60, 1 + theta/180
} clod_hopper_arch;

/** What is wanted of one shape. */
typedef struct clod_hopper_wish {
    clod_radial_shape shape;
    double half_angle; ///< rad; 0: the limit less the margin
    double limit;      ///< rad: of mass flow at the outlet that is built, given; 0: a cone's
    double margin;     ///< rad below the limit
    clod_hopper_arch arch;
    double outlet;    ///< m: that is built or planned; 0: none
    double least;     ///< m: that of large particles; 0: not known
    double tolerance; ///< CLOD_RADIAL_TOLERANCE
    double first;     ///< Pa: where the search for the state begins; 0: at the smallest stress
} clod_hopper_wish;

/** How it comes out. */
typedef enum clod_hopper_outcome {
    CLOD_HOPPER_FLOWS,     ///< mass flow, without an arch above the critical outlet
    CLOD_HOPPER_NO_ARCH,   ///< mass flow; the strength nowhere reaches the stress of an arch
    CLOD_HOPPER_ARCHES,    ///< it stays above it, everywhere or beyond some stress
    CLOD_HOPPER_FUNNEL,    ///< the solid does not slide along the wall: funnel flow
    CLOD_HOPPER_UNSETTLED, ///< properties change so with stress that no state was found
    CLOD_HOPPER_UNPROVEN ///< a wedge wider than the limit of a cone: the field has a solution,
                         ///< which does not show mass flow; the outlet is that of the solution
} clod_hopper_outcome;

/**
 * A hopper of one shape; where there is no critical outlet the state is that of the largest or
 * smallest measured stress. Limit and half angle are those at the stresses of the outlet that is
 * built: the largest of that of the wish, that of large particles and the critical one; or, where the
 * wall holds the solid at the critical one and no outlet is given, at the smallest measured sigma_1.
 */
typedef struct clod_hopper_design {
    clod_hopper_outcome outcome;
    clod_solid_state state;        ///< critical state
    clod_solid_state design_state; ///< of limit and half angle: at the outlet that is built
    double built;                  ///< m: that outlet; 0: there is none
    bool sticks; ///< at outlets below the critical one the solid does not slide along the wall;
                 ///< without that, no arch would stand over some of them
    bool at_measured; ///< limit and half angle are those at the smallest measured sigma_1
    double
        limit; ///< rad: largest half angle of mass flow, that of the wish or a cone's; 0: none
    double half_angle;  ///< rad
    double arch;        ///< H
    double axis;        ///< of the last stress field, as in clod_radial_wall; 0: none
    double flow_factor; ///< ff
    double outlet;      ///< m: critical diameter or width; 0: no arch; INFINITY: arches
} clod_hopper_design;

/** Whether there is a critical state: one of an outlet above which no arch stands. */
bool clod_hopper_is_critical(const clod_hopper_design *self);

/** Whether the solid is in mass flow, through some outlet or through any.   Threads  pure. */
bool clod_hopper_is_mass_flow(const clod_hopper_design *self);

/** H of a half angle. Source: docs/theory/hopper.md. Test: tests/hopper/test_design.c */
double clod_hopper_arch_thickness(clod_hopper_arch fit, clod_radial_shape shape, double theta);

/** Largest half angle of mass flow in a cone at one stress; 0: none.   Threads  pure. */
double clod_hopper_limit_at(const clod_solid *solid, double sigma_1, double tolerance);

/**
 * Design a hopper of one shape: half angle at the stresses of the outlet that is built; iterate until
 * the state is where the flow function meets the flow factor of that state; and where the solid
 * sticks to the wall there, the smallest outlet at which it slides.
 *
 * Source  docs/theory/hopper.md.
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_design.c
 */
clod_hopper_design clod_hopper_design_shape(const clod_solid *solid,
                                            const clod_hopper_wish *wish);

/** An outlet that is given. */
typedef struct clod_hopper_margin {
    clod_solid_state
        state;     ///< in flow at the outlet; where it sticks, the one that does not slide
    double stress; ///< Pa in an arch over the outlet
    double ratio; ///< stress over strength: above 1 an arch breaks; NAN: it sticks, or no state
    bool sticks;  ///< at the stresses of this outlet the solid does not slide along the wall
} clod_hopper_margin;

/**
 * How far from an arch a given outlet is.
 *
 * @param outlet  m: diameter or width
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_design.c
 */
clod_hopper_margin clod_hopper_margin_of(const clod_solid *solid, const clod_hopper_wish *wish,
                                         double outlet);
