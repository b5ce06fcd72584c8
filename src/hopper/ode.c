#include "hopper/ode.h"

#include <math.h>
#include <stddef.h>

#define STAGES 7
#define SMALLEST 1e-13 // of a step, relative to 1 + |x|

static const double NODE[STAGES] = {0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};

static const double WEIGHT[STAGES][STAGES - 1] = {
    {0.0},
    {0.2},
    {3.0 / 40.0, 9.0 / 40.0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
};

/** Fifth order less fourth order. */
static const double DIFFERENCE[STAGES] = {
    71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
    -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};

static double scaled(double error, double value)
{
    return fabs(error) / (1.0 + fabs(value));
}

/** Where a step ends, which is where the rates of the last stage are. @param rate [STAGES] [out] */
static clod_ode_pair take(const clod_ode *self, double size, clod_ode_pair *rate)
{
    clod_ode_pair y = self->y;
    rate[0] = self->begun ? self->rate : self->rates(self->context, self->x, y);
    for (int s = 1; s < STAGES; s++) {
        y = self->y;
        for (int k = 0; k < s; k++) {
            y.a += size * WEIGHT[s][k] * rate[k].a;
            y.b += size * WEIGHT[s][k] * rate[k].b;
        }
        rate[s] = self->rates(self->context, self->x + NODE[s] * size, y);
    }
    return y;
}

/** Difference of the two orders. */
static double error_of(const clod_ode *self, double size, const clod_ode_pair *rate)
{
    clod_ode_pair sum = {0.0, 0.0};
    for (int s = 0; s < STAGES; s++) {
        sum.a += size * DIFFERENCE[s] * rate[s].a;
        sum.b += size * DIFFERENCE[s] * rate[s].b;
    }
    return isfinite(sum.a) && isfinite(sum.b)
               ? fmax(scaled(sum.a, self->y.a), scaled(sum.b, self->y.b))
               : (double)INFINITY;
}

clod_ode_pair clod_ode_try(const clod_ode *self, double size, double *error)
{
    clod_ode_pair rate[STAGES];
    const clod_ode_pair y = take(self, size, rate);
    if (error != NULL) {
        *error = error_of(self, size, rate);
    }
    return y;
}

bool clod_ode_advance(clod_ode *self, double end)
{
    for (;;) {
        const bool last = self->x + self->step >= end;
        const double size = last ? end - self->x : self->step;
        clod_ode_pair rate[STAGES];
        const clod_ode_pair y = take(self, size, rate);
        const double error = error_of(self, size, rate);
        const bool good = error <= self->tolerance;
        const double grow = 0.9 * pow(self->tolerance / fmax(error, 1e-30), 0.2);
        const double next = size * fmin(4.0, fmax(0.2, grow));
        if (good) {
            self->x = last ? end : self->x + size;
            self->y = y;
            self->rate = rate[STAGES - 1];
            self->begun = true;
            self->step = last ? fmax(self->step, next) : next;
            return true;
        }
        self->step = next;
        if (next < SMALLEST * (1.0 + fabs(self->x))) {
            return false;
        }
    }
}
