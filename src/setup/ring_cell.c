#include "setup/ring_cell.h"

#include <math.h>

#include "base/assert.h"
#include "setup/cell_part.h"
#include "setup/walls.h"

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

static clod_cell_part_bars bars_of(const clod_case_ring_shear *cell)
{
    return (clod_cell_part_bars){.inner = cell->inner_radius,
                                 .outer = cell->outer_radius,
                                 .radius_min = cell->radius_min,
                                 .count = cell->bar_count,
                                 .height = cell->bar_height,
                                 .width = cell->bar_width};
}

/** Solid volume that fills the depth between and beside the bars [m3]. */
static double solid_volume(const clod_case_ring_shear *cell)
{
    const clod_cell_part_bars bars_each = bars_of(cell); // of lid and base
    const double bars = 2.0 * clod_cell_part_bars_volume(&bars_each);
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

/** A ring with bars on it: the trough (facing 1) or the lid (facing -1). */
static void fill_ring(const clod_case_ring_shear *cell, double height, double facing,
                      clod_wall *wall)
{
    const clod_cell_part_bars bars = bars_of(cell);
    clod_cell_part_barred_ring(&bars, height, facing, wall);
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
    clod_cell_part_begin(from, cell->fill_adhesion, state);
    double height = 0.0;
    if (!make_walls(from, state, status) || !fill_cell(from, seed, state, &height, status)) {
        return false;
    }
    close_cell(cell, height, state);
    return clod_cell_part_finish(from, state, status);
}
