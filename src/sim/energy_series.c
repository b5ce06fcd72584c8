#include "sim/energy_series.h"

const char *const clod_energy_series_columns[CLOD_ENERGY_SERIES_COLUMNS] = {
    "time [s]",          "translation [J]",    "rotation [J]",       "potential [J]",
    "stored_normal [J]", "stored_sliding [J]", "stored_rolling [J]", "lost_plastic [J]",
    "lost_dash_pot [J]", "lost_friction [J]",  "lost_rolling [J]",   "lag [J]",
    "wall_work [J]",     "exchanged [J]",      "residual [J]",       "residual_of_flow [1]",
};

/** Energy that has gone through the books: what is there, was lost, or left with grains [J]. */
static double flow_of(const clod_state *state, const clod_energies *now)
{
    const clod_ledger *ledger = &state->ledger;
    double lost = ledger->plastic + ledger->dash_pot + ledger->friction + ledger->rolling;
    for (int f = 0; f < CLOD_EXITS; f++) {
        lost += state->exchange.left_energy[f];
    }
    return now->translation + now->rotation + now->normal + now->sliding + now->rolling + lost;
}

bool clod_energy_series_row(clod_series *series, const clod_state *state,
                            const clod_energies *now, clod_status *status)
{
    const clod_ledger *ledger = &state->ledger;
    const double residual = clod_ledger_residual(ledger, now);
    const double flow = flow_of(state, now);
    const double row[CLOD_ENERGY_SERIES_COLUMNS] = {
        state->time,       now->translation,
        now->rotation,     now->potential,
        now->normal,       now->sliding,
        now->rolling,      ledger->plastic,
        ledger->dash_pot,  ledger->friction,
        ledger->rolling,   ledger->lag,
        ledger->wall_work, ledger->exchanged,
        residual,          flow > 0.0 ? residual / flow : 0.0,
    };
    return clod_series_row(series, row, status);
}
