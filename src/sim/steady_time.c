#include "sim/steady_time.h"

#include <math.h>

#include "sim/outputs.h"

/** Of a block or a step: times are sums and products of decimal numbers. */
#define ROUNDING 1e-6
#define FAR_AWAY 1e15 ///< steps

clod_steady_time clod_steady_time_of(const clod_case *from, double begin, double dt)
{
    const double whole = (double)clod_outputs_of(from, dt).steps * dt;
    const double since =
        from->output.has_steady_since ? from->output.steady_since : whole * (2.0 / 3.0);
    const double length = fmax(whole - since, dt); // since may lie behind the last step
    return (clod_steady_time){begin + since, length / CLOD_STEADY_BLOCKS};
}

int64_t clod_steady_time_steps(double moment, double time, double dt)
{
    const double steps = ceil((moment - time) / dt - ROUNDING);
    return (int64_t)fmax(fmin(steps, FAR_AWAY), -FAR_AWAY);
}

double clod_steady_time_within(const clod_steady_time *self, double from, double to)
{
    return fmax(0.0, to - fmax(from, self->since));
}

int clod_steady_time_edges(const clod_steady_time *self, double time)
{
    const double blocks = floor((time - self->since) / self->block + ROUNDING);
    return (int)fmin(fmax(blocks + 1.0, 0.0), CLOD_STEADY_BLOCKS + 1);
}

int clod_steady_time_block(const clod_steady_time *self, double time)
{
    const int block = clod_steady_time_edges(self, time) - 1;
    return block < CLOD_STEADY_BLOCKS ? block : CLOD_STEADY_BLOCKS - 1;
}

double clod_steady_time_deviation(const double *values, int count)
{
    double sum = 0.0, squares = 0.0;
    int number = 0;
    for (int k = 0; k < count; k++) {
        if (!isnan(values[k])) {
            sum += values[k];
            number++;
        }
    }
    for (int k = 0; k < count; k++) {
        const double off = isnan(values[k]) ? 0.0 : values[k] - sum / number;
        squares += off * off;
    }
    return number > 1 ? sqrt(squares / (number - 1)) : (double)NAN;
}
