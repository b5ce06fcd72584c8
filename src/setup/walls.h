#pragma once
/**
 * @file walls.h
 * Walls of a case made ready: shapes in one form, unit directions, loads in newtons.
 */

#include "clod/case.h"
#include "state/walls.h"

/**
 * Build the walls of a case.
 *
 * @param from    checked case
 * @param walls   [out] owned by the caller (clod_walls_fini), also after a failure; the damping
 *                of loaded walls is still 0 (clod_setup_wall_damping)
 * Errors  CLOD_USAGE: a name too long, a plane that would turn out of itself; CLOD_FAILED.
 * Threads pure.   Test  tests/setup/test_setup_walls.c
 */
bool clod_setup_walls(const clod_case *from, clod_walls *walls, clod_status *status);

/** One wall of a case, or one like them; as clod_setup_walls. */
bool clod_setup_wall(const clod_case *from, const clod_case_wall *given, clod_wall *wall,
                     clod_status *status);

/** Whether a wall stays where it is during all stages. Threads: pure. */
bool clod_setup_wall_stays(const clod_case *from, const clod_wall *wall);

/**
 * Check that the time step resolves every oscillation.
 *
 * @param dt  time step [s]
 * Errors  CLOD_USAGE: a period of fewer than 50 steps.
 * Threads pure.   Test  tests/setup/test_setup_walls.c
 */
bool clod_setup_wall_pace(const clod_walls *walls, double dt, clod_status *status);

/**
 * Damping of a loaded wall: 2 z sqrt(k m), z as a fraction of critical.
 *
 * @param wall       [in,out] its mass and z are read, its damping is set
 * @param stiffness  k of the bed under the wall [N/m] (clod_setup_bed_stiffness)
 */
void clod_setup_wall_damping(clod_wall *wall, double stiffness);

/**
 * Estimated stiffness of a bed of grains: area/(2R)^2 columns side by side, each of
 * height/(2R) contacts in a row.
 *
 * @param tangent  stiffness of one contact [N/m]
 * @param area     loaded area [m2]
 * @param height   height of the bed [m]
 * @param radius   mean radius R [m]
 * @return         N/m
 */
double clod_setup_bed_stiffness(double tangent, double area, double height, double radius);
