#pragma once
/**
 * @file clumps_report.h
 * What is reported of clumps: columns of the series, lines of the report, summary, clumps.csv.
 */

#include "sim/free_measures.h"

size_t clod_clumps_report_columns(const clod_case *from, const clod_state *state);
void clod_clumps_report_column(const clod_case *from, const clod_state *state, size_t k,
                               char *text, size_t size);
void clod_clumps_report_row(void *memory, const clod_free_moment *now, double *row);
void clod_clumps_report_lines(FILE *out, const void *memory, const clod_free_moment *now);
json_t *clod_clumps_report_json(const void *memory, const clod_free_moment *now);
void clod_clumps_report_paths(const clod_case *from, const clod_state *state,
                              clod_free_paths *paths);
bool clod_clumps_report_files(const clod_folder *folder, const void *memory,
                              const clod_free_moment *now, clod_status *status);
