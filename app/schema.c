/**
 * @file schema.c
 * clod schema: the JSON Schema of case files.
 */

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>

#include "app.h"
#include "arguments.h"
#include "clod/schema.h"
#include "output.h"

int clod_app_schema(int argc, char **argv)
{
    const struct argp argp = {
        .doc =
            "Print the JSON Schema (draft 2020-12) of case files. Editors with a YAML language "
            "server complete and check keys with it: save it as clod.schema.json and begin the "
            "case with the line\n\n  # yaml-language-server: $schema=clod.schema.json",
    };
    if (!clod_arguments_parse(&argp, argc, argv, 0, NULL)) {
        return CLOD_FAILED;
    }
    char *text = clod_schema_json();
    if (text == NULL) {
        fputs("clod schema: no memory\n", stderr);
        return CLOD_FAILED;
    }
    clod_output_put(text);
    clod_output_put("\n");
    clod_schema_free(text);
    return EXIT_SUCCESS;
}
