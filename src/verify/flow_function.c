// Flow function of a cohesive powder by the uniaxial test: what strength is left after which
// consolidation, for contacts that yield and contacts that do not. Thakur et al. (2014) found
// that without contact plasticity (k2 = k1) strength does not come from consolidation, with it
// strength rises, even when the pull of a contact is held constant, and more when it is not.
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fit.h"
#include "clod/run.h"
#include "tester/limits.h"
#include "verify/case_file.h"
#include "verify/suite.h"

#define SEEDS 3
#define STRESSES 4
#define POINTS (SEEDS * STRESSES)
#define CLEAR 5.0 ///< standard errors of a slope that is there beyond doubt
#define THAKUR "Thakur et al., Granular Matter 16 (2014) 383"
#define LIMITS "docs/theory/uniaxial.md"

/** Contacts of one powder. */
typedef struct powder {
    const char *name;
    double k2;    ///< N/m
    double k_adh; ///< N/m
} powder;

typedef enum powder_kind { ELASTIC, CONSTANT, GROWING, POWDERS } powder_kind;

#define K1 1.5e5 ///< N/m: mean overlap below 1 % of a radius at the largest stress

static const powder POWDER[POWDERS] = {
    [ELASTIC] = {"k2 = k1, constant pull", K1, 0.0},
    [CONSTANT] = {"k2 = 5 k1, constant pull", 5.0 * K1, 0.0},
    [GROWING] = {"k2 = 5 k1, pull grows with yield", 5.0 * K1, 0.2 * K1},
};

/** A flow function: STRESSES points of each seed. */
typedef struct flow {
    double sigma_1[POINTS], sigma_c[POINTS]; ///< Pa
    double overlap;                          ///< largest of all contacts, over the radius
    int flags;                               ///< things that went not as they should
} flow;

static const char CASE[] =
    "# Written by clod verify: a powder after Thakur et al. (2014); the numbers are ours, "
    "scaled\n"
    "# so that a grain's pull is a tenth of its load at 50 kPa. Mould and ends do not pull.\n"
    "title: Flow function, %s\n"
    "seed: %d\n"
    "materials: {powder: {density: 2500 kg/m3}, side: {}, base: {}}\n"
    "contacts:\n"
    "  default:\n"
    "    law: eepa\n"
    "    exponent: 1\n"
    "    k1: %g N/m\n"
    "    k2: %g N/m\n"
    "    k_adh: %g N/m\n"
    "    pull_off_force: 0.2 N\n"
    "    restitution: 0.4\n"
    "    friction: 0.5\n"
    "    coulomb: adhesive\n"
    "    tangential_ratio: 0.2857142857142857 # 2/7, as in the paper\n"
    "    rolling: epsd2 # for their shape: the paper's grains were pairs of spheres\n"
    "    rolling_friction: 0.1\n"
    "  powder-side: {friction: 0, rolling: none, pull_off_force: 0 N, k_adh: 0 N/m}\n"
    "  powder-base: {pull_off_force: 0 N, k_adh: 0 N/m}\n"
    "uniaxial:\n"
    "  grain_material: powder\n"
    "  side_material: side\n"
    "  base_material: base\n"
    "  lid_material: base\n"
    "  radius: {mean: 3.175 mm, sd: 0.32 mm, min: 2.5 mm, max: 3.85 mm}\n"
    "  diameter: 65 mm\n"
    "  height: 80 mm\n"
    "  grain_count: 1000\n"
    "  lid_damping: 0.05\n"
    "  consolidation_stresses: [10 kPa, 25 kPa, 50 kPa, 80 kPa]\n"
    "  fill_adhesion: 0 %%\n";

static double number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/** What the run found, from its summary. */
static bool read_summary(const char *directory, int seed, flow *self, clod_status *status)
{
    char path[4200];
    json_error_t error;
    snprintf(path, sizeof path, "%s/summary.json", directory);
    json_t *summary = json_load_file(path, 0, &error);
    if (summary == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s: %s", path, error.text);
    }
    const json_t *parts = json_object_get(summary, "parts");
    for (size_t p = 0; p < json_array_size(parts); p++) {
        const json_t *part = json_array_get(parts, p);
        self->flags += (int)json_array_size(json_object_get(part, "flags"));
        self->overlap = clod_verify_larger(self->overlap, number(part, "max_overlap"));
    }
    const json_t *points = json_object_get(summary, "flow_function");
    for (size_t s = 0; s < STRESSES; s++) {
        const json_t *point = json_array_get(points, s);
        self->sigma_1[(size_t)(seed - 1) * STRESSES + s] = number(point, "sigma_1_Pa");
        self->sigma_c[(size_t)(seed - 1) * STRESSES + s] = number(point, "sigma_c_Pa");
    }
    json_decref(summary);
    return true;
}

static bool run_case(const clod_verify_bench *bench, const char *path, const char *directory,
                     clod_status *status)
{
    clod_case *from = clod_case_load(path, NULL, 0, status);
    if (from == NULL) {
        return false;
    }
    char *report = NULL;
    const clod_run_options options = {
        .directory = directory, .fresh = true, .ranks = bench->ranks};
    const bool ok = clod_run(from, &options, &report, status);
    clod_run_free(report);
    clod_case_destroy(&from);
    return ok;
}

static bool run_powder(const clod_verify_bench *bench, powder_kind kind, flow *self,
                       clod_status *status)
{
    const powder *of = &POWDER[kind];
    for (int seed = 1; seed <= SEEDS; seed++) {
        char name[64];
        char text[sizeof CASE + 256];
        char path[4096];
        char directory[4096];
        snprintf(name, sizeof name, "flow-function-%d-%d", (int)kind + 1, seed);
        snprintf(text, sizeof text, CASE, of->name, seed, K1, of->k2, of->k_adh);
        if (!clod_verify_case_file(bench->directory, name, text, path, status)) {
            return false;
        }
        snprintf(directory, sizeof directory, "%s/cases/%s/run", bench->directory, name);
        if (!run_case(bench, path, directory, status) ||
            !read_summary(directory, seed, self, status)) {
            return false;
        }
    }
    return true;
}

/** Mean strength of the seeds after the s-th stress [Pa]. */
static double strength(const flow *self, size_t s)
{
    double sum = 0.0;
    for (size_t p = s; p < POINTS; p += STRESSES) {
        sum += self->sigma_c[p];
    }
    return sum / SEEDS;
}

static bool check_runs(const clod_verify_bench *bench, const powder *of, const flow *self,
                       clod_status *status)
{
    const clod_verify_expect none = {0.0, 0.0, false, LIMITS};
    const clod_verify_expect shallow = {0.0, CLOD_LIMITS_OVERLAP_MOST, false, LIMITS};
    return clod_verify_bench_check(bench, &none, self->flags, status,
                                   "%s: tests that did not rest or had no peak [1]",
                                   of->name) &&
           clod_verify_bench_check(bench, &shallow, self->overlap, status,
                                   "%s: largest overlap over the radius [1]", of->name);
}

/** k2 = k1: flat beside the powder whose pull grows, at a tenth of its slope or less. */
static bool check_flat(const clod_verify_bench *bench, const flow *self, const flow *growing,
                       clod_status *status)
{
    const clod_fit line = clod_fit_line(self->sigma_1, self->sigma_c, POINTS);
    const clod_fit steep = clod_fit_line(growing->sigma_1, growing->sigma_c, POINTS);
    const clod_verify_expect flat = {0.0, 0.1, false, THAKUR};
    return clod_verify_bench_check(bench, &flat, line.slope / steep.slope, status,
                                   "%s: its slope, %.4f with standard error %.4f, over that of "
                                   "the growing pull [1]",
                                   POWDER[ELASTIC].name, line.slope,
                                   clod_fit_slope_error(&line, POINTS));
}

/** With the same pull, the elastic powder's slope is below that of the plastic one. */
static bool check_flatter(const clod_verify_bench *bench, const flow *self, const flow *plastic,
                          clod_status *status)
{
    const clod_fit line = clod_fit_line(self->sigma_1, self->sigma_c, POINTS);
    const clod_fit steep = clod_fit_line(plastic->sigma_1, plastic->sigma_c, POINTS);
    const double error =
        hypot(clod_fit_slope_error(&line, POINTS), clod_fit_slope_error(&steep, POINTS));
    const clod_verify_expect yes = {1.0, 0.0, false, THAKUR};
    return clod_verify_bench_check(
        bench, &yes, steep.slope - line.slope > 2.0 * error, status,
        "%s: its slope is %.4f below that of k2 = 5 k1 with the same pull, above two errors of "
        "%.4f (1: yes)",
        POWDER[ELASTIC].name, steep.slope - line.slope, error);
}

/** k2 = 5 k1: a slope beyond doubt. */
static bool check_rise(const clod_verify_bench *bench, powder_kind kind, const flow *self,
                       clod_status *status)
{
    const clod_fit line = clod_fit_line(self->sigma_1, self->sigma_c, POINTS);
    const clod_verify_expect yes = {1.0, 0.0, false, THAKUR};
    if (!clod_verify_bench_check(
            bench, &yes, line.slope > CLEAR * clod_fit_slope_error(&line, POINTS), status,
            "%s: the slope %.3f is above %g standard errors of %.3f "
            "(1: yes)",
            POWDER[kind].name, line.slope, CLEAR, clod_fit_slope_error(&line, POINTS))) {
        return false;
    }
    if (kind == CONSTANT) {
        clod_verify_bench_record_miss(bench, "twelve specimens: 0.0105 +- 0.0018, 0.010 +- "
                                             "0.001 and 0.0117 +- 0.0024 with three sets of "
                                             "last bits");
    }
    return true;
}

/** Each consolidation leaves the solid stronger than the one before. */
static bool check_order(const clod_verify_bench *bench, const flow *self, clod_status *status)
{
    int rises = 0;
    for (size_t s = 1; s < STRESSES; s++) {
        rises += strength(self, s) > strength(self, s - 1);
    }
    const clod_verify_expect all = {STRESSES - 1.0, 0.0, false, THAKUR};
    return clod_verify_bench_check(bench, &all, rises, status,
                                   "%s: stresses whose strength is above that of the stress "
                                   "before, of %d",
                                   POWDER[GROWING].name, STRESSES - 1);
}

static bool write_curve(const clod_verify_bench *bench, const flow *found, clod_status *status)
{
    clod_verify_curve *curve =
        clod_verify_curve_open(bench, bench->test,
                               "sigma_1 [Pa],clod: k2 = k1 with constant pull: sigma_c [Pa],"
                               "clod: k2 = 5 k1 with constant pull: sigma_c [Pa],"
                               "clod: k2 = 5 k1 with growing pull: sigma_c [Pa]",
                               status);
    if (curve == NULL) {
        return false;
    }
    for (int kind = 0; kind < POWDERS; kind++) {
        for (size_t p = 0; p < POINTS; p++) {
            double row[1 + POWDERS] = {found[kind].sigma_1[p], NAN, NAN, NAN};
            row[1 + kind] = found[kind].sigma_c[p];
            clod_verify_curve_add(curve, row, 1 + POWDERS);
        }
    }
    return clod_verify_curve_close(&curve, status);
}

bool clod_verify_flow_function(const clod_verify_bench *bench, clod_status *status)
{
    flow found[POWDERS] = {0};
    for (powder_kind kind = 0; kind < POWDERS; kind++) {
        if (!run_powder(bench, kind, &found[kind], status) ||
            !check_runs(bench, &POWDER[kind], &found[kind], status)) {
            return false;
        }
    }
    return write_curve(bench, found, status) &&
           check_flat(bench, &found[ELASTIC], &found[GROWING], status) &&
           check_flatter(bench, &found[ELASTIC], &found[CONSTANT], status) &&
           check_rise(bench, CONSTANT, &found[CONSTANT], status) &&
           check_rise(bench, GROWING, &found[GROWING], status) &&
           check_order(bench, &found[GROWING], status);
}
