#include "arguments.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

bool clod_arguments_parse(const struct argp *argp, int argc, char **argv, unsigned flags,
                          void *input)
{
    const error_t error = argp_parse(argp, argc, argv, flags, NULL, input);
    if (error != 0) {
        fprintf(stderr, "%s: the arguments cannot be read: %s\n", argv[0],
                error == ENOMEM ? "no memory" : strerror(error));
    }
    return error == 0;
}
