#pragma once
/**
 * @file sim_ranks.h
 * Lives of simulations of the library, each led alone and on ranks, which are threads.
 */

#include "output/temp_folder.h"
#include "support/ranks_crew.h"
#include "support/sanitized.h"
#include "support/sim_trace.h"

/** Cohesive grains fall into a trough with a loaded lid, and out of it. */
#define SIM_HEAD(time)                                                                         \
    "materials: {ore: {density: 2500 kg/m3}, clay: {density: 1500 kg/m3}}\n"                   \
    "contacts: {default: {law: mepa, k1: 4.75e4 N/m^1.5, k2: 2.37e5 N/m^1.5, "                 \
    "k_adh: 1e4 N/m^1.5, restitution: 0.3, friction: 0.35, rolling: epsd2, "                   \
    "rolling_friction: 0.1}}\n"                                                                \
    "gravity: [1 m/s2, 0 m/s2, -9.81 m/s2]\n"                                                  \
    "time: {step: 1e-5 s, overlap_limit: 0.6" time "}\n"                                       \
    "domain: {min: [-25 mm, -12 mm, -5 mm], max: [25 mm, 12 mm, 80 mm], "                      \
    "periodic: [false, true, false], open: delete}\n"                                          \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "walls:\n"                                                                                 \
    "  floor: {material: ore, shapes: [{box: {center: [0 mm, 0 mm, -1 mm], "                   \
    "size: [44 mm, 30 mm, 2 mm]}}]}\n"                                                         \
    "  side: {material: ore, shapes: [{plane: {point: [-22 mm, 0 mm, 0 mm], "                  \
    "normal: [1, 0, 0]}}]}\n"                                                                  \
    "  post: {material: clay, shapes: [{bar: {from: [9 mm, -9 mm, 5 mm], "                     \
    "to: [9 mm, 9 mm, 5 mm], width: 4 mm, height: 4 mm, up: [0, 0, 1]}}]}\n"

#define BED_HEAD SIM_HEAD("")
static const char SIM_BED[] =
    BED_HEAD "  lid: {material: ore, load: {axis: [0, 0, -1], force: 0.2 N, mass: 10 g}, "
             "shapes: [{box: {center: [0 mm, 0 mm, 35 mm], size: [30 mm, 30 mm, 2 mm]}}]}\n"
             "grains:\n"
             "  - {material: ore, count: 240, radius: {distribution: uniform, min: 1.4 mm, "
             "max: 1.6 mm}, region: {box: {min: [-20 mm, -12 mm, 2 mm], max: [20 mm, 12 mm, "
             "30 mm]}}, velocity: [0.2 m/s, 0 m/s, -0.8 m/s]}\n"
             "gauges: {low: {region: {box: {min: [-20 mm, -12 mm, 0 mm], max: [20 mm, 12 mm, "
             "9 mm]}}, direction: [1, 0, 0], plane: {at: 0 mm}}}\n"
             "clumps: {}\n"
             "output: {surfaces: true}\n";

/** A life of a simulation, told line by line. */
typedef struct sim_life {
    void (*live)(sim_trace *trace, clod_sim *sim, const char *folder);
    const char *text;
    int threads;
    sim_trace trace;
} sim_life;

static inline clod_sim *made_on(const char *text, int threads, clod_ranks *ranks)
{
    const clod_sim_options options = {.ranks = ranks, .threads = threads};
    clod_sim *sim = clod_sim_create_from_text("case.yaml", text, &options, &status);
    CHECK(sim != NULL);
    return sim;
}

static inline void run_life(void *context, clod_ranks *ranks)
{
    sim_life *self = context;
    void *folder;
    assert_int_equal(temp_folder_make(&folder), 0);
    clod_sim *sim = made_on(self->text, self->threads, ranks);
    trace_open(&self->trace);
    self->live(&self->trace, sim, folder);
    trace_close(&self->trace);
    clod_sim_destroy(&sim);
    temp_folder_remove(&folder);
}

static inline void same_on_ranks(sim_life lived)
{
    sim_life alone = lived;
    run_life(&alone, NULL);
    for (int ranks = looks_for_races() ? 3 : 1; ranks <= 3; ranks++) {
        sim_life together = lived;
        ranks_crew_run(ranks, run_life, &together);
        trace_same(&alone.trace, &together.trace, ranks);
        free(together.trace.text);
    }
    free(alone.trace.text);
}

static inline void advance(clod_sim *sim, int64_t steps)
{
    CHECK(clod_sim_advance(sim, steps, &status));
}
