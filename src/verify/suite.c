#include "verify/suite.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/assert.h"
#include "base/memory.h"
#include "config/suggest.h"
#include "output/file.h"

typedef struct entry {
    const char *name;
    clod_verify_test *run;
    const char *help;
    bool slow; ///< minutes and more: a bulk solid, not a contact
} entry;

static const entry TESTS[] = {
    {"chung-ooi-1", clod_verify_chung_ooi_1, "elastic impact of two equal spheres", false},
    {"chung-ooi-2", clod_verify_chung_ooi_2, "elastic impact of a sphere on a rigid plane",
     false},
    {"chung-ooi-3", clod_verify_chung_ooi_3, "restitution asked for and obtained", false},
    {"chung-ooi-4", clod_verify_chung_ooi_4, "oblique impact on a plane, constant speed",
     false},
    {"chung-ooi-5", clod_verify_chung_ooi_5, "oblique impact, constant normal speed", false},
    {"chung-ooi-6", clod_verify_chung_ooi_6, "spinning sphere on a plane", false},
    {"chung-ooi-7", clod_verify_chung_ooi_7, "two equal spinning spheres", false},
    {"chung-ooi-8", clod_verify_chung_ooi_8, "spinning sphere on a larger, heavier one", false},
    {"mepa-cycle", clod_verify_mepa_cycle, "mepa: load, unload, reload, pull off, meet again",
     false},
    {"mepa-restitution", clod_verify_mepa_restitution, "mepa: restitution and sticking", false},
    {"hooke-restitution", clod_verify_hooke_restitution, "hooke: restitution asked for", false},
    {"rolling", clod_verify_rolling, "a ball that rolls out, and a ball on an incline", false},
    {"chute", clod_verify_chute, "a grain on belts, chutes, spoon, hood and head pulley",
     false},
    {"luding-cycle", clod_verify_luding_cycle, "luding: the same, below and beyond its limit",
     false},
    {"luding-collision", clod_verify_luding_collision, "luding: MercuryDPM's collisions",
     false},
    {"eepa-cycle", clod_verify_eepa_cycle, "eepa: the same with f0 and with surface energy",
     false},
    {"passivity", clod_verify_passivity, "no contact makes energy in any step", false},
    {"passivity-sweep", clod_verify_passivity_sweep,
     "the same for every restitution with every friction", true},
    {"flow-function", clod_verify_flow_function, "uniaxial test: strength over consolidation",
     true},
    {"wall-friction", clod_verify_wall_friction,
     "smooth plates at their own friction, rough ones at the solid's", true},
    {"janssen", clod_verify_janssen, "silo: the wall carries part of the weight", true},
    {"beverloo", clod_verify_beverloo, "discharge rate of a flat-bottomed silo", true},
    {"repose", clod_verify_repose, "angle of repose against friction and rolling friction",
     true},
    {"stream-belt", clod_verify_stream_belt, "a stream of grains that a belt takes along",
     true},
    {"trough", clod_verify_trough, "a heap and a stream on a troughed belt, beside ISO 5048",
     true},
    {"mesh-drum", clod_verify_mesh_drum, "rotating drum as mesh beside the cylinder", true},
    {"mesh-hopper", clod_verify_mesh_hopper, "hopper as mesh beside cone and cylinder", true},
    {"mesh-ring", clod_verify_mesh_ring, "ring shear cell as meshes beside its shapes", true},
};
#define TEST_COUNT (sizeof TESTS / sizeof *TESTS)

size_t clod_verify_count(void)
{
    return TEST_COUNT;
}

const char *clod_verify_name(size_t k)
{
    return TESTS[k].name;
}

const char *clod_verify_help(size_t k)
{
    return TESTS[k].help;
}

bool clod_verify_is_slow(size_t k)
{
    return TESTS[k].slow;
}

static bool is_wanted(const clod_verify_options *options, const entry *test)
{
    bool wanted = options->name_count == 0;
    for (size_t k = 0; k < options->name_count; k++) {
        wanted |= strcmp(options->names[k], test->name) == 0;
    }
    return wanted && test->slow == options->slow;
}

/** The names that a run of this kind takes: "a, b, c"; the buffer is large enough for all. */
static const char *list_names(bool slow, char *buffer, size_t size)
{
    size_t length = 0;
    for (size_t t = 0; t < TEST_COUNT; t++) {
        if (TESTS[t].slow == slow) {
            length += (size_t)snprintf(buffer + length, size - length, "%s%s",
                                       length > 0 ? ", " : "", TESTS[t].name);
            CLOD_ASSERT(length < size);
        }
    }
    return buffer;
}

/** Is this the name of a test of the kind that is run? */
static bool check_name(const char *name, bool slow, clod_status *status)
{
    char names[512];
    char suggestion[128];
    clod_suggest near = clod_suggest_start(name);
    for (size_t t = 0; t < TEST_COUNT; t++) {
        if (strcmp(name, TESTS[t].name) != 0) {
            clod_suggest_offer(&near, TESTS[t].name);
        } else if (TESTS[t].slow == slow) {
            return true;
        } else {
            return clod_status_fail(
                status, CLOD_USAGE, "%s is %s test: run it %s --slow; %s --slow there are %s",
                name, slow ? "no slow" : "a slow", slow ? "without" : "with",
                slow ? "with" : "without", list_names(slow, names, sizeof names));
        }
    }
    clod_suggest_text(&near, suggestion, sizeof suggestion);
    return clod_status_fail(status, CLOD_USAGE,
                            "there is no test %s%s; there are %s; clod verify --list says what "
                            "they look at",
                            name, suggestion, list_names(slow, names, sizeof names));
}

static bool check_names(const clod_verify_options *options, clod_status *status)
{
    for (size_t k = 0; k < options->name_count; k++) {
        if (!check_name(options->names[k], options->slow, status)) {
            return false;
        }
    }
    return true;
}

/** Make a folder and those above it. */
static bool make_folders(const char *directory, clod_status *status)
{
    char path[2048];
    if ((size_t)snprintf(path, sizeof path, "%s", directory) >= sizeof path) {
        return clod_status_fail(status, CLOD_USAGE, "the name of the folder is too long");
    }
    for (char *at = path + 1;; at++) {
        const char stop = *at;
        if (stop != '/' && stop != '\0') {
            continue;
        }
        *at = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST) {
            return clod_status_fail(status, CLOD_FAILED, "%s: cannot be made: %s", path,
                                    strerror(errno));
        }
        if (stop == '\0') {
            return true;
        }
        *at = stop;
    }
}

static bool write_report(const clod_verify_report *report, const char *directory,
                         clod_status *status)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, clod_verify_report_name(report->slow));
    char *text = clod_verify_report_text(report);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %s", path);
    }
    // at one stroke: half a report would be taken for a file of the user by the next run
    const bool written = clod_file_replace(path, text, strlen(text), NULL, 0, status);
    clod_memory_free(text);
    return written;
}

bool clod_verify_run(const clod_verify_options *options, clod_verify_report *report,
                     clod_status *status)
{
    *report = (clod_verify_report){.slow = options->slow};
    if (!check_names(options, status) || !make_folders(options->directory, status)) {
        return false;
    }
    for (size_t t = 0; t < TEST_COUNT; t++) {
        if (!is_wanted(options, &TESTS[t])) {
            continue;
        }
        if (options->progress != NULL) {
            options->progress(options->context, TESTS[t].name);
        }
        const clod_verify_bench bench = {options->directory, TESTS[t].name, report,
                                         options->ranks};
        if (!TESTS[t].run(&bench, status)) {
            return false;
        }
    }
    return write_report(report, options->directory, status);
}
