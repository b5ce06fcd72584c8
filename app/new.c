/**
 * @file new.c
 * clod new [TEMPLATE [FILE]]: an example case to start from.
 */

#include <argp.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "app.h"
#include "arguments.h"
#include "clod/status.h"
#include "clod_templates.h" // written by the build: tools/templates.cmake

#define TABLES 12 ///< at most

/** A further file of a template, which is written beside its case. */
typedef struct table {
    const char *name;
    const char *text;
} table;

typedef struct template
{
    const char *name;
    const char *file; ///< what the case is called unless the user says; NULL: NAME.yaml
    const char *help;
    const char *text;
    table tables[TABLES];
}
template;

static const template TEMPLATES[] = {
    {"ring-shear",
     NULL,
     "virtual ring shear test of copper ore with 5 % moisture",
     CLOD_TEMPLATE_RING_SHEAR,
     {{0}}},
    {"jenike", NULL, "virtual Jenike shear test of the same ore", CLOD_TEMPLATE_JENIKE, {{0}}},
    {"uniaxial",
     NULL,
     "virtual uniaxial test: flow function of the same ore",
     CLOD_TEMPLATE_UNIAXIAL,
     {{0}}},
    {"wall-friction",
     NULL,
     "virtual wall friction test of the same ore: wall yield locus",
     CLOD_TEMPLATE_WALL_FRICTION,
     {{0}}},
    {"free-run",
     NULL,
     "a box of grains under a lid: settle, then compress",
     CLOD_TEMPLATE_FREE_RUN,
     {{0}}},
    {"contact-bench",
     NULL,
     "one contact driven along a path of overlap, slip and roll",
     CLOD_TEMPLATE_CONTACT_BENCH,
     {{0}}},
    {"hopper",
     NULL,
     "design of a hopper from measured tables, for clod hopper",
     CLOD_TEMPLATE_HOPPER,
     {{"flow-function.csv", CLOD_TEMPLATE_HOPPER_FLOW_FUNCTION},
      {"wall.csv", CLOD_TEMPLATE_HOPPER_WALL}}},
    {"calibrate",
     NULL,
     "calibration of an ore's adhesion, for clod calibrate",
     CLOD_TEMPLATE_CALIBRATE,
     {{"ring.yaml", CLOD_TEMPLATE_CALIBRATE_RING}}},
    {"lab-to-outlet",
     "hopper.yaml",
     "a laboratory's tables to hopper, calibration, outlet, chute",
     CLOD_TEMPLATE_LAB_TO_OUTLET,
     {{"shear.csv", CLOD_TEMPLATE_LAB_TO_OUTLET_SHEAR},
      {"wall.csv", CLOD_TEMPLATE_LAB_TO_OUTLET_WALL},
      {"wall-liner.csv", CLOD_TEMPLATE_LAB_TO_OUTLET_WALL_LINER},
      {"wall-rust.csv", CLOD_TEMPLATE_LAB_TO_OUTLET_WALL_RUST},
      {"plan.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_PLAN},
      {"ring.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_RING},
      {"plan-wall.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_PLAN_WALL},
      {"wall.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_WALL_CASE},
      {"outlet.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_OUTLET},
      {"side.obj", CLOD_TEMPLATE_LAB_TO_OUTLET_SIDE},
      {"chute.yaml", CLOD_TEMPLATE_LAB_TO_OUTLET_CHUTE},
      {"chute.obj", CLOD_TEMPLATE_LAB_TO_OUTLET_CHUTE_MESH}}},
    {"transfer-chute",
     NULL,
     "moist ore over a transfer chute: belts, hood and spoon",
     CLOD_TEMPLATE_TRANSFER_CHUTE,
     {{"dry.yaml", CLOD_TEMPLATE_TRANSFER_CHUTE_DRY},
      {"chute.yaml", CLOD_TEMPLATE_TRANSFER_CHUTE_LAYOUT},
      {"chute.obj", CLOD_TEMPLATE_TRANSFER_CHUTE_MESH},
      {"geometry", CLOD_TEMPLATE_TRANSFER_CHUTE_GEOMETRY},
      {"chute.py", CLOD_TEMPLATE_TRANSFER_CHUTE_CHUTE},
      {"mesh.py", CLOD_TEMPLATE_TRANSFER_CHUTE_MESH_PY},
      {"belts.py", CLOD_TEMPLATE_TRANSFER_CHUTE_BELTS}}},
};

#define TEMPLATE_COUNT (sizeof TEMPLATES / sizeof TEMPLATES[0])

typedef struct request {
    const char *name;
    const char *file;
} request;

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    if (key != ARGP_KEY_ARG) {
        return ARGP_ERR_UNKNOWN;
    }
    if (state->arg_num == 0) {
        self->name = argument;
    } else if (state->arg_num == 1) {
        self->file = argument;
    } else {
        argp_error(state, "too many arguments");
    }
    return 0;
}

static void list(FILE *out)
{
    for (size_t i = 0; i < TEMPLATE_COUNT; i++) {
        fprintf(out, "%-14s %s\n", TEMPLATES[i].name, TEMPLATES[i].help);
    }
}

/** The case on standard output, for a pipe. */
static int print_case(const template *chosen)
{
    if (fputs(chosen->text, stdout) < 0 || fflush(stdout) != 0) {
        fprintf(stderr, "clod new: standard output: cannot be written: %s\n", strerror(errno));
        return CLOD_FAILED;
    }
    return EXIT_SUCCESS;
}

/** A script may be run by whoever may read it. */
static bool make_executable(FILE *out, const char *text)
{
    struct stat about;
    if (strncmp(text, "#!", 2) != 0) {
        return true;
    }
    return fstat(fileno(out), &about) == 0 &&
           fchmod(fileno(out), about.st_mode | (about.st_mode & 0444) >> 2) == 0;
}

static int write_text(const char *text, const char *path)
{
    FILE *out = fopen(path, "wx"); // never over a file that is there
    const char *slash = strrchr(path, '/');
    if (out == NULL && errno == ENOENT && slash != NULL) {
        const int length = (int)(slash - path);
        fprintf(stderr, "clod new: %s: there is no folder %.*s; make it first: mkdir -p %.*s\n",
                path, length, path, length, path);
        return CLOD_USAGE;
    }
    if (out == NULL) {
        fprintf(stderr, "clod new: %s: %s\n", path, strerror(errno));
        return errno == EEXIST ? CLOD_USAGE : CLOD_FAILED;
    }
    const bool written = fputs(text, out) >= 0 && make_executable(out, text);
    if (fclose(out) != 0 || !written) {
        fprintf(stderr, "clod new: %s: cannot be written: %s\n", path, strerror(errno));
        remove(path); // half a case is none, and would be in the way of the next try
        return CLOD_FAILED;
    }
    printf("wrote %s\n", path);
    return EXIT_SUCCESS;
}

/** Path of a file beside the case: owned, or NULL. */
static char *path_beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    const size_t folder = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    const size_t size = folder + strlen(name) + 1;
    char *beside = malloc(size);
    if (beside == NULL) {
        fputs("clod new: no memory\n", stderr);
    } else {
        snprintf(beside, size, "%.*s%s", (int)folder, path, name);
    }
    return beside;
}

/** Whether no file is there, which new never overwrites; else say why nothing was written. */
static bool is_free(const char *path)
{
    struct stat about;
    if (lstat(path, &about) == 0) {
        fprintf(stderr,
                "clod new: %s: File exists, and nothing was written; rename it, or write into "
                "another folder: clod new TEMPLATE FOLDER/FILE.yaml\n",
                path);
        return false;
    }
    if (errno != ENOENT) {
        fprintf(stderr, "clod new: %s: %s, and nothing was written\n", path, strerror(errno));
        return false;
    }
    return true;
}

/** The case, and its further files into its folder: all of them or, if one is there, none. */
static int write_case(const template *chosen, const char *path)
{
    char *beside[TABLES] = {NULL};
    int result = is_free(path) ? EXIT_SUCCESS : CLOD_USAGE;
    for (size_t i = 0; i < TABLES && chosen->tables[i].name != NULL && result == 0; i++) {
        beside[i] = path_beside(path, chosen->tables[i].name);
        result = beside[i] == NULL    ? CLOD_FAILED
                 : is_free(beside[i]) ? EXIT_SUCCESS
                                      : CLOD_USAGE;
    }
    result = result == EXIT_SUCCESS ? write_text(chosen->text, path) : result;
    for (size_t i = 0; i < TABLES; i++) {
        if (result == EXIT_SUCCESS && beside[i] != NULL) {
            result = write_text(chosen->tables[i].text, beside[i]);
        }
        free(beside[i]);
    }
    return result;
}

/** Text of --help, with the templates at its end. */
static void write_help(char *text, size_t size)
{
    size_t used = (size_t)snprintf(
        text, size,
        "Write an example case to start from; FILE is TEMPLATE.yaml unless given (of "
        "lab-to-outlet hopper.yaml), - is standard output. Further files of a template are "
        "written beside it. Without arguments the templates are listed. A file that exists is "
        "never overwritten.\v"
        "Templates:\n\n");
    for (size_t i = 0; i < TEMPLATE_COUNT && used < size; i++) {
        used += (size_t)snprintf(text + used, size - used, "  %-14s %s\n", TEMPLATES[i].name,
                                 TEMPLATES[i].help);
    }
}

int clod_app_new(int argc, char **argv)
{
    char help[2048];
    write_help(help, sizeof help);
    const struct argp argp = {
        .parser = parse,
        .args_doc = "[TEMPLATE [FILE]]",
        .doc = help,
    };
    request self = {NULL, NULL};
    if (!clod_arguments_parse(&argp, argc, argv, 0, &self)) {
        return CLOD_FAILED;
    }
    if (self.name == NULL) {
        list(stdout);
        return EXIT_SUCCESS;
    }
    for (size_t i = 0; i < TEMPLATE_COUNT; i++) {
        if (strcmp(TEMPLATES[i].name, self.name) == 0) {
            if (self.file != NULL && strcmp(self.file, "-") == 0) {
                return print_case(&TEMPLATES[i]);
            }
            char path[64];
            const char *usual = TEMPLATES[i].file;
            snprintf(path, sizeof path, "%s%s", usual != NULL ? usual : self.name,
                     usual != NULL ? "" : ".yaml");
            return write_case(&TEMPLATES[i], self.file != NULL ? self.file : path);
        }
    }
    fprintf(stderr, "clod new: there is no template %s; templates are\n", self.name);
    list(stderr);
    return CLOD_USAGE;
}
