#pragma once
/**
 * @file sight.h
 * What of a bed somebody must see between two steps. Where several ranks have it, all of it is
 * gathered, or what reaches into some places.
 */

#include <stdbool.h>

#include "clod/case.h"
#include "state/domain.h"

typedef struct clod_sight {
    bool whole;                            ///< all grains and contacts
    int boxes;                             ///< else grains that reach into these; 0: none
    clod_domain_box box[CLOD_CASE_INLETS]; ///< m
} clod_sight;
