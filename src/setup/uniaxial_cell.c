#include "setup/uniaxial_cell.h"

#include <math.h>

#include "base/assert.h"
#include "setup/cell_part.h"
#include "setup/walls.h"

/** Radius of the pan on which the mould stands, in radii of the mould. */
#define PAN_RADII 3.0

double clod_uniaxial_cell_area(const clod_case_uniaxial *cell)
{
    return 0.25 * M_PI * cell->diameter * cell->diameter;
}

static bool cell_sizes(const clod_case_uniaxial *cell, clod_sizes *sizes, clod_status *status)
{
    return clod_sizes_init_normal(sizes, cell->radius_mean, cell->radius_sd, cell->radius_min,
                                  cell->radius_max, status);
}

bool clod_uniaxial_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                               clod_status *status)
{
    const clod_case_uniaxial *cell = &from->uniaxial;
    const int material = clod_case_material_index(from, cell->grain_material);
    CLOD_ASSERT(material >= 0); // checked at load
    const double volume = cell->fill_fraction * clod_uniaxial_cell_area(cell) * cell->height;
    *amount = (clod_amount){.key = "uniaxial",
                            .sizes = sizes,
                            .count = cell->grain_count,
                            .volume = volume,
                            .density = from->materials[material].density};
    return cell_sizes(cell, sizes, status);
}

size_t clod_uniaxial_cell_count(const clod_case *from, int64_t seed, clod_status *status)
{
    clod_sizes sizes;
    clod_amount amount;
    return clod_uniaxial_cell_amount(from, &sizes, &amount, status)
               ? clod_amount_count(&amount, (uint64_t)seed, 1, status)
               : 0;
}

/** The pan, which the grains need; mould and lid follow from the grains. */
static bool make_walls(const clod_case *from, clod_state *state, clod_status *status)
{
    const clod_case_uniaxial *cell = &from->uniaxial;
    if (!clod_cell_part_walls(state, CLOD_UNIAXIAL_CELL_WALLS, status)) {
        return false;
    }
    clod_wall *base = &state->walls.wall[CLOD_UNIAXIAL_CELL_BASE];
    clod_wall *mould = &state->walls.wall[CLOD_UNIAXIAL_CELL_MOULD];
    clod_wall *lid = &state->walls.wall[CLOD_UNIAXIAL_CELL_LID];
    if (!clod_cell_part_wall(from, "base", cell->base_material, 2, base, status) ||
        !clod_cell_part_wall(from, "mould", cell->side_material, 1, mould, status) ||
        !clod_cell_part_wall(from, "lid", cell->lid_material, 1, lid, status)) {
        return false;
    }
    const double pan = 0.5 * PAN_RADII * cell->diameter;
    base->shapes[0] = clod_cell_part_ring(0.0, pan, 0.0, 1.0);
    base->shapes[1] = clod_cell_part_side(pan, cell->height, CLOD_SIDE_INSIDE);
    clod_wall_find_symmetry(base);
    mould->shape_count = lid->shape_count = 0; // open until the grains are in
    return true;
}

/** The lid above the grains, the mould up to it, and the domain around all. */
static void close_cell(const clod_case_uniaxial *cell, double height, clod_state *state)
{
    const double lid_height = height + 0.5 * cell->radius_max;
    const double radius = 0.5 * cell->diameter;
    clod_wall *mould = &state->walls.wall[CLOD_UNIAXIAL_CELL_MOULD];
    mould->shape_count = 1;
    mould->shapes[0] = clod_cell_part_side(radius, lid_height, CLOD_SIDE_INSIDE);
    clod_wall_find_symmetry(mould);
    clod_wall *lid = &state->walls.wall[CLOD_UNIAXIAL_CELL_LID];
    lid->shape_count = 1;
    lid->shapes[0] = clod_cell_part_ring(0.0, radius, lid_height, -1.0);
    clod_wall_find_symmetry(lid);
    lid->load = CLOD_LOAD_STRESS;
    lid->mass = cell->lid_mass;
    lid->area = clod_uniaxial_cell_area(cell);
    const double margin = 4.0 * cell->radius_max;
    const double wide = PAN_RADII * radius + margin;
    const double high = fmax(lid_height, cell->height) + margin;
    state->domain = (clod_domain){.min = {-wide, -wide, -margin}, .max = {wide, wide, high}};
}

bool clod_setup_uniaxial_cell(const clod_case *from, int64_t seed, clod_state *state,
                              clod_status *status)
{
    const clod_case_uniaxial *cell = &from->uniaxial;
    clod_sizes sizes;
    clod_cell_part_begin(from, cell->fill_adhesion, state);
    if (!make_walls(from, state, status) || !cell_sizes(cell, &sizes, status)) {
        return false;
    }
    const clod_cell_part_filling what = {.name = "uniaxial",
                                         .material = cell->grain_material,
                                         .sizes = &sizes,
                                         .seed = seed,
                                         .count = clod_uniaxial_cell_count(from, seed, status),
                                         .outer = 0.5 * cell->diameter};
    double height = 0.0;
    if (what.count == 0 || !clod_cell_part_fill(from, &what, state, &height, status)) {
        return false;
    }
    close_cell(cell, height, state);
    return clod_cell_part_finish(from, state, status);
}
