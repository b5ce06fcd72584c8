#pragma once
/**
 * @file change.h
 * The one point at which grains and walls come and go: a rebuild. Everything that depends on
 * which there are is made anew here: rows, contacts, skins, rows of walls, lists, views,
 * ledger.
 */

#include "step/step.h"

/**
 * Within a rebuild of a running step: grains beyond an open side of a domain that removes them
 * are counted and marked.
 *
 * @return  how many; their marks are in neighbour.rank, as for clod_state_drop_grains
 * Errors  none.   Threads  one, the others wait.   Test  tests/step/test_change.c
 */
size_t clod_change_find_leavers(clod_step *self);

/** Energy of the state for the ledger [J]; 0 when it is not open. */
double clod_change_balance(clod_step *self);
