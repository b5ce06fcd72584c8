#pragma once
/**
 * @file play.h
 * Run a deck: write its files, load them as a user's case, and step it with the engine, looking
 * at it after every step.
 */

#include "law/law.h"
#include "step/step.h"
#include "verify/bench.h"
#include "verify/deck.h"

typedef struct clod_verify_play {
    const clod_verify_deck *deck;
    const clod_verify_frame *frame;
    clod_case *from;
    clod_laws laws;
    clod_state state;
    clod_step step;
    int stage;
    size_t row[CLOD_VERIFY_GRAINS]; ///< row of each grain of the deck, now
} clod_verify_play;

/** Called before the first step and after each one. */
typedef bool (*clod_verify_look)(void *context, const clod_verify_play *now,
                                 clod_status *status);

/**
 * Run a deck from its first stage to the end of its last.
 *
 * @param look  sees every step; false ends the run
 * Errors  CLOD_FAILED, CLOD_USAGE: what loader, set-up or engine say.   Threads  one per
 * folder.
 */
bool clod_verify_play_run(const clod_verify_bench *bench, const clod_verify_deck *deck,
                          const clod_verify_frame *frame, clod_verify_look look, void *context,
                          clod_status *status);

// ---- a grain of the deck now, along t, b, n

clod_vec3 clod_verify_play_place(const clod_verify_play *self, int grain);
clod_vec3 clod_verify_play_velocity(const clod_verify_play *self, int grain);
clod_vec3 clod_verify_play_spin(const clod_verify_play *self, int grain);
clod_vec3 clod_verify_play_force(const clod_verify_play *self, int grain);
clod_vec3 clod_verify_play_torque(const clod_verify_play *self, int grain);
