#pragma once
/**
 * @file figure_json.h
 * Figures and texts as JSON that may stand in a page.
 */

#include <stdio.h>

#include "report/figure.h"

/** Write a text as a JSON string; `<` is escaped, so no markup ends the block it is in. */
void clod_figure_json_text(FILE *out, const char *text);

/** Write a number with as few digits as read back exactly; null where it is not finite. */
void clod_figure_json_number(FILE *out, double value);

/** Write a figure as a JSON object. Test  tests/report/test_page.py */
void clod_figure_json(FILE *out, const clod_figure *figure);
