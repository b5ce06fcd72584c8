#pragma once
/**
 * @file scripts.h
 * What is embedded in the program for its pages: style, scripts and their licences.
 */

#include <stdio.h>

/** The style sheet. */
const char *clod_scripts_style(void);

/** The scripts as one text, plotly and three.js among them; NULL: clod was built without. */
const char *clod_scripts_bundle(void);

/** Write the licences of what is embedded as a section of the page. */
void clod_scripts_licences(FILE *out);
