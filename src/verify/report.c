#include "verify/report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "clod/version.h"

static bool judge(const clod_verify_row *row)
{
    const double scale = row->relative ? fabs(row->expected) : 1.0;
    return fabs(row->got - row->expected) <= row->tolerance * scale;
}

bool clod_verify_report_add(clod_verify_report *self, const clod_verify_row *row,
                            clod_status *status)
{
    if (self->count == self->capacity) {
        const size_t wanted = 2 * self->capacity + 64;
        clod_verify_row *grown =
            clod_memory_grow(self->rows, self->capacity, wanted, sizeof *self->rows);
        if (grown == NULL) {
            return clod_status_fail(status, CLOD_FAILED, "no memory for the report");
        }
        self->rows = grown;
        self->capacity = wanted;
    }
    clod_verify_row *added = &self->rows[self->count++];
    *added = *row;
    added->passed = judge(row);
    self->misses += !added->passed;
    return true;
}

void clod_verify_report_record_miss(clod_verify_report *self, const char *reason)
{
    clod_verify_row *row = &self->rows[self->count - 1];
    if (row->passed && self->slow) {
        return;
    }
    snprintf(row->known, sizeof row->known, "%s", reason);
    if (row->passed) {
        self->misses++;
    } else {
        self->misses--;
        self->known++;
    }
}

void clod_verify_fini(clod_verify_report *self)
{
    clod_memory_free(self->rows);
    *self = (clod_verify_report){0};
}

static void write_row(FILE *out, const clod_verify_row *row)
{
    fprintf(out, "| %s | %s | %.9g | %s | %.9g | ", row->test, row->quantity, row->expected,
            row->source, row->got);
    if (row->relative) {
        fprintf(out, "%.3g %%", 100.0 * row->tolerance);
    } else {
        fprintf(out, "%.3g", row->tolerance);
    }
    fprintf(out, " | %s", row->passed ? "yes" : "**MISS**");
    if (row->known[0] != '\0') {
        fprintf(out, row->passed ? ", **but recorded as a miss**: %s" : ", recorded: %s",
                row->known);
    }
    fprintf(out, " |\n");
}

static const char VERIFICATION[] =
    "# Verification\n\n"
    "Written by `clod verify`; `make verify` renews docs/verification.md with its plots.\n"
    "Each test stepped the case files under its name in `cases/`; `clod run` takes them\n"
    "too. SI units where none is named. Expected values come from the source that is\n"
    "named, never from clod; a tolerance without % is absolute. A recorded miss is known\n"
    "and has its reason beside it; it counts as missed when it passes.\n";

static const char VALIDATION[] =
    "# Validation\n\n"
    "Written by `clod verify --slow`; `make validate` renews docs/validation.md and a page "
    "for\n"
    "each test, `make validate NAMES=...` those of the tests that are named. Whole beds of\n"
    "grains beside laws of bulk solids and the literature; the case files are in `cases/`, "
    "and\n"
    "`clod run` takes them too. SI units where none is named; a tolerance without % is\n"
    "absolute. A recorded miss is known and has its reason beside it; beds are chaotic, so "
    "with\n"
    "other last bits it may pass.\n";

const char *clod_verify_report_name(bool slow)
{
    return slow ? "validation.md" : "verification.md";
}

/** Rows [begin, end) as a table, under how many there are and how many miss. */
static void write_rows(FILE *out, const clod_verify_report *self, size_t begin, size_t end)
{
    size_t misses = 0;
    size_t known = 0;
    for (size_t r = begin; r < end; r++) {
        const clod_verify_row *row = &self->rows[r];
        const bool recorded = row->known[0] != '\0';
        misses += row->passed == recorded;
        known += !row->passed && recorded;
    }
    fprintf(out,
            "%zu quantities, %zu missed; %zu recorded misses.\n\n"
            "| test | quantity | expected | source | got | tolerance | pass |\n"
            "|---|---|---|---|---|---|---|\n",
            end - begin, misses, known);
    for (size_t r = begin; r < end; r++) {
        write_row(out, &self->rows[r]);
    }
}

/** A section for each test, which says with which program: they may be run one by one. */
static void write_sections(FILE *out, const clod_verify_report *self)
{
    size_t begin = 0;
    while (begin < self->count) {
        const char *test = self->rows[begin].test;
        size_t end = begin + 1;
        while (end < self->count && strcmp(self->rows[end].test, test) == 0) {
            end++;
        }
        fprintf(out, "%s## %s\n\n`clod verify --slow %s` of %s: ", begin > 0 ? "\n" : "", test,
                test, clod_version_text());
        write_rows(out, self, begin, end);
        begin = end;
    }
}

char *clod_verify_report_text(const clod_verify_report *self)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "%s\n", self->slow ? VALIDATION : VERIFICATION);
    if (self->slow) {
        write_sections(out, self);
    } else {
        write_rows(out, self, 0, self->count);
    }
    return clod_text_close(&text);
}
