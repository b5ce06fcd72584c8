#pragma once
/**
 * @file bed.h
 * The periodic beds of copper ore that the benchmarks step, and the laws they step them with.
 */

#include "law/law.h"
#include "state/state.h"

/**
 * Read a packing: lines id,x,y,z,r,vx,vy,vz [m, m/s] after a header; the box is three periods.
 *
 * @param state  [out] owned content (clod_state_fini); gravity along -z, no step made yet
 * @return       false: a file cannot be read, or no memory
 */
bool bench_bed_read(const char *csv, const char *box, clod_state *state, clod_status *status);

/**
 * A law by name: `mepa`, the full law of the 5 % ore (Table 1; restitution, friction and
 * rolling as in cases/copper-ore-5); `hertz`, its dry twin from E and nu without rolling
 * resistance; `hertz-rolling`, the same with epsd2.
 *
 * @return  false for an unknown name
 */
bool bench_bed_law(const char *name, clod_law *law, clod_status *status);
