#include "sim/wall_loads.h"

#include <string.h>

/** Columns of each wall: means over the time since the last row, and where it is. */
static const char *const PER_WALL[] = {"force_x [N]",    "force_y [N]",    "force_z [N]",
                                       "torque_x [N m]", "torque_y [N m]", "torque_z [N m]",
                                       "power [W]",      "shift_x [m]",    "shift_y [m]",
                                       "shift_z [m]",    "angle [rad]"};
#define PER_WALL_COUNT (sizeof PER_WALL / sizeof *PER_WALL)

static size_t wall_columns(const clod_case *from, const clod_state *state)
{
    (void)from;
    return PER_WALL_COUNT * (size_t)state->walls.count;
}

static void wall_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                        size_t size)
{
    (void)from;
    snprintf(text, size, "%s.%s", state->walls.wall[k / PER_WALL_COUNT].name,
             PER_WALL[k % PER_WALL_COUNT]);
}

static void put_wall(const clod_wall *wall, double *row)
{
    const double steps = (double)(wall->sum_steps > 0 ? wall->sum_steps : 1);
    const clod_vec3 f = clod_vec3_scale(wall->sum_force, 1.0 / steps);
    const clod_vec3 t = clod_vec3_scale(wall->sum_torque, 1.0 / steps);
    const double values[PER_WALL_COUNT] = {f.x,
                                           f.y,
                                           f.z,
                                           t.x,
                                           t.y,
                                           t.z,
                                           wall->sum_power / steps,
                                           wall->shift.x,
                                           wall->shift.y,
                                           wall->shift.z,
                                           wall->angle};
    memcpy(row, values, sizeof values);
}

static void wall_row(void *memory, const clod_free_moment *now, double *row)
{
    (void)memory;
    for (int32_t w = 0; w < now->state->walls.count; w++) {
        put_wall(&now->state->walls.wall[w], row + (size_t)w * PER_WALL_COUNT);
    }
}

static void wall_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    (void)memory;
    for (int32_t w = 0; w < now->state->walls.count; w++) {
        const clod_wall *wall = &now->state->walls.wall[w];
        fprintf(out, "  wall %-16s force (%.4g, %.4g, %.4g) N\n", wall->name, wall->force.x,
                wall->force.y, wall->force.z);
    }
}

static void wall_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)from;
    if (state->walls.count > 0) {
        char all[32];
        snprintf(all, sizeof all, "[0-%d]", (int)state->walls.count - 1);
        clod_free_paths_add(paths, all,
                            "force_N.[0-2] torque_Nm.[0-2] shift_m.[0-2] angle_rad");
    }
}

static json_t *wall_json(const void *memory, const clod_free_moment *now)
{
    (void)memory;
    json_t *walls = json_array();
    for (int32_t w = 0; w < now->state->walls.count; w++) {
        const clod_wall *wall = &now->state->walls.wall[w];
        json_array_append_new(walls, json_pack("{s:s, s:[fff], s:[fff], s:[fff], s:f}", "name",
                                               wall->name, "force_N", wall->force.x,
                                               wall->force.y, wall->force.z, "torque_Nm",
                                               wall->torque.x, wall->torque.y, wall->torque.z,
                                               "shift_m", wall->shift.x, wall->shift.y,
                                               wall->shift.z, "angle_rad", wall->angle));
    }
    return walls;
}

const clod_free_measure CLOD_MEASURE_WALL_LOADS = {.key = "walls",
                                                   .paths = wall_paths,
                                                   .columns = wall_columns,
                                                   .column = wall_column,
                                                   .row = wall_row,
                                                   .report = wall_report,
                                                   .json = wall_json};
