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

/**
 * Write the warnings of a run, each text with a 0 at its end; how many.
 * @param lab  the laboratory's results (NULL: none): whether they are of another preshear stress
 */
size_t clod_head_warnings(FILE *out, const clod_run_files *run, const json_t *lab);

/** The same of the evaluation of the laboratory's points (NULL: none), each with the preshear stress of its locus. */
size_t clod_head_lab_warnings(FILE *out, const json_t *lab);

/**
 * A number of the summary, or of its parts: times add up, steps are none, for each part counts on from those of its
 * preparation, and of others there is the least and the largest, as of seeds.
 *
 * @param ends  [2] [out] least and largest; equal where there is one number
 * @return      whether there is one
 */
bool clod_head_number(const json_t *summary, const char *key, double ends[2]);

/** The report as text, the case, and what computed it. */
void clod_head_sources(FILE *out, const clod_run_files *run);
