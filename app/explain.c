/**
 * @file explain.c
 * clod explain [KEY...]: what the keys of case files, hoppers and plans mean.
 */

#include <argp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "app.h"
#include "arguments.h"
#include "calibrate/calibrate.h"
#include "clod/hopper.h"
#include "clod/schema.h"
#include "output.h"

typedef struct request {
    bool manual;
    int first; ///< index of the first KEY in argv
} request;

static const struct argp_option OPTIONS[] = {
    {"manual", 'm', NULL, 0, "print the manual of all keys, in Markdown", 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    (void)argument;
    switch (key) {
    case 'm':
        self->manual = true;
        return 0;
    case ARGP_KEY_ARG:
        self->first = state->next - 1;
        state->next = state->argc;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/** All kinds of file that this clod reads. */
static const clod_schema *const *schemas(void)
{
    static const clod_schema *all[4]; // the last is NULL
    size_t count = 0;
    all[count++] = clod_schema_case();
    all[count++] = clod_hopper_schema();
#if CLOD_GSL
    all[count] = clod_calibrate_schema();
#endif
    return all;
}

/** Print an owned text and free it; false when there is none. */
static bool print(char *text)
{
    if (text != NULL) {
        clod_output_put(text);
    }
    clod_schema_free(text);
    return text != NULL;
}

static int without_memory(void)
{
    fputs("clod explain: no memory\n", stderr);
    return CLOD_FAILED;
}

int clod_app_explain(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "[KEY...]",
        .doc =
            "Explain keys of a case file, of the case of a hopper and of the plan of a calibration: kind, unit, range, default, source. KEY is a path "
            "such as ring_shear.depth, or the last part of one, such as k_adh. The verb that "
            "reads such a file, run, hopper or calibrate, lists its topmost keys, and stands before a key "
            "that several files have, hopper.wall_friction. Without KEY, list all keys.",
    };
    request self = {.first = argc};
    if (!clod_arguments_parse(&argp, argc, argv, ARGP_IN_ORDER, &self)) {
        return CLOD_FAILED;
    }
    clod_status status = {CLOD_OK, ""};
    if (self.manual) {
        return print(clod_schema_manual(schemas())) ? EXIT_SUCCESS : without_memory();
    }
    if (self.first == argc) {
        return print(clod_schema_explain(schemas(), NULL, &status)) ? EXIT_SUCCESS
                                                                    : without_memory();
    }
    for (int i = self.first; i < argc; i++) {
        if (!print(clod_schema_explain(schemas(), argv[i], &status))) {
            fprintf(stderr, "clod explain: %s\n", status.text);
            return (int)status.code;
        }
    }
    return EXIT_SUCCESS;
}
