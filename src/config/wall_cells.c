#include "config/wall_cells.h"

#include <math.h>
#include <stddef.h>

const char *const CLOD_WALL_CELL_NAMES[] = {
    [CLOD_CASE_CELL_RING] = "ring", [CLOD_CASE_CELL_STRAIGHT] = "straight", NULL};

static const clod_wall_cell CELLS[] = {
    [CLOD_CASE_CELL_RING] = {.annulus = true, .bars = true, .turns = true},
    [CLOD_CASE_CELL_STRAIGHT] = {0},
};

const clod_wall_cell *clod_wall_cell_of(const clod_case_wall_friction *test)
{
    return &CELLS[test->cell];
}

double clod_wall_cell_inner(const clod_case_wall_friction *test)
{
    return clod_wall_cell_of(test)->annulus ? test->inner_radius : 0.0;
}

double clod_wall_cell_width(const clod_case_wall_friction *test)
{
    const double outer = test->outer_radius;
    return clod_wall_cell_of(test)->annulus ? outer - test->inner_radius : 2.0 * outer;
}

double clod_wall_cell_area(const clod_case_wall_friction *test)
{
    const double inner = clod_wall_cell_inner(test);
    return M_PI * (test->outer_radius * test->outer_radius - inner * inner);
}

int64_t clod_wall_cell_bars(const clod_case_wall_friction *test)
{
    return clod_wall_cell_of(test)->bars ? test->bar_count : 0;
}
