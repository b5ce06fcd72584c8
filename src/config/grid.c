#include "config/grid.h"

#include <math.h>

double clod_grid_cells(const double low[3], const double high[3], double cell)
{
    double cells = 1.0;
    for (int a = 0; a < 3; a++) {
        cells *= fmax(1.0, ceil((high[a] - low[a]) / cell * (1.0 - 1e-12)));
    }
    return cells;
}
