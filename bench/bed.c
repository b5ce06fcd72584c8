#include "bed.h"

#include <stdio.h>
#include <string.h>

// The peers have the same numbers: bench/peers/packing.py and the decks beside it.
typedef struct bench_law {
    const char *name;
    clod_case_contact contact;
} bench_law;

#define COMMON                                                                                 \
    .restitution = 0.3, .friction = 0.35, .coulomb = CLOD_COULOMB_ADHESIVE,                    \
    .tangential = CLOD_TANGENTIAL_TANGENT, .tangential_ratio = 1.0

static const bench_law LAWS[] = {
    {"mepa",
     {.law = CLOD_LAW_MEPA,
      .exponent = 1.5,
      .k1 = 4.75e8,
      .k2 = 2.37e9,
      .k_adh = 3.56e8,
      .rolling = CLOD_ROLLING_EPSD2,
      .rolling_friction = 0.3,
      COMMON}},
    {"hertz", {.law = CLOD_LAW_HERTZ, .rolling = CLOD_ROLLING_NONE, COMMON}},
    {"hertz-rolling",
     {.law = CLOD_LAW_HERTZ, .rolling = CLOD_ROLLING_EPSD2, .rolling_friction = 0.3, COMMON}},
};
static const clod_case_material MATERIAL = {
    .density = 2481.3, .youngs_modulus = 119e9, .poissons_ratio = 0.34};

bool bench_bed_law(const char *name, clod_law *law, clod_status *status)
{
    for (size_t k = 0; k < sizeof LAWS / sizeof *LAWS; k++) {
        if (strcmp(name, LAWS[k].name) == 0) {
            *law = clod_law_make(&LAWS[k].contact, &MATERIAL, &MATERIAL);
            return true;
        }
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "--law %s: there are mepa, hertz and hertz-rolling", name);
}

/** Lines of a file, so that the rows are allocated once and memory is measured right. */
static size_t lines_of(FILE *file)
{
    size_t lines = 0;
    for (int c = getc(file); c != EOF; c = getc(file)) {
        lines += c == '\n';
    }
    rewind(file);
    return lines;
}

static bool read_grains(FILE *file, clod_state *state, clod_status *status)
{
    char line[512];
    unsigned long long id;
    double p[4], v[3];
    bool ok = clod_grains_reserve(&state->grains, lines_of(file), status);
    while (ok && fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%llu,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &id, &p[0], &p[1], &p[2], &p[3],
                   &v[0], &v[1], &v[2]) == 8) {
            ok = clod_grains_add(&state->grains, p, v, (double[3]){0.0}, MATERIAL.density, 0,
                                 id, status);
        }
    }
    return ok;
}

static bool read_box(FILE *file, clod_state *state)
{
    bool ok = true;
    for (int a = 0; a < 3; a++) {
        state->domain.periodic[a] = true;
        ok = ok && fscanf(file, "%lf", &state->domain.max[a]) == 1;
    }
    return ok;
}

bool bench_bed_read(const char *csv, const char *box, clod_state *state, clod_status *status)
{
    FILE *grains = fopen(csv, "r");
    FILE *periods = fopen(box, "r");
    bool ok = false;
    *state = (clod_state){.gravity = {0.0, 0.0, -9.81}, .build_motion = -1.0, .adhesion = 1.0};
    if (grains == NULL || periods == NULL) {
        clod_status_fail(status, CLOD_USAGE, "cannot open %s", grains == NULL ? csv : box);
    } else if (!read_box(periods, state)) {
        clod_status_fail(status, CLOD_USAGE, "%s: three lengths [m] are needed", box);
    } else {
        ok = read_grains(grains, state, status);
    }
    if (grains != NULL) {
        fclose(grains);
    }
    if (periods != NULL) {
        fclose(periods);
    }
    return ok;
}
