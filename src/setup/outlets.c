#include "setup/outlets.h"

#include <string.h>

/** Whether a shape is of a part of a mesh; names of parts are cut to fit. */
static bool is_of(const clod_shape *shape, const char *part)
{
    const clod_surface *surface = shape->surface;
    return part == NULL ||
           (surface != NULL && strncmp(surface->part_name[surface->patches[shape->patch].part],
                                       part, CLOD_SURFACE_NAME - 1) == 0);
}

/** Note an outlet in the shapes of its wall; how many there are. */
static int32_t note(clod_wall *wall, const char *part, int32_t number, bool *twice)
{
    int32_t count = 0;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape *shape = &wall->shapes[s];
        if (is_of(shape, part)) {
            *twice |= shape->outlet > 0;
            shape->outlet = number;
            count++;
        }
    }
    return count;
}

bool clod_setup_outlets(const clod_case *from, clod_walls *walls, clod_status *status)
{
    for (size_t k = 0; k < from->outlet_count; k++) {
        const clod_case_outlet *outlet = &from->outlets[k];
        int32_t found = 0;
        bool twice = false;
        for (int32_t w = 0; outlet->wall != NULL && w < walls->count; w++) {
            if (strcmp(walls->wall[w].name, outlet->wall) == 0) {
                found += note(&walls->wall[w], outlet->part, (int32_t)k + 1, &twice);
            }
        }
        if (twice) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "outlets.%s: a surface of walls.%s belongs to another "
                                    "outlet already; each can be one of them only",
                                    outlet->name, outlet->wall);
        }
        if (outlet->wall != NULL && found == 0) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "outlets.%s.part: no mesh of walls.%s has a part '%s'; clod "
                "mesh FILE lists the parts of a file",
                outlet->name, outlet->wall, outlet->part != NULL ? outlet->part : "");
        }
    }
    return true;
}
