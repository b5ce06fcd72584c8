/**
 * libFuzzer target: the report of clod check, with any numbers in it, fits its text, and its
 * JSON is JSON.
 */

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "clod/check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** A text of the input, ended and of printable letters: texts of a case are UTF-8 for sure. */
static void make_text(char *text, size_t size)
{
    for (size_t k = 0; k + 1 < size && text[k] != '\0'; k++) {
        text[k] = (char)(' ' + (unsigned char)text[k] % 95);
    }
    text[size - 1] = '\0';
}

/** What bytes of chance must not be: pointers, enumerators, truth values and counts. */
static void make_valid(clod_check_report *report, const uint8_t flags[4])
{
    report->kind = (clod_case_kind)(flags[0] % CLOD_CASE_KINDS);
    report->path = "case.yaml";
    report->title = flags[1] % 2 == 0 ? NULL : "A \"title\"";
    report->reason = "the stiffest pair";
    report->pair_1 = flags[1] & 2 ? "ore" : NULL;
    report->pair_2 = flags[1] & 2 ? "steel" : NULL;
    report->simd = "avx2";
    report->step_given = (flags[2] & 1) != 0;
    report->pair_wall = (flags[2] & 2) != 0;
    report->rayleigh_imposed = (flags[2] & 4) != 0;
    report->busy = (flags[2] & 8) != 0;
    report->sheared = (flags[2] & 128) != 0;
    report->of_ranks.ranks = (flags[2] & 32) != 0 ? 4 : 0;
    report->plate_ridges = (flags[2] & 64) != 0 ? 39 : 0;
    report->soften = (flags[2] & 16) != 0 ? 100.0 : 0.0;
    report->warning_count = flags[3] % (CLOD_CHECK_WARNINGS + 1);
    report->note_count = flags[3] % (CLOD_CHECK_NOTES + 1);
    for (size_t w = 0; w < CLOD_CHECK_WARNINGS; w++) {
        make_text(report->warning[w], sizeof report->warning[w]);
    }
    for (size_t n = 0; n < CLOD_CHECK_NOTES; n++) {
        make_text(report->note[n], sizeof report->note[n]);
    }
}

/** The report as JSON that was read back; never NULL. */
static json_t *read_json(const clod_check_report *report)
{
    static char text[CLOD_CHECK_TEXT];
    json_error_t error;
    memset(text, 'x', sizeof text);
    json_t *json = clod_check_report_json(report, text) ? json_loads(text, 0, &error) : NULL;
    if (!json_is_object(json)) {
        abort();
    }
    return json;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static clod_check_report report, zeros;
    static char text[CLOD_CHECK_TEXT];
    if (size < 4) {
        return 0;
    }
    memset(&report, 0, sizeof report);
    memcpy(&report, data + 4, size - 4 < sizeof report ? size - 4 : sizeof report);
    make_valid(&report, data);
    memset(text, 'x', sizeof text);
    clod_check_report_text(&report, text);
    if (memchr(text, '\0', sizeof text) == NULL) {
        abort();
    }
    memset(&zeros, 0, sizeof zeros);
    make_valid(&zeros, data);
    json_t *json = read_json(&report);
    json_t *expected = read_json(&zeros);
    if (json_object_size(json) != json_object_size(expected)) {
        abort(); // a number that JSON cannot hold was left out
    }
    json_decref(json);
    json_decref(expected);
    return 0;
}
