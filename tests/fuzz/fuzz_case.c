/**
 * libFuzzer target: no text may crash the loader of case files, and the echo of a case that
 * loads must load again to the same echo.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "clod/case.h"
#include "clod/schema.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/** libfyaml 0.7.12 loses 512 bytes with a text of five or more doubled single quotes. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libfyaml\n";
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static clod_status status;
    // a first line that begins with "#set " is an override as well
    char override[256] = "";
    const char *const overrides[] = {override};
    size_t count = 0;
    if (size > 5 && memcmp(data, "#set ", 5) == 0) {
        const uint8_t *end = memchr(data, '\n', size);
        const size_t length = (size_t)((end == NULL ? data + size : end) - data) - 5;
        if (length < sizeof override) {
            memcpy(override, data + 5, length);
            count = 1;
        }
    }
    clod_case *first =
        clod_case_parse("fuzz.yaml", (const char *)data, size, overrides, count, &status);
    if (first == NULL) {
        return 0;
    }
    char *echo = clod_case_echo(first);
    clod_case *second = clod_case_parse("fuzz.yaml", echo, strlen(echo), NULL, 0, &status);
    if (second == NULL) {
        abort(); // the echo does not load
    }
    char *again = clod_case_echo(second);
    if (strcmp(echo, again) != 0) {
        abort(); // the echo says something else
    }
    clod_schema_free(echo);
    clod_schema_free(again);
    clod_case_destroy(&first);
    clod_case_destroy(&second);
    return 0;
}
