#include "verify/luding.h"

#include <math.h>

double clod_verify_luding_limit(const clod_verify_luding *self)
{
    return self->k2 / (self->k2 - self->k1) * self->depth * self->diameter;
}

double clod_verify_luding_stiffness(const clod_verify_luding *self, double most)
{
    const double share = fmin(most / clod_verify_luding_limit(self), 1.0);
    return self->k1 + (self->k2 - self->k1) * share;
}

double clod_verify_luding_elastic(const clod_verify_luding *self, double overlap, double most)
{
    const double k2 = clod_verify_luding_stiffness(self, most);
    const double plastic = (1.0 - self->k1 / k2) * fmin(most, clod_verify_luding_limit(self));
    return k2 * (overlap - plastic);
}

double clod_verify_luding_pull(const clod_verify_luding *self, double most)
{
    const double k2 = clod_verify_luding_stiffness(self, most);
    return (k2 - self->k1) / (k2 + self->k_adh) * fmin(most, clod_verify_luding_limit(self));
}

double clod_verify_luding_left(const clod_verify_luding *self, double overlap)
{
    // With k2 = k1 + h m: h m^2 = (k1 + h m + k_adh) overlap, and m > 0.
    const double h = (self->k2 - self->k1) / clod_verify_luding_limit(self);
    const double half = 0.5 * overlap;
    return half + sqrt(half * half + (self->k1 + self->k_adh) / h * overlap);
}

double clod_verify_luding_force(const void *law, double overlap, double *most)
{
    const clod_verify_luding *self = law;
    if (overlap <= 0.0) {
        *most = 0.0;
        return 0.0;
    }
    if (overlap > *most) {
        *most = fmin(overlap, clod_verify_luding_limit(self));
    }
    const double elastic = clod_verify_luding_elastic(self, overlap, *most);
    const double adhesive = -self->k_adh * overlap;
    if (elastic >= adhesive) {
        return elastic;
    }
    const double k2 = clod_verify_luding_stiffness(self, *most);
    *most = (k2 + self->k_adh) / (k2 - self->k1) * overlap;
    return adhesive;
}
