#pragma once
/**
 * @file posterior_look.h
 * What samples of a posterior say about parameters and targets.
 */

#include "calibrate/posterior.h"

/** What the surrogates of the used targets say at a place, each by one of its draws.
 *  @param chosen [used]  @param told [out] [targets]  @param room clod_posterior_room */
void clod_posterior_look_ask(const clod_posterior *self, const double *place,
                             const size_t *chosen, clod_surrogate_value *told, double *room);

/** Share of a population that lies outside the range of all samples, of the parameter where it is largest.
 *  @param places [count][dimensions] */
double clod_posterior_look_missed(const clod_posterior *self, const double *places,
                                  size_t count);

/**
 * Look at the samples of a posterior: parameters, correlations, targets, chi-square and p.
 *
 * Errors  CLOD_FAILED: memory; CLOD_INTERRUPTED.   Threads  safe.   Test  tests/calibrate/test_posterior.c
 */
bool clod_posterior_look(const clod_posterior_runs *runs, clod_posterior *self,
                         clod_status *status);
