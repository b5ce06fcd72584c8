#pragma once
/**
 * @file remake_order.h
 * Phases of a rebuild (remake.c) in which grains that leave are found and the others get a new
 * order among themselves. Where grains are spread over ranks they migrate in place of that: then
 * they are wrapped here, and that is all.
 *
 * `layers` also refuses grains outside the domain and, on ranks, disowns those that leave.
 *
 * @param part  `begin` and `layers`: thread 0; the others: each of the parts
 *
 * Threads  all of the step.   Test  tests/step/test_same_bits.c, test_leave.c, test_ranks.c
 */

#include "step/step.h"

/** Whether the grains get a new order among themselves. */
bool clod_remake_order_is_new(const clod_step *self);

/** At a rebuild: which grains go, and room for the order of the others. */
void clod_remake_order_begin(clod_step *self, int part);

/** Rows are wrapped, and measured. */
void clod_remake_order_measure(clod_step *self, int part);

/** The layers of the bed; it has failed when a grain has left the domain. Nothing is taken apart
 *  yet. */
void clod_remake_order_layers(clod_step *self, int part);

void clod_remake_order_find_keys(clod_step *self, int part);
void clod_remake_order_sort(clod_step *self, clod_chunk parts);

/** The contacts of each grain into ascending order. */
void clod_remake_order_ascend(clod_step *self, int part);

/** Rows of grains into the new order, column by column. */
void clod_remake_order_move_rows(clod_step *self, clod_chunk parts);
