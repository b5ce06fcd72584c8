// Whether what comes through inlets has room where it comes in.
#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/region.h"
#include "config/region_clear.h"
#include "config/sizes.h"

/** Area of a face across a velocity [m2]. */
static double face_across(const clod_case_region *region, const double *v, double speed)
{
    double axis[3][3];
    clod_region_axes(region, axis);
    const double *n = axis[2];
    return clod_region_area(region) * (v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / speed;
}

/** Solid that a group brings in a second [m3/s]; 0: not known here. */
static double solid_flow(const clod_case *self, const clod_case_grains *grains)
{
    const int material = clod_case_material_index(self, grains->material);
    const clod_case_inlet *inlet = &grains->inlet;
    if (inlet->mass_flow > 0.0) {
        return material < 0 ? 0.0 : inlet->mass_flow / self->materials[material].density;
    }
    clod_sizes sizes;
    clod_status ignored = {0}; // told where grains are made
    const double volume =
        clod_sizes_init(&sizes, grains, &ignored) ? clod_sizes_mean_volume(&sizes) : 0.0;
    clod_sizes_fini(&sizes);
    return inlet->number_flow * volume;
}

static double speed_of(const clod_case_grains *grains)
{
    const double *v = grains->velocity;
    return hypot(hypot(v[0], v[1]), v[2]);
}

/** Solid fraction of the stream of a group where it leaves its region; 0: not known here. */
static double fraction_of(const clod_case *self, const clod_case_grains *grains)
{
    const clod_case_region *region = &grains->region;
    if (clod_region_is_face(region)) {
        const double speed = speed_of(grains);
        const double through =
            speed > 0.0 ? face_across(region, grains->velocity, speed) * speed : 0.0; // m3/s
        return through > 0.0 ? solid_flow(self, grains) / through : 0.0;
    }
    const double volume = clod_region_area(region) * clod_region_height(region);
    const clod_region_clear leaves =
        clod_region_clear_of(region, grains->velocity, self->gravity);
    return volume > 0.0 ? solid_flow(self, grains) * leaves.time / volume : 0.0;
}

/** Whether group b comes while group a begins, in the same space; of those that begin together
 *  the one that is written later has the others with it. */
static bool is_with(const clod_case *self, size_t a, size_t b)
{
    const clod_case_inlet *one = &self->grains[a].inlet, *other = &self->grains[b].inlet;
    const bool goes_on = other->end == 0.0 || other->end > one->start;
    const bool before = other->start < one->start || (other->start == one->start && b <= a);
    return self->grains[b].comes && goes_on && before &&
           clod_region_overlap(&self->grains[a].region, &self->grains[b].region);
}

static bool has_gravity(const clod_case *self)
{
    const double *g = self->gravity;
    return g[0] != 0.0 || g[1] != 0.0 || g[2] != 0.0;
}

/** Solid fraction of all streams that share the space of one, it among them; how many. What stays where
 *  it comes is told by itself, so it does not count. */
static double fraction_with(const clod_case *self, size_t index, int *streams)
{
    double all = 0.0;
    *streams = 0;
    for (size_t k = 0; k < self->grains_count; k++) {
        const bool moves = speed_of(&self->grains[k]) > 0.0 || has_gravity(self);
        if (is_with(self, index, k) && moves) {
            all += fraction_of(self, &self->grains[k]);
            (*streams)++;
        }
    }
    return all;
}

double clod_check_rest_fraction(const clod_case *self, size_t index)
{
    int streams;
    return has_gravity(self) ? fraction_with(self, index, &streams) : HUGE_VAL;
}

bool clod_check_falls_back(const clod_case *self, size_t index, char text[CLOD_CHECK_BACK_TEXT])
{
    const clod_case_grains *grains = &self->grains[index];
    clod_region_clear leaves = {.falls_back = false};
    if (!clod_region_is_face(&grains->region)) {
        leaves = clod_region_clear_of(&grains->region, grains->velocity, self->gravity);
    }
    text[0] = '\0';
    if (leaves.falls_back) {
        snprintf(text, CLOD_CHECK_BACK_TEXT,
                 "grains rise by %.3g mm and fall back into the region, %.3g mm high; from "
                 "%.4g m/s on in this direction they leave it before they turn",
                 1e3 * leaves.rise, 1e3 * leaves.height, leaves.enough);
    }
    return leaves.falls_back;
}

static void check_room(clod_loader *loader, const clod_case *self, size_t index)
{
    const clod_case_grains *grains = &self->grains[index];
    int streams;
    const double all = fraction_with(self, index, &streams);
    if (speed_of(grains) == 0.0 || fraction_of(self, grains) == 0.0 ||
        all <= CLOD_CHECK_DENSE) {
        return;
    }
    const bool by_mass = grains->inlet.mass_flow > 0.0;
    const double flow = by_mass ? grains->inlet.mass_flow : grains->inlet.number_flow;
    char key[CLOD_LOAD_PATH], with[64] = "", back[CLOD_CHECK_BACK_TEXT];
    snprintf(key, sizeof key, "grains.%zu.inlet.%s", index,
             by_mass ? "mass_flow" : "number_flow");
    if (streams > 1) {
        snprintf(with, sizeof with, " with the %s in its region",
                 streams > 2 ? "others" : "other");
    }
    clod_check_fail(loader, key,
                    "%.4g %s at this velocity are a solid fraction of %.2g%s; grains at random "
                    "places without overlap go up to %.2g: at most %.4g %s%s, or make the "
                    "region wider%s%s",
                    flow, by_mass ? "kg/s" : "grains/s", all, with, CLOD_CHECK_DENSE,
                    flow * CLOD_CHECK_DENSE / all, by_mass ? "kg/s" : "grains/s",
                    streams > 1 ? ", the others in the same proportion" : "",
                    clod_check_falls_back(self, index, back) ? ": " : " or velocity larger",
                    back);
}

void clod_check_streams(clod_loader *loader, const clod_case *self)
{
    for (size_t k = 0; k < self->grains_count; k++) {
        if (self->grains[k].comes) {
            check_room(loader, self, k);
        }
    }
}
