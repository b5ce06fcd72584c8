#include "setup/jenike_cell.h"

#include <math.h>

#include "base/assert.h"
#include "setup/cell_part.h"
#include "setup/walls.h"

double clod_jenike_cell_area(const clod_case_jenike *cell)
{
    return 0.25 * M_PI * cell->diameter * cell->diameter;
}

static bool cell_sizes(const clod_case_jenike *cell, clod_sizes *sizes, clod_status *status)
{
    return clod_sizes_init_normal(sizes, cell->radius_mean, cell->radius_sd, cell->radius_min,
                                  cell->radius_max, status);
}

bool clod_jenike_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                             clod_status *status)
{
    const clod_case_jenike *cell = &from->jenike;
    const int material = clod_case_material_index(from, cell->grain_material);
    CLOD_ASSERT(material >= 0); // checked at load
    const double height = cell->base_height + cell->ring_height;
    const double volume = cell->fill_fraction * clod_jenike_cell_area(cell) * height;
    *amount = (clod_amount){.key = "jenike",
                            .sizes = sizes,
                            .count = cell->grain_count,
                            .volume = volume,
                            .density = from->materials[material].density};
    return cell_sizes(cell, sizes, status);
}

size_t clod_jenike_cell_count(const clod_case *from, int64_t seed, clod_status *status)
{
    clod_sizes sizes;
    clod_amount amount;
    return clod_jenike_cell_amount(from, &sizes, &amount, status)
               ? clod_amount_count(&amount, (uint64_t)seed, 1, status)
               : 0;
}

/** A ring of the cell: a cylinder that stands on `bottom`, and its rim on the shear plane. */
static void fill_ring(const clod_case_jenike *cell, double bottom, double height, double facing,
                      clod_wall *wall)
{
    const double radius = 0.5 * cell->diameter;
    wall->shapes[0] = clod_cell_part_side(radius, height, CLOD_SIDE_INSIDE);
    wall->shapes[0].center.z = bottom;
    wall->shapes[1] =
        clod_cell_part_ring(radius, radius + cell->rim, cell->base_height, facing);
}

/** Put a wall behind the base by the offset, with the axis about which it turns. */
static void put_behind(const clod_case_jenike *cell, clod_wall *wall)
{
    wall->spin_point.x = -cell->offset;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        wall->shapes[s].center.x = -cell->offset;
    }
    clod_wall_find_symmetry(wall);
}

/** The base, which the grains need; shear ring and lid follow from the grains. */
static bool make_walls(const clod_case *from, clod_state *state, clod_status *status)
{
    const clod_case_jenike *cell = &from->jenike;
    if (!clod_cell_part_walls(state, CLOD_JENIKE_CELL_WALLS, status)) {
        return false;
    }
    clod_wall *base = &state->walls.wall[CLOD_JENIKE_CELL_BASE];
    clod_wall *base_ring = &state->walls.wall[CLOD_JENIKE_CELL_BASE_RING];
    clod_wall *shear_ring = &state->walls.wall[CLOD_JENIKE_CELL_SHEAR_RING];
    clod_wall *lid = &state->walls.wall[CLOD_JENIKE_CELL_LID];
    const char *side = cell->side_material;
    if (!clod_cell_part_wall(from, "base", cell->base_material, 1, base, status) ||
        !clod_cell_part_wall(from, "base_ring", side, 2, base_ring, status) ||
        !clod_cell_part_wall(from, "shear_ring", side, 2, shear_ring, status) ||
        !clod_cell_part_wall(from, "lid", cell->lid_material, 1, lid, status)) {
        return false;
    }
    base->shapes[0] = clod_cell_part_ring(0.0, 0.5 * cell->diameter, 0.0, 1.0);
    clod_wall_find_symmetry(base);
    fill_ring(cell, 0.0, cell->base_height, 1.0, base_ring);
    clod_wall_find_symmetry(base_ring);
    shear_ring->shape_count = lid->shape_count = 0; // open until the grains are in
    return true;
}

/** The lid above the grains, the shear ring up to it, and the domain around all. */
static void close_cell(const clod_case_jenike *cell, double height, clod_state *state)
{
    const double least = cell->base_height + cell->ring_height;
    const double lid_height = fmax(height + 0.5 * cell->radius_max, least);
    clod_wall *shear_ring = &state->walls.wall[CLOD_JENIKE_CELL_SHEAR_RING];
    shear_ring->shape_count = 2;
    fill_ring(cell, cell->base_height, lid_height - cell->base_height, -1.0, shear_ring);
    put_behind(cell, shear_ring);
    clod_wall *lid = &state->walls.wall[CLOD_JENIKE_CELL_LID];
    lid->shape_count = 1;
    lid->shapes[0] = clod_cell_part_ring(0.0, 0.5 * cell->diameter, lid_height, -1.0);
    put_behind(cell, lid);
    lid->load = CLOD_LOAD_STRESS;
    lid->mass = cell->lid_mass;
    lid->area = clod_jenike_cell_area(cell);
    const double margin = 4.0 * cell->radius_max;
    const double wide = 0.5 * cell->diameter + 2.0 * cell->rim + margin;
    state->domain =
        (clod_domain){.min = {-wide, -wide, -margin}, .max = {wide, wide, lid_height + margin}};
}

bool clod_setup_jenike_cell(const clod_case *from, int64_t seed, clod_state *state,
                            clod_status *status)
{
    const clod_case_jenike *cell = &from->jenike;
    clod_sizes sizes;
    clod_cell_part_begin(from, cell->fill_adhesion, state);
    if (!make_walls(from, state, status) || !cell_sizes(cell, &sizes, status)) {
        return false;
    }
    const clod_cell_part_filling what = {.name = "jenike",
                                         .material = cell->grain_material,
                                         .sizes = &sizes,
                                         .seed = seed,
                                         .count = clod_jenike_cell_count(from, seed, status),
                                         .outer = 0.5 * cell->diameter - cell->offset};
    double height = 0.0;
    if (what.count == 0 || !clod_cell_part_fill(from, &what, state, &height, status)) {
        return false;
    }
    close_cell(cell, height, state);
    return clod_cell_part_finish(from, state, status);
}
