#pragma once
/**
 * @file ledger.h
 * The energy ledger of a state: what has gone since it was opened (docs/theory/energy.md).
 */

#include <stdint.h>

typedef struct clod_ledger {
    int64_t open;     ///< 0: nothing is recorded, and the step costs nothing more
    double start;     ///< J, kinetic, potential and stored energy when it was opened
    double plastic;   ///< J, lost by plasticity and adhesion
    double dash_pot;  ///< J, lost in dash-pots
    double friction;  ///< J, lost by sliding
    double rolling;   ///< J, lost by rolling resistance
    double lag;       ///< J, work beyond that of forces with an earlier velocity; either sign
    double wall_work; ///< J, done by the walls on the grains
    double
        exchanged; ///< J, brought in by grains and walls that came, less what others took away
} clod_ledger;

/** Energies of one moment [J]. */
typedef struct clod_energies {
    double translation, rotation; ///< kinetic
    double potential;             ///< in gravity, zero at the origin
    double normal;                ///< stored by overlaps
    double sliding, rolling;      ///< stored by tangential and rolling springs
} clod_energies;

static inline double clod_energies_sum(const clod_energies *e)
{
    return e->translation + e->rotation + e->potential + e->normal + e->sliding + e->rolling;
}

/** Energy that has appeared from nowhere since the ledger was opened [J]: 0 is right. */
static inline double clod_ledger_residual(const clod_ledger *self, const clod_energies *now)
{
    const double lost = self->plastic + self->dash_pot + self->friction + self->rolling;
    return clod_energies_sum(now) - self->start + lost + self->lag - self->wall_work -
           self->exchanged;
}
