#include "config/region_clear.h"

#include <math.h>

#include "config/region.h"

/** Whether a grain turns within a way of length `way`. */
static bool turns(double v, double g, double way)
{
    return v * g < 0.0 && v * v < 2.0 * fabs(g) * way;
}

/** Longest time that a grain is within a way along one axis [s]. */
static double time_within(double v, double g, double way)
{
    const double speed = fabs(v), pull = fabs(g);
    if (turns(v, g, way)) {
        return (speed + sqrt(2.0 * pull * way)) / pull;
    }
    const double gained = (v * g < 0.0 ? -2.0 : 2.0) * pull * way;
    const double sum = speed + sqrt(speed * speed + gained); // twice the mean speed
    return sum > 0.0 ? 2.0 * way / sum : HUGE_VAL;
}

/** Least speed in the direction of `v` at which no grain turns inside along axis `a`: it comes out at
 *  the end, or by a side without gravity before it turns. */
static double enough_for(int a, const double size[3], const double v[3], const double g[3])
{
    const double speed = hypot(hypot(v[0], v[1]), v[2]);
    const double up = fabs(v[a]) / speed, pull = fabs(g[a]);
    double enough = sqrt(2.0 * pull * size[a]) / up;
    for (int b = 0; b < 3; b++) {
        if (b != a && v[b] != 0.0 && g[b] == 0.0) {
            enough = fmin(enough, sqrt(pull * size[b] / (up * fabs(v[b]) / speed)));
        }
    }
    return enough;
}

clod_region_clear clod_region_clear_of(const clod_case_region *region, const double velocity[3],
                                       const double gravity[3])
{
    double size[3], time[3], rate = 0.0;
    clod_region_row(region)->size(region, size);
    for (int a = 0; a < 3; a++) {
        time[a] = time_within(velocity[a], gravity[a], size[a]);
        rate += 1.0 / time[a];
    }
    clod_region_clear self = {.time = rate > 0.0 ? 1.0 / rate : HUGE_VAL};
    for (int a = 0; a < 3; a++) {
        const double beside = fmin(time[(a + 1) % 3], time[(a + 2) % 3]);
        if (turns(velocity[a], gravity[a], size[a]) &&
            beside > fabs(velocity[a] / gravity[a])) {
            self.falls_back = true;
            self.rise = velocity[a] * velocity[a] / (2.0 * fabs(gravity[a]));
            self.height = size[a];
            self.enough = enough_for(a, size, velocity, gravity);
        }
    }
    return self;
}
