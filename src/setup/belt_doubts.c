#include "setup/belt_doubts.h"

#include <stdio.h>

#include "base/vec3.h"
#include "clod/check.h"
#include "config/check.h"
#include "config/source.h"

/** Cosine of 60 degrees, the steepest rise of a belt: it may lean as much as a whole. */
#define STEEPEST 0.5
/** Of a cosine: rounding of directions. */
#define SAME_DIRECTION 1e-6

void clod_setup_belts_doubts(const clod_case *from, clod_setup_belts_tell tell, void *context)
{
    const clod_vec3 gravity = clod_vec3_of(from->gravity), z = {0.0, 0.0, 1.0};
    for (size_t w = 0; clod_vec3_length(gravity) > 0.0 && w < from->wall_count; w++) {
        const clod_case_wall *wall = &from->walls[w];
        const clod_vec3 down = clod_vec3_unit(gravity);
        clod_vec3 up = z;
        if (wall->rotate.angle != 0.0) {
            up = clod_vec3_rotate(z, clod_vec3_unit(clod_vec3_of(wall->rotate.axis)),
                                  wall->rotate.angle);
        }
        if (!clod_check_has_belt(wall) ||
            clod_vec3_dot(down, up) < -STEEPEST * (1.0 - SAME_DIRECTION)) {
            continue;
        }
        char key[64], where[CLOD_SOURCE_WHERE], text[CLOD_CHECK_WARNING_TEXT];
        snprintf(key, sizeof key, "walls.%s", wall->name);
        snprintf(
            text, sizeof text,
            "%s%s: its belt takes z as up, which leans by more than 60 deg from where gravity [%.4g, "
            "%.4g, %.4g] m/s2 comes: grains would not lie on it as on a belt. Let gravity point "
            "along -z, or turn the wall (rotate) so that the z of its belt points against gravity",
            clod_source_where(from, key, where), key, gravity.x, gravity.y, gravity.z);
        tell(context, text);
    }
}
