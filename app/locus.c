/**
 * @file locus.c
 * clod locus TABLE.csv: yield loci and flow function of shear points, wall yield loci, bulk
 * densities, angles of repose.
 */

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "arguments.h"
#include "clod/measured.h"
#include "clod/text_file.h"

enum { KEY_JSON = 256, KEY_CSV, KEY_SIGMA, KEY_TAU };

typedef struct request {
    const char *points, *output;
    clod_locus_defaults defaults;
    char *(*write)(const clod_measured *table);
    bool json, csv;
} request;

static const struct argp_option OPTIONS[] = {
    {"json", KEY_JSON, NULL, 0, "print everything as JSON", 0},
    {"csv", KEY_CSV, NULL, 0,
     "print one row per preshear stress, or per point, as CSV; warnings go to standard error",
     0},
    {"output", 'o', "FILE", 0, "write to FILE; - is standard output", 0},
    {"sigma-pre", KEY_SIGMA, "STRESS", 0,
     "preshear normal stress of rows without one, e.g. 10kPa", 0},
    {"tau-pre", KEY_TAU, "STRESS", 0, "preshear shear stress of rows without one", 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case KEY_JSON:
        self->write = clod_measured_json;
        self->json = true;
        return 0;
    case KEY_CSV:
        self->write = clod_measured_csv;
        self->csv = true;
        return 0;
    case 'o':
        self->output = argument;
        return 0;
    case KEY_SIGMA:
        self->defaults.sigma_pre = argument;
        return 0;
    case KEY_TAU:
        self->defaults.tau_pre = argument;
        return 0;
    case ARGP_KEY_ARG:
        if (self->points != NULL) {
            argp_error(state, "one table at a time");
        }
        self->points = argument;
        return 0;
    case ARGP_KEY_END:
        if (self->json && self->csv) {
            argp_error(state, "give either --json or --csv, not both");
        }
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which table?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static bool put(const request *self, const char *text, clod_status *status)
{
    if (self->output != NULL && strcmp(self->output, "-") != 0) {
        return clod_text_file_write(self->output, self->points, text, status);
    }
    return (fputs(text, stdout) >= 0 && fflush(stdout) == 0) ||
           clod_status_fail(status, CLOD_FAILED, "Cannot write the result: %s.",
                            strerror(errno));
}

/** A CSV has no place for warnings: they go to standard error. */
static void show_warning(void *context, const char *text)
{
    (void)context;
    fprintf(stderr, "clod locus: %s\n", text);
}

static bool run(const request *self, clod_status *status)
{
    clod_measured table;
    if (!clod_measured_read(self->points, &self->defaults, &table, status)) {
        clod_measured_fini(&table);
        return false;
    }
    if (self->csv) {
        clod_measured_warnings(&table, show_warning, NULL);
    }
    char *text = self->write(&table);
    const bool done = text != NULL
                          ? put(self, text, status)
                          : clod_status_fail(status, CLOD_FAILED, "No memory for the result.");
    clod_locus_free(text);
    clod_measured_fini(&table);
    return done;
}

int clod_app_locus(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "TABLE.csv",
        .doc =
            "Evaluate a table, simulated or measured: shear points to yield locus, Mohr circles "
            "and flow function; wall friction to wall yield locus, wall friction angles and "
            "adhesion; bulk densities to compressibility; angles of repose to their mean. TABLE.csv may be - for standard "
            "input.\vThe columns say what the table is; their units stand in its header.\n"
            "Shear points: sigma_pre [kPa], tau_pre "
            "[kPa], sigma_sh [kPa], tau_sh [kPa]; optional seed, rho_b [kg/m3], "
            "tau_pre_error [kPa], tau_sh_error [kPa], rho_b_error [kg/m3], "
            "rho_inside [kg/m3].\n"
            "Wall friction: sigma_w [kPa], tau_w [kPa] or phi_x [deg]; optional seed, "
            "sigma_w_error [kPa], tau_w_error [kPa] or phi_x_error [deg], steady (1; 0: the "
            "shear stress still changed), wall_stress [kPa], the normal stress that a simulation "
            "was asked for.\n"
            "Bulk densities: sigma_1 [kPa], rho_b [kg/m3]; optional sigma_1_error [kPa], "
            "rho_b_error [kg/m3].\n"
            "Angles of repose: angle_of_repose [deg], one row of each heap; optional "
            "angle_of_repose_error [deg].\n"
            "seed numbers specimens. Columns point, no, number, remark, comment and note are not read.",
    };
    request self = {.write = clod_measured_table};
    if (!clod_arguments_parse(&argp, argc, argv, 0, &self)) {
        return CLOD_FAILED;
    }
    clod_status status = {CLOD_OK, ""};
    if (!run(&self, &status)) {
        fprintf(stderr, "clod locus: %s\n", status.text);
        return (int)status.code;
    }
    return EXIT_SUCCESS;
}
