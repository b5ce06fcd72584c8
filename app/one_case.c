#include "one_case.h"

#include <stdio.h>
#include <stdlib.h>

#include "arguments.h"

bool clod_one_case_init(clod_one_case *self, const struct argp *argp, int argc, char **argv,
                        void *input)
{
    self->overrides = calloc((size_t)argc + 1, sizeof *self->overrides);
    if (self->overrides == NULL) {
        fprintf(stderr, "%s: out of memory\n", argv[0]);
        return false;
    }
    if (!clod_arguments_parse(argp, argc, argv, 0, input)) {
        free(self->overrides);
        return false;
    }
    return true;
}

error_t clod_one_case_parse(clod_one_case *self, int key, char *argument,
                            struct argp_state *state)
{
    switch (key) {
    case 'S':
        self->overrides[self->override_count++] = argument;
        return 0;
    case ARGP_KEY_ARG:
        if (self->path != NULL) {
            argp_error(state, "one case at a time");
        }
        self->path = argument;
        return 0;
    case ARGP_KEY_END:
        if (self->path == NULL) {
            argp_error(state, "which case? %s writes an example", self->example);
        }
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

clod_case *clod_one_case_load(const clod_one_case *self, clod_status *status)
{
    return clod_case_load(self->path, self->overrides, self->override_count, status);
}

int clod_one_case_fini(clod_one_case *self, char **argv, bool good, const clod_status *status)
{
    free(self->overrides);
    self->overrides = NULL;
    if (good) {
        return EXIT_SUCCESS;
    }
    fprintf(stderr, "%s: %s\n", argv[0], status->text);
    return status->code == CLOD_OK ? CLOD_FAILED : (int)status->code;
}
