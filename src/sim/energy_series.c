#include "sim/energy_series.h"

const char *const clod_energy_series_columns[CLOD_ENERGY_SERIES_COLUMNS] = {
    "time [s]",          "translation [J]",    "rotation [J]",         "potential [J]",
    "stored_normal [J]", "stored_sliding [J]", "stored_rolling [J]",   "lost_plastic [J]",
    "lost_dash_pot [J]", "lost_friction [J]",  "lost_rolling [J]",     "lag [J]",
    "wall_work [J]",     "residual [J]",       "residual_of_flow [1]",
};

/** Energy that has gone through the books: what was there, came from walls, and was lost [J].
 */
static double flow_of(const clod_ledger *ledger, const clod_energies *now)
{
    const double lost = ledger->plastic + ledger->dash_pot + ledger->friction + ledger->rolling;
    return now->translation + now->rotation + now->normal + now->sliding + now->rolling + lost;
}

bool clod_energy_series_row(clod_series *series, const clod_state *state,
                            const clod_energies *now, clod_status *status)
{
    const clod_ledger *ledger = &state->ledger;
    const double residual = clod_ledger_residual(ledger, now);
    const double flow = flow_of(ledger, now);
    const double row[CLOD_ENERGY_SERIES_COLUMNS] = {
        state->time,       now->translation, now->rotation,
        now->potential,    now->normal,      now->sliding,
        now->rolling,      ledger->plastic,  ledger->dash_pot,
        ledger->friction,  ledger->rolling,  ledger->lag,
        ledger->wall_work, residual,         flow > 0.0 ? residual / flow : 0.0,
    };
    return clod_series_row(series, row, status);
}
