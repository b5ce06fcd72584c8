#pragma once
/**
 * @file gauges.h
 * The stream in the gauges of the case (docs/gauges.md): a measure of free runs. They are sampled
 * every CLOD_GAUGES_INTERVAL of simulated time.
 */

#include "measure/gauge_bins.h"
#include "sim/belt_work.h"
#include "sim/free_measures.h"

/** Simulated time from one sample to the next [s]. */
#define CLOD_GAUGES_INTERVAL 1e-3

/** Alarm of one gauge. */
typedef struct clod_gauge_alarm {
    int64_t
        slow_since;   ///< step since which it has held much that hardly moves; -1: it does not
    int64_t first;    ///< step at which what led to the first alarm began; -1: none yet
    int64_t alarms;   ///< so many so far
    int64_t on;       ///< there is one now
    int64_t reported; ///< `on` as it was said last
    double mass, speed; ///< kg, m/s: inside at the last sample
} clod_gauge_alarm;

/** Mass that had passed the plane of a gauge at a moment; plain data. */
typedef struct clod_gauge_passed {
    double time;          ///< s
    double forward, back; ///< kg, since the beginning
} clod_gauge_passed;

/** What one gauge remembers; plain data. */
typedef struct clod_gauge_memory {
    double row[CLOD_GAUGE_SUMS]; ///< since the last row of the series
    double block[CLOD_STEADY_BLOCKS][CLOD_GAUGE_SUMS];
    clod_belt_work work; ///< of the belt
    clod_gauge_alarm alarm;
    clod_gauge_bins profile, trajectory; ///< of the steady time
    clod_gauge_passed passed_row;        ///< at the last row of the series, or the beginning
    clod_gauge_passed passed_edge[CLOD_STEADY_BLOCKS + 1]; ///< at the edges of blocks
} clod_gauge_memory;

/** All gauges of a case. */
typedef struct clod_gauges {
    int64_t next;  ///< step of the next sample
    int64_t edges; ///< edges of blocks that have been noted, with planes
    clod_gauge_memory gauge[];
} clod_gauges;

/** A gauge of the case. */
clod_gauge clod_gauges_make(const clod_case *from, const clod_case_gauge *gauge);

/** Whether a gauge of the case has what a value needs. */
bool clod_gauges_has(const clod_case *from, const clod_case_gauge *gauge, int value);

/** Note what a sample says of the alarm (gauges_alarm.c). @return  whether there is one */
bool clod_gauges_watch(clod_gauge_alarm *self, const clod_case_gauge *gauge, const double *sums,
                       const clod_state *state);

/** The next alarm that has begun or ended and was not reported (gauges_alarm.c). */
bool clod_gauges_news(void *memory, const clod_case *from, const clod_state *state,
                      clod_news *news);

/** Lines of the report, object of the summary, tables (gauges_report.c, gauges_table.c). */
void clod_gauges_report(FILE *out, const void *memory, const clod_free_moment *now);
json_t *clod_gauges_json(const void *memory, const clod_free_moment *now);

/** Warn of gauges whose means are not those of a steady stream (gauges_warn.c). */
void clod_gauges_warn(json_t *list, const void *memory, const clod_free_moment *now);

void clod_gauges_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths);
bool clod_gauges_write(const clod_folder *folder, const void *memory,
                       const clod_free_moment *now, clod_status *status);

/**
 * Errors  CLOD_FAILED: memory.   Threads  one per state.
 * Test    tests/cli/test_gauges.py
 */
extern const clod_free_measure CLOD_MEASURE_GAUGES;
