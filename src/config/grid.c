#include "config/grid.h"

#include "base/cell_count.h"

double clod_grid_cells(const double low[3], const double high[3], double cell)
{
    double cells = 1.0;
    for (int a = 0; a < 3; a++) {
        cells *= clod_cell_count(high[a] - low[a], cell);
    }
    return cells;
}
