// Rules between the keys of a conveyor belt.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/check.h"

#define MOST_FACETS 1e6

static void fail(clod_loader *loader, const char *path, const char *key, const char *text)
{
    char whole[CLOD_LOAD_PATH + 64];
    snprintf(whole, sizeof whole, "%s.belt%s%s", path, key[0] == '\0' ? "" : ".", key);
    clod_check_fail(loader, whole, "%s", text);
}

static void check_trough(clod_loader *loader, const char *path, const clod_case_belt *belt)
{
    const double last = belt->runs[belt->run_count - 1].length;
    if (belt->middle_roll >= belt->width) {
        char text[128];
        snprintf(
            text, sizeof text,
            "leaves nothing of the width, %.4g mm, for the wing rolls; make it shorter than that",
            1e3 * belt->width);
        fail(loader, path, "middle_roll", text);
    } else if (belt->transition > last) {
        char text[128];
        snprintf(text, sizeof text,
                 "%.6g m is longer than the last run, %.6g m; shorten it, or lengthen the run",
                 belt->transition, last);
        fail(loader, path, "transition", text);
    } else if (belt->pulley.radius > 0.0 && belt->transition == 0.0) {
        fail(loader, path, "",
             "a trough has to flatten before the pulley; give transition, as a rule the width "
             "of the belt or more");
    }
}

static void check_skirts(clod_loader *loader, const char *path, const clod_case_belt *belt)
{
    const clod_case_belt_skirts *skirts = &belt->skirts;
    const bool told = // where the skirts may end follows from a transition that is right
        belt->idler_angle > 0.0 && belt->transition > belt->runs[belt->run_count - 1].length;
    double length = -belt->transition;
    for (size_t r = 0; r < belt->run_count; r++) {
        length += belt->runs[r].length;
    }
    if (skirts->from >= skirts->to) {
        char text[128];
        snprintf(text, sizeof text,
                 "%.6g m must be larger than from, %.6g m: skirts begin at from and end at to",
                 skirts->to, skirts->from);
        fail(loader, path, "skirts.to", text);
    } else if (!told && skirts->to > length * (1.0 + 1e-12)) {
        char text[128];
        snprintf(text, sizeof text,
                 "%.6g m is beyond the runs, or within the transition; at most %.6g m",
                 skirts->to, length);
        fail(loader, path, "skirts.to", text);
    }
    if (skirts->distance > belt->width) {
        char text[128];
        snprintf(text, sizeof text, "%.6g m is wider than the belt; at most its width, %.6g m",
                 skirts->distance, belt->width);
        fail(loader, path, "skirts.distance", text);
    }
}

/** Refuse facets so fine that nobody can have meant them. */
static void check_facets(clod_loader *loader, const char *path, const clod_case_belt *belt)
{
    double length = belt->pulley.radius * belt->pulley.wrap + belt->pulley.return_length;
    for (size_t r = 0; r < belt->run_count; r++) {
        length += belt->runs[r].length;
    }
    const clod_case_belt_skirts *skirts = &belt->skirts;
    const double area =
        length * belt->width + 2.0 * fmax(0.0, skirts->to - skirts->from) * skirts->height;
    const double least = sqrt(2.0 * area / MOST_FACETS);
    if (belt->facet < least) {
        char text[128];
        snprintf(text, sizeof text,
                 "%.4g mm cuts the belt into more than %.0e facets; at least %.4g mm",
                 1e3 * belt->facet, MOST_FACETS, 1e3 * least);
        fail(loader, path, "facet", text);
    }
}

void clod_check_belt(clod_loader *loader, const char *path, const clod_case_shape *shape)
{
    const clod_case_belt *belt = &shape->belt;
    const double *heading = belt->heading;
    if (heading[2] != 0.0) {
        fail(
            loader, path, "heading",
            "must be level, so its z must be 0: what rises are the runs (runs: [{length: 3 m, rise: 5 "
            "deg}])");
    }
    if (belt->run_count == 0) {
        return; // told
    }
    for (size_t r = 1; r < belt->run_count; r++) {
        if (fabs(belt->runs[r].rise - belt->runs[r - 1].rise) > M_PI / 3.0) {
            char key[48], text[128];
            snprintf(key, sizeof key, "runs.%zu.rise", r);
            snprintf(
                text, sizeof text,
                "the belt bends by %.4g deg from the run before; at most 60 deg are allowed: "
                "put a run between",
                180.0 / M_PI * fabs(belt->runs[r].rise - belt->runs[r - 1].rise));
            fail(loader, path, key, text);
        }
    }
    if (belt->idler_angle > 0.0) {
        check_trough(loader, path, belt);
    }
    if (belt->skirts.height > 0.0) {
        check_skirts(loader, path, belt);
    }
    if (belt->facet > 0.0) {
        check_facets(loader, path, belt);
    }
}
