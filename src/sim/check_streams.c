// Streams that cannot be meant: too fast for the step, at rest, removed where they come in; regions and walls out of
// reach, walls through the regions of grains.

#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/region.h"
#include "config/source.h"
#include "setup/belt_doubts.h"
#include "setup/domain.h"
#include "setup/flush_walls.h"
#include "setup/grains.h"
#include "setup/planes.h"
#include "setup/region_walls.h"
#include "setup/walls.h"
#include "sim/check_testers.h"

static double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/** Grains that pass more than a radius in a step go through each other and through walls. */
static void warn_speed(const clod_check_subject *subject, clod_check_report *r)
{
    for (size_t k = 0; k < subject->from->grains_count; k++) {
        const double speed = length3(subject->from->grains[k].velocity);
        if (speed * r->step > r->radius_min) {
            clod_check_warning(
                r,
                "grains.%zu.velocity: %.4g m/s are %.3g mm in a step, more than the radius of "
                "the smallest grain, %.3g mm: grains would pass through each other and through "
                "walls. Lower the velocity or time.step",
                k, speed, 1e3 * speed * r->step, 1e3 * r->radius_min);
        }
    }
}

/** A warning that begins with a key, with where that stands and the line of the case. */
static void warn_at(const clod_case *from, clod_check_report *r, clod_status *said)
{
    clod_source_tell(from, said);
    clod_check_warning(r, "%s", said->text);
}

/** Grains that come at rest leave their region by falling, or not at all. */
static void warn_rest(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *grains = &from->grains[k];
        clod_status said;
        if (!grains->comes || length3(grains->velocity) > 0.0) {
            continue;
        }
        const double fraction = clod_check_rest_fraction(from, k);
        const bool by_mass = grains->inlet.mass_flow > 0.0;
        const double flow = by_mass ? grains->inlet.mass_flow : grains->inlet.number_flow;
        if (isinf(fraction)) {
            clod_status_fail(
                &said, CLOD_USAGE,
                "grains.%zu.velocity: is zero, and there is no gravity: what comes "
                "stays where it is, so the inlet is blocked as soon as its region "
                "is full. Give a velocity that leads out of the region, or gravity",
                k);
            warn_at(from, r, &said);
        } else if (fraction > CLOD_CHECK_DENSE) {
            clod_status_fail(
                &said, CLOD_USAGE,
                "grains.%zu.velocity: is zero: grains only fall out of the region, "
                "and with all that come there they fill %.2g of its bottom; random "
                "places without overlap go up to %.2g, so the inlet will be blocked. Give a "
                "velocity that leads out, a larger region, or at most %.4g %s, others in "
                "proportion",
                k, fraction, CLOD_CHECK_DENSE, flow * CLOD_CHECK_DENSE / fraction,
                by_mass ? "kg/s" : "grains/s");
            warn_at(from, r, &said);
        }
    }
}

/** Grains that are thrown upwards and turn inside their region meet those that come after them. */
static void warn_back(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (size_t k = 0; k < from->grains_count; k++) {
        char text[CLOD_CHECK_BACK_TEXT];
        clod_status said;
        if (from->grains[k].comes && clod_check_falls_back(from, k, text)) {
            clod_status_fail(&said, CLOD_USAGE,
                             "grains.%zu.velocity: %s. Or let it lead down, or sideways", k,
                             text);
            warn_at(from, r, &said);
        }
    }
}

/** A grain comes when half of it is due; of some inlets that is never. */
static void warn_due(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (size_t k = 0; k < from->grains_count; k++) {
        const double due = from->grains[k].comes ? clod_setup_grains_due(from, k) : 1.0;
        clod_status said;
        if (due < 0.5) {
            clod_status_fail(&said, CLOD_USAGE,
                             "grains.%zu.inlet: nothing comes: until it ends, or the run does, "
                             "%.2g of the smallest grain is due, and a grain comes when half "
                             "of it is. Give more, for a longer time, or smaller grains",
                             k, due);
            warn_at(from, r, &said);
        }
    }
}

/** An outlet where grains come in removes them at once. */
static void warn_outlets(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (size_t o = 0; o < from->outlet_count; o++) {
        for (size_t k = 0; from->outlets[o].has_region && k < from->grains_count; k++) {
            const clod_case_grains *grains = &from->grains[k];
            if (grains->file == NULL &&
                clod_region_overlap(&from->outlets[o].region, &grains->region)) {
                clod_status said;
                clod_status_fail(&said, CLOD_USAGE,
                                 "outlets.%s.region: overlaps grains.%zu.region: grains are "
                                 "removed where they come in. Move one of them",
                                 from->outlets[o].name, k);
                warn_at(from, r, &said);
            }
        }
    }
}

/** Whether a plane has a place within an outlet, behind its border. */
static bool is_inside(const clod_plane *plane, const clod_case_region *region)
{
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    bool inside = true;
    for (int a = 0; a < 3; a++) {
        const bool along = a == plane->axis;
        inside = inside && (along ? plane->at : plane->region.high[a]) > low[a] &&
                 (along ? plane->at : plane->region.low[a]) < high[a];
    }
    return inside;
}

/** A plane behind the border of an outlet, which removes grains now and then. */
static void warn_planes(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (size_t k = 0; k < from->gauge_count; k++) {
        const int number = clod_setup_planes_number(from, &from->gauges[k]);
        for (size_t o = 0; number >= 0 && o < from->outlet_count; o++) {
            const clod_case_outlet *outlet = &from->outlets[o];
            if (outlet->has_region &&
                is_inside(&subject->state.planes.plane[number], &outlet->region)) {
                clod_status said;
                clod_status_fail(
                    &said, CLOD_USAGE,
                    "gauges.%s.plane: lies within outlets.%s, which removes grains "
                    "at the next neighbour list: some pass the plane before, some "
                    "do not. Put it on the border of the outlet or before it",
                    from->gauges[k].name, outlet->name);
                warn_at(from, r, &said);
            }
        }
    }
}

/** A region that has none of the domain's grains; `path` is that of what has it. */
static void warn_outside(const clod_case *from, clod_check_report *r, const char *path,
                         const clod_case_region *region)
{
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    for (int a = 0; a < 3; a++) {
        if (low[a] > from->domain_max[a] || high[a] < from->domain_min[a]) {
            clod_status said;
            clod_status_fail(
                &said, CLOD_USAGE,
                "%s.region: nothing of it lies in the domain, so no grain is ever in it: "
                "its %c is %.4g to %.4g m, that of the domain %.4g to %.4g m. Check its "
                "place and domain",
                path, "xyz"[a], low[a], high[a], from -> domain_min[a], from -> domain_max[a]);
            warn_at(from, r, &said);
            return;
        }
    }
}

/** Regions that remove or measure grains where there are none; of fields, mixing and repose that is an error. */
static void warn_regions(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    char path[80];
    for (size_t k = 0; k < from->outlet_count; k++) {
        snprintf(path, sizeof path, "outlets.%s", from->outlets[k].name);
        if (from->outlets[k].has_region) {
            warn_outside(from, r, path, &from->outlets[k].region);
        }
    }
    for (size_t k = 0; k < from->gauge_count; k++) {
        snprintf(path, sizeof path, "gauges.%s", from->gauges[k].name);
        warn_outside(from, r, path, &from->gauges[k].region);
    }
    for (size_t k = 0; k < from->clumps.count_count; k++) {
        snprintf(path, sizeof path, "clumps.counts.%s", from->clumps.counts[k].name);
        if (from->clumps.counts[k].has_region) {
            warn_outside(from, r, path, &from->clumps.counts[k].region);
        }
    }
    if (from->history_map.present && from->history_map.has_region) {
        warn_outside(from, r, "history_map", &from->history_map.region);
    }
}

/** A wall that no grain of the domain can reach. */
static void warn_walls(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    for (int32_t w = 0; from->has_domain && w < subject->state.walls.count; w++) {
        const clod_wall *wall = &subject->state.walls.wall[w];
        double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
        double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        if (!clod_setup_domain_add_wall(wall, low, high) ||
            !clod_setup_wall_stays(from, wall)) {
            continue;
        }
        for (int a = 0; a < 3; a++) {
            const double reach = r->radius_max; // of a grain whose centre is on the side
            if (low[a] > from->domain_max[a] + reach || high[a] < from->domain_min[a] - reach) {
                char key[64], where[CLOD_SOURCE_WHERE];
                snprintf(key, sizeof key, "walls.%s", wall->name);
                clod_check_warning(r,
                                   "%s%s: nothing of it lies in the domain: its %c is %.4g "
                                   "to %.4g m, that of the domain %.4g to %.4g m. Check its "
                                   "place, the unit of a mesh, and domain",
                                   clod_source_where(from, key, where), key, "xyz"[a], low[a],
                                   high[a], from -> domain_min[a], from -> domain_max[a]);
                break;
            }
        }
    }
}

/** What is said of walls: they cut a region of grains, have a face in common, or belts with another side up. */
static void tell(void *report, const char *text)
{
    clod_check_warning(report, "%s", text);
}

void clod_check_streams_warn(const clod_check_subject *subject, clod_check_report *r)
{
    warn_speed(subject, r);
    warn_rest(subject, r);
    warn_back(subject, r);
    warn_due(subject, r);
    warn_outlets(subject, r);
    warn_planes(subject, r);
    warn_walls(subject, r);
    if (subject->from->has_domain) {
        warn_regions(subject, r);
    }
    clod_setup_regions_doubts(subject->from, &subject->state.walls, true, tell, r);
    clod_setup_belts_doubts(subject->from, tell, r);
    clod_setup_flush_doubts(subject->from, &subject->state.walls, r->radius_mean, tell, r);
}
