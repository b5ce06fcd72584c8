#pragma once
/**
 * @file deck.h
 * A small case in a frame of its own, and its files: case.yaml and grains.csv.
 *
 * The axes are t (along slip), b (across) and n (normal). A frame says where they point in
 * space, so that one deck can be run in any of them.
 */

#include "base/vec3.h"
#include "clod/status.h"

#define CLOD_VERIFY_GRAINS 48
#define CLOD_VERIFY_MATERIALS 24
#define CLOD_VERIFY_STAGES 32
#define CLOD_VERIFY_WALLS 2
#define CLOD_VERIFY_NAME 24
#define CLOD_VERIFY_CONTACTS 2048

/** Where the axes of a deck point in space; orthonormal, right-handed. */
typedef struct clod_verify_frame {
    const char *name;
    clod_vec3 t, b, n;
} clod_verify_frame;

/** Along x, y, z; the grain that lies lower along n comes first in the engine's order. */
clod_verify_frame clod_verify_frame_plain(void);

/** Half a turn about b: the same, with the other order of every pair. */
clod_verify_frame clod_verify_frame_swapped(void);

/** Turned by 1 rad about (1, 2, 3): no component of any axis is zero. */
clod_verify_frame clod_verify_frame_turned(void);

clod_vec3 clod_verify_frame_out(const clod_verify_frame *self, clod_vec3 local);
clod_vec3 clod_verify_frame_in(const clod_verify_frame *self, clod_vec3 space);

typedef struct clod_verify_material {
    char name[CLOD_VERIFY_NAME];
    double density;        ///< kg/m3
    double youngs_modulus; ///< Pa; 0: none
    double poissons_ratio; ///< -
} clod_verify_material;

typedef struct clod_verify_grain {
    char material[CLOD_VERIFY_NAME];
    double radius;            ///< m
    clod_vec3 place;          ///< m, along t, b, n
    clod_vec3 velocity, spin; ///< m/s, rad/s
} clod_verify_grain;

/** A plane across n at `height`; `side` +1: the grains are above it, -1: below. */
typedef struct clod_verify_wall {
    char name[CLOD_VERIFY_NAME], material[CLOD_VERIFY_NAME];
    double height; ///< m along n
    double side;
} clod_verify_wall;

/** A stage: how long, and how fast each wall moves along n in it. */
typedef struct clod_verify_stage {
    double duration; ///< s
    double velocity[CLOD_VERIFY_WALLS];
} clod_verify_stage;

typedef struct clod_verify_deck {
    const char *name;  ///< folder below DIR/cases
    const char *title; ///< one line
    double step;       ///< s; 0: the automatic one
    bool ledger;       ///< keep the energy ledger
    clod_vec3 gravity; ///< m/s2, along t, b, n
    clod_verify_material materials[CLOD_VERIFY_MATERIALS];
    int material_count;
    char contacts[CLOD_VERIFY_CONTACTS]; ///< YAML, one pair a line
    clod_verify_grain grains[CLOD_VERIFY_GRAINS];
    int grain_count;
    clod_verify_wall walls[CLOD_VERIFY_WALLS];
    int wall_count;
    clod_verify_stage stages[CLOD_VERIFY_STAGES];
    int stage_count;
} clod_verify_deck;

void clod_verify_deck_material(clod_verify_deck *self, const char *name, double density,
                               double youngs_modulus, double poissons_ratio);

/** Keys of a pair of materials, or of "default"; the format gives them as YAML. */
void clod_verify_deck_contact(clod_verify_deck *self, const char *pair, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Add a grain at rest; what is returned may be set moving. */
clod_verify_grain *clod_verify_deck_grain(clod_verify_deck *self, const char *material,
                                          double radius, clod_vec3 place);

void clod_verify_deck_wall(clod_verify_deck *self, const char *name, const char *material,
                           double height, double side);

void clod_verify_deck_stage(clod_verify_deck *self, clod_verify_stage stage);

/** Largest distance from the origin that a grain's surface reaches in free flight and fall [m].
 */
double clod_verify_deck_reach(const clod_verify_deck *self);

/**
 * Write case.yaml and grains.csv into DIR/cases/NAME, or NAME-FRAME but for the plain frame.
 *
 * @param path  [4096, out] of case.yaml
 * Errors  CLOD_FAILED: disk.   Threads  one per folder.
 */
bool clod_verify_deck_write(const clod_verify_deck *self, const clod_verify_frame *frame,
                            const char *directory, char path[4096], clod_status *status);
