#pragma once
/**
 * @file tables_note.h
 * What is to be said of the tables of a case: gaps in columns, columns that sections replace, and densities of another unit.
 */

#include "hopper/tables.h"

/** Note a flow function of a uniaxial test, whose strengths are those of another test than a design takes.
 *  @param what  "Flow function" */
void clod_tables_note_uniaxial(const char *path, const char *what, clod_tables_notes *notes);

/** Note a column of the flow function that is empty at the smallest sigma_1, where the design takes it from there. */
void clod_tables_note_blanks(const clod_hopper_case *from, const clod_solid *solid,
                             clod_tables_notes *notes);

/** Note columns of the flow function in whose place sections of the case are taken. */
void clod_tables_note_replaced(const clod_hopper_case *from, const clod_solid *solid,
                               clod_tables_notes *notes);

/** Note a bulk density so low that it may be one in lb/ft3. */
void clod_tables_note_light(const clod_hopper_case *from, const clod_solid *solid,
                            clod_tables_notes *notes);
