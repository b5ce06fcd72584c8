/**
 * @file export.c
 * A design for other programs: JSON with everything.
 */

#include <jansson.h>
#include <math.h>
#include <stdio.h>

#include "analysis/cells.h"
#include "base/given.h"
#include "base/json.h"
#include "clod/version.h"
#include "hopper/fields.h"
#include "hopper/joint.h"

#define DEGREES 57.295779513082323

/** JSON has no infinity, and here it means something: "infinite". */
static json_t *number(double value)
{
    return isinf(value) ? json_string("infinite") : clod_json_number(value);
}

static json_t *interval(const clod_hopper_value *from, double scale)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "value", number(scale * from->value), "low",
                     number(scale * from->low), "high", number(scale * from->high), "low_error",
                     number(scale * from->low_error), "high_error",
                     number(scale * from->high_error));
}

/** Pairs of m. */
static json_t *ranges_of(const clod_ranges *from)
{
    json_t *list = json_array();
    for (size_t k = 0; k < from->count; k++) {
        json_array_append_new(
            list, json_pack("[o, o]", number(from->of[k].from), number(from->of[k].to)));
    }
    return list;
}

/** Outlets of the samples by their shares, and where their spread comes from. */
static void put_spread(json_t *self, const clod_hopper_found *found)
{
    json_t *quantiles = json_array();
    for (int q = 0; q < CLOD_HOPPER_QUANTILES; q++) {
        json_array_append_new(quantiles, number(found->quantile[q]));
    }
    json_object_set_new(self, "outlet_percentiles_m", quantiles);
    json_t *causes = json_object();
    for (int k = 0; k < CLOD_SOLID_CURVES; k++) {
        if (k != CLOD_SOLID_PHI_T) { // which only the rathole needs
            json_object_set_new(causes, CLOD_HOPPER_CURVE_KEYS[k], number(found->cause[k]));
        }
    }
    json_object_set_new(causes, "not_told", number(found->untold));
    json_object_set_new(self, "outlet_variance_shares", causes);
}

static json_t *shape_of(const clod_hopper_found *found)
{
    json_t *self = json_object();
    json_object_set_new(self, "outcome",
                        json_string(CLOD_HOPPER_OUTCOME_NAMES[found->design.outcome]));
    for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
        const clod_hopper_field *field = &CLOD_HOPPER_FIELDS[n];
        if (n != CLOD_HOPPER_MARGIN || found->planned > 0.0) {
            json_object_set_new(self, field->key, interval(&found->number[n], field->json));
        }
    }
    const clod_hopper_design *at = &found->design;
    if (at->built > 0.0) {
        json_object_set_new(self, "design_state",
                            json_pack("{s:o, s:o, s:o, s:o, s:o}", "outlet_m",
                                      number(at->built), "sigma_1_Pa",
                                      number(at->design_state.sigma_1), "sigma_w_Pa",
                                      number(at->design_state.sigma_w), "phi_e_deg",
                                      number(DEGREES * at->design_state.phi_e), "phi_w_deg",
                                      number(DEGREES * at->design_state.phi_w)));
    }
    json_object_set_new(self, "limit_given", json_boolean(found->wish.limit > 0.0));
    json_object_set_new(self, "outlet_by_wall", json_boolean(at->sticks));
    json_object_set_new(self, "smaller_outlets_without_arch_m", ranges_of(&found->lower));
    if (found->planned > 0.0) {
        json_object_set_new(self, "planned_outlet_m", number(found->planned));
        json_object_set_new(self, "planned_outlet_arching_share", number(found->arching));
    }
    if (found->mechanical > 0.0) {
        json_object_set_new(self, "particle_outlet_m", number(found->mechanical));
    }
    json_t *shares = json_object();
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        json_object_set_new(shares, CLOD_HOPPER_OUTCOME_NAMES[k], number(found->share[k]));
    }
    json_object_set_new(self, "sample_shares", shares);
    put_spread(self, found);
    return self;
}

static json_t *rathole_of(const clod_hopper *self)
{
    const bool known = self->solid.phi_t.count > 0, filled = known && self->silo.diameter > 0.0;
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:{s:o, s:o}}", "emptying_m",
                     interval(&self->rathole[CLOD_HOPPER_EMPTYING], 1.0),
                     "smaller_diameters_without_rathole_m", ranges_of(&self->lower_holes),
                     "filling_m", interval(&self->rathole[CLOD_HOPPER_FILLING], 1.0),
                     "filling_stress_Pa", number(self->hole.filling_stress),
                     CLOD_HOPPER_FIELD_SLOT.key, interval(&self->slot_width, 1.0),
                     "known_shares", "emptying",
                     number(known ? self->holed[CLOD_HOPPER_EMPTYING] : (double)NAN), "filling",
                     number(filled ? self->holed[CLOD_HOPPER_FILLING] : (double)NAN));
}

static json_t *curve_of(const clod_curve *curve, const char *x, const char *y, double scale)
{
    json_t *list = json_array();
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        json_array_append_new(list,
                              json_pack("{s:o, s:o, s:o, s:o}", x, number(point->x), y,
                                        number(scale * point->y), "x_error",
                                        number(clod_cells_error(point->x_error)), "y_error",
                                        number(scale * clod_cells_error(point->y_error))));
    }
    return list;
}

static json_t *measured(const clod_hopper *self)
{
    const clod_solid *solid = &self->solid;
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "flow_function",
                     curve_of(&solid->strength, "sigma_1_Pa", "f_c_Pa", 1.0), "phi_e",
                     curve_of(&solid->phi_e, "sigma_1_Pa", "phi_e_deg", DEGREES), "phi_t",
                     curve_of(&solid->phi_t, "sigma_1_Pa", "phi_t_deg", DEGREES), "rho_b",
                     curve_of(&solid->rho, "sigma_1_Pa", "rho_b_kg_m3", 1.0), "wall",
                     curve_of(&solid->wall, "sigma_w_Pa", "tau_w_Pa", 1.0));
}

/** The line of the flow function, and how well it fits; null: there is none. */
static json_t *line_of(const clod_curve *strength)
{
    const clod_curve_misfit *at = &strength->misfit;
    if (at->stretch == 0.0) {
        return json_null();
    }
    return json_pack("{s:o, s:o, s:b, s:o, s:I, s:o, s:o}", "f_c_at_0_Pa", number(at->line.a),
                     "slope", number(at->line.b), "weighted", at->weighted, "chi_square",
                     number(at->chi_square), "degrees_of_freedom", (json_int_t)at->freedom,
                     "p_value", number(at->chance), "errors_times", number(at->stretch));
}

/** Designs from each specimen alone. */
static json_t *specimens_of(const clod_hopper *self)
{
    json_t *list = json_array();
    for (size_t k = 0; k < self->specimen_count; k++) {
        const clod_hopper_specimen *at = &self->specimens[k];
        json_t *one = json_pack("{s:I}", "seed", (json_int_t)at->seed);
        for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
            json_object_set_new(one, CLOD_HOPPER_SHAPE_NAMES[s],
                                json_pack("{s:o, s:o}", "half_angle_deg",
                                          number(DEGREES * at->half_angle[s]), "outlet_m",
                                          number(at->outlet[s])));
        }
        json_array_append_new(list, one);
    }
    return list;
}

char *clod_hopper_json(const clod_hopper *self)
{
    CLOD_NEED(self);
    json_t *warnings = json_array();
    json_t *overrides = json_array();
    for (size_t i = 0; i < self->warnings.count; i++) {
        json_array_append_new(warnings, json_string(self->warnings.text[i]));
    }
    for (size_t i = 0; i < self->override_count; i++) {
        json_array_append_new(overrides, json_string(self->overrides[i]));
    }
    const clod_hopper_interval *interval_of = &self->from.interval;
    const clod_joint_rows loci = clod_joint_count(&self->solid);
    json_t *all = json_pack(
        "{s:s?, s:s?, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:s, s:{s:f, s:I, s:I, s:I, s:I}, s:o, s:o}",
        "title", self->from.title, "after_storage", self->from.strength.after_storage,
        "version", clod_version_text(), "case", self->path, "overrides", overrides, "cone",
        shape_of(&self->shape[CLOD_RADIAL_CONE]), "wedge",
        shape_of(&self->shape[CLOD_RADIAL_WEDGE]), "rathole", rathole_of(self), "measured",
        measured(self), "flow_function_line", line_of(&self->solid.strength), "arch_thickness",
        CLOD_HOPPER_ARCH_NAMES[self->from.arch], "interval", "level", interval_of->level,
        "samples", (json_int_t)interval_of->samples, "seed", (json_int_t)interval_of->seed,
        "loci_drawn_together", (json_int_t)loci.together, "loci_drawn_apart",
        (json_int_t)loci.apart, "specimens", specimens_of(self), "warnings", warnings);
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}
