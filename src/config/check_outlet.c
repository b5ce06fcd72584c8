// Rules for outlets: regions and walls that remove grains.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/check.h"
#include "config/region.h"

/** Thickness of a region, the least of its sizes [m]. */
static double thickness(const clod_case_region *region)
{
    const clod_region_kind_row *row = clod_region_row(region);
    double size[3];
    row->size(region, size);
    const double across =
        row->upright ? region->outer_radius - region->inner_radius : fmin(size[0], size[1]);
    return fmin(across, size[2]);
}

/** Largest radius that a group of grains can have [m]; 0: not known before the run. */
static double largest_radius(const clod_case_grains *grains)
{
    return grains->sizes == CLOD_SIZE_SIEVE && grains->sieve_count > 0
               ? 0.5 * grains->sieve[grains->sieve_count - 1].size
               : grains->radius_max;
}

/** Radius of the largest grain that there can be [m]. */
static double largest_of(const clod_case *self)
{
    double radius = 0.0;
    for (size_t k = 0; k < self->grains_count; k++) {
        radius = fmax(radius, largest_radius(&self->grains[k]));
    }
    return radius;
}

static void check_region(clod_loader *loader, const char *path, const clod_case *self,
                         const clod_case_outlet *outlet)
{
    char key[CLOD_LOAD_PATH + 16];
    snprintf(key, sizeof key, "%s.region", path);
    const double radius = largest_of(self);
    if (clod_report_clean(loader->report, key) &&
        clod_check_region(loader, path, &outlet->region) &&
        !(thickness(&outlet->region) > radius)) {
        clod_check_fail(loader, key,
                        "is %.4g m thick; grains move by up to a radius between two checks, "
                        "so make it thicker than that of the largest, %.4g m",
                        thickness(&outlet->region), radius);
    }
}

static const clod_case_wall *find_wall(const clod_case *self, const char *name)
{
    for (size_t w = 0; w < self->wall_count; w++) {
        if (strcmp(self->walls[w].name, name) == 0) {
            return &self->walls[w];
        }
    }
    return NULL;
}

static void check_wall(clod_loader *loader, const char *path, const clod_case *self,
                       const clod_case_outlet *outlet)
{
    char key[CLOD_LOAD_PATH + 16];
    const clod_case_wall *wall = find_wall(self, outlet->wall);
    snprintf(key, sizeof key, "%s.wall", path);
    if (wall == NULL) {
        char names[280];
        clod_check_fail(loader, key, "'%s' is not the name of a wall%s", outlet->wall,
                        clod_check_walls_text(self, outlet->wall, false, names, sizeof names));
    } else if (wall->load != CLOD_LOAD_NONE) {
        clod_check_fail(loader, key,
                        "walls.%s has a load, but grains do not push a wall that removes "
                        "them; give the wall a velocity, or take another one",
                        outlet->wall);
    }
}

static void check_outlet(clod_loader *loader, const clod_case *self,
                         const clod_case_outlet *outlet)
{
    char path[CLOD_LOAD_PATH];
    snprintf(path, sizeof path, "outlets.%s", outlet->name);
    if (outlet->has_region == (outlet->wall != NULL)) {
        clod_check_fail(loader, path, "must have exactly one of region, wall");
    } else if (outlet->has_region && outlet->part != NULL) {
        clod_check_fail(loader, path, "has a part, but no wall; remove part, or give the wall");
    } else if (outlet->has_region) {
        check_region(loader, path, self, outlet);
    } else {
        check_wall(loader, path, self, outlet);
    }
}

void clod_check_outlets(clod_loader *loader, const clod_case *self)
{
    for (size_t k = 0; k < self->outlet_count; k++) {
        check_outlet(loader, self, &self->outlets[k]);
    }
    if (self->outlet_count > CLOD_CASE_OUTLETS) {
        clod_check_fail(loader, "outlets", "has %zu outlets; at most %d", self->outlet_count,
                        CLOD_CASE_OUTLETS);
    }
}
