#pragma once
/**
 * @file suite.h
 * The tests of the suite: each fills rows of the report and writes its cases and curves. A new
 * law's tests are one file, one line here and one row of the table in suite.c.
 */

#include "verify/bench.h"

/** A test; false only when a case could not be written or run. */
typedef bool clod_verify_test(const clod_verify_bench *bench, clod_status *status);

clod_verify_test clod_verify_chung_ooi_1;
clod_verify_test clod_verify_chung_ooi_2;
clod_verify_test clod_verify_chung_ooi_3;
clod_verify_test clod_verify_chung_ooi_4;
clod_verify_test clod_verify_chung_ooi_5;
clod_verify_test clod_verify_chung_ooi_6;
clod_verify_test clod_verify_chung_ooi_7;
clod_verify_test clod_verify_chung_ooi_8;
clod_verify_test clod_verify_mepa_cycle;
clod_verify_test clod_verify_mepa_restitution;
clod_verify_test clod_verify_hooke_restitution;
clod_verify_test clod_verify_rolling;
clod_verify_test clod_verify_chute;
clod_verify_test clod_verify_stream_belt;
clod_verify_test clod_verify_trough;
clod_verify_test clod_verify_luding_cycle;
clod_verify_test clod_verify_luding_collision;
clod_verify_test clod_verify_eepa_cycle;
clod_verify_test clod_verify_passivity;
clod_verify_test clod_verify_passivity_sweep;
clod_verify_test clod_verify_flow_function;
clod_verify_test clod_verify_janssen;
clod_verify_test clod_verify_wall_friction;
clod_verify_test clod_verify_beverloo;
clod_verify_test clod_verify_repose;
clod_verify_test clod_verify_mesh_drum;
clod_verify_test clod_verify_mesh_hopper;
clod_verify_test clod_verify_mesh_ring;
