#include "setup/outlets.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "state/part_labels.h"

/** Whether a shape is of a part of a mesh; without a name of one any is. */
static bool is_of(const clod_shape *shape, const char *part)
{
    const clod_surface *surface = shape->surface;
    return part == NULL ||
           (surface != NULL &&
            clod_part_labels_asked(surface, surface->patches[shape->patch].part, part));
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

/** "feed has the parts run 1, pulley": those of all meshes and belts of a wall. */
static void say_parts(const clod_walls *walls, const char *name, char *text, size_t size)
{
    const clod_surface *last = NULL; // shapes of one mesh follow each other
    clod_text_names names = clod_text_names_begin(text, size);
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        for (int32_t s = 0; strcmp(wall->name, name) == 0 && s < wall->shape_count; s++) {
            const clod_surface *surface = wall->shapes[s].surface;
            for (size_t p = 0; surface != NULL && surface != last && p < surface->part_count;
                 p++) {
                if (surface->part_label[p][0] != '\0') {
                    clod_text_names_add(&names, surface->part_label[p]);
                }
            }
            last = surface;
        }
    }
    clod_text_names_end(&names);
}

/** That a wall has no such part, and which it has. */
static bool fail_part(const clod_walls *walls, const clod_case_outlet *outlet,
                      clod_status *status)
{
    char parts[600];
    say_parts(walls, outlet->wall, parts, sizeof parts);
    if (parts[0] == '\0') {
        return clod_status_fail(
            status, CLOD_USAGE,
            "outlets.%s.part: walls.%s has no part '%s', and no named part "
            "at all; remove the key part, and all of the wall is the outlet",
            outlet->name, outlet->wall, outlet->part);
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "outlets.%s.part: walls.%s has no part '%s'; its parts are %s",
                            outlet->name, outlet->wall, outlet->part, parts);
}

bool clod_setup_outlets(const clod_case *from, clod_walls *walls, clod_status *status)
{
    for (size_t k = 0; k < from->outlet_count; k++) {
        const clod_case_outlet *outlet = &from->outlets[k];
        bool twice = false;
        const int32_t w = outlet->wall != NULL ? clod_walls_find(walls, outlet->wall) : -1;
        const int32_t found =
            w >= 0 ? note(&walls->wall[w], outlet->part, (int32_t)k + 1, &twice) : 0;
        if (twice) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "outlets.%s: a surface of walls.%s belongs to another "
                                    "outlet already; each can be one of them only",
                                    outlet->name, outlet->wall);
        }
        if (outlet->wall != NULL && outlet->part != NULL && found == 0) {
            return fail_part(walls, outlet, status);
        }
    }
    return true;
}
