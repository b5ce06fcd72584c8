#include "report/hopper_page.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "hopper/words.h"
#include "report/hopper_cells.h"
#include "report/hopper_figures.h"
#include "report/hopper_numbers.h"
#include "report/html.h"

static void put_card(FILE *out, const clod_hopper_field *how, double value, const char *caption)
{
    char text[48];
    clod_hopper_cells_text(text, how, value);
    fputs("<div class=\"card\">", out);
    clod_hopper_cells_begin(out, "b", how, value);
    fputs(text, out);
    if (isfinite(value) && (value != 0.0 || how->zero == NULL)) {
        fprintf(out, " <small>%s</small>", how->unit);
    }
    fputs("</b>", out);
    clod_html_cell(out, "span", caption);
    fputs("</div>\n", out);
}

/** "As measured 18.9, within the errors 16.7 to 20.5 deg" */
static void tell(char text[240], const clod_hopper_field *how, const clod_hopper_value *number)
{
    char value[48], low[48], high[48];
    const char *gap = how->unit[0] != '\0' ? " " : "";
    clod_hopper_cells_text(value, how, number->value);
    clod_hopper_cells_text(low, how, number->low);
    clod_hopper_cells_text(high, how, number->high);
    if (isnan(number->low)) {
        snprintf(text, 240, "As measured %s%s%s; how far errors may move it is not known",
                 value, gap, how->unit);
    } else {
        snprintf(text, 240, "As measured %s, within the errors %s to %s%s%s", value, low, high,
                 gap, how->unit);
    }
}

/** A card of the size to build; infinite: there is none. `none` is what takes the place of `what` then. */
static void put_size(FILE *out, const clod_hopper_field *how, double build, const char *what,
                     const char *none, const char *numbers)
{
    clod_hopper_field shown = *how;
    char caption[1024];
    shown.zero = isinf(build) ? "not known" : how->zero;
    snprintf(caption, sizeof caption, "%s. %s", isinf(build) ? none : what, numbers);
    put_card(out, &shown, build, caption);
}

/** Which outlet the half angle is for: that of the wish or of the particles, where they are not below the critical one. */
static double least_of(const clod_hopper_found *found)
{
    const double least = fmax(found->planned, found->mechanical);
    return found->design.built <= least ? least : 0.0;
}

/** "an outlet of 500.0 mm": that, or the stress, which limit and half angle are of. */
static void tell_outlet(char text[64], const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    const double least = least_of(found);
    if (least > 0.0 || at->at_measured) {
        snprintf(text, 64, "an outlet of %.1f mm", 1e3 * (least > 0.0 ? least : at->built));
    } else if (at->built > 0.0) {
        snprintf(text, 64, "the critical outlet");
    } else {
        snprintf(text, 64, "a sigma_1 of %.3f kPa", 1e-3 * at->design_state.sigma_1);
    }
}

/** ". With this outlet the half angle is 19.1 in place of 20.5 deg, as measured", of one below that of the half angle. */
static void tell_steeper(char text[176], const clod_hopper *design,
                         const clod_hopper_found *found, double build)
{
    const double least = least_of(found);
    clod_hopper_wish wish = found->wish;
    text[0] = '\0';
    if (wish.half_angle > 0.0 || wish.limit > 0.0 || !(build < least)) {
        return;
    }
    wish.outlet = build;
    wish.least = 0.0;
    const clod_hopper_design at = clod_hopper_design_shape(&design->solid, &wish);
    if (at.outcome == CLOD_HOPPER_FLOWS || at.outcome == CLOD_HOPPER_NO_ARCH) {
        const clod_hopper_field *how = &CLOD_HOPPER_FIELDS[CLOD_HOPPER_HALF_ANGLE];
        char here[48], there[48];
        clod_hopper_cells_text(here, how, at.half_angle);
        clod_hopper_cells_text(there, how, found->design.half_angle);
        snprintf(text, 176,
                 ". With this outlet the half angle is %s in place of %s deg, as measured",
                 here, there);
    }
}

static void put_angle(FILE *out, const clod_hopper *design, const clod_hopper_found *found)
{
    const clod_hopper_field *how = &CLOD_HOPPER_FIELDS[CLOD_HOPPER_HALF_ANGLE];
    const clod_hopper_value *angle = &found->number[CLOD_HOPPER_HALF_ANGLE];
    char numbers[240], caption[512];
    if (found->wish.half_angle > 0.0) {
        tell(numbers, how, &found->number[CLOD_HOPPER_LIMIT]);
        snprintf(
            caption, sizeof caption,
            "half angle that the case asks for, from the vertical. Limit of mass flow%s: %s",
            found->wish.limit > 0.0 ? " that it gives" : " in a cone", numbers);
        put_card(out, how, found->wish.half_angle, caption);
        return;
    }
    tell(numbers, how, angle);
    const double safe = 50.0 * (1.0 + design->from.interval.level);
    char outlet[64];
    tell_outlet(outlet, found);
    if (isnan(angle->low)) {
        snprintf(caption, sizeof caption,
                 "half angle as measured, from the vertical, for %s: how much steeper to build "
                 "is not known, since %s",
                 outlet,
                 found->wish.limit > 0.0 ? "the limit that is given has no limit_error"
                                         : "the wall friction has no errors");
        put_card(out, how, angle->value, caption);
        return;
    }
    if (angle->low > 0.0) {
        snprintf(
            caption, sizeof caption,
            "half angle to build, at most, from the vertical, for %s: right for %.3g %% of "
            "the samples. %s",
            outlet, safe, numbers);
    } else {
        snprintf(caption, sizeof caption,
                 "half angle to build: none is right for %.3g %% of the samples, for %s. %s",
                 safe, outlet, numbers);
    }
    put_card(out, how, angle->low, caption);
}

/** "; each specimen alone: 42.2, 42.9, 42.4 mm", of as many as have room. */
static void tell_alone(char text[128], const clod_hopper *design, int shape)
{
    const clod_hopper_field *how = &CLOD_HOPPER_FIELDS[CLOD_HOPPER_OUTLET];
    size_t used = 0;
    size_t k = 0;
    text[0] = '\0';
    for (; k < design->specimen_count && used < 96; k++) {
        char value[48];
        clod_hopper_cells_text(value, how, design->specimens[k].outlet[shape]);
        used += (size_t)snprintf(text + used, 128 - used, "%s%.12s",
                                 k == 0 ? "; each specimen alone: " : ", ", value);
    }
    if (used > 0) {
        snprintf(text + used, 128 - used, "%s %s", k < design->specimen_count ? ", ..." : "",
                 how->unit);
    }
}

/** The size to build: the upper end, or the value as measured if it has none. NAN: not known. */
static double build_of(const clod_hopper_value *size, double mechanical)
{
    const double safe = isnan(size->high) ? size->value : size->high;
    return isnan(safe) ? safe : fmax(safe, mechanical);
}

/** What is said of that size. */
static const char *at_least(const clod_hopper_value *size)
{
    return isnan(size->high) ? " as measured: how much wider to build is not known"
                             : " to build, at least";
}

static void put_outlet(FILE *out, const clod_hopper *design, const clod_hopper_found *found)
{
    const clod_hopper_field *how = &CLOD_HOPPER_FIELDS[CLOD_HOPPER_OUTLET];
    const clod_hopper_value *outlet = &found->number[CLOD_HOPPER_OUTLET];
    const bool cone = found->wish.shape == CLOD_RADIAL_CONE;
    const double build = build_of(outlet, found->mechanical);
    char numbers[240], particles[96] = "", alone[128], steeper[176], what[112], all[768];
    tell(numbers, how, outlet);
    tell_steeper(steeper, design, found, build);
    tell_alone(alone, design, (int)found->wish.shape);
    if (found->mechanical > 0.0) {
        snprintf(particles, sizeof particles, "; %s times the largest particle: %.1f mm",
                 cone ? "8" : "4", how->scale * found->mechanical);
    }
    snprintf(what, sizeof what, "%s%s%s", cone ? "diameter of the outlet" : "width of the slot",
             at_least(outlet),
             found->design.outcome == CLOD_HOPPER_UNPROVEN
                 ? ", if a chart for wedges shows mass flow"
                 : "");
    snprintf(all, sizeof all, "Critical outlet: %s%s%s%s", numbers, particles, alone, steeper);
    put_size(out, how, build, what,
             "outlet to build: no outlet of mass flow is known within the errors", all);
}

static void put_margin(FILE *out, const clod_hopper_found *found)
{
    const clod_hopper_field *how = &CLOD_HOPPER_FIELDS[CLOD_HOPPER_MARGIN];
    const clod_hopper_value *margin = &found->number[CLOD_HOPPER_MARGIN];
    const double unproven = found->share[CLOD_HOPPER_UNPROVEN];
    char numbers[240], flow[64] = "", perhaps[64] = "", caption[512];
    if (isnan(margin->value)) { // funnel flow: no arch is asked for
        return;
    }
    tell(numbers, how, margin);
    if (!isnan(found->arching)) {
        snprintf(flow, sizeof flow, "; %.1f %% of the samples do not flow",
                 100.0 * found->arching);
    }
    if (unproven > 0.0) {
        snprintf(perhaps, sizeof perhaps, "; %.1f %% are perhaps no mass flow",
                 100.0 * unproven);
    }
    snprintf(caption, sizeof caption,
             "stress over strength of an arch over the outlet asked for, %.1f mm: above 1 it "
             "breaks. %s%s%s",
             1e3 * found->planned, numbers, flow, perhaps);
    put_card(out, how, margin->value, caption);
}

/** A slot in funnel flow; its length is that of the rathole. */
static void put_slot(FILE *out, const clod_hopper *design, const clod_hopper_found *found)
{
    const clod_hopper_value *width = &design->slot_width;
    char numbers[240], what[192];
    tell(numbers, &CLOD_HOPPER_FIELD_SLOT, width);
    snprintf(what, sizeof what,
             "width of the slot%s, if it stays funnel flow; its diagonal must be longer than "
             "the rathole's diameter",
             at_least(width));
    put_size(out, &CLOD_HOPPER_FIELD_SLOT, build_of(width, found->mechanical), what,
             "slot to build in funnel flow: no width is known within the errors", numbers);
}

static void put_shape(FILE *out, const clod_hopper *design, int shape)
{
    const clod_hopper_found *found = &design->shape[shape];
    const bool funnel = found->design.outcome == CLOD_HOPPER_FUNNEL;
    char text[CLOD_WORDS_MOST];
    clod_words_verdict(found, text);
    fprintf(out, "<h3>%s</h3>\n<p class=\"verdict\">", clod_hopper_cells_shape(shape));
    clod_html_text(out, text);
    fputs("</p>\n", out);
    if (clod_words_design_state(found, text)) {
        fprintf(out, "<p class=\"note\">%s: ", funnel ? "Why" : "Limit and half angle");
        clod_html_text(out, text);
        fputs(".</p>\n", out);
    }
    fputs("<div class=\"cards\">\n", out);
    if (!funnel) {
        put_angle(out, design, found);
        put_outlet(out, design, found);
    }
    if (funnel && found->wish.shape == CLOD_RADIAL_WEDGE) {
        put_slot(out, design, found);
    }
    if (found->planned > 0.0) {
        put_margin(out, found);
    }
    fputs("</div>\n", out);
}

/** A rathole: a wider outlet empties, so its safe end is the larger one. */
static void put_hole(FILE *out, const clod_hopper *design, int hole, const char *what)
{
    const clod_hopper_value *diameter = &design->rathole[hole];
    char numbers[240];
    tell(numbers, &CLOD_HOPPER_CELLS_HOLES[hole], diameter);
    put_size(out, &CLOD_HOPPER_CELLS_HOLES[hole], build_of(diameter, 0.0), what,
             "outlet to build in funnel flow: no diameter is known within the errors", numbers);
}

/** Cards of ratholes; of one that is not known, why. */
static void put_holes(FILE *out, const clod_hopper *design)
{
    const int asked = design->silo.diameter > 0.0 ? CLOD_HOPPER_HOLES : 1;
    char what[CLOD_HOPPER_HOLES][240], why[CLOD_HOPPER_HOLES][CLOD_WORDS_MOST];
    bool none[CLOD_HOPPER_HOLES] = {true, true};
    if (design->solid.phi_t.count == 0) {
        return;
    }
    snprintf(what[CLOD_HOPPER_EMPTYING], sizeof what[0],
             "diameter of the outlet%s, by the stresses around the hole while it empties: a "
             "narrower one may keep a rathole",
             at_least(&design->rathole[CLOD_HOPPER_EMPTYING]));
    snprintf(
        what[CLOD_HOPPER_FILLING], sizeof what[0],
        "diameter of the outlet%s, by the head after filling, %.3f kPa below %.4g m of solid "
        "in a silo of %.4g m",
        isnan(design->rathole[CLOD_HOPPER_FILLING].high)
            ? at_least(&design->rathole[CLOD_HOPPER_FILLING])
            : " that empties in any case",
        1e-3 * design->hole.filling_stress, design->silo.height, design->silo.diameter);
    fputs("<h3>Rathole, if it is funnel flow</h3>\n", out);
    for (int k = 0; k < asked; k++) {
        none[k] = clod_words_no_rathole(design, k, why[k]);
        if (none[k]) {
            clod_html_cell(out, "p", why[k]);
        }
    }
    if (!none[CLOD_HOPPER_EMPTYING] || !none[CLOD_HOPPER_FILLING]) {
        fputs("<div class=\"cards\">\n", out);
        for (int k = 0; k < asked; k++) {
            if (!none[k]) {
                put_hole(out, design, k, what[k]);
            }
        }
        fputs("</div>\n", out);
    }
}

static bool are_alike(const char *one, const char *other)
{
    return clod_text_alike(one, strlen(one), other, strlen(other));
}

/** A warning, and those that differ from it in numbers alone, folded. */
static void put_warning(FILE *out, const clod_warning_list *warnings, size_t first)
{
    size_t alike = 0;
    for (size_t k = first; k < warnings->count; k++) {
        alike += are_alike(warnings->text[first], warnings->text[k]);
    }
    fputs("<li>", out);
    clod_html_text(out, warnings->text[first]);
    if (alike > 1) {
        fprintf(out,
                " <small>(one of %zu like it)</small><details><summary>the numbers of "
                "each</summary><ul>",
                alike);
        for (size_t k = first; k < warnings->count; k++) {
            if (are_alike(warnings->text[first], warnings->text[k])) {
                clod_html_cell(out, "li", warnings->text[k]);
            }
        }
        fputs("</ul></details>", out);
    }
    fputs("</li>\n", out);
}

static void put_warnings(FILE *out, const clod_warning_list *warnings)
{
    if (warnings->count == 0) {
        fputs("<p class=\"good\">No warnings.</p>\n", out);
        return;
    }
    fputs("<section class=\"warnings\" id=\"warnings\"><h2>Warnings</h2><ul>", out);
    for (size_t k = 0; k < warnings->count; k++) {
        bool told = false;
        for (size_t j = 0; j < k; j++) {
            told = told || are_alike(warnings->text[j], warnings->text[k]);
        }
        if (!told) {
            put_warning(out, warnings, k);
        }
    }
    fputs("</ul></section>\n", out);
}

void clod_hopper_page_put(clod_sheet *sheet, const clod_hopper *design)
{
    FILE *out = sheet->body;
    fputs("<header><p class=\"kind\">Hopper</p><h1>", out);
    clod_html_text(out, clod_hopper_page_title(design));
    fputs("</h1><p class=\"when\">", out);
    clod_html_text(out, design->path);
    fputs("</p></header>\n", out);
    put_warnings(out, &design->warnings);
    clod_html_section(out, "decision", "What to build");
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        put_shape(out, design, CLOD_HOPPER_CELLS_SHAPES[k]);
    }
    put_holes(out, design);
    clod_html_section(out, "figures", "The design, and what was measured");
    clod_hopper_figures_put(sheet, design);
    clod_hopper_numbers_put(out, design);
}

const char *clod_hopper_page_title(const clod_hopper *design)
{
    return design->from.title != NULL ? design->from.title : "Hopper";
}
