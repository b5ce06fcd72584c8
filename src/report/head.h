#pragma once
/**
 * @file head.h
 * What every page has: title and warnings at its head; case and provenance at its end.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/run_files.h"

/** Title, kind, when. */
void clod_head_put(FILE *out, const clod_run_files *run);

/** All warnings of a run and of the laboratory's points (NULL: none). */
void clod_head_warnings(FILE *out, const clod_run_files *run, const json_t *lab);

/** The report as text, the case, and what computed it. */
void clod_head_sources(FILE *out, const clod_run_files *run);
