#pragma once
/**
 * @file grain_solid.h
 * What the grains of a case are made of: density, and the law of their contacts with each other, by key. A material
 * card has it of the case that it was calibrated with (`calibrated_with`), and a case that includes the card is
 * compared with it.
 */

#include "config/settings.h"

#define CLOD_SOLID_TEXT 512 ///< bytes of a warning

// Keys of `calibrated_with` that say how the calibration went, and what they say.
#define CLOD_SOLID_TARGETS "targets"
#define CLOD_SOLID_HELD_BACK "held_back"
#define CLOD_SOLID_MET "met"
#define CLOD_SOLID_MISSED "missed"
#define CLOD_SOLID_UNTOLD "untold" ///< surrogates know too little to say either

/** Keys of a solid; those of its contacts by their last word. */
typedef struct clod_grain_solid {
    const char *
        material; ///< borrowed from the case; NULL: the case has no grains, and no keys are there
    clod_setting *keys; ///< [count] owned; values as the complete case has them
    size_t count;
} clod_grain_solid;

/**
 * The solid of a case: that of the tester's grains, or of the first group of a free run.
 *
 * @param self  [out] owned content (clod_grain_solid_fini), in any case
 * @return      false without memory
 * Threads safe.   Test  tests/calibrate/test_calibrate_card.py
 */
bool clod_grain_solid_init(clod_grain_solid *self, const clod_case *from);

void clod_grain_solid_fini(clod_grain_solid *self);

/**
 * Whether the solid of a case is another one than the card says that it includes; sizes of grains are not looked at.
 *
 * @param text  [size] [out] warning, CLOD_SOLID_TEXT at most that names the keys with both values; "" where there is nothing to say
 * @return      text[0] is not 0
 * Threads safe.   Test  as above
 */
bool clod_grain_solid_differs(const clod_case *from, char *text, size_t size);

/**
 * Whether the card that a case includes missed what it was calibrated with, used targets or held-back ones, or may have:
 * untold. A card without these keys did not.
 *
 * @param text  [size] [out] warning, CLOD_SOLID_TEXT at most; "" where there is nothing to say
 * @return      text[0] is not 0
 * Threads pure.   Test  as above
 */
bool clod_grain_solid_missed(const clod_case *from, char *text, size_t size);
