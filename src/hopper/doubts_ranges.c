/**
 * @file doubts_ranges.c
 * A flow function that crosses a flow factor more than once.
 */

#include <stdio.h>
#include <string.h>

#include "hopper/doubts.h"

#define ROOM (40 * CLOD_RANGES_MOST)

/** "155.9 to 386.4 mm and 12.0 to 40.1 mm", from the largest on. */
static void put_ranges(const clod_ranges *ranges, char text[ROOM])
{
    text[0] = '\0';
    for (size_t k = 0; k < ranges->count; k++) {
        const size_t used = strlen(text);
        snprintf(text + used, ROOM - used, "%s%.1f to %.1f mm", k > 0 ? " and " : "",
                 1e3 * ranges->of[k].from, 1e3 * ranges->of[k].to);
    }
}

/** Whether the curve only rises through the ray: up to a size none stands, above it all do. */
static bool only_rises(const clod_ranges *ranges)
{
    return ranges->count == 1 && ranges->of[0].from == 0.0;
}

/** Whether all that stands above a range does so beyond the largest measured stress. */
static bool is_beyond(const clod_hopper_design *at)
{
    return at->outcome == CLOD_HOPPER_ARCHES &&
           at->state.strength * at->flow_factor <= at->state.sigma_1;
}

void clod_doubts_ranges(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_curve *curve = &self->solid.strength;
    char ranges[ROOM], beyond[96] = "";
    if (found->lower.count == 0) {
        return;
    }
    if (is_beyond(&found->design)) {
        snprintf(beyond, sizeof beyond,
                 " That rests on an extrapolation beyond the largest sigma_1, %.3f kPa.",
                 1e-3 * curve->points[curve->count - 1].x);
    }
    if (only_rises(&found->lower)) {
        clod_warning_list_add(
            &self->warnings,
            "%s: no arch stands over outlets below %.1f mm, but one does above them, where the hopper is wider: "
            "strength grows faster with stress than the stress in an arch.%s",
            name, 1e3 * found->lower.of[0].to, beyond);
        return;
    }
    put_ranges(&found->lower, ranges);
    clod_warning_list_add(
        &self->warnings,
        "%s: no arch stands over outlets of %s either, but one does above them, where the hopper is wider: the "
        "flow function crosses the flow factor more than once.%s Tests at more stresses tell whether it does.",
        name, ranges, beyond);
}

void clod_doubts_holes(clod_hopper *self)
{
    char ranges[ROOM];
    if (only_rises(&self->lower_holes)) {
        clod_warning_list_add(
            &self->warnings,
            "Rathole, emptying: below %.1f mm none stands, but wider ones do: strength grows faster with stress than "
            "the stress about a rathole.",
            1e3 * self->lower_holes.of[0].to);
    } else if (self->lower_holes.count > 0) {
        put_ranges(&self->lower_holes, ranges);
        clod_warning_list_add(
            &self->warnings,
            "Rathole, emptying: of %s none stands either, but wider ones do: the flow function crosses the flow "
            "factor of a rathole more than once. Tests at more stresses tell whether it does.",
            ranges);
    }
}
