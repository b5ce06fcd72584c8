#include "parallel/fixed.h"

/** Multiples of which the limbs are. */
static const double UNIT[CLOD_FIXED_LIMBS] = {1.0, 0x1p-40, 0x1p-80};

void clod_fixed_carry(clod_fixed *self)
{
    for (int k = CLOD_FIXED_LIMBS - 1; k > 0; k--) {
        for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) {
            // downwards: what stays is at least 0, so the same sum has the same limbs
            const double up = floor(self->limb[k][c] / UNIT[k - 1]) * UNIT[k - 1];
            self->limb[k][c] -= up;
            self->limb[k - 1][c] += up;
        }
    }
    for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) {
        if (!(fabs(self->limb[0][c]) < CLOD_FIXED_MOST)) {
            self->limb[0][c] = NAN;
        }
    }
}

void clod_fixed_merge(clod_fixed *self, const clod_fixed *other)
{
    for (int k = 0; k < CLOD_FIXED_LIMBS; k++) {
        for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) {
            self->limb[k][c] += other->limb[k][c];
        }
    }
    clod_fixed_carry(self);
}

void clod_fixed_value(const clod_fixed *self, double value[CLOD_FIXED_COLUMNS])
{
    clod_fixed carried = *self;
    clod_fixed_carry(&carried);
    for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) { // cancellation is exact from above
        value[c] = carried.limb[0][c] + carried.limb[1][c] + carried.limb[2][c];
    }
}
