/**
 * @file table.c
 * A design for people: aligned tables with units, intervals and warnings.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/text.h"
#include "hopper/fields.h"

#define WIDTH 96 ///< of a line of text
#define DEGREES 57.295779513082323

static void put_number(FILE *out, int width, const clod_hopper_field *how, double value)
{
    if (isnan(value)) {
        fprintf(out, "%*s", width, "-");
    } else if (isinf(value)) {
        fprintf(out, "%*s", width, "infinite");
    } else if (value == 0.0 && how->zero != NULL) {
        fprintf(out, "%*s", width, how->zero);
    } else {
        fprintf(out, "%*.*f", width, how->digits, how->scale * value);
    }
}

static void put_line(FILE *out, const clod_hopper_field *how, const clod_hopper_value *number)
{
    fprintf(out, "  %-32s", how->text);
    put_number(out, 10, how, number->value);
    put_number(out, 12, how, number->low);
    put_number(out, 12, how, number->high);
    fprintf(out, "%s%s\n", how->unit[0] == '\0' ? "" : "  ", how->unit);
}

/** A text, broken between words, its lines after the first as far in as the first. */
static void put_text(FILE *out, const char *first, const char *text)
{
    const size_t indent = strlen(first);
    fputs(first, out);
    while (strlen(text) > WIDTH - indent) {
        size_t end = WIDTH - indent;
        while (end > 0 && text[end] != ' ') {
            end--;
        }
        end = end == 0 ? WIDTH - indent : end;
        fprintf(out, "%.*s\n%*s", (int)end, text, (int)indent, "");
        text += end + (text[end] == ' ' ? 1 : 0);
    }
    fprintf(out, "%s\n", text);
}

/** What comes of the shape, in a sentence. */
static void put_verdict(FILE *out, const clod_hopper_found *found)
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "Mass flow, and no cohesive arch above the critical outlet.",
        [CLOD_HOPPER_NO_ARCH] =
            ("Mass flow. The strength nowhere reaches the stress of an arch: no cohesive arch "
             "at any outlet. Particles and the flow rate decide about its size."),
        [CLOD_HOPPER_ARCHES] =
            ("The strength stays above the stress of an arch, at every stress or beyond some "
             "stress: no outlet is large enough, the solid cannot flow by gravity."),
        [CLOD_HOPPER_FUNNEL] =
            ("Funnel flow: the solid does not slide along this wall. A smoother or a steeper "
             "one may help; otherwise see the rathole."),
        [CLOD_HOPPER_UNSETTLED] = "No critical state was found; see the warnings.",
    };
    const clod_hopper_design *at = &found->design;
    if (at->outcome == CLOD_HOPPER_UNPROVEN) {
        char text[256];
        snprintf(
            text, sizeof text,
            "Not known to be mass flow: a wedge steeper than %.1f deg is, this one has %.1f "
            "deg. If a chart for wedges allows that, no cohesive arch stands %s.",
            DEGREES * at->limit, DEGREES * at->half_angle,
            at->outlet > 0.0 ? "above the critical outlet" : "at any outlet");
        put_text(out, "  ", text);
    } else {
        put_text(out, "  ", WORDS[at->outcome]);
    }
}

static void put_shares(FILE *out, const clod_hopper_found *found)
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "with a critical outlet",
        [CLOD_HOPPER_NO_ARCH] = "without an arch",
        [CLOD_HOPPER_ARCHES] = "arching at any outlet",
        [CLOD_HOPPER_FUNNEL] = "in funnel flow",
        [CLOD_HOPPER_UNSETTLED] = "not settled",
        [CLOD_HOPPER_UNPROVEN] = "not known to be mass flow"};
    char text[256] = "";
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        if (found->share[k] > 0.0) {
            const size_t used = strlen(text);
            snprintf(text + used, sizeof text - used, "%s%.1f %% %s", used > 0 ? ", " : "",
                     100.0 * found->share[k], WORDS[k]);
        }
    }
    put_text(out, "  samples ", text);
}

static void put_planned(FILE *out, const clod_hopper_found *found)
{
    if (found->planned <= 0.0) {
        return;
    }
    fprintf(out, "\n  Outlet of %.1f mm%s\n", 1e3 * found->planned,
            found->design.outcome == CLOD_HOPPER_UNPROVEN ? ", if it is mass flow" : "");
    put_line(out, &CLOD_HOPPER_FIELDS[CLOD_HOPPER_MARGIN], &found->number[CLOD_HOPPER_MARGIN]);
    fprintf(out, "  %-32s%10.1f %%\n", "samples that do not flow", 100.0 * found->arching);
    if (found->share[CLOD_HOPPER_UNPROVEN] > 0.0) {
        fprintf(out, "  %-32s%10.1f %%\n", "perhaps no mass flow",
                100.0 * found->share[CLOD_HOPPER_UNPROVEN]);
    }
}

static void put_shape(FILE *out, const clod_hopper_found *found)
{
    const bool cone = found->wish.shape == CLOD_RADIAL_CONE;
    fprintf(out, "\n%s\n",
            cone ? "Cone, round outlet" : "Wedge, slot at least 3 times as long");
    put_verdict(out, found);
    for (int n = 0; n < CLOD_HOPPER_MARGIN; n++) {
        put_line(out, &CLOD_HOPPER_FIELDS[n], &found->number[n]);
    }
    if (found->mechanical > 0.0) {
        fprintf(out, "  %-32s%10.1f                          mm\n",
                cone ? "outlet by particles, 8 times" : "outlet by particles, 4 times",
                1e3 * found->mechanical);
    }
    put_shares(out, found);
    put_planned(out, found);
}

static void put_rathole(FILE *out, const clod_hopper *self)
{
    static const clod_hopper_field EMPTYING = {
        "", "diameter, emptying (least)", "mm", 1e3, 1.0, 1, NULL};
    static const clod_hopper_field FILLING = {
        "", "diameter, after filling (most)", "mm", 1e3, 1.0, 1, NULL};
    if (self->solid.phi_t.count == 0) {
        return;
    }
    fputs("\nRathole in funnel flow\n", out);
    put_line(out, &EMPTYING, &self->rathole[CLOD_HOPPER_EMPTYING]);
    if (self->silo.diameter > 0.0) {
        put_line(out, &FILLING, &self->rathole[CLOD_HOPPER_FILLING]);
        fprintf(out, "  %-32s%10.3f                          kPa\n",
                "vertical stress after filling", 1e-3 * self->hole.filling_stress);
    }
}

char *clod_hopper_table(const clod_hopper *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    const double tail = 50.0 * (1.0 - self->from.interval.level);
    fprintf(out, "Hopper%s%s\n\n", self->from.title != NULL ? ": " : "",
            self->from.title != NULL ? self->from.title : "");
    fprintf(out, "  %-32s%10s%10.3g %%%10.3g %%\n", "", "value", tail, 100.0 - tail);
    put_shape(out, &self->shape[CLOD_RADIAL_CONE]);
    put_shape(out, &self->shape[CLOD_RADIAL_WEDGE]);
    put_rathole(out, self);
    fprintf(out, "\n  %.3g %% interval from %lld samples, seed %lld; H(theta) by %s\n",
            100.0 * self->from.interval.level, (long long)self->from.interval.samples,
            (long long)self->from.interval.seed, CLOD_HOPPER_ARCH_NAMES[self->from.arch]);
    fputs(self->warnings.count > 0 ? "\n  Warnings\n" : "", out);
    for (size_t i = 0; i < self->warnings.count; i++) {
        put_text(out, "  - ", self->warnings.text[i]);
    }
    return clod_text_close(&text);
}
