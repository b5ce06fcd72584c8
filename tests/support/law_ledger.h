#pragma once
/**
 * @file law_ledger.h
 * One contact of src/law with its ledger, driven by hand; and laws of every kind for it.
 */

#include "law/law_energy.h"
#include "support/law_probe.h"

#define LEDGER_DT 1e-7
#define LEDGER_LAWS 8

/** One law of every kind and exponent; overlaps of some um. */
static inline clod_case_contact ledger_law(int k)
{
    clod_case_contact c = contact_ore();
    c.friction = 0.0;
    c.rolling = CLOD_ROLLING_NONE;
    switch (k) {
    case 0: // mepa, n = 3/2
        return c;
    case 1: // mepa, n = 1
        c.exponent = 1.0;
        c.k1 = 1e6;
        c.k2 = 5e6;
        c.k_adh = 1e6;
        return c;
    case 2: // mepa, any n
        c.exponent = 1.2;
        c.k1 = 2e7;
        c.k2 = 6e7;
        c.k_adh = 1e7;
        return c;
    case 3:
        c.law = CLOD_LAW_HERTZ;
        return c;
    case 4:
        c.law = CLOD_LAW_HOOKE;
        c.k1 = 1e6;
        return c;
    case 5: // constant pull
        c.law = CLOD_LAW_EEPA;
        c.pull_off_force = 0.2;
        return c;
    case 6: // pull of the plastic patch
        c.law = CLOD_LAW_EEPA;
        c.k_adh = 0.0;
        c.surface_energy = 2.0;
        return c;
    default:
        c.law = CLOD_LAW_LUDING;
        c.exponent = 1.0;
        c.k1 = 1e6;
        c.k2 = 5e6;
        c.k_adh = 1e6;
        c.plasticity_depth = 0.004;
        c.restitution = 0.5; // no loss of the history may have the dash-pot in it
        return c;
    }
}

/** One step of the probe from one motion to another; what it cost. */
static inline clod_law_dissipation ledger_step(law_probe *probe, const clod_law_motion *before,
                                               const clod_law_motion *now)
{
    const clod_law_memory memory = clod_law_memory_load(&probe->history, 0);
    clod_law_memory after = memory;
    const clod_law_result result = clod_law_contact(&probe->law, now, LEDGER_DT, &after);
    const clod_law_dissipation dissipated =
        clod_law_dissipate(&probe->law, now, &result, &after, before, &memory, LEDGER_DT);
    clod_law_memory_store(&probe->history, 0, result.closed, after);
    return dissipated;
}
