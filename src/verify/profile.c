#include "verify/profile.h"

#include <math.h>

#include "analysis/fit.h"

void clod_verify_profile_find(clod_verify_profile *self, const double (*place)[4], size_t count)
{
    double top[CLOD_VERIFY_COLUMNS][CLOD_VERIFY_COLUMNS] = {{0.0}};
    const double rows = fmax(1.0, floor(self->depth / self->width));
    const size_t across = (size_t)fmin(rows, CLOD_VERIFY_COLUMNS);
    for (size_t g = 0; g < count; g++) {
        const double along = (place[g][0] - self->begin) / self->width;
        if (!(along >= 0.0 && along < (double)self->count)) {
            continue;
        }
        const double turns = place[g][1] / self->depth;
        const size_t row = (size_t)((turns - floor(turns)) * (double)across) % across;
        double *highest = &top[(size_t)along][row];
        *highest = fmax(*highest, place[g][2] + place[g][3]);
    }
    for (size_t c = 0; c < self->count; c++) {
        self->x[c] = self->begin + ((double)c + 0.5) * self->width;
        self->height[c] = 0.0;
        for (size_t r = 0; r < across; r++) {
            self->height[c] += top[c][r] / (double)across;
        }
    }
}

double clod_verify_profile_angle(const clod_verify_profile *self, double least, double *error)
{
    const double degrees = 180.0 / M_PI;
    size_t count = 0;
    while (count < self->count && self->height[count] >= least) {
        count++;
    }
    *error = nan("");
    if (count < 4) {
        return nan("");
    }
    const clod_fit line = clod_fit_line(self->x, self->height, count);
    const double variance = line.residual / (double)(count - 2) / line.sxx;
    *error = degrees * sqrt(variance) / (1.0 + line.slope * line.slope);
    return -degrees * atan(line.slope);
}
