#pragma once
/**
 * @file shear_tester.h
 * What a shear test's procedure (tester/ring_shear.h) needs to know of a tester: how its cell
 * is driven, what is read off it, and how far it can be sheared. One row for each tester,
 * looked up by the number that the procedure holds; ring_tester.c and jenike.c have the rows.
 */

#include "tester/inside.h"
#include "tester/ring_shear.h"

typedef struct clod_shear_tester {
    clod_ring_shear_kind kind;
    const char *key; ///< in the case file
    /** Fill in what describes the cell, the rest zero. */
    void (*describe)(clod_ring_shear *self, const clod_case *from, const clod_state *state);

    // what turns or moves
    double (*speed)(const clod_ring_shear *self, const clod_state *state); ///< m/s, of shear
    void (*set_speed)(const clod_ring_shear *self, clod_state *state, double speed);
    /** Whether the speed is the procedure's target, to the last bit. */
    bool (*is_at_speed)(const clod_ring_shear *self, const clod_state *state);
    /**
     * Turn the lid to and fro before preshear, `twists` times; true when it is done and stands.
     * `change` is that of its edge's speed since the last look, at most [m/s]. NULL when the
     * cell has no twists.
     */
    bool (*twist)(clod_ring_shear *self, clod_state *state, double change);

    // what is read
    /** Height of the shear plane above the base [m]; `lid` is that of the lid's plane. */
    double (*shear_plane)(const clod_ring_shear *self, double lid);
    /**
     * Means over `steps` of the shear stress, that at the base, the normal stress at the base
     * and the power of the drive, into their columns; the others of the row are there.
     */
    void (*read)(const clod_ring_shear *self, const clod_state *state, double steps,
                 double *row);
    /** Where the bed is; `lid` is the height of the lid's plane. */
    clod_inside (*bed)(const clod_ring_shear *self, const clod_state *state, double lid);

    // what limits the path
    /** Whether it is sheared back as far as the cell can be. */
    bool (*is_back)(const clod_state *state);

    // words of advice to the user
    const char *lid_meets;     ///< between what no grain fits when the lid has sunk too far
    const char *if_no_bed;     ///< what to do then
    const char *if_not_steady; ///< what follows from it, and what to do
    const char *to_reverse;    ///< what else to raise for a longer way back, or ""
    const char *to_go_further; ///< what else to raise for a longer way, or ""
} clod_shear_tester;

extern const clod_shear_tester CLOD_SHEAR_TESTER_RING, CLOD_SHEAR_TESTER_JENIKE;

/** The tester of a procedure. */
const clod_shear_tester *clod_shear_tester_of(const clod_ring_shear *self);

/** The tester of a case that has a shear test. */
const clod_shear_tester *clod_shear_tester_of_case(const clod_case *from);

/** Height of the lid's plane above the base [m]. */
double clod_shear_tester_lid_height(const clod_ring_shear *self, const clod_state *state);

/** Stress of the solid above the shear plane [Pa]. */
double clod_shear_tester_solid_above(const clod_ring_shear *self, const clod_state *state);

/**
 * Mean forces on the walls since the last look: row [CLOD_RING_SHEAR_COLUMNS].
 *
 * The normal stress is sigma = F_z(lid)/A + solid above the shear plane, with the force of the
 * grains on the lid and the cell's area A.
 */
void clod_shear_tester_measure(const clod_ring_shear *self, const clod_state *state,
                               double *row);
