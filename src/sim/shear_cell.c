#include "sim/shear_cell.h"

#include "setup/jenike_cell.h"
#include "setup/ring_cell.h"

static clod_shear_cell jenike_cell(const clod_case *from)
{
    const clod_case_jenike *cell = &from->jenike;
    return (clod_shear_cell){.key = "jenike",
                             .programme = &cell->programme,
                             .grain_material = cell->grain_material,
                             .radius_mean = cell->radius_mean,
                             .area = clod_jenike_cell_area(cell),
                             .width = cell->diameter,
                             .height = cell->base_height + cell->ring_height,
                             .lid_mass = cell->lid_mass,
                             .fill_max = cell->fill_max,
                             .settle_max = cell->settle_max};
}

static clod_shear_cell ring_cell(const clod_case *from)
{
    const clod_case_ring_shear *ring = &from->ring_shear;
    return (clod_shear_cell){.key = "ring_shear",
                             .programme = &ring->programme,
                             .grain_material = ring->grain_material,
                             .radius_mean = ring->radius_mean,
                             .area = clod_ring_cell_area(ring),
                             .width = ring->outer_radius - ring->inner_radius,
                             .height = ring->depth,
                             .lid_mass = ring->lid_mass,
                             .fill_max = ring->fill_max,
                             .settle_max = ring->settle_max};
}

/** The cell of each kind of case that has a shear test. */
static clod_shear_cell (*const CELL[CLOD_CASE_KINDS])(const clod_case *from) = {
    [CLOD_CASE_RING_SHEAR] = ring_cell,
    [CLOD_CASE_JENIKE] = jenike_cell,
};

clod_shear_cell clod_shear_cell_of(const clod_case *from)
{
    return CELL[clod_case_kind_of(from)](from);
}
