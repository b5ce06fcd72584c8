#include "analysis/cells.h"

#include <math.h>

double clod_cells_error(double stated)
{
    return stated > 0.0 ? stated : (double)NAN;
}

void clod_cells_put(FILE *out, double value)
{
    if (isfinite(value)) {
        fprintf(out, ",%.10g", value);
    } else {
        fputs(isnan(value) ? "," : ",inf", out);
    }
}
