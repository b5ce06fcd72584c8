#pragma once
/**
 * @file solid.h
 * What was measured of a bulk solid and its wall, and what it says at one stress.
 */

#include <stdbool.h>
#include <stdint.h>

#include "hopper/curve.h"

/** Places of the curves. */
enum {
    CLOD_SOLID_STRENGTH,
    CLOD_SOLID_PHI_E,
    CLOD_SOLID_PHI_T,
    CLOD_SOLID_RHO,
    CLOD_SOLID_WALL,
    CLOD_SOLID_CURVES,
};

/** Properties; stresses in Pa, angles in rad, densities in kg/m3. */
typedef struct clod_solid {
    union {
        struct {
            clod_curve
                strength;     ///< unconfined yield strength f_c over sigma_1: the flow function
            clod_curve phi_e; ///< effective angle of internal friction over sigma_1
            clod_curve phi_t; ///< static angle of internal friction over sigma_1
            clod_curve rho;   ///< bulk density over sigma_1
            clod_curve wall;  ///< shear stress over normal stress at the wall
        };
        clod_curve curves[CLOD_SOLID_CURVES];
    };
    int64_t *seeds; ///< [strength.specimens] owned numbers of the specimens of the shear tests,
                    ///< ascending; NULL: there are none
} clod_solid;

/** The solid at one major principal stress. */
typedef struct clod_solid_state {
    double sigma_1, strength, phi_e, phi_t, rho;
    double phi_w; ///< at the normal stress that the wall feels in flow; pi/2: it does not slide
    double sigma_w; ///< that stress
} clod_solid_state;

/** Wall friction angle at a normal stress: atan(tau_w/sigma_w). */
double clod_solid_wall_angle(const clod_solid *self, double sigma_w);

/**
 * Properties where a hopper flows with this major principal stress at its wall. The normal stress
 * at the wall, and with it phi_w, follows from sigma_1, phi_e and phi_w itself.
 *
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_solid.c
 */
clod_solid_state clod_solid_at(const clod_solid *self, double sigma_1);

/** The largest sigma_1 at which strength, phi_e or phi_t were measured [Pa]. */
double clod_solid_end(const clod_solid *self);
