#include "sim/wall_shear_warnings.h"

#include <math.h>
#include <stdio.h>

#include "config/wall_cells.h"
#include "config/wall_ridges.h"
#include "sim/warning_box.h"
#include "tester/limits.h"
#include "tester/wall_shear.h"

#define SIDE_LIMIT 0.05 ///< of the wall normal stress that the sides carry
/// Of a diameter between ridges, up to which the straight cell was not above the solid: not at 0.16, but at 0.22.
#define SINK_LIMIT 0.18

static void add_settling(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_wall_shear *t = part->test;
    if ((t->flags & CLOD_WALL_SHEAR_NOT_SETTLED) != 0) {
        const bool filling = part->point < 0;
        clod_warning_box_add(
            list, "%s: %s did not come to rest within wall_friction.%s (%.3g s): raise it%s",
            part->name, filling ? "filling" : "consolidation",
            filling ? "fill_max" : "settle_max",
            filling ? from->wall_friction.fill_max : from->wall_friction.settle_max,
            filling ? "" : ", or wall_friction.lid_damping if the lid swings");
    }
}

/** A shear stress that still changed where the stress ended. */
static void add_steadiness(json_t *list, const clod_case *from, const clod_part *part,
                           int64_t k)
{
    const clod_wall_shear *t = part->test;
    const clod_wall_shear_point *p = &t->point[k];
    if (p->steady == 0) {
        clod_warning_box_add(
            list,
            "%s: at %.4g kPa the wall shear stress was not steady after %.3g mm "
            "(at most wall_friction.shear_max = %.3g mm): %.4g kPa, changing by %.2g ± %.2g kPa "
            "per mm. Raise it, or block_displacement if the solid slips and sticks",
            part->name, 1e-3 * t->stresses[k], 1e3 * p->displacement,
            1e3 * from->wall_friction.shear_max, 1e-3 * p->shear, 1e-6 * p->rate,
            1e-6 * p->rate_error);
    }
}

/** Friction of the grains with another material. */
static double friction_with(const clod_case *from, const char *other)
{
    return clod_case_pair(from,
                          clod_case_material_index(from, from->wall_friction.grain_material),
                          clod_case_material_index(from, other))
        ->friction;
}

bool clod_wall_shear_lever(const clod_case *from, char *text, size_t size)
{
    const clod_case_wall_friction *test = &from->wall_friction;
    const double plate = friction_with(from, test->plate_material);
    const double grains = friction_with(from, test->grain_material);
    snprintf(
        text, size,
        "the plate (friction %.3g) is smoother than the grains (%.3g): in a ring tau_w then "
        "has an error of the lever, from 5 %% too little to 13 %% too much among packings "
        "four grains wide, which no error bar of one specimen shows and which can look like "
        "adhesion. Raise wall_friction.seeds, or use cell: straight",
        plate, grains);
    return clod_wall_cell_of(test)->turns && test->seeds == 1 && plate < grains &&
           test->plate_ridges.height == 0.0;
}

/** Ridges between which grains sink so deep that a straight plate bore more than the solid. */
static bool has_high_ridges(const clod_case_wall_friction *test, char *text, size_t size)
{
    if (test->plate_ridges.height == 0.0) {
        return false;
    }
    const clod_wall_ridges ridges = clod_wall_ridges_of(test);
    const double diameter = 2.0 * test->radius_mean;
    const double sinks = clod_wall_ridges_sink_depth(&ridges, test->radius_mean) / diameter;
    snprintf(
        text, size,
        "grains sink %.2g of their diameter between the ridges (at most %.2g in a straight "
        "cell): so rough a plate bears more than the solid's own strength there, for the side "
        "wall holds the solid down to the plate. Use cell: ring",
        sinks, SINK_LIMIT);
    return sinks > SINK_LIMIT;
}

bool clod_wall_shear_rough(const clod_case *from, char *text, size_t size)
{
    const clod_case_wall_friction *test = &from->wall_friction;
    const double plate = friction_with(from, test->plate_material);
    const double grains = friction_with(from, test->grain_material);
    if (clod_wall_cell_of(test)->turns) {
        return false;
    }
    if (has_high_ridges(test, text, size)) {
        return true;
    }
    snprintf(
        text, size,
        "the plate (friction %.3g) is not smoother than the grains (%.3g): the side wall of a "
        "straight cell holds the solid down to the plate, so that tau_w can be above what the "
        "solid itself bears (measured: 43 deg where the solid has 26). Use cell: ring, where it "
        "shears within itself; here phi_x is that of the wall only if it is, at the largest "
        "stress, below phi_sf of a ring shear test",
        plate, grains);
    return plate >= grains;
}

/** What a cell cannot do well, once it was used: one specimen in a ring; a rough plate in no ring. */
static void add_cell(json_t *list, const clod_case *from, const clod_part *part, int parts)
{
    char text[512];
    bool sheared = false;
    for (int p = 0; p < parts; p++) {
        const clod_wall_shear *t = part[p].test;
        sheared = sheared || (part[p].point >= 0 && t->at > 0);
    }
    if (sheared && clod_wall_shear_lever(from, text, sizeof text)) {
        clod_warning_box_add(list, "%s", text);
    }
    if (sheared && clod_wall_shear_rough(from, text, sizeof text)) {
        clod_warning_box_add(list, "%s", text);
    }
}

/** The load of the lid should be on the plate, not on the sides. */
static void add_sides(json_t *list, const clod_part *part, int64_t k)
{
    const clod_wall_shear *t = part->test;
    const double carried = 1.0 - t->point[k].normal / t->stresses[k];
    if (carried < -SIDE_LIMIT) {
        clod_warning_box_add(
            list,
            "%s: %.4g kPa were asked for, and the plate has %.4g kPa: the solid presses with "
            "more, by its weight or pushed down by the side walls, and the lid cannot pull. The "
            "wall yield locus has the stress on the plate. Leave this stress out, or lower "
            "wall_friction.grain_count, depth or the friction of the side material",
            part->name, 1e-3 * t->stresses[k], 1e-3 * t->point[k].normal);
    }
    if (carried > SIDE_LIMIT) {
        clod_warning_box_add(
            list,
            "%s: of %.4g kPa, %.4g kPa came to the plate: the side walls carry the rest. The "
            "wall yield locus has the stress on the plate. Lower the friction of the side "
            "material, or wall_friction.depth",
            part->name, 1e-3 * t->stresses[k], 1e-3 * t->point[k].normal);
    }
}

/** I = (speed/height) d sqrt(rho/sigma), as if the whole specimen were sheared. */
static void add_inertia(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_case_wall_friction *test = &from->wall_friction;
    const clod_wall_shear *t = part->test;
    const clod_case_material *ore =
        &from->materials[clod_case_material_index(from, test->grain_material)];
    const double number = test->speed / t->point[0].height * 2.0 * test->radius_mean *
                          sqrt(ore->density / t->stresses[0]);
    if (number > CLOD_LIMITS_INERTIA) {
        clod_warning_box_add(list,
                             "%s: inertial number %.2g if the solid is sheared and does not "
                             "slip: not quasi-static (%.0e); lower wall_friction.speed",
                             part->name, number, CLOD_LIMITS_INERTIA_GOOD);
    }
}

/** Between bars and plate one layer of grains rolls like the balls of a bearing. */
static void add_gap(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_wall_shear *t = part->test;
    const double gap =
        (t->point[t->at - 1].height - t->bar_height - from->wall_friction.plate_ridges.height) /
        (2.0 * from->wall_friction.radius_mean);
    if (t->bar_height > 0.0 && gap < CLOD_LIMITS_BARS_GRAINS) {
        clod_warning_box_add(
            list,
            "%s: only %.1f grain diameters between the bars of the lid and the "
            "plate (at least %.0f): grains roll there and the plate feels too "
            "little. Raise wall_friction.depth, or lower bar_height",
            part->name, gap, CLOD_LIMITS_BARS_GRAINS);
    }
}

json_t *clod_wall_shear_warnings(const clod_case *from, const clod_part *part, int parts)
{
    json_t *list = json_array();
    add_cell(list, from, part, parts);
    for (int p = 0; p < parts; p++) {
        const clod_wall_shear *t = part[p].test;
        const int64_t points = part[p].point >= 0 ? t->at : 0;
        add_settling(list, from, &part[p]);
        for (int64_t k = 0; k < points; k++) {
            add_steadiness(list, from, &part[p], k);
        }
        for (int64_t k = 0; k < points; k++) {
            add_sides(list, &part[p], k);
        }
        if (points > 0) {
            add_inertia(list, from, &part[p]);
            add_gap(list, from, &part[p]);
        }
        clod_parts_warn_end(list, &part[p]);
    }
    return list;
}
