// Summaries of tests that give no result, or only a part of it: what is known is written.

#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "clod/locus.h"
#include "sim/ring_report.h"
#include "sim/uniaxial_report.h"
#include "support/case_of.h"
#include "tester/uniaxial.h"

#define HEAD                                                                                   \
    "materials:\n"                                                                             \
    "  ore: {density: 2481.3 kg/m3}\n"                                                         \
    "  side: {}\n"                                                                             \
    "contacts:\n"                                                                              \
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"          \
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35}\n"
#define MATERIALS                                                                              \
    "  grain_material: ore\n"                                                                  \
    "  side_material: side\n"                                                                  \
    "  base_material: side\n"                                                                  \
    "  lid_material: side\n"                                                                   \
    "  radius: {mean: 3 mm, sd: 0.1 mm, min: 2.9 mm, max: 3.1 mm}\n"

static const char RING[] = HEAD "ring_shear:\n" MATERIALS "  preshear_stress: 10 kPa\n"
                                "  shear_stresses: [2 kPa, 5 kPa, 8 kPa]\n";
static const char MOULD[] =
    HEAD "uniaxial:\n" MATERIALS "  consolidation_stresses: [10 kPa, 20 kPa, 40 kPa]\n";

/** A case with a folder, and what the user was told. */
typedef struct bench {
    clod_case *from;
    clod_run_options options;
    clod_job_shared sim;
    clod_folder *open;
    char folder[64];
    char told[512];
} bench;

static void note(void *context, const char *text)
{
    bench *self = context;
    snprintf(self->told, sizeof self->told, "%s", text);
}

static void begin(bench *self, const char *text)
{
    clod_status status = {0};
    *self = (bench){.options = {.notice = note, .context = self}};
    snprintf(self->folder, sizeof self->folder, P_tmpdir "/clod-reports-XXXXXX");
    assert_non_null(mkdtemp(self->folder));
    self->from = case_of(text, NULL);
    self->open = clod_folder_open(self->folder, &status);
    if (self->open == NULL) {
        fail_msg("%s", status.text);
    }
    self->sim = (clod_job_shared){.from = self->from,
                                  .options = &self->options,
                                  .directory = self->folder,
                                  .folder = self->open};
}

static void end(bench *self, const char *table)
{
    char path[128];
    const char *const names[] = {table, "summary.json", ".clod-lock"};
    clod_folder_close(&self->open);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        snprintf(path, sizeof path, "%s/%s", self->folder, names[k]);
        remove(path);
    }
    assert_int_equal(rmdir(self->folder), 0); // nothing else was written
    clod_case_destroy(&self->from);
}

static json_t *summary_of(const bench *self)
{
    char path[128];
    snprintf(path, sizeof path, "%s/summary.json", self->folder);
    return json_load_file(path, 0, NULL);
}

/** The summary of a test that gave no result, for this reason. */
static json_t *incomplete_summary_of(const bench *self, const char *reason)
{
    json_t *summary = summary_of(self);
    assert_string_equal(json_string_value(json_object_get(summary, "incomplete")), reason);
    return summary;
}

/** Lines of a table. */
static size_t lines_of(const bench *self, const char *table)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", self->folder, table);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    size_t lines = 0;
    for (int c = getc(in); c != EOF; c = getc(in)) {
        lines += c == '\n' ? 1u : 0u;
    }
    fclose(in);
    return lines;
}

/** Preshear, reversal and three points on a line; `tau` is the shear stress of the second. */
static void fill_ring(clod_part part[5], clod_ring_shear test[5], double tau)
{
    memset(part, 0, 5 * sizeof *part);
    memset(test, 0, 5 * sizeof *test);
    const double stresses[] = {2e3, 5e3, 8e3};
    for (int p = 0; p < 5; p++) {
        part[p].test = &test[p];
        part[p].point = p == 0 ? CLOD_RING_PRESHEAR : p == 1 ? CLOD_RING_REVERSE : p - 2;
        part[p].ok = true;
        part[p].grains = 100;
        snprintf(part[p].name, sizeof part[p].name, p < 2 ? "before-%d" : "point-%d", p);
        test[p].preshear_stress = test[p].preshear_normal = 10e3;
        test[p].preshear_shear = 7e3;
        test[p].preshear_error = 100.0;
        test[p].preshear_density = 1500.0;
        test[p].preshear_height = 0.02;
        if (p > 1) {
            test[p].shear_stress = test[p].point_normal = stresses[p - 2];
            test[p].point_shear = p == 3 ? tau : 1e3 + 0.6 * stresses[p - 2];
        }
    }
}

static void complete_ring_test(void **state)
{
    (void)state;
    bench b;
    clod_part part[5];
    clod_ring_shear test[5];
    clod_status status = {0};
    char *report = NULL;
    begin(&b, RING);
    fill_ring(part, test, 4e3);
    assert_true(clod_ring_report(&b.sim, part, 2, 3, &report, &status));
    assert_non_null(strstr(report, CLOD_LOCUS_ONE_SPECIMEN));
    clod_run_free(report);
    json_t *summary = summary_of(&b);
    assert_null(json_object_get(summary, "incomplete"));
    const json_t *loci = json_object_get(json_object_get(summary, "locus"), "loci");
    assert_int_equal(json_array_size(loci), 1);
    assert_string_equal(
        json_string_value(json_object_get(json_array_get(loci, 0), "errors_note")),
        CLOD_LOCUS_ONE_SPECIMEN);
    assert_string_equal(b.told, "");
    json_decref(summary);
    end(&b, "points.csv");
}

static json_malloc_t allocate; ///< the program's, for jansson
static long left;              ///< of its calls that still succeed; below 0: one has failed

static void *allocate_some(size_t size)
{
    return allocate(left-- == 0 ? PTRDIFF_MAX : size); // so many bytes there are not
}

// Whichever call for memory fails: a test that is told to be good has its locus.
static void no_locus_is_lost_without_memory(void **state)
{
    (void)state;
    bench b;
    clod_part part[5];
    clod_ring_shear test[5];
    json_free_t release;
    json_get_alloc_funcs(&allocate, &release);
    begin(&b, RING);
    fill_ring(part, test, 4e3);
    int failed = 0;
    bool all_found = false;
    for (long k = 0; !all_found; k++) {
        clod_status status = {0};
        char *report = NULL;
        json_set_alloc_funcs(allocate_some, release);
        left = k;
        const bool good = clod_ring_report(&b.sim, part, 2, 3, &report, &status);
        all_found = left >= 0;
        json_set_alloc_funcs(allocate, release);
        if (good) {
            json_t *summary = summary_of(&b);
            assert_true(json_is_object(json_object_get(summary, "locus")));
            json_decref(summary);
        } else {
            assert_int_equal(status.code, CLOD_FAILED);
            assert_non_null(strstr(status.text, "memory"));
            failed++;
        }
        clod_run_free(report);
    }
    assert_true(failed > 3);
    end(&b, "points.csv");
}

// A shear stress below zero is that of no solid: no locus, but all that was measured stays.
static void points_without_a_locus(void **state)
{
    (void)state;
    bench b;
    clod_part part[5];
    clod_ring_shear test[5];
    clod_status status = {0};
    char *report = NULL;
    begin(&b, RING);
    fill_ring(part, test, -20.0);
    part[3].mean_overlap = (double)NAN; // no number of a part may cost the others theirs
    assert_false(clod_ring_report(&b.sim, part, 2, 3, &report, &status));
    assert_null(report);
    assert_int_equal(status.code, CLOD_FAILED);
    assert_string_equal(status.text,
                        "the test ran to its end, but its points give no yield locus: Preshear "
                        "at 10.000 kPa: Point 2: the peak shear stress is -20; it must "
                        "be 0 or more.");
    clod_ring_report_finished(&b.sim, part, 2, 3, status.text);
    json_t *summary = incomplete_summary_of(&b, status.text);
    assert_true(json_is_null(json_object_get(summary, "locus")));
    const json_t *parts = json_object_get(summary, "parts");
    assert_int_equal(json_array_size(parts), 5);
    check_close(json_real_value(json_object_get(json_array_get(parts, 3), "shear_stress_Pa")),
                -20.0, 0.0);
    assert_true(json_is_null(json_object_get(json_array_get(parts, 3), "mean_overlap")));
    assert_int_equal(lines_of(&b, "points.csv"), 1 + 3);
    assert_non_null(strstr(b.told, "what is known of the 5 finished parts is in"));
    json_decref(summary);
    end(&b, "points.csv");
}

static void ring_test_that_failed_on_its_way(void **state)
{
    (void)state;
    bench b;
    clod_part part[5];
    clod_ring_shear test[5];
    begin(&b, RING);
    fill_ring(part, test, 4e3);
    part[2].ok = false; // of the points only the last two are finished
    clod_ring_report_finished(&b.sim, part, 2, 3, "the disk is full");
    json_t *summary = incomplete_summary_of(&b, "the disk is full");
    const json_t *parts = json_object_get(summary, "parts");
    assert_int_equal(json_array_size(parts), 4);
    assert_string_equal(json_string_value(json_object_get(json_array_get(parts, 2), "part")),
                        "point-3");
    assert_int_equal(lines_of(&b, "points.csv"), 1 + 2);
    json_decref(summary);
    end(&b, "points.csv");

    begin(&b, RING);
    part[0].ok = part[1].ok = part[3].ok = part[4].ok = false;
    clod_ring_report_finished(&b.sim, part, 2, 3, "the disk is full");
    assert_string_equal(b.told, "");
    end(&b, "points.csv"); // nothing is known, nothing is written
}

/** The filled mould and three strengths; the last falls when asked. */
static void fill_mould(clod_part part[4], clod_uniaxial test[4], double last)
{
    memset(part, 0, 4 * sizeof *part);
    memset(test, 0, 4 * sizeof *test);
    const double stresses[] = {0.0, 10e3, 20e3, 40e3};
    const double strengths[] = {0.0, 3e3, 5e3, last};
    for (int p = 0; p < 4; p++) {
        part[p].test = &test[p];
        part[p].point = p - 1;
        part[p].ok = true;
        part[p].grains = p == 0 ? 1 : 100;
        snprintf(part[p].name, sizeof part[p].name, "stress-%d", p);
        test[p].stress = test[p].sigma_1 = test[p].sigma_base = stresses[p];
        test[p].strength = strengths[p];
        test[p].strength_error = 100.0;
        test[p].solid_fraction = 0.5;
        test[p].density = 1250.0;
        test[p].unloaded_height = 0.1;
        test[p].area = 0.005;
    }
}

static void uniaxial_test_whose_strength_falls(void **state)
{
    (void)state;
    bench b;
    clod_part part[4];
    clod_uniaxial test[4];
    clod_status status = {0};
    char *report = NULL;
    begin(&b, MOULD);
    fill_mould(part, test, 4e3);
    assert_true(clod_uniaxial_report(&b.sim, part, 3, &report, &status));
    assert_non_null(strstr(report, "sigma_c falls from 5.000 to 4.000 kPa while the"));
    assert_non_null(strstr(report, CLOD_LOCUS_ONE_SPECIMEN));
    assert_non_null(strstr(report, "\n1 grain, dt"));
    clod_run_free(report);
    fill_mould(part, test, 6e3);
    assert_true(clod_uniaxial_report(&b.sim, part, 3, &report, &status));
    assert_null(strstr(report, "sigma_c falls"));
    clod_run_free(report);
    json_t *summary = summary_of(&b);
    assert_null(json_object_get(summary, "incomplete"));
    const json_t *points = json_object_get(summary, "flow_function");
    assert_int_equal(json_array_size(points), 3);
    assert_string_equal(
        json_string_value(json_object_get(json_array_get(points, 0), "errors_note")),
        CLOD_LOCUS_ONE_SPECIMEN);
    json_decref(summary);
    end(&b, "flow_function.csv");
}

static void uniaxial_test_that_failed_on_its_way(void **state)
{
    (void)state;
    bench b;
    clod_part part[4];
    clod_uniaxial test[4];
    begin(&b, MOULD);
    fill_mould(part, test, 6e3);
    part[2].ok = false;
    clod_uniaxial_report_finished(&b.sim, part, 3, "a grain left the mould");
    json_t *summary = incomplete_summary_of(&b, "a grain left the mould");
    assert_int_equal(json_array_size(json_object_get(summary, "parts")), 3);
    assert_int_equal(json_array_size(json_object_get(summary, "flow_function")), 2);
    assert_int_equal(lines_of(&b, "flow_function.csv"), 1 + 2);
    json_decref(summary);
    end(&b, "flow_function.csv");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(complete_ring_test),
        cmocka_unit_test(no_locus_is_lost_without_memory),
        cmocka_unit_test(points_without_a_locus),
        cmocka_unit_test(ring_test_that_failed_on_its_way),
        cmocka_unit_test(uniaxial_test_whose_strength_falls),
        cmocka_unit_test(uniaxial_test_that_failed_on_its_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
