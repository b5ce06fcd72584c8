#pragma once
/**
 * @file settings.h
 * Keys of another file with values, as `--set` takes them, written as a section:
 *
 *     set: {ring_shear.preshear_stress: 0.6 kPa, ring_shear.shear_stresses: [0.2 kPa, 0.4 kPa]}
 */

#include "config/load.h"

typedef struct clod_setting {
    char *key;   ///< owned; "ring_shear.preshear_stress"
    char *value; ///< owned; in one line, as --set takes it behind the =
} clod_setting;

/**
 * Settings from a section; a section in it is gone into, so that `ring_shear: {speed: 5 mm/s}` is
 * `ring_shear.speed: 5 mm/s`.
 *
 * @param param   row of the kind CLOD_PARAM_SETTINGS, with the offset of the number of settings at `count`
 * @param target  struct that gets an owned array of clod_setting, [count] (clod_settings_free)
 * Errors  in the loader's report: no section, an empty one, a key without value.
 * Threads safe.   Test  tests/calibrate/test_plan_set.c
 */
void clod_settings_load(clod_loader *self, const clod_param *param, const clod_node *node,
                        void *target);

/** Append a setting. @param value  owned, taken over; NULL: no memory. False: no memory; what was appended stays owned. */
bool clod_settings_add(clod_setting **items, size_t *count, const char *key, char *value);

/** Free settings; NULL is fine. */
void clod_settings_free(clod_setting *self, size_t count);
