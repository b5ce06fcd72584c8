#pragma once
/**
 * @file plan_made.h
 * Plans made by tests, without files: parameters from 0 to 1 and targets of no test.
 */

#include <stdio.h>
#include <string.h>

#include "calibrate/plan.h"

#define MADE_MOST 8

typedef struct plan_made {
    clod_plan plan;
    clod_plan_parameter parameters[MADE_MOST];
    clod_plan_target targets[MADE_MOST];
    char names[MADE_MOST][8];
} plan_made;

/** A plan with so many parameters and targets; values and errors are the caller's. */
static inline void plan_make(plan_made *self, size_t parameters, size_t targets)
{
    memset(self, 0, sizeof *self);
    for (size_t k = 0; k < parameters; k++) {
        snprintf(self->names[k], sizeof self->names[k], "p%zu", k);
        self->parameters[k] = (clod_plan_parameter){
            .name = self->names[k], .key = self->names[k], .low = 0.0, .high = 1.0};
    }
    for (size_t t = 0; t < targets; t++) {
        snprintf(self->targets[t].name, sizeof self->targets[t].name, "t%zu", t);
        self->targets[t].measure = (clod_plan_measure){"", 1.0, 3};
    }
    self->plan = (clod_plan){.points = 24,
                             .seeds = 2,
                             .seed = 1,
                             .parameters = self->parameters,
                             .parameter_count = parameters,
                             .targets = self->targets,
                             .target_count = targets,
                             .sampling = {2000, 0.9},
                             .path = "made"};
}
