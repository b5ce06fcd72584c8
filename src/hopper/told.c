#include "hopper/told.h"

#include <math.h>

bool clod_told_strength(const clod_hopper *self)
{
    return clod_curve_has_errors(&self->solid.strength);
}

static bool has_wall(const clod_hopper *self)
{
    return clod_curve_has_errors(&self->solid.wall);
}

/** Whether the stress of the outlet that is built is known: that of a critical one follows from the strength. */
static bool is_at_known_stress(const clod_hopper *self, const clod_hopper_found *found)
{
    const bool matters = self->solid.wall.count > 1;
    return clod_told_strength(self) || found->wish.outlet > 0.0 || !matters;
}

static bool has_limit(const clod_hopper *self, const clod_hopper_found *found)
{
    return found->wish.limit > 0.0 ? found->limit_error > 0.0
                                   : has_wall(self) && is_at_known_stress(self, found);
}

bool clod_told_is_sure(const clod_hopper *self, const clod_hopper_found *found)
{
    return found->wish.half_angle == 0.0 || (has_wall(self) && has_limit(self, found));
}

void clod_told_no_interval(clod_hopper_value *value)
{
    value->low = value->high = value->low_error = value->high_error = (double)NAN;
}

static bool is_told(const clod_hopper *self, const clod_hopper_found *found,
                    clod_hopper_number number)
{
    switch (number) {
    case CLOD_HOPPER_HALF_ANGLE:
    case CLOD_HOPPER_ARCH:
        return found->wish.half_angle > 0.0 || has_limit(self, found);
    case CLOD_HOPPER_LIMIT:
        return has_limit(self, found);
    case CLOD_HOPPER_DESIGN_PHI_W:
        return has_wall(self) && is_at_known_stress(self, found);
    case CLOD_HOPPER_PHI_W:
        return has_wall(self) && clod_told_strength(self);
    default:
        return clod_told_is_sure(self, found) && clod_told_strength(self);
    }
}

void clod_told_forget(const clod_hopper *self, clod_hopper_found *found)
{
    for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
        if (!is_told(self, found, (clod_hopper_number)n)) {
            clod_told_no_interval(&found->number[n]);
        }
    }
    const bool sure = clod_told_is_sure(self, found);
    if (sure && clod_told_strength(self)) {
        return;
    }
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        const bool of_wall = k == CLOD_HOPPER_FUNNEL || k == CLOD_HOPPER_UNPROVEN;
        found->share[k] =
            sure && of_wall && has_limit(self, found) ? found->share[k] : (double)NAN;
    }
    for (int q = 0; q < CLOD_HOPPER_QUANTILES; q++) {
        found->quantile[q] = (double)NAN;
    }
    for (int k = 0; k < CLOD_SOLID_CURVES; k++) {
        found->cause[k] = (double)NAN;
    }
    found->arching = found->held = found->untold = (double)NAN;
    found->arched_low = found->arched_high = (double)NAN;
}
