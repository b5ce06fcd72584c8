#include "sim/leavers.h"

#include <inttypes.h>

#include "base/plural.h"
#include "setup/grains.h"
#include "sim/residence.h"

/** Names of a side, in the order of CLOD_FACES. */
typedef struct side {
    const char *name;
    const char *column[3]; ///< grains, mass, kinetic energy that have left
} side;

#define SIDE(name)                                                                             \
    {                                                                                          \
        name,                                                                                  \
        {                                                                                      \
            "left_" name ".grains [1]", "left_" name ".mass [kg]", "left_" name ".energy [J]"  \
        }                                                                                      \
    }
static const side SIDES[CLOD_FACES] = {SIDE("x_min"), SIDE("x_max"), SIDE("y_min"),
                                       SIDE("y_max"), SIDE("z_min"), SIDE("z_max")};

static bool is_open(const clod_case *from, int face)
{
    return from->open == CLOD_OPEN_DELETE && !from->periodic[face / 2];
}

static bool has_inlets_or_outlets(const clod_case *from)
{
    return clod_setup_grains_coming(from) + from->outlet_count > 0;
}

size_t clod_leavers_columns(const clod_case *from, const char **names)
{
    size_t count = 0;
    if (from->open == CLOD_OPEN_DELETE || has_inlets_or_outlets(from)) {
        names[count++] = "grains [1]";
    }
    for (int f = 0; f < CLOD_FACES; f++) {
        for (int c = 0; is_open(from, f) && c < 3; c++) {
            names[count++] = SIDES[f].column[c];
        }
    }
    return count;
}

void clod_leavers_row(const clod_case *from, const clod_state *state, double *row)
{
    const clod_exchange *gone = &state->exchange;
    if (from->open == CLOD_OPEN_DELETE || has_inlets_or_outlets(from)) {
        *row++ = (double)state->grains.count;
    }
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(from, f)) {
            *row++ = (double)gone->left[f];
            *row++ = gone->left_mass[f];
            *row++ = gone->left_energy[f];
        }
    }
}

void clod_leavers_report(FILE *out, const clod_case *from, const clod_state *state)
{
    const clod_exchange *gone = &state->exchange;
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(from, f)) {
            fprintf(out, "  left at %-13s %" PRId64 " grain%s, %.6g kg, %.6g J kinetic\n",
                    SIDES[f].name, gone->left[f], clod_plural((double)gone->left[f]),
                    gone->left_mass[f], gone->left_energy[f]);
        }
    }
    for (size_t k = 0; k < from->outlet_count; k++) {
        const size_t e = CLOD_FACES + k;
        fprintf(out, "  outlet %-14s %" PRId64 " grain%s, %.6g kg, %.6g J kinetic\n",
                from->outlets[k].name, gone->left[e], clod_plural((double)gone->left[e]),
                gone->left_mass[e], gone->left_energy[e]);
    }
    clod_residence_report(out, gone);
}

json_t *clod_leavers_json(const clod_case *from, const clod_state *state)
{
    if (from->open != CLOD_OPEN_DELETE) {
        return NULL;
    }
    const clod_exchange *gone = &state->exchange;
    json_t *sides = json_object();
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(from, f)) {
            json_object_set_new(
                sides, SIDES[f].name,
                json_pack("{s:I, s:f, s:f}", "grains", (json_int_t)gone->left[f], "mass_kg",
                          gone->left_mass[f], "kinetic_energy_J", gone->left_energy[f]));
        }
    }
    return sides;
}

void clod_leavers_outlet_column(const clod_case *from, size_t k, int column, char *text,
                                size_t size)
{
    static const char *const NAME[CLOD_OUTLET_COLUMNS] = {"grains [1]", "mass [kg]",
                                                          "energy [J]"};
    snprintf(text, size, "outlet_%s.%s", from->outlets[k].name, NAME[column]);
}

size_t clod_leavers_outlets_row(const clod_case *from, const clod_state *state, double *row)
{
    const clod_exchange *gone = &state->exchange;
    for (size_t k = 0; k < from->outlet_count; k++) {
        row[CLOD_OUTLET_COLUMNS * k] = (double)gone->left[CLOD_FACES + k];
        row[CLOD_OUTLET_COLUMNS * k + 1] = gone->left_mass[CLOD_FACES + k];
        row[CLOD_OUTLET_COLUMNS * k + 2] = gone->left_energy[CLOD_FACES + k];
    }
    return CLOD_OUTLET_COLUMNS * from->outlet_count;
}

json_t *clod_leavers_outlets_json(const clod_case *from, const clod_state *state)
{
    if (from->outlet_count == 0) {
        return NULL;
    }
    const clod_exchange *gone = &state->exchange;
    json_t *all = json_object();
    for (size_t k = 0; k < from->outlet_count; k++) {
        const size_t e = CLOD_FACES + k;
        json_object_set_new(all, from->outlets[k].name,
                            json_pack("{s:I, s:f, s:f}", "grains", (json_int_t)gone->left[e],
                                      "mass_kg", gone->left_mass[e], "kinetic_energy_J",
                                      gone->left_energy[e]));
    }
    return all;
}
