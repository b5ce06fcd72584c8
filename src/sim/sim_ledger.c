// What has come and gone, and where the energy went.
#include "sim/sim.h"

_Static_assert((int)CLOD_SIM_SIDES == (int)CLOD_FACES, "sides of the domain");

bool clod_sim_exchange_look(const clod_sim *self, clod_sim_exchange *exchange,
                            clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(exchange, status)) {
        return false;
    }
    const clod_exchange *from = &self->state.exchange;
    *exchange = (clod_sim_exchange){.added = from->added,
                                    .removed = from->removed,
                                    .added_mass = from->added_mass,
                                    .removed_mass = from->removed_mass,
                                    .walls_removed = from->walls_removed};
    for (int f = 0; f < CLOD_FACES; f++) {
        exchange->left[f] = (clod_sim_left){.grains = from->left[f],
                                            .mass = from->left_mass[f],
                                            .energy = from->left_energy[f]};
    }
    return true;
}

bool clod_sim_open_ledger(clod_sim *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !clod_sim_settle(self, status)) {
        return false;
    }
    for (int a = 0; a < 3; a++) {
        if (self->state.domain.periodic[a] && self->state.gravity[a] != 0.0) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s: gravity has a part along %c (%g m/s2), in which the domain is periodic: "
                "potential energy has no value there; set that part of gravity to 0 in the "
                "case",
                __func__, "xyz"[a], self -> state.gravity[a]);
        }
    }
    return clod_step_open_ledger(&self->step, status);
}

bool clod_sim_ledger_look(clod_sim *self, clod_sim_ledger *ledger, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(ledger, status) ||
        !clod_sim_settle(self, status)) {
        return false;
    }
    const clod_ledger *from = &self->state.ledger;
    if (from->open == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the ledger is not open; call clod_sim_open_ledger first, "
                                "or set output.energy in the case",
                                __func__);
    }
    const clod_energies now = clod_step_energies(&self->step);
    *ledger = (clod_sim_ledger){.plastic = from->plastic,
                                .dash_pot = from->dash_pot,
                                .friction = from->friction,
                                .rolling = from->rolling,
                                .lag = from->lag,
                                .wall_work = from->wall_work,
                                .exchanged = from->exchanged,
                                .residual = clod_ledger_residual(from, &now)};
    return true;
}
