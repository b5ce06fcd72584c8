#include "setup/wall_friction_cell.h"

#include <math.h>

#include "base/assert.h"
#include "config/wall_cells.h"
#include "config/wall_ridges.h"
#include "setup/cell_part.h"
#include "setup/ridged_plate.h"
#include "setup/walls.h"

/** Bars of the lid. */
static clod_cell_part_bars bars_of(const clod_case_wall_friction *cell)
{
    return (clod_cell_part_bars){.inner = clod_wall_cell_inner(cell),
                                 .outer = cell->outer_radius,
                                 .radius_min = cell->radius_min,
                                 .count = clod_wall_cell_bars(cell),
                                 .height = cell->bar_height,
                                 .width = cell->bar_width};
}

static bool cell_sizes(const clod_case_wall_friction *cell, clod_sizes *sizes,
                       clod_status *status)
{
    return clod_sizes_init_normal(sizes, cell->radius_mean, cell->radius_sd, cell->radius_min,
                                  cell->radius_max, status);
}

bool clod_wall_friction_cell_amount(const clod_case *from, clod_sizes *sizes,
                                    clod_amount *amount, clod_status *status)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    const int material = clod_case_material_index(from, cell->grain_material);
    CLOD_ASSERT(material >= 0); // checked at load
    const clod_cell_part_bars bars = bars_of(cell);
    const double room = clod_wall_cell_area(cell) * cell->depth -
                        clod_cell_part_bars_volume(&bars) - clod_wall_ridges_of(cell).volume;
    *amount = (clod_amount){.key = "wall_friction",
                            .sizes = sizes,
                            .count = cell->grain_count,
                            .volume = cell->fill_fraction * room,
                            .density = from->materials[material].density};
    return cell_sizes(cell, sizes, status);
}

/** The plate: as wide as the specimen where it turns; else endless, for it moves on and on, or as
 *  long as its ridges are needed. */
static bool make_plate(const clod_case_wall_friction *cell, clod_wall *plate,
                       clod_status *status)
{
    if (clod_wall_ridges_of(cell).count > 0) {
        return clod_setup_ridged_plate(cell, plate, status);
    }
    plate->shapes[0] =
        clod_cell_part_ring(clod_wall_cell_inner(cell), cell->outer_radius, 0.0, 1.0);
    if (!clod_wall_cell_of(cell)->turns) {
        plate->shapes[0].kind = CLOD_SHAPE_PLANE;
    }
    clod_wall_find_symmetry(plate);
    return true;
}

/** Side walls from the plate up. */
static void make_sides(const clod_case_wall_friction *cell, double height, clod_wall *sides)
{
    sides->shapes[0] = clod_cell_part_side(cell->outer_radius, height, CLOD_SIDE_INSIDE);
    if (clod_wall_cell_of(cell)->annulus) {
        sides->shapes[1] = clod_cell_part_side(cell->inner_radius, height, CLOD_SIDE_OUTSIDE);
    }
    clod_wall_find_symmetry(sides);
}

/** Plate and sides, which the grains need; the lid's place follows from the grains. */
static bool make_walls(const clod_case *from, clod_state *state, clod_status *status)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    if (!clod_cell_part_walls(state, CLOD_WALL_FRICTION_CELL_WALLS, status)) {
        return false;
    }
    const int64_t faces = clod_wall_cell_of(cell)->annulus ? 2 : 1; // of the side walls
    clod_wall *plate = &state->walls.wall[CLOD_WALL_FRICTION_CELL_PLATE];
    clod_wall *sides = &state->walls.wall[CLOD_WALL_FRICTION_CELL_SIDES];
    clod_wall *lid = &state->walls.wall[CLOD_WALL_FRICTION_CELL_LID];
    if (!clod_cell_part_wall(from, "plate", cell->plate_material, 1, plate, status) ||
        !clod_cell_part_wall(from, "sides", cell->side_material, faces, sides, status) ||
        !clod_cell_part_wall(from, "lid", cell->lid_material, bars_of(cell).count + 1, lid,
                             status)) {
        return false;
    }
    make_sides(cell, 0.0, sides);
    lid->shape_count = 0; // open until the grains are in
    return make_plate(cell, plate, status);
}

/** The lid above the grains, the sides up to it, and the domain around all. */
static void close_cell(const clod_case_wall_friction *cell, double height, clod_state *state)
{
    const clod_cell_part_bars bars = bars_of(cell);
    const double hang = bars.count > 0 ? bars.height : 0.0;
    const double lid_height = height + 0.5 * cell->radius_max + hang;
    clod_wall *lid = &state->walls.wall[CLOD_WALL_FRICTION_CELL_LID];
    lid->shape_count = (int32_t)(bars.count + 1);
    clod_cell_part_barred_ring(&bars, lid_height, -1.0, lid);
    lid->load = CLOD_LOAD_STRESS;
    lid->mass = cell->lid_mass;
    lid->area = clod_wall_cell_area(cell);
    make_sides(cell, lid_height, &state->walls.wall[CLOD_WALL_FRICTION_CELL_SIDES]);
    const double margin = 4.0 * cell->radius_max;
    const double wide = cell->outer_radius + margin;
    state->domain =
        (clod_domain){.min = {-wide, -wide, -margin}, .max = {wide, wide, lid_height + margin}};
}

/** Fill the open cell; *height is the highest point of the grains. */
static bool fill_cell(const clod_case *from, int64_t seed, clod_state *state, double *height,
                      clod_status *status)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    clod_sizes sizes;
    clod_amount amount;
    if (!clod_wall_friction_cell_amount(from, &sizes, &amount, status)) {
        return false;
    }
    const clod_cell_part_filling what = {
        .name = "wall_friction",
        .material = cell->grain_material,
        .sizes = &sizes,
        .seed = seed,
        .count = clod_amount_count(&amount, (uint64_t)seed, 1, status),
        .inner = clod_wall_cell_inner(cell),
        .outer = cell->outer_radius};
    if (what.count == 0 || !clod_cell_part_fill(from, &what, state, height, status)) {
        return false;
    }
    const double crests = cell->plate_ridges.height; // 0: grains stay where they are
    for (size_t i = 0; crests > 0.0 && i < state->grains.count; i++) {
        state->grains.position[i][2] += crests;
    }
    *height += crests;
    return true;
}

bool clod_setup_wall_friction_cell(const clod_case *from, int64_t seed, clod_state *state,
                                   clod_status *status)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    clod_cell_part_begin(from, cell->fill_adhesion, state);
    double height = 0.0;
    if (!make_walls(from, state, status) || !fill_cell(from, seed, state, &height, status)) {
        return false;
    }
    close_cell(cell, height, state);
    return clod_cell_part_finish(from, state, status);
}
