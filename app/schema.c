/**
 * @file schema.c
 * clod schema: the JSON Schema of case files.
 */

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>

#include "app.h"
#include "clod/schema.h"

int clod_app_schema(int argc, char **argv)
{
    const struct argp argp = {
        .doc =
            "Print the JSON Schema (draft 2020-12) of case files. Editors with a YAML language "
            "server complete and check keys with it: save it as clod.schema.json and begin the "
            "case with the line\n\n  # yaml-language-server: $schema=clod.schema.json",
    };
    argp_parse(&argp, argc, argv, 0, NULL, NULL);
    char *text = clod_schema_json();
    if (text == NULL) {
        fputs("clod schema: out of memory\n", stderr);
        return CLOD_FAILED;
    }
    puts(text);
    clod_schema_free(text);
    return EXIT_SUCCESS;
}
