#include "config/check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/suggest.h"
#include "config/testers.h"

void clod_check_fail(clod_loader *loader, const char *path, const char *format, ...)
{
    char message[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    const clod_node *node = clod_tree_nearest(loader->root, path);
    const bool exact = clod_tree_at(loader->root, path) != NULL;
    const bool value = exact && node->kind == CLOD_NODE_SCALAR;
    clod_report_add(loader->report, value ? node->place : clod_load_place(node), path, "%s",
                    message);
}

bool clod_check_has_belt(const clod_case_wall *wall)
{
    bool found = false;
    for (size_t s = 0; s < wall->shape_count; s++) {
        found = found || wall->shapes[s].belt.run_count > 0;
    }
    return found;
}

const char *clod_check_walls_text(const clod_case *self, const char *name, bool belts,
                                  char *text, size_t size)
{
    const char *kind = belts ? "walls with a belt" : "walls";
    clod_suggest near = clod_suggest_start(name);
    char list[200] = "";
    for (size_t w = 0; w < self->wall_count; w++) {
        if (!belts || clod_check_has_belt(&self->walls[w])) {
            const size_t used = strlen(list);
            clod_suggest_offer(&near, self->walls[w].name);
            snprintf(list + used, sizeof list - used, "%s%s", used > 0 ? ", " : "",
                     self->walls[w].name);
        }
    }
    if (clod_suggest_text(&near, text, size)[0] == '\0') {
        if (list[0] != '\0') {
            snprintf(text, size, "; %s are %s", kind, list);
        } else {
            snprintf(text, size, "; the case has no %s: remove this key", kind);
        }
    }
    return text;
}

bool clod_check_has(const clod_loader *loader, const char *path)
{
    return clod_tree_at(loader->root, path) != NULL;
}

const char *clod_check_written(const clod_loader *loader, const char *first, const char *second)
{
    return clod_check_has(loader, first) || !clod_check_has(loader, second) ? first : second;
}

/** Index of a value before `at` that is the same as that one; `at` when there is none. */
static size_t find_same(const double *values, size_t at, double apart)
{
    for (size_t k = 0; k < at; k++) {
        if (fabs(values[at] - values[k]) <= apart) {
            return k;
        }
    }
    return at;
}

void clod_check_apart(clod_loader *loader, const char *path, const double *values, size_t count,
                      double apart, const char *same)
{
    for (size_t i = 0; i < count; i++) {
        const size_t k = find_same(values, i, apart);
        if (k < i) {
            char place[128];
            snprintf(place, sizeof place, "%s.%zu", path, i);
            clod_check_fail(loader, place,
                            "%.10g Pa and %.10g Pa (number %zu of the list) are less than "
                            "%.3g Pa apart: %s; change one of them or take it out",
                            values[i], values[k], k + 1, apart, same);
            return;
        }
    }
}

void clod_check_material(clod_loader *loader, const clod_case *self, const char *path,
                         const char *name)
{
    const bool unread = self->material_count == 0; // which has been said
    if (name == NULL || unread || clod_case_material_index(self, name) >= 0) {
        return;
    }
    char hint[64];
    clod_suggest near = clod_suggest_start(name);
    for (size_t i = 0; i < self->material_count; i++) {
        clod_suggest_offer(&near, self->materials[i].name);
    }
    clod_check_fail(loader, path, "there is no material %s%s", name,
                    clod_suggest_text(&near, hint, sizeof hint));
}

static bool is(const char *name, const char *material)
{
    return name != NULL && strcmp(name, material) == 0;
}

/** Materials of a tester; all NULL when it is not in the case. */
static clod_tester_materials materials_of(const clod_case *self, int kind)
{
    const clod_config_tester *tester = &CLOD_CONFIG_TESTER[kind];
    return tester->key != NULL && tester->present(self) ? tester->materials(self)
                                                        : (clod_tester_materials){0};
}

/** Whether a program of the user's may add grains of a material: the run begins without any. */
static bool may_come(const clod_case *self, const char *material)
{
    const int m = clod_case_material_index(self, material);
    return clod_config_begins_empty(self) && m >= 0 && self->materials[m].density > 0.0;
}

/**
 * Whether grains are of a material; grains from a file, or from the user's program, may be of
 * any, and only some are.
 */
static bool is_grain(const clod_case *self, const char *material, bool from_elsewhere)
{
    if (from_elsewhere && may_come(self, material)) {
        return true;
    }
    for (size_t i = 0; i < self->grains_count; i++) {
        const clod_case_grains *grains = &self->grains[i];
        if ((from_elsewhere && grains->file != NULL) || is(grains->material, material)) {
            return true;
        }
    }
    for (int kind = 0; kind < CLOD_CASE_KINDS; kind++) {
        if (is(materials_of(self, kind).grain, material)) {
            return true;
        }
    }
    return false;
}

/** Whether walls, or the partner on the contact bench, are of a material. */
static bool is_wall(const clod_case *self, const char *material)
{
    for (size_t i = 0; i < self->wall_count; i++) {
        const clod_case_wall *wall = &self->walls[i];
        for (size_t s = 0; s < wall->shape_count; s++) {
            const clod_case_shape *shape = &wall->shapes[s];
            const char *own = shape->surface.material;
            if (is(own != NULL ? own : wall->material, material)) {
                return true;
            }
            if (is(shape->belt.skirts.material, material)) {
                return true;
            }
            for (size_t p = 0; p < shape->part_count; p++) {
                if (is(shape->parts[p].material, material)) {
                    return true;
                }
            }
        }
    }
    for (int kind = 0; kind < CLOD_CASE_KINDS; kind++) {
        const clod_tester_materials tester = materials_of(self, kind);
        if (is(tester.wall[0], material) || is(tester.wall[1], material) ||
            is(tester.wall[2], material)) {
            return true;
        }
    }
    return false;
}

bool clod_check_pair_needed(const clod_case *self, int a, int b)
{
    const char *first = self->materials[a].name;
    const char *second = self->materials[b].name;
    const bool grain_a = is_grain(self, first, true);
    const bool grain_b = is_grain(self, second, true);
    return (grain_a && (grain_b || is_wall(self, second))) || (grain_b && is_wall(self, first));
}

/** Which kind of case this is, and what does not go together. */
static void check_kind(clod_loader *loader, const clod_case *self)
{
    static const char *const FREE[] = {"grains", "walls",  "outlets",  "gauges",     "stages",
                                       "domain", "clumps", "build_up", "history_map"};
    static const char *const RUN[] = {"walls",       "outlets", "gauges", "domain", "gravity",
                                      "time",        "output",  "seed",   "clumps", "build_up",
                                      "history_map", "fields",  "mixing", "repose"};
    const char *tester = clod_case_tester(self);
    const bool grains = clod_check_has(loader, "grains");
    const bool stages = clod_check_has(loader, "stages");
    for (size_t i = 0; i < sizeof FREE / sizeof FREE[0]; i++) {
        if (tester != NULL && clod_check_has(loader, FREE[i])) {
            clod_check_fail(loader, FREE[i],
                            "%s makes its own cell and stages; remove %s, or %s", tester,
                            FREE[i], tester);
        }
    }
    if (tester != NULL && clod_check_has(loader, "repose")) {
        clod_check_fail(
            loader, "repose",
            "the bed of %s lies under a lid and has no slope: the angle of repose is "
            "a measure of free runs; remove repose, or %s",
            tester, tester);
    }
    for (int k = CLOD_CASE_KINDS; k-- > (int)clod_case_kind_of(self) + 1;) {
        const clod_config_tester *other = &CLOD_CONFIG_TESTER[k];
        if (tester != NULL && other->cell && other->present(self)) {
            clod_check_fail(loader, other->key, "a case has one tester; remove %s, or %s",
                            other->key, tester);
        }
    }
    if (tester == NULL && grains && !stages) {
        clod_check_fail(
            loader, "grains",
            "grains need stages that say how long to run, for instance stages: [{name: "
            "settle, duration: 0.2 s}]");
    }
    const bool empty = clod_check_has(loader, "domain") && self->time.step > 0.0 &&
                       self->time.design_stress > 0.0;
    if (tester == NULL && stages && !grains && !empty) {
        clod_check_fail(loader, "stages",
                        "stages need grains; where a program adds them later, give domain, "
                        "time.step and time.design_stress instead");
    }
    const bool run = tester != NULL || grains || stages;
    const bool bench = !run && clod_case_kind_of(self) == CLOD_CASE_CONTACT_BENCH;
    for (size_t i = 0; bench && i < sizeof RUN / sizeof RUN[0]; i++) {
        if (clod_check_has(loader, RUN[i])) {
            clod_check_fail(loader, RUN[i],
                            "contact_bench has one contact, no weight and no steps; remove %s",
                            RUN[i]);
        }
    }
    if (!run && !bench && loader->report->count == 0) {
        char testers[CLOD_CONFIG_TESTER_KEYS];
        clod_config_tester_keys(testers);
        clod_check_fail(loader, "",
                        "nothing to simulate; a case has grains, walls and stages, or %s or "
                        "contact_bench (clod new writes an example)",
                        testers);
    }
}

/** Grains of a material without density would have no mass. */
static void check_density(clod_loader *loader, const clod_case *self)
{
    for (size_t i = 0; i < self->material_count; i++) {
        const clod_case_material *material = &self->materials[i];
        char path[64];
        snprintf(path, sizeof path, "materials.%s", material->name);
        if (material->density == 0.0 && is_grain(self, material->name, false) &&
            clod_report_clean(loader->report, path)) {
            clod_check_fail(
                loader, path,
                "grains are of this material: it needs the key density, for instance "
                "density: 2481.3 kg/m3");
        }
    }
}

/** A coefficient of wear means nothing without a hardness. */
static void check_wear(clod_loader *loader, const clod_case *self)
{
    for (size_t i = 0; i < self->material_count; i++) {
        const clod_case_material *material = &self->materials[i];
        const bool archard = material->archard > 0.0;
        char path[64], key[80];
        snprintf(path, sizeof path, "materials.%s", material->name);
        snprintf(key, sizeof key, "%s.%s", path, archard ? "archard" : "finnie");
        if ((archard || material->finnie > 0.0) && material->hardness == 0.0 &&
            clod_report_clean(loader->report, path)) {
            clod_check_fail(loader, key,
                            "needs the key hardness beside it, which worn volume is divided "
                            "by; for instance hardness: 2 GPa");
        }
    }
}

void clod_check_case(clod_loader *loader, clod_case *self)
{
    check_kind(loader, self);
    check_density(loader, self);
    check_wear(loader, self);
    clod_check_run(loader, self);
    clod_check_tester(loader, self);
    clod_check_unused(loader, self);
}
