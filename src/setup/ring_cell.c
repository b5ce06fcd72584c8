#include "setup/ring_cell.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "setup/cell_part.h"
#include "setup/walls.h"

/** Free length at both ends of a bar, as a fraction of the smallest radius. */
#define BAR_CLEARANCE 0.1

double clod_ring_cell_area(const clod_case_ring_shear *cell)
{
    return M_PI *
           (cell->outer_radius * cell->outer_radius - cell->inner_radius * cell->inner_radius);
}

static bool cell_sizes(const clod_case_ring_shear *cell, clod_sizes *sizes, clod_status *status)
{
    return clod_sizes_init_normal(sizes, cell->radius_mean, cell->radius_sd, cell->radius_min,
                                  cell->radius_max, status);
}

/** Length of a bar [m]. */
static double bar_length(const clod_case_ring_shear *cell)
{
    return cell->outer_radius - cell->inner_radius - 2.0 * BAR_CLEARANCE * cell->radius_min;
}

/** Solid volume that fills the depth between and beside the bars [m3]. */
static double solid_volume(const clod_case_ring_shear *cell)
{
    const double bar = bar_length(cell) * cell->bar_width * cell->bar_height;
    const double bars = 2.0 * (double)cell->bar_count * bar;
    return cell->fill_fraction * (clod_ring_cell_area(cell) * cell->depth - bars);
}

bool clod_ring_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                           clod_status *status)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    const int material = clod_case_material_index(from, cell->grain_material);
    CLOD_ASSERT(material >= 0); // checked at load
    const double volume = solid_volume(cell);
    *amount = (clod_amount){.key = "ring_shear",
                            .sizes = sizes,
                            .count = cell->grain_count,
                            .volume = volume,
                            .density = from->materials[material].density};
    return cell_sizes(cell, sizes, status);
}

size_t clod_ring_cell_count(const clod_case *from, int64_t seed, clod_status *status)
{
    clod_sizes sizes;
    clod_amount amount;
    return clod_ring_cell_amount(from, &sizes, &amount, status)
               ? clod_amount_count(&amount, (uint64_t)seed, 1, status)
               : 0;
}

/** A radial bar; `bottom` is the height of its lower face. */
static clod_shape make_bar(const clod_case_ring_shear *cell, int64_t number, double bottom)
{
    const double angle = 2.0 * M_PI * (double)number / (double)cell->bar_count;
    const clod_vec3 radial = {cos(angle), sin(angle), 0.0};
    const double middle = 0.5 * (cell->inner_radius + cell->outer_radius);
    return (clod_shape){
        .kind = CLOD_SHAPE_BAR,
        .center = {middle * radial.x, middle * radial.y, bottom + 0.5 * cell->bar_height},
        .axis = {radial, {-radial.y, radial.x, 0.0}, {0.0, 0.0, 1.0}},
        .half = {0.5 * bar_length(cell), 0.5 * cell->bar_width, 0.5 * cell->bar_height},
    };
}

/** A ring with bars on it: the trough (facing 1) or the lid (facing -1). */
static void fill_ring(const clod_case_ring_shear *cell, double height, double facing,
                      clod_wall *wall)
{
    wall->shapes[0] =
        clod_cell_part_ring(cell->inner_radius, cell->outer_radius, height, facing);
    const double bottom = facing > 0.0 ? height : height - cell->bar_height;
    for (int64_t b = 0; b < cell->bar_count; b++) {
        wall->shapes[b + 1] = make_bar(cell, b, bottom);
    }
    clod_wall_find_symmetry(wall);
}

/** Trough and sides, which the grains need; the lid's place follows from the grains. */
static bool make_walls(const clod_case *from, clod_state *state, clod_status *status)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    if (!clod_cell_part_walls(state, CLOD_RING_CELL_WALLS, status)) {
        return false;
    }
    clod_wall *wall = state->walls.wall;
    if (!clod_cell_part_wall(from, "trough", cell->base_material, cell->bar_count + 1,
                             &wall[CLOD_RING_CELL_TROUGH], status) ||
        !clod_cell_part_wall(from, "sides", cell->side_material, 2, &wall[CLOD_RING_CELL_SIDES],
                             status) ||
        !clod_cell_part_wall(from, "lid", cell->lid_material, cell->bar_count + 1,
                             &wall[CLOD_RING_CELL_LID], status)) {
        return false;
    }
    fill_ring(cell, 0.0, 1.0, &wall[CLOD_RING_CELL_TROUGH]);
    clod_shape *side = wall[CLOD_RING_CELL_SIDES].shapes;
    side[0] = clod_cell_part_side(cell->inner_radius, 0.0, CLOD_SIDE_OUTSIDE);
    side[1] = clod_cell_part_side(cell->outer_radius, 0.0, CLOD_SIDE_INSIDE);
    clod_wall_find_symmetry(&wall[CLOD_RING_CELL_SIDES]);
    wall[CLOD_RING_CELL_LID].shape_count = 0; // open until the grains are in
    return true;
}

/** The lid above the grains, the sides up to it, and the domain around all. */
static void close_cell(const clod_case_ring_shear *cell, double height, clod_state *state)
{
    const double gap = 0.5 * cell->radius_max;
    const double lid_height = height + gap + cell->bar_height;
    clod_wall *lid = &state->walls.wall[CLOD_RING_CELL_LID];
    lid->shape_count = (int32_t)(cell->bar_count + 1);
    fill_ring(cell, lid_height, -1.0, lid);
    lid->load = CLOD_LOAD_STRESS;
    lid->mass = cell->lid_mass;
    lid->area = clod_ring_cell_area(cell);
    clod_shape *side = state->walls.wall[CLOD_RING_CELL_SIDES].shapes;
    side[0].half[2] = 0.5 * lid_height;
    side[1].half[2] = 0.5 * lid_height;
    const double margin = 4.0 * cell->radius_max;
    state->domain = (clod_domain){
        .min = {-cell->outer_radius - margin, -cell->outer_radius - margin, -margin},
        .max = {cell->outer_radius + margin, cell->outer_radius + margin, lid_height + margin},
    };
}

/** Fill the open cell; *height is the highest point of the grains. */
static bool fill_cell(const clod_case *from, int64_t seed, clod_state *state, double *height,
                      clod_status *status)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    clod_sizes sizes;
    if (!cell_sizes(cell, &sizes, status)) {
        return false;
    }
    const clod_cell_part_filling what = {.name = "ring_shear",
                                         .material = cell->grain_material,
                                         .sizes = &sizes,
                                         .seed = seed,
                                         .count = clod_ring_cell_count(from, seed, status),
                                         .inner = cell->inner_radius,
                                         .outer = cell->outer_radius};
    return what.count > 0 && clod_cell_part_fill(from, &what, state, height, status);
}

bool clod_setup_ring_cell(const clod_case *from, int64_t seed, clod_state *state,
                          clod_status *status)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    *state = (clod_state){.build_motion = -1.0, .adhesion = cell->fill_adhesion};
    memcpy(state->gravity, from->gravity, sizeof state->gravity);
    double height = 0.0;
    if (!make_walls(from, state, status) || !fill_cell(from, seed, state, &height, status)) {
        return false;
    }
    close_cell(cell, height, state);
    return clod_cell_part_finish(from, state, status);
}
