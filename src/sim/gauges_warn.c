// Gauges whose means are not those of a steady stream.

#include "sim/gauges_plane.h"
#include "sim/steady_doubt.h"

/** What a gauge is judged by. */
static const struct {
    int value;
    const char *text, *unit;
} JUDGED[] = {{CLOD_GAUGE_OF_FLOW, "mass flow", "kg/s"},
              {CLOD_GAUGE_OF_MASS, "mass inside", "kg"}};

/** Means of a value in the blocks until the last that has samples; how many.
 *  @param block  [CLOD_STEADY_BLOCKS] */
static int take_blocks(const clod_gauge *gauge, const clod_gauge_memory *memory, int value,
                       double *block)
{
    int count = 0;
    for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
        double values[CLOD_GAUGE_VALUES];
        clod_gauge_values(gauge, memory->block[b], values);
        block[b] = values[value];
        count = memory->block[b][CLOD_GAUGE_SAMPLES] > 0.0 ? b + 1 : count;
    }
    return count;
}

/** One warning of a gauge at most: what drives its flow drives the mass inside. */
static void warn(json_t *list, const clod_gauges *all, const clod_free_moment *now, size_t k)
{
    const clod_case_gauge *mine = &now->from->gauges[k];
    const clod_gauge gauge = clod_gauges_make(now->from, mine);
    double block[CLOD_STEADY_BLOCKS];
    char what[128];
    bool warned = false;
    for (size_t j = 0; !warned && j < sizeof JUDGED / sizeof *JUDGED; j++) {
        if (clod_gauges_has(now->from, mine, JUDGED[j].value)) {
            const int blocks = take_blocks(&gauge, &all->gauge[k], JUDGED[j].value, block);
            snprintf(what, sizeof what, "Gauge %s: the %s", mine->name, JUDGED[j].text);
            warned =
                clod_steady_doubt_warn(list, what, JUDGED[j].unit, block, blocks, &now->steady);
        }
    }
    if (!warned && mine->has_plane) {
        const int blocks = clod_gauges_plane_blocks(all, k, block);
        snprintf(what, sizeof what, "Gauge %s: the flow through its plane", mine->name);
        clod_steady_doubt_warn(list, what, "kg/s", block, blocks, &now->steady);
    }
}

void clod_gauges_warn(json_t *list, const void *memory, const clod_free_moment *now)
{
    for (size_t k = 0; k < now->from->gauge_count; k++) {
        warn(list, memory, now, k);
    }
}
