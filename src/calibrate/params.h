#pragma once
/**
 * @file params.h
 * Parameter table of the plan of a calibration.
 */

#include "config/param.h"

extern const clod_table CLOD_TABLE_PLAN;
