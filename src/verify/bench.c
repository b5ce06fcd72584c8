#include "verify/bench.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

struct clod_verify_curve {
    FILE *out;
    char path[4096];
};

bool clod_verify_bench_check(const clod_verify_bench *self, const clod_verify_expect *expect,
                             double got, clod_status *status, const char *format, ...)
{
    clod_verify_row row = {.expected = expect->value,
                           .got = got,
                           .tolerance = expect->tolerance,
                           .relative = expect->relative};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(row.quantity, sizeof row.quantity, format, arguments);
    va_end(arguments);
    snprintf(row.test, sizeof row.test, "%s", self->test);
    snprintf(row.source, sizeof row.source, "%s", expect->source);
    return clod_verify_report_add(self->report, &row, status);
}

void clod_verify_bench_record_miss(const clod_verify_bench *self, const char *reason)
{
    clod_verify_report_record_miss(self->report, reason);
}

double clod_verify_larger(double most, double value)
{
    return value <= most || isnan(most) ? most : value;
}

void clod_verify_worst_offer(clod_verify_worst *self, double at, double expected, double got)
{
    const double off = fabs(got - expected) / fabs(expected);
    if (!(off <= self->off) && !isnan(self->off)) {
        *self = (clod_verify_worst){at, expected, got, off};
    }
}

clod_verify_curve *clod_verify_curve_open(const clod_verify_bench *bench, const char *name,
                                          const char *header, clod_status *status)
{
    clod_verify_curve *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the curve %s", name);
        return NULL;
    }
    snprintf(self->path, sizeof self->path, "%s/%s.csv", bench->directory, name);
    self->out = fopen(self->path, "w");
    if (self->out == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", self->path,
                         strerror(errno));
        clod_memory_free(self);
        return NULL;
    }
    fprintf(self->out, "%s\n", header);
    return self;
}

void clod_verify_curve_add(clod_verify_curve *self, const double *values, size_t count)
{
    for (size_t c = 0; c < count; c++) {
        const char *before = c > 0 ? "," : "";
        if (isfinite(values[c])) {
            fprintf(self->out, "%s%.9g", before, values[c]);
        } else {
            fprintf(self->out, "%s", before);
        }
    }
    fprintf(self->out, "\n");
}

bool clod_verify_curve_close(clod_verify_curve **self, clod_status *status)
{
    clod_verify_curve *curve = *self;
    *self = NULL;
    if (curve == NULL) {
        return true;
    }
    const bool written = ferror(curve->out) == 0;
    const bool closed = fclose(curve->out) == 0;
    const bool ok = (written && closed) ||
                    clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s",
                                     curve->path, strerror(errno));
    clod_memory_free(curve);
    return ok;
}
