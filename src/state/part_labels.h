#pragma once
/**
 * @file part_labels.h
 * What tables, summaries, reports, snapshots and pictures call the parts of a wall's meshes and
 * belts: the name that the file gives, without characters that have a meaning in a table, and
 * made to be the only one of its wall.
 */

#include "state/walls.h"

/** Character that stands for this one in a label: those that have a meaning in tables become _. */
char clod_part_labels_clean(char of);

/**
 * Give the named parts of a wall their labels (clod_surface.part_label), and number its surfaces.
 * A label is the cleaned name. Parts whose cleaned names are equal, or are those of surfaces
 * without a name ("2"), have the number of their shape in the wall before it, from 1:
 * "1.run 1", "2.run 1"; and where that is taken, one more number behind it: "1.a_b (2)".
 *
 * @param wall  all shapes of a wall of a case, as setup has made them
 * @return      false without memory
 * Threads  one for a wall.   Test  tests/state/test_part_labels.c, tests/cli/test_part_names.py
 */
bool clod_part_labels_make(clod_wall *wall);

/**
 * Whether a text asks for a part: by its label, or by its name.
 *
 * @param part  of the surface, with a label
 * Threads  pure.
 */
bool clod_part_labels_asked(const clod_surface *surface, size_t part, const char *text);
