#include "setup/belt_doubts.h"

#include <stdio.h>

#include "base/vec3.h"
#include "clod/check.h"
#include "config/check.h"
#include "config/source.h"

/** Sine of the angle below which two directions are one. */
#define SAME_DIRECTION 1e-6

/** Whether gravity points against a direction; `down` is its unit vector. */
static bool is_against(clod_vec3 down, clod_vec3 up)
{
    return clod_vec3_dot(down, up) < 0.0 &&
           clod_vec3_length(clod_vec3_cross(down, up)) < SAME_DIRECTION;
}

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
        if (!clod_check_has_belt(wall) || is_against(down, z) || is_against(down, up)) {
            continue;
        }
        char key[64], where[CLOD_SOURCE_WHERE], text[CLOD_CHECK_WARNING_TEXT];
        snprintf(key, sizeof key, "walls.%s", wall->name);
        snprintf(
            text, sizeof text,
            "%s%s: its belt takes z as up, and gravity is [%.4g, %.4g, %.4g] m/s2: grains "
            "would not lie on it as on a belt. Let gravity point along -z, or turn the wall "
            "(rotate) so that the z of its belt points against gravity",
            clod_source_where(from, key, where), key, gravity.x, gravity.y, gravity.z);
        tell(context, text);
    }
}
