#pragma once
/**
 * @file uniaxial_rows.h
 * What a uniaxial test tells of each consolidation, on its own page and beside others.
 */

#include "report/result_table.h"

#define CLOD_UNIAXIAL_ROW_COUNT 8

extern const clod_result_row CLOD_UNIAXIAL_ROWS[CLOD_UNIAXIAL_ROW_COUNT];
