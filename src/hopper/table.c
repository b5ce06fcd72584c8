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
#include "hopper/words.h"

#define WIDTH 96 ///< of a line of text

static void put_number(FILE *out, int width, const clod_hopper_field *how, double value)
{
    if (isnan(value)) {
        fprintf(out, "%*s", width, "-");
    } else if (isinf(value)) {
        fprintf(out, "%*s", width, how->zero != NULL ? how->zero : "infinite");
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

static void put_planned(FILE *out, const clod_hopper_found *found)
{
    static const clod_hopper_field SHARE = {"", "", "%", 100.0, 1.0, 1, NULL};
    if (found->planned <= 0.0) {
        return;
    }
    fprintf(out, "\n  Outlet of %.1f mm%s\n", 1e3 * found->planned,
            found->design.outcome == CLOD_HOPPER_UNPROVEN ? ", if it is mass flow" : "");
    put_line(out, &CLOD_HOPPER_FIELDS[CLOD_HOPPER_MARGIN], &found->number[CLOD_HOPPER_MARGIN]);
    fprintf(out, "  %-32s",
            found->design.outcome == CLOD_HOPPER_FUNNEL ? "samples without mass flow"
                                                        : "samples that do not flow");
    put_number(out, 10, &SHARE, found->arching);
    fputs(" %\n", out);
    if (found->share[CLOD_HOPPER_UNPROVEN] > 0.0) {
        fprintf(out, "  %-32s%10.1f %%\n", "perhaps no mass flow",
                100.0 * found->share[CLOD_HOPPER_UNPROVEN]);
    }
}

/** The outlets that specimens ask for, each alone: "43.1 (seed 101), 42.9 (seed 102) mm"; of as many as
 *  have room. */
static void put_specimens(FILE *out, const clod_hopper *self, int shape)
{
    char text[1024] = "";
    size_t used = 0;
    size_t k = 0;
    for (; k < self->specimen_count && used < sizeof text - 80; k++) {
        const clod_hopper_specimen *at = &self->specimens[k];
        const double outlet = 1e3 * at->outlet[shape];
        char number[32] = "none"; // arches at every size, or funnel flow
        if (isfinite(outlet)) {
            snprintf(number, sizeof number, "%.1f", outlet);
        }
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s (seed %lld)",
                                 k > 0 ? ", " : "", isnan(outlet) ? "-" : number,
                                 (long long)at->seed);
    }
    if (k > 0) {
        snprintf(text + used, sizeof text - used, "%s mm",
                 k < self->specimen_count ? ", ..." : "");
        put_text(out, "  critical outlet by specimen ", text);
    }
}

/** How well the number of samples tells the ends of an interval. */
static void put_ends(FILE *out, const clod_hopper_field *how, const clod_hopper_value *number)
{
    if (number->low_error > 0.0 || number->high_error > 0.0) {
        fprintf(out, "  %-32s%10s", "  ends, ± by number of samples", "");
        put_number(out, 12, how, number->low_error);
        put_number(out, 12, how, number->high_error);
        fprintf(out, "  %s\n", how->unit);
    }
}

static void put_shape(FILE *out, const clod_hopper *self, int shape)
{
    const clod_hopper_found *found = &self->shape[shape];
    const bool cone = found->wish.shape == CLOD_RADIAL_CONE;
    char text[CLOD_WORDS_MOST];
    fprintf(out, "\n%s\n",
            cone ? "Cone, round outlet" : "Wedge, slot at least 3 times as long");
    clod_words_verdict(found, text);
    put_text(out, "  ", text);
    if (clod_words_design_state(found, text)) {
        const bool funnel = found->design.outcome == CLOD_HOPPER_FUNNEL;
        put_text(out, funnel ? "  why: " : "  limit and half angle: ", text);
    }
    for (int n = 0; n < CLOD_HOPPER_MARGIN; n++) {
        const clod_hopper_field *how = clod_hopper_field_of(found, (clod_hopper_number)n);
        put_line(out, how, &found->number[n]);
        if (n == CLOD_HOPPER_OUTLET) {
            put_ends(out, &CLOD_HOPPER_FIELDS[n], &found->number[n]);
        }
    }
    if (found->mechanical > 0.0) {
        fprintf(out, "  %-32s%10.1f                          mm\n",
                cone ? "outlet by particles, 8 times" : "outlet by particles, 4 times",
                1e3 * found->mechanical);
    }
    if (!cone) {
        put_line(out, &CLOD_HOPPER_FIELD_SLOT, &self->slot_width);
    }
    clod_words_shares(found, text);
    put_text(out, "  samples ", text);
    put_specimens(out, self, (int)found->wish.shape);
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
    if (self->from.strength.after_storage != NULL) {
        fprintf(out, "  After storage: f_c of %s\n\n", self->from.strength.after_storage);
    }
    fprintf(out, "  %-32s%10s%10.3g %%%10.3g %%\n", "", "value", tail, 100.0 - tail);
    put_shape(out, self, CLOD_RADIAL_CONE);
    put_shape(out, self, CLOD_RADIAL_WEDGE);
    put_rathole(out, self);
    fprintf(out, "\n  %.3g %% interval from %lld samples, seed %lld; H(theta) by %s\n",
            100.0 * self->from.interval.level, (long long)self->from.interval.samples,
            (long long)self->from.interval.seed, CLOD_HOPPER_ARCH_NAMES[self->from.arch]);
    char note[CLOD_WORDS_MOST];
    if (clod_words_line(self, note)) {
        put_text(out, "  ", note);
    }
    if (clod_words_drawn(self, note)) {
        put_text(out, "  ", note);
    }
    fputs(self->warnings.count > 0 ? "\n  Warnings\n" : "", out);
    for (size_t i = 0; i < self->warnings.count; i++) {
        put_text(out, "  - ", self->warnings.text[i]);
    }
    return clod_text_close(&text);
}
