#include "sim/shear_cell.h"

#include "config/testers.h"
#include "setup/jenike_cell.h"
#include "setup/ring_cell.h"
#include "sim/testers.h"

/** Time in which the lid of a Jenike cell is twisted: to each side and back, at its edge. */
static double twisting(const clod_case_jenike *test)
{
    const double way = 4.0 * (double)test->twists * test->twist_angle * 0.5 * test->diameter;
    return test->twists > 0 ? way / test->programme.speed : 0.0;
}

clod_shear_cell clod_shear_cell_jenike(const clod_case *from)
{
    const clod_case_jenike *cell = &from->jenike;
    return (clod_shear_cell){.radius_mean = cell->radius_mean,
                             .area = clod_jenike_cell_area(cell),
                             .width = cell->diameter,
                             .height = cell->base_height + cell->ring_height,
                             .twisting = twisting(cell),
                             .lid_mass = cell->lid_mass,
                             .fill_max = cell->fill_max,
                             .settle_max = cell->settle_max};
}

clod_shear_cell clod_shear_cell_ring(const clod_case *from)
{
    const clod_case_ring_shear *ring = &from->ring_shear;
    return (clod_shear_cell){.radius_mean = ring->radius_mean,
                             .area = clod_ring_cell_area(ring),
                             .width = ring->outer_radius - ring->inner_radius,
                             .height = ring->depth,
                             .bar_count = ring->bar_count,
                             .bar_height = ring->bar_height,
                             .lid_mass = ring->lid_mass,
                             .fill_max = ring->fill_max,
                             .settle_max = ring->settle_max};
}

clod_shear_cell clod_shear_cell_of(const clod_case *from)
{
    clod_shear_cell cell = clod_testers_of(from)->cell(from);
    cell.key = clod_case_tester(from);
    cell.programme = clod_case_shear(from);
    cell.grain_material = clod_config_tester_of(from)->materials(from).grain;
    return cell;
}
