#pragma once
/**
 * @file params.h
 * Parameter table of the case file of a hopper.
 */

#include "config/param.h"

extern const clod_table CLOD_TABLE_HOPPER;
