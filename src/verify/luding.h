#pragma once
/**
 * @file luding.h
 * Luding's law branch by branch, as Granular Matter 10 (2008) 235 prints it, and what follows
 * from it by hand; written apart from src/law.
 */

/** The numbers of a contact. */
typedef struct clod_verify_luding {
    double k1, k2, k_adh; ///< k2 at most [N/m]
    double depth;         ///< phi_f
    double diameter;      ///< Luding's a = 2 R_i R_j/(R_i + R_j); at a wall 2 R [m]
} clod_verify_luding;

/** Overlap from which k2 is at its most [m]. */
double clod_verify_luding_limit(const clod_verify_luding *self);

/** k2 after an overlap of `most` at most [N/m]. */
double clod_verify_luding_stiffness(const clod_verify_luding *self, double most);

/** Force at an overlap on the k2 line of a contact that was pressed to `most` [N]. */
double clod_verify_luding_elastic(const clod_verify_luding *self, double overlap, double most);

/** Overlap of the largest pull after `most`: where k2 (d - d0) = -k_adh d [m]. */
double clod_verify_luding_pull(const clod_verify_luding *self, double most);

/**
 * What is left of the largest overlap after a slow way down the adhesive branch to an overlap
 * [m]: the m whose own largest pull is there.
 */
double clod_verify_luding_left(const clod_verify_luding *self, double overlap);

/** A clod_verify_branches: the force step by step, remembering the largest overlap. */
double clod_verify_luding_force(const void *law, double overlap, double *most);
