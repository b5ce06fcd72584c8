/**
 * @file bench_step.c
 * Whole steps on a periodic packing: grain-steps per second of the full MEPA law with friction
 * and rolling resistance, per number of threads and per instruction set.
 *
 *   bench_step PACKING.csv PACKING.box [steps] [threads] [simd]
 *
 * The packing has lines id,x,y,z,r,vx,vy,vz [m, m/s] after a header; the box its three periods.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "law/law.h"
#include "step/step.h"

// Copper ore, 5 % moisture (Table 1); restitution and rolling as in cases/copper-ore-5.
static const clod_case_contact ORE = {.law = CLOD_LAW_MEPA,
                                      .exponent = 1.5,
                                      .k1 = 4.75e8,
                                      .k2 = 2.37e9,
                                      .k_adh = 3.56e8,
                                      .restitution = 0.3,
                                      .friction = 0.35,
                                      .coulomb = CLOD_COULOMB_ADHESIVE,
                                      .tangential = CLOD_TANGENTIAL_TANGENT,
                                      .tangential_ratio = 1.0,
                                      .rolling = CLOD_ROLLING_EPSD2,
                                      .rolling_friction = 0.3};
static const clod_case_material MATERIAL = {
    .density = 2481.3, .youngs_modulus = 119e9, .poissons_ratio = 0.34};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void give_up(const char *text)
{
    fprintf(stderr, "bench_step: %s\n", text);
    exit(1);
}

static void read_packing(const char *csv, const char *box, clod_state *state)
{
    clod_status status = {0};
    FILE *file = fopen(csv, "r");
    FILE *periods = fopen(box, "r");
    if (file == NULL || periods == NULL) {
        give_up("cannot open the packing");
    }
    for (int a = 0; a < 3; a++) {
        state->domain.periodic[a] = true;
        if (fscanf(periods, "%lf", &state->domain.max[a]) != 1) {
            give_up("the box needs three lengths");
        }
    }
    char line[512];
    unsigned long long id;
    double p[4], v[3];
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%llu,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &id, &p[0], &p[1], &p[2], &p[3],
                   &v[0], &v[1], &v[2]) == 8 &&
            !clod_grains_add(&state->grains, p, v, (double[3]){0.0}, MATERIAL.density, 0, id,
                             &status)) {
            give_up(status.text);
        }
    }
    fclose(file);
    fclose(periods);
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        give_up("usage: bench_step PACKING.csv PACKING.box [steps] [threads] [simd] [ledger]");
    }
    const int64_t steps = argc > 3 ? atoll(argv[3]) : 2000;
    const clod_step_options options = {.threads = argc > 4 ? atoi(argv[4]) : 1,
                                       .simd = argc > 5 ? argv[5] : NULL};
    clod_state state = {.dt = 1e-7, .gravity = {0.0, 0.0, -9.81}, .build_motion = -1.0};
    read_packing(argv[1], argv[2], &state);
    clod_law law = clod_law_make(&ORE, &MATERIAL, &MATERIAL);
    const clod_laws laws = {.materials = 1, .count = 1, .law = &law};
    clod_step step;
    clod_status status = {0};
    const bool ledger = argc > 6 && strcmp(argv[6], "ledger") == 0;
    if (!clod_step_init(&step, &state, &laws, &options, &status) ||
        (ledger && !clod_step_open_ledger(&step, &status)) ||
        !clod_step_advance(&step, steps / 10 + 1, &status)) {
        give_up(status.text);
    }
    const double begin = now();
    if (!clod_step_advance(&step, steps, &status)) {
        give_up(status.text);
    }
    const double wall = now() - begin;
    if (!clod_step_export(&step, &status)) {
        give_up(status.text);
    }
    const double grains = (double)state.grains.count;
    printf("{\"simd\": \"%s\", \"threads\": %d, \"grains\": %zu, \"contacts_per_grain\": %.3f, "
           "\"near_per_contact\": %.3f, \"steps\": %lld, \"rebuilds\": %lld, \"refreshes\": "
           "%lld, \"grain_steps_per_s\": %.4g, \"ns_per_contact\": %.2f}\n",
           step.kernel->name, options.threads, state.grains.count,
           (double)state.contact_count / grains,
           (double)step.near.pairs.count * CLOD_LANES / (double)state.contact_count,
           (long long)steps, (long long)step.rebuilds, (long long)step.refreshes,
           grains * (double)steps / wall,
           1e9 * wall / ((double)steps * (double)state.contact_count));
    clod_step_fini(&step);
    clod_state_fini(&state);
    return 0;
}
