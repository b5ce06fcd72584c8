#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/check.h"
#include "config/region.h"
#include "state/shape_kinds.h"

#define PATH_SIZE 320
/** Cosine of the angle between two directions below which they are across each other. */
#define ACROSS 1e-9

static bool has(const clod_loader *loader, const char *path, const char *key)
{
    char whole[PATH_SIZE + 96];
    snprintf(whole, sizeof whole, "%s.%s", path, key);
    return clod_check_has(loader, whole);
}

static void fail(clod_loader *loader, const char *path, const char *key, const char *message)
{
    char whole[PATH_SIZE + 96];
    snprintf(whole, sizeof whole, "%s%s%s", path, key[0] == '\0' ? "" : ".", key);
    clod_check_fail(loader, whole, "%s", message);
}

static bool clean(const clod_loader *loader, const char *path)
{
    return clod_report_clean(loader->report, path);
}

static bool rises(const double low[3], const double high[3])
{
    return low[0] < high[0] && low[1] < high[1] && low[2] < high[2];
}

static void check_radius(clod_loader *loader, const char *path, const clod_case_grains *grains)
{
    const bool normal = grains->sizes == CLOD_SIZE_NORMAL;
    const bool mean = has(loader, path, "radius.mean");
    const bool sd = has(loader, path, "radius.sd");
    if (normal && !(mean && sd)) {
        fail(loader, path, "radius",
             "a normal distribution needs mean and sd, for instance mean: 3.175 mm, sd: 0.16 "
             "mm");
    } else if (!normal && (mean || sd)) {
        fail(loader, path, mean ? "radius.mean" : "radius.sd",
             "a uniform distribution has only min and max; remove this key");
    } else if (grains->radius_min > grains->radius_max) {
        fail(loader, path, "radius.min", "the smallest radius is larger than max");
    } else if (normal && (grains->radius_mean < grains->radius_min ||
                          grains->radius_mean > grains->radius_max)) {
        fail(loader, path, "radius.mean", "the mean must lie between min and max");
    }
}

static void check_sieve(clod_loader *loader, const char *path, const clod_case_grains *grains)
{
    const size_t count = grains->sieve_count;
    for (size_t i = 1; i < count; i++) {
        char key[64];
        if (grains->sieve[i].size <= grains->sieve[i - 1].size) {
            snprintf(key, sizeof key, "sizes.sieve.%zu.size", i);
            fail(loader, path, key, "sieves go from fine to coarse; this one is not coarser");
        }
        if (grains->sieve[i].passing < grains->sieve[i - 1].passing) {
            snprintf(key, sizeof key, "sizes.sieve.%zu.passing", i);
            fail(loader, path, key, "less passes this sieve than a finer one");
        }
    }
    if (count < 2 || grains->sieve[0].passing != 0.0 ||
        grains->sieve[count - 1].passing != 1.0) {
        fail(loader, path, "sizes.sieve",
             "the table must begin at 0 % passing (smallest grain) and end at 100 % (largest)");
    }
}

static void check_sizes(clod_loader *loader, const char *path, clod_case_grains *grains)
{
    const bool radius = has(loader, path, "radius");
    const bool sizes = has(loader, path, "sizes");
    if (radius == sizes) {
        fail(loader, path, radius ? "sizes" : "",
             radius
                 ? "radius says the sizes already; keep one of them"
                 : "needs the sizes of grains: radius (by number) or sizes (sieves, by mass)");
        return;
    }
    if (radius) {
        check_radius(loader, path, grains);
    } else {
        grains->sizes = CLOD_SIZE_SIEVE;
        check_sieve(loader, path, grains);
    }
}

/** Grains beyond an open border are lost at once, beyond a periodic one they come in elsewhere.
 */
static void check_region_inside(clod_loader *loader, const char *path, const clod_case *self,
                                const clod_case_region *region)
{
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    for (int a = 0; a < 3; a++) {
        const double least = self->domain_min[a];
        const double most = self->domain_max[a];
        const double rounding = 1e-9 * (most - least); // of decimal numbers
        if (low[a] < least - rounding || high[a] > most + rounding) {
            char key[PATH_SIZE + 16];
            snprintf(key, sizeof key, "%s.region", path);
            clod_check_fail(loader, key,
                            "reaches from %c = %.10g m to %.10g m, beyond the domain, %.10g m "
                            "to %.10g m; make the region smaller, or the domain larger",
                            "xyz"[a], low[a], high[a], least, most);
            return;
        }
    }
}

/** Grains from a file carry everything with them. */
static void check_file(clod_loader *loader, const char *path)
{
    static const char *const KEYS[] = {"radius", "sizes", "region", "velocity"};
    for (size_t i = 0; i < sizeof KEYS / sizeof KEYS[0]; i++) {
        if (has(loader, path, KEYS[i])) {
            fail(loader, path, KEYS[i], "the file says this for each grain; remove this key");
        }
    }
}

static void check_grains(clod_loader *loader, const clod_case *self, size_t index)
{
    static const char *const AMOUNTS[] = {"count", "mass", "fill_height", "file"};
    clod_case_grains *grains = &self->grains[index];
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "grains.%zu", index);
    char material[PATH_SIZE + 16];
    snprintf(material, sizeof material, "%s.material", path);
    clod_check_material(loader, self, material, grains->material);
    if (!clean(loader, path)) {
        return;
    }
    size_t given = 0;
    const char *last = "";
    for (size_t i = 0; i < sizeof AMOUNTS / sizeof AMOUNTS[0]; i++) {
        if (has(loader, path, AMOUNTS[i])) {
            last = AMOUNTS[i];
            given++;
        }
    }
    if (grains->comes) {
        clod_check_inlet(loader, path, self, grains);
    } else if (given != 1) {
        fail(loader, path, last,
             given == 0
                 ? "needs an amount: one of count, mass, fill_height, file"
                 : "the amount is given twice; keep one of count, mass, fill_height, file");
        return;
    }
    if (grains->file != NULL) {
        check_file(loader, path);
        return;
    }
    if (grains->material == NULL) {
        fail(loader, path, "", "needs the key material, for instance material: ore");
    }
    check_sizes(loader, path, grains);
    if (!has(loader, path, "region")) {
        fail(loader, path, "",
             "needs the key region: where the grains are put, box or annulus");
    } else if (clod_check_region(loader, path, &grains->region) && clean(loader, path) &&
               (!clod_region_is_face(&grains->region) ||
                clod_check_face(loader, path, grains)) &&
               self->has_domain && clean(loader, "domain")) {
        check_region_inside(loader, path, self, &grains->region);
    }
}

/** Rules between the keys of a shape. */
static void check_keys(clod_loader *loader, const char *path, const clod_case_shape *shape)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row((clod_shape_kind)shape->kind);
    const clod_shape_fault fault =
        kind->fault != NULL ? kind->fault(shape) : (clod_shape_fault){0};
    if (fault.key != NULL) {
        fail(loader, path, fault.key, fault.text);
    }
    if (kind->conveyor) {
        clod_check_belt(loader, path, shape);
    }
}

static void check_load(clod_loader *loader, const char *path, clod_case_wall *wall)
{
    const bool force = has(loader, path, "load.force");
    const bool stress = has(loader, path, "load.stress");
    if (force == stress) {
        fail(loader, path, "load", "must have exactly one of force, stress");
        return;
    }
    wall->load = force ? CLOD_LOAD_FORCE : CLOD_LOAD_STRESS;
    if (stress && wall->area == 0.0) {
        fail(loader, path, "load",
             "a stress needs the area it acts on, for instance area: 25 cm2");
    }
    if (force && wall->area > 0.0) {
        fail(loader, path, "load.area", "a force needs no area; remove this key");
    }
}

bool clod_check_sways_across(const clod_case_wall *wall)
{
    const clod_case_oscillation *o = &wall->oscillation;
    double along = 0.0, direction = 0.0, axis = 0.0;
    for (int a = 0; a < 3; a++) {
        along += o->direction[a] * wall->load_axis[a];
        direction += o->direction[a] * o->direction[a];
        axis += wall->load_axis[a] * wall->load_axis[a];
    }
    return !(o->amplitude > 0.0) || wall->load == CLOD_LOAD_NONE ||
           fabs(along) <= ACROSS * sqrt(direction * axis);
}

static void check_oscillation(clod_loader *loader, const char *path, const clod_case_wall *wall)
{
    const clod_case_oscillation *o = &wall->oscillation;
    if (o->amplitude == 0.0 && o->angle == 0.0) {
        fail(loader, path, "oscillation", "needs an amplitude, an angle or both");
    }
    if (!clod_check_sways_across(wall)) {
        fail(loader, path, "oscillation.direction",
             "is not across the axis of the load, along which the load alone moves the wall");
    }
}

/** Materials of a shape's own, and of its parts, have to be of the case. */
static void check_surface(clod_loader *loader, const clod_case *self, const char *path,
                          const clod_case_shape *shape)
{
    char key[PATH_SIZE + CLOD_LOAD_PATH];
    const char *kind = CLOD_TABLE_SHAPE.params[shape->kind].key;
    if (shape->surface.material != NULL) {
        snprintf(key, sizeof key, "%s.%s.surface.material", path, kind);
        clod_check_material(loader, self, key, shape->surface.material);
    }
    if (shape->belt.skirts.material != NULL) {
        snprintf(key, sizeof key, "%s.belt.skirts.material", path);
        clod_check_material(loader, self, key, shape->belt.skirts.material);
    }
    for (size_t p = 0; p < shape->part_count; p++) {
        if (shape->parts[p].material != NULL) {
            snprintf(key, sizeof key, "%s.%s.parts.%s.material", path, kind,
                     shape->parts[p].name);
            clod_check_material(loader, self, key, shape->parts[p].material);
        }
    }
}

static void check_wall(clod_loader *loader, const clod_case *self, size_t index)
{
    clod_case_wall *wall = &self->walls[index];
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "walls.%s", wall->name);
    char key[PATH_SIZE + 32];
    snprintf(key, sizeof key, "%s.material", path);
    clod_check_material(loader, self, key, wall->material);
    if (!clean(loader, path)) {
        return;
    }
    for (size_t i = 0; i < wall->shape_count; i++) {
        snprintf(key, sizeof key, "%s.shapes.%zu", path, i);
        check_keys(loader, key, &wall->shapes[i]);
        check_surface(loader, self, key, &wall->shapes[i]);
    }
    if (has(loader, path, "load")) {
        check_load(loader, path, wall);
    }
    if (has(loader, path, "oscillation")) {
        check_oscillation(loader, path, wall);
    }
}

/** Shapes of all walls: the step numbers eight rows of each, and of a few more, with 32 bits.
 */
#define SHAPES_MAX ((size_t)INT32_MAX / 8 - 8)

static void check_shape_count(clod_loader *loader, const clod_case *self)
{
    size_t shapes = 0;
    for (size_t i = 0; i < self->wall_count; i++) {
        shapes += self->walls[i].shape_count;
    }
    if (shapes > SHAPES_MAX) {
        clod_check_fail(loader, "walls", "have %zu shapes, at most %zu are allowed", shapes,
                        SHAPES_MAX);
    }
}

void clod_check_walls(clod_loader *loader, const clod_case *self)
{
    for (size_t i = 0; i < self->wall_count; i++) {
        check_wall(loader, self, i);
    }
    check_shape_count(loader, self);
}

static const clod_case_wall *find_wall(const clod_case *self, const char *name)
{
    for (size_t i = 0; i < self->wall_count; i++) {
        if (strcmp(self->walls[i].name, name) == 0) {
            return &self->walls[i];
        }
    }
    return NULL;
}

static void check_change(clod_loader *loader, const clod_case *self, const char *path,
                         const clod_case_wall_change *change)
{
    const clod_case_wall *wall = find_wall(self, change->name);
    if (wall == NULL) {
        char names[280];
        clod_check_fail(loader, path, "there is no wall %s%s", change->name,
                        clod_check_walls_text(self, change->name, false, names, sizeof names));
        return;
    }
    char wall_path[PATH_SIZE];
    snprintf(wall_path, sizeof wall_path, "walls.%s", wall->name);
    if (!clean(loader, wall_path)) {
        return;
    }
    if (change->has_force && wall->load != CLOD_LOAD_FORCE) {
        fail(loader, path, "force", "this wall has no load with a force that could change");
    }
    if (change->has_stress && wall->load != CLOD_LOAD_STRESS) {
        fail(loader, path, "stress", "this wall has no load with a stress that could change");
    }
}

/** A name of a stage that an earlier one has; `names` are those of the earlier ones. */
static void check_stage_name(clod_loader *loader, clod_index *names, const char *name,
                             size_t index)
{
    char path[PATH_SIZE];
    size_t first;
    const size_t length = name != NULL ? strlen(name) : 0;
    if (name != NULL && clod_index_find(names, name, length, &first)) {
        snprintf(path, sizeof path, "stages.%zu.name", index);
        clod_check_fail(loader, path, "stage %zu has the name %s already", first, name);
    } else if (name != NULL && !clod_index_add(names, loader->arena, name, length, index)) {
        loader->report->lost = true;
    }
}

static void check_stage(clod_loader *loader, const clod_case *self, clod_index *names,
                        size_t index)
{
    const clod_case_stage *stage = &self->stages[index];
    char path[PATH_SIZE];
    check_stage_name(loader, names, stage->name, index);
    for (size_t i = 0; i < stage->wall_count; i++) {
        snprintf(path, sizeof path, "stages.%zu.walls.%s", index, stage->walls[i].name);
        if (clean(loader, path)) {
            check_change(loader, self, path, &stage->walls[i]);
        }
    }
}

/** Potential energy has no value where grains come back at the other end. */
static void check_energy(clod_loader *loader, const clod_case *self)
{
    for (int a = 0; self->output.energy && a < 3; a++) {
        if (self->periodic[a] && self->gravity[a] != 0.0) {
            clod_check_fail(loader, "output.energy",
                            "gravity has a part along %c, in which the domain is periodic: "
                            "potential energy has no value there; leave the ledger out, or set "
                            "that part of gravity to 0",
                            "xyz"[a]);
        }
    }
}

void clod_check_run(clod_loader *loader, clod_case *self)
{
    check_energy(loader, self);
    if (self->has_domain && clean(loader, "domain") &&
        !rises(self->domain_min, self->domain_max)) {
        clod_check_fail(loader, "domain.max", "must be larger than min in x, y and z");
    }
    for (size_t i = 0; i < self->grains_count; i++) {
        check_grains(loader, self, i);
    }
    if (clean(loader, "grains")) {
        clod_check_streams(loader, self);
    }
    clod_check_gauges(loader, self);
    clod_check_clumps(loader, self);
    clod_check_fields(loader, self);
    clod_check_mixing(loader, self);
    clod_check_walls(loader, self);
    clod_check_outlets(loader, self); // knows which walls have a load
    clod_index stage_names = {0};
    for (size_t i = 0; i < self->stage_count; i++) {
        check_stage(loader, self, &stage_names, i);
    }
}
