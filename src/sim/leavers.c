#include "sim/leavers.h"

#include <inttypes.h>

#include "base/plural.h"
#include "setup/grains.h"

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

/** Columns of a side or an outlet. */
#define PER_EXIT 3

static size_t inside_columns(const clod_case *from)
{
    return from->open == CLOD_OPEN_DELETE || has_inlets_or_outlets(from) ? 1 : 0;
}

static size_t side_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    size_t count = inside_columns(from);
    for (int f = 0; f < CLOD_FACES; f++) {
        count += is_open(from, f) ? PER_EXIT : 0;
    }
    return count;
}

static void side_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                        size_t size)
{
    (void)state;
    if (k < inside_columns(from)) {
        snprintf(text, size, "grains [1]");
        return;
    }
    k -= inside_columns(from);
    int face = 0;
    for (; !is_open(from, face) || k >= PER_EXIT; face++) {
        k -= is_open(from, face) ? PER_EXIT : 0;
    }
    snprintf(text, size, "%s", SIDES[face].column[k]);
}

/** Number, mass and energy that left at an exit: sides first, then outlets. */
static double *put_exit(const clod_exchange *gone, size_t exit, double *row)
{
    *row++ = (double)gone->left[exit];
    *row++ = gone->left_mass[exit];
    *row++ = gone->left_energy[exit];
    return row;
}

static void side_row(void *memory, const clod_free_moment *now, double *row)
{
    (void)memory;
    if (inside_columns(now->from) > 0) {
        *row++ = (double)now->motion->grains;
    }
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(now->from, f)) {
            row = put_exit(&now->state->exchange, (size_t)f, row);
        }
    }
}

static void side_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_exchange *gone = &now->state->exchange;
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(now->from, f)) {
            fprintf(out, "  left at %-13s %" PRId64 " grain%s, %.6g kg, %.6g J kinetic\n",
                    SIDES[f].name, gone->left[f], clod_plural((double)gone->left[f]),
                    gone->left_mass[f], gone->left_energy[f]);
        }
    }
}

static json_t *exit_json(const clod_exchange *gone, size_t exit)
{
    return json_pack("{s:I, s:f, s:f}", "grains", (json_int_t)gone->left[exit], "mass_kg",
                     gone->left_mass[exit], "kinetic_energy_J", gone->left_energy[exit]);
}

/** Of exit_json. */
#define EXIT_PATHS "grains mass_kg kinetic_energy_J"

static void side_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(from, f)) {
            clod_free_paths_add(paths, SIDES[f].name, EXIT_PATHS);
        }
    }
}

static bool side_told(const clod_case *from)
{
    return from->open == CLOD_OPEN_DELETE;
}

static json_t *side_json(const void *memory, const clod_free_moment *now)
{
    (void)memory;
    json_t *sides = json_object();
    for (int f = 0; f < CLOD_FACES; f++) {
        if (is_open(now->from, f)) {
            json_object_set_new(sides, SIDES[f].name,
                                exit_json(&now->state->exchange, (size_t)f));
        }
    }
    return sides;
}

const clod_free_measure CLOD_MEASURE_LEAVERS = {.key = "left",
                                                .paths = side_paths,
                                                .columns = side_columns,
                                                .column = side_column,
                                                .row = side_row,
                                                .report = side_report,
                                                .told = side_told,
                                                .json = side_json};

static size_t outlet_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return PER_EXIT * from->outlet_count;
}

static void outlet_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    static const char *const NAME[PER_EXIT] = {"grains [1]", "mass [kg]", "energy [J]"};
    (void)state;
    snprintf(text, size, "outlet_%s.%s", from->outlets[k / PER_EXIT].name, NAME[k % PER_EXIT]);
}

static void outlet_row(void *memory, const clod_free_moment *now, double *row)
{
    (void)memory;
    for (size_t k = 0; k < now->from->outlet_count; k++) {
        row = put_exit(&now->state->exchange, CLOD_FACES + k, row);
    }
}

static void outlet_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_exchange *gone = &now->state->exchange;
    for (size_t k = 0; k < now->from->outlet_count; k++) {
        const size_t e = CLOD_FACES + k;
        fprintf(out, "  outlet %-14s %" PRId64 " grain%s, %.6g kg, %.6g J kinetic\n",
                now->from->outlets[k].name, gone->left[e], clod_plural((double)gone->left[e]),
                gone->left_mass[e], gone->left_energy[e]);
    }
}

static bool outlet_told(const clod_case *from)
{
    return from->outlet_count > 0;
}

static json_t *outlet_json(const void *memory, const clod_free_moment *now)
{
    (void)memory;
    json_t *all = json_object();
    for (size_t k = 0; k < now->from->outlet_count; k++) {
        json_object_set_new(all, now->from->outlets[k].name,
                            exit_json(&now->state->exchange, CLOD_FACES + k));
    }
    return all;
}

static void outlet_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t e = 0; e < from->outlet_count; e++) {
        clod_free_paths_add(paths, from->outlets[e].name, EXIT_PATHS);
    }
}

const clod_free_measure CLOD_MEASURE_OUTLETS = {.key = "outlets",
                                                .paths = outlet_paths,
                                                .columns = outlet_columns,
                                                .column = outlet_column,
                                                .row = outlet_row,
                                                .report = outlet_report,
                                                .told = outlet_told,
                                                .json = outlet_json};
