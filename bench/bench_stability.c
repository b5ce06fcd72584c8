/**
 * @file bench_stability.c
 * The largest stable time step of a bed (setup/stability.h), and what the bed does when it is
 * stepped below and above it, as rows of a table.
 *
 *   bench_stability CASE FOLDER PART slides|holds [FACTOR ...]
 *
 * FOLDER is that of a `clod run` of CASE, PART one of its parts. The walls are held, the weight is
 * taken away, the bed comes to rest, every grain is given a speed of up to 1 um/s along each axis:
 * far too little for a contact to open. With `holds` no contact slides or rolls at a limit, which
 * is what the largest stable step is for. Then it is stepped 4000 times with each FACTOR times the
 * largest stable step.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "measure/contacts.h"
#include "setup/stability.h"
#include "sim/sim.h"

#define REST_TAKES 12   ///< each begins with all grains standing still
#define REST_STEPS 2500 ///< of a take
#define REST_FACTOR 0.4
#define KICK 1e-6 // m/s
#define NO_LIMIT 1e12
#define TAKES 4
#define TAKE_STEPS 1000

static void give_up(const char *text)
{
    fprintf(stderr, "bench_stability: %s\n", text);
    exit(2);
}

static clod_stability measure(clod_step *step, clod_status *status)
{
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    clod_stability found;
    if (!clod_stability_measure(&found, step->state, &contacts, step->laws, status)) {
        give_up(status->text);
    }
    return found;
}

static void hold_all(clod_state *state)
{
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall *wall = &state->walls.wall[w];
        wall->load = CLOD_LOAD_NONE;
        wall->velocity = wall->surface_velocity = (clod_vec3){0.0, 0.0, 0.0};
        wall->spin = wall->servo_velocity = 0.0;
    }
    state->gravity[0] = state->gravity[1] = state->gravity[2] = 0.0; // no loose grain falls
}

/** Friction and rolling resistance without a limit, of contacts under tension too. */
static void hold_contacts(clod_laws *laws)
{
    for (int32_t l = 0; l < laws->count; l++) {
        clod_law *law = &laws->law[l];
        law->friction = law->friction > 0.0 ? NO_LIMIT : 0.0;
        law->coulomb = CLOD_COULOMB_FORCE;
        law->rolling_friction = law->rolling_friction > 0.0 ? NO_LIMIT : 0.0;
    }
}

/** Speeds of up to `most` [m/s], the same for a grain in every bed; it does not turn. */
static void set_speeds(clod_state *state, double most)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        for (uint64_t a = 0; a < 3; a++) {
            const double u =
                clod_random_uniform(0, CLOD_RANDOM_VELOCITY, state->grains.id[g], a);
            state->grains.velocity[g][a] = most * (2.0 * u - 1.0);
            state->grains.angular_velocity[g][a] = 0.0;
        }
    }
}

/** Step a copy of the bed, with its kinetic energy after every take. */
static void try_factor(const clod_sim *sim, double largest, double factor)
{
    clod_status status = {0};
    clod_state state = {0};
    clod_step step;
    const clod_step_options options = {.threads = 1};
    if (!clod_state_copy(&state, &sim->state, &status)) {
        give_up(status.text);
    }
    set_speeds(&state, KICK);
    state.dt = factor * largest;
    if (!clod_step_init(&step, &state, &sim->laws, &options, &status)) {
        give_up(status.text);
    }
    printf("| %.2f | %.3e | %.2e |", factor, state.dt,
           clod_measure_motion_of(&state).kinetic_energy);
    bool good = true;
    for (int t = 0; good && t < TAKES; t++) {
        good = clod_step_advance(&step, TAKE_STEPS, &status);
        printf(good ? " %.2e |" : " %.2e, stopped |",
               clod_measure_motion_of(&state).kinetic_energy);
    }
    printf("\n");
    fflush(stdout);
    clod_step_fini(&step);
    clod_state_fini(&state);
}

/** The bed at rest without weight between walls that are held; its contacts are in sim->state. */
static clod_stability settle(clod_sim *sim, bool holds, clod_status *status)
{
    const clod_stability before = measure(&sim->step, status);
    printf("%zu contacts; dt %.4g s; 2/omega without dash-pots %.4g s; largest stable step "
           "%.4g s: dt is %.3f of it\n",
           before.contacts, sim->state.dt, 2.0 / before.frequency, before.step,
           sim->state.dt / before.step);
    hold_all(&sim->state);
    if (holds) {
        hold_contacts(&sim->laws);
    }
    clod_step_fini(&sim->step);
    sim->state.dt = REST_FACTOR * before.step;
    bool good = clod_sim_take_up(sim, status);
    for (int t = 0; good && t < REST_TAKES; t++) {
        set_speeds(&sim->state, 0.0);
        good = clod_step_advance(&sim->step, REST_STEPS, status);
    }
    if (!good || !clod_step_export(&sim->step, status)) {
        give_up(status->text);
    }
    return measure(&sim->step, status);
}

int main(int argc, char **argv)
{
    clod_status status = {0};
    if (argc < 5) {
        give_up("usage: bench_stability CASE FOLDER PART slides|holds [FACTOR ...]");
    }
    const clod_sim_options options = {.threads = 1};
    clod_sim *sim = clod_sim_create_from_file(argv[1], &options, &status);
    if (sim == NULL || !clod_sim_read_checkpoint(sim, argv[2], argv[3], &status)) {
        give_up(status.text);
    }
    const clod_stability rest = settle(sim, strcmp(argv[4], "holds") == 0, &status);
    printf("at rest: largest stable step %.4g s, kinetic energy %.2e J\n\n", rest.step,
           clod_measure_motion_of(&sim->state).kinetic_energy);
    printf("| dt / largest stable | dt [s] | kinetic energy [J] at the start | after %d steps |"
           " %d | %d | %d |\n|---|---|---|---|---|---|---|\n",
           TAKE_STEPS, 2 * TAKE_STEPS, 3 * TAKE_STEPS, 4 * TAKE_STEPS);
    for (int k = 5; k < argc; k++) {
        try_factor(sim, rest.step, strtod(argv[k], NULL));
    }
    clod_sim_destroy(&sim);
    return 0;
}
