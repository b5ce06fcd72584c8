#include "sim/time_limit.h"

/** Of the limit, which is left at the end: what follows the checkpoint, and a clock that differs. */
#define SPARE 0.02

bool clod_time_limit_is_near(const clod_time_limit *self, const clod_time_spent *spent,
                             int jobs, double now)
{
    const double needed = 2.0 * (spent->turn + jobs * spent->checkpoint) + SPARE * self->all;
    return self->all > 0.0 && now - self->begin + needed >= self->all;
}

bool clod_time_limit_asks(const clod_time_limit *self, const clod_time_spent *spent, double now)
{
    return self->all > 0.0 && spent->checkpoint == 0.0 && now - self->begin >= 0.5 * self->all;
}
