#pragma once
/**
 * @file echo.h
 * Values of a case as the complete case writes them: in SI units, numbers that read back to the same bits.
 */

#include <stdio.h>

#include "config/param.h"

/** Whether the complete case has a row of a struct: it was given, has a default, or has an effect. */
bool clod_echo_shows(const clod_case *whole, const clod_param *param, const void *target);

/** Write the value of a row that is no group: "4.75e+08 N/m^1.5", "mepa". */
void clod_echo_value(FILE *out, const clod_param *param, const void *target);
