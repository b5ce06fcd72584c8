#include "setup/cell_part.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "config/testers.h"
#include "setup/insertion.h"
#include "setup/state.h"

/** Free length at both ends of a bar, as a fraction of the smallest radius. */
#define BAR_CLEARANCE 0.1

void clod_cell_part_begin(const clod_case *from, double adhesion, clod_state *state)
{
    *state = (clod_state){.build_motion = -1.0, .adhesion = adhesion};
    memcpy(state->gravity, from->gravity, sizeof state->gravity);
}

bool clod_cell_part_walls(clod_state *state, int32_t count, clod_status *status)
{
    state->walls.wall = clod_memory_alloc((size_t)count, sizeof *state->walls.wall);
    if (state->walls.wall == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the walls of the cell");
    }
    state->walls.count = count;
    return true;
}

bool clod_cell_part_wall(const clod_case *from, const char *name, const char *material,
                         int64_t shapes, clod_wall *wall, clod_status *status)
{
    const int number = clod_case_material_index(from, material);
    CLOD_ASSERT(number >= 0); // checked at load
    snprintf(wall->name, sizeof wall->name, "%s", name);
    wall->material = (uint16_t)number;
    wall->spin_axis = (clod_vec3){0.0, 0.0, 1.0};
    wall->load_axis = (clod_vec3){0.0, 0.0, -1.0};
    wall->shapes = clod_memory_alloc((size_t)shapes, sizeof *wall->shapes);
    if (wall->shapes == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the walls of the cell");
    }
    wall->shape_count = (int32_t)shapes;
    return true;
}

clod_shape clod_cell_part_ring(double inner, double outer, double height, double facing)
{
    return (clod_shape){
        .kind = CLOD_SHAPE_ANNULUS,
        .center = {0.0, 0.0, height},
        .axis = {{1.0, 0.0, 0.0}, {0.0, facing, 0.0}, {0.0, 0.0, facing}},
        .inner = inner,
        .outer = outer,
    };
}

clod_shape clod_cell_part_side(double radius, double height, clod_side side)
{
    return (clod_shape){
        .kind = CLOD_SHAPE_CYLINDER,
        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
        .outer = radius,
        .half = {0.0, 0.0, 0.5 * height},
        .side = side,
    };
}

static double bar_length(const clod_cell_part_bars *bars)
{
    return bars->outer - bars->inner - 2.0 * BAR_CLEARANCE * bars->radius_min;
}

double clod_cell_part_bars_volume(const clod_cell_part_bars *bars)
{
    return (double)bars->count * (bar_length(bars) * bars->width * bars->height);
}

/** A radial bar; `bottom` is the height of its lower face. */
static clod_shape make_bar(const clod_cell_part_bars *bars, int64_t number, double bottom)
{
    const double angle = 2.0 * M_PI * (double)number / (double)bars->count;
    const clod_vec3 radial = {cos(angle), sin(angle), 0.0};
    const double middle = 0.5 * (bars->inner + bars->outer);
    return (clod_shape){
        .kind = CLOD_SHAPE_BAR,
        .center = {middle * radial.x, middle * radial.y, bottom + 0.5 * bars->height},
        .axis = {radial, {-radial.y, radial.x, 0.0}, {0.0, 0.0, 1.0}},
        .half = {0.5 * bar_length(bars), 0.5 * bars->width, 0.5 * bars->height},
    };
}

void clod_cell_part_barred_ring(const clod_cell_part_bars *bars, double height, double facing,
                                clod_wall *wall)
{
    wall->shapes[0] = clod_cell_part_ring(bars->inner, bars->outer, height, facing);
    const double bottom = facing > 0.0 ? height : height - bars->height;
    for (int64_t b = 0; b < bars->count; b++) {
        wall->shapes[b + 1] = make_bar(bars, b, bottom);
    }
    clod_wall_find_symmetry(wall);
}

bool clod_cell_part_fill(const clod_case *from, const clod_cell_part_filling *what,
                         clod_state *state, double *height, clod_status *status)
{
    const int material = clod_case_material_index(from, what->material);
    CLOD_ASSERT(material >= 0); // checked at load
    const clod_case_region region = {
        .kind = CLOD_REGION_ANNULUS, .inner_radius = what->inner, .outer_radius = what->outer};
    const clod_insertion grains = {.name = what->name,
                                   .region = &region,
                                   .sizes = what->sizes,
                                   .seed = (uint64_t)what->seed,
                                   .first_id = 1,
                                   .count = what->count,
                                   .material = (uint16_t)material,
                                   .density = from->materials[material].density};
    return clod_insert_annulus_column(state, &grains, height, status);
}

bool clod_cell_part_finish(const clod_case *from, clod_state *state, clod_status *status)
{
    clod_timestep timestep;
    if (!clod_setup_timestep(from, state, &timestep, status)) {
        return false;
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        state->walls.wall[w].damping_fraction = clod_config_tester_of(from)->lid_damping(from);
    }
    clod_setup_damping(state, &timestep);
    state->dt = timestep.step;
    return true;
}
