// Rules for grains that come during a run.
#include <math.h>
#include <stdio.h>

#include "config/check.h"

static void fail(clod_loader *loader, const char *path, const char *key, const char *text)
{
    char whole[CLOD_LOAD_PATH + 64];
    snprintf(whole, sizeof whole, "%s.%s", path, key);
    clod_check_fail(loader, whole, "%s", text);
}

static bool has(const clod_loader *loader, const char *path, const char *key)
{
    char whole[CLOD_LOAD_PATH + 64];
    snprintf(whole, sizeof whole, "%s.%s", path, key);
    return clod_check_has(loader, whole);
}

/** Numbers of groups that have an inlet. */
static size_t count_inlets(const clod_case *self)
{
    size_t count = 0;
    for (size_t k = 0; k < self->grains_count; k++) {
        count += self->grains[k].comes;
    }
    return count;
}

void clod_check_inlet(clod_loader *loader, const char *path, const clod_case *self,
                      const clod_case_grains *grains)
{
    const clod_case_inlet *inlet = &grains->inlet;
    if ((inlet->mass_flow > 0.0) == (inlet->number_flow > 0.0)) {
        fail(loader, path, "inlet", "must have exactly one of mass_flow, number_flow");
    }
    if (grains->file != NULL || grains->fill_height > 0.0) {
        fail(loader, path, grains->file != NULL ? "file" : "fill_height",
             "an inlet makes grains until it ends, or there are count or mass of them; remove "
             "this key");
    } else if (grains->count > 0 && grains->mass > 0.0) {
        fail(loader, path, "mass", "the amount is given twice; keep one of count, mass");
    }
    if (has(loader, path, "inlet.end") && inlet->end <= inlet->start) {
        char text[128];
        snprintf(text, sizeof text, "%.6g s must be later than start, %.6g s", inlet->end,
                 inlet->start);
        fail(loader, path, "inlet.end", text);
    }
    if (self->time.design_stress == 0.0) {
        fail(
            loader, path, "inlet",
            "the load on the grains that will come is not known; give it, for instance "
            "time: {design_stress: 5 kPa}, the weight of the deepest bed that there will be on "
            "its area");
    }
    if (count_inlets(self) > CLOD_CASE_INLETS) {
        char text[64];
        snprintf(text, sizeof text, "there are %zu inlets; at most %d", count_inlets(self),
                 CLOD_CASE_INLETS);
        fail(loader, path, "inlet", text);
    }
}
