/**
 * @file params_run.c
 * Tables of the domain, the time step, the stages of a free run and the output.
 */

#include "config/check.h"
#include "config/law_keys.h"
#include "config/param.h"
#include "config/params_corner.h"

#define C clod_case
#define T clod_case_time
#define O clod_case_output
#define S clod_case_stage
#define W clod_case_wall_change

static const char *const OPEN[] = {"stop", "delete", NULL};

static const clod_param DOMAIN_ROWS[] = {
    CLOD_CORNER_ROW("min", "smallest", C, domain_min, "[0 mm, 0 mm, -10 mm]"),
    CLOD_CORNER_ROW("max", "largest", C, domain_max, "[50 mm, 50 mm, 200 mm]"),
    {.key = "periodic",
     .kind = CLOD_PARAM_FLAGS,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false false false",
     .example = "[true, false, false]",
     CLOD_AT(C, periodic),
     .help = "Directions x, y, z in which the domain repeats itself; the other sides are open. "
             "Walls do not repeat: let them end a radius before such a side, or go on "
             "beyond both.",
     .source = "convention"},
    {.key = "open",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = OPEN,
     .fallback = "stop",
     CLOD_AT(C, open),
     .help =
         "What happens when a grain leaves through an open side: stop the run and name it, "
         "or delete it and count number, mass and kinetic energy, by side. It is noticed at "
         "the next rebuild of the neighbour search, at most half a radius of the largest grain "
         "behind the side.",
     .source = "convention"},
};
const clod_table CLOD_TABLE_DOMAIN = {.title = "The space in which grains may be.",
                                      CLOD_ROWS(DOMAIN_ROWS)};

/** Whether a pair that can meet is elastic with the moduli of its materials, or one is not. */
static bool has_law(const clod_case *whole, bool elastic_moduli)
{
    const int n = (int)whole->material_count;
    for (int i = 0; i < n * n; i++) {
        if (clod_check_pair_needed(whole, i / n, i % n) &&
            clod_law_keys_of(clod_case_pair(whole, i / n, i % n)->law)->elastic_moduli ==
                elastic_moduli) {
            return true;
        }
    }
    return false;
}

static bool has_safety(const clod_case *whole, const void *self)
{
    return ((const T *)self)->step == 0.0 && has_law(whole, false);
}

static bool has_rayleigh(const clod_case *whole, const void *self)
{
    return ((const T *)self)->step == 0.0 && has_law(whole, true);
}

static bool has_free_run(const clod_case *whole, const void *self)
{
    (void)self;
    return clod_case_tester(whole) == NULL;
}

static const clod_param TIME_ROWS[] = {
    {.key = "step",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1),
     .zero_word = "auto",
     .fallback = "auto",
     .example = "1e-7 s",
     CLOD_AT(T, step),
     .help = "Time step, or auto: from the stiffest pair that can meet, its smallest grains "
             "and safety.",
     .source = "docs/theory/time-step.md"},
    {.key = "safety",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 1),
     .fallback = "0.1",
     CLOD_AT(T, safety),
     .used = has_safety,
     .unused = "only step: auto has a safety, and not for the law hertz; remove this key",
     .help = "Automatic step as a fraction of the critical step of the stiffest pair; not for "
             "hertz.",
     .source = "docs/theory/time-step.md"},
    {.key = "design_stress",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_ABOVE(0, 1e9),
     .zero_word = "auto",
     .fallback = "auto",
     .example = "54.8 kPa",
     CLOD_AT(T, design_stress),
     .help =
         "Stress for which the automatic step estimates the overlap, or auto: from the loads "
         "and gravity.",
     .source = "docs/theory/time-step.md"},
    {.key = "rayleigh_limit",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 1),
     .fallback = "0.15",
     CLOD_AT(T, rayleigh_limit),
     .used = has_rayleigh,
     .unused = "only step: auto has this limit, and only for the law hertz (the others have "
               "safety); remove this key",
     .help = "Largest fraction of the Rayleigh time that the automatic step takes; hertz only.",
     .source = "docs/theory/time-step.md"},
    {.key = "overlap_limit",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, CLOD_CASE_OVERLAP_MOST),
     .fallback = "20 %",
     .example = "40 %",
     CLOD_AT(T, overlap_limit),
     .help = "Overlap at which a run stops, as a fraction of the smaller radius. The laws are "
             "made for small overlaps, and a deeper one is mostly a mistake: too large a step, "
             "too soft a contact. Raise it where deep contacts are meant, as when a grain is "
             "trapped in an impact; at 100 % nothing would tell out of which side of a wall a "
             "grain is to be pushed.",
     .source = "docs/theory/time-step.md"},
};
const clod_table CLOD_TABLE_TIME = {.title = "The time step, and the overlap that ends a run.",
                                    CLOD_ROWS(TIME_ROWS)};

static const clod_param OUTPUT_ROWS[] = {
    {.key = "series_interval",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1e6),
     .fallback = "1 ms",
     CLOD_AT(O, series_interval),
     .used = has_free_run,
     .unused = "a tester writes a row of its series whenever it looks at the walls; "
               "remove this key",
     .help = "Simulated time between two rows of the series of a free run, to the nearest "
             "step; it begins anew with each stage, whose end has a row in any case.",
     .source = "convention"},
    {.key = "steady_since",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_FROM(0, 1e9),
     .example = "2 s",
     CLOD_AT(O, steady_since),
     .given = offsetof(O, has_steady_since),
     .used = has_free_run,
     .unused = "only a free run has these means; remove this key",
     .formerly = "surfaces_from",
     .help =
         "Time from the beginning of the run from which on all means are taken: those of "
         "gauges, fields, mixing, repose, belts, balance, clumps, build-up, history map and "
         "surfaces; without it the last third of the stages' durations.",
     .source = "docs/gauges.md"},
    {.key = "snapshot_interval",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_FROM(0, 1e6),
     .fallback = "0 s",
     .example = "10 ms",
     CLOD_AT(O, snapshot_interval),
     .help = "Simulated time between two snapshots, to the nearest step, whatever the series "
             "does; the end of each stage or phase has one in any case. 0 keeps only those.",
     .source = "convention"},
    {.key = "checkpoint_interval",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1e6),
     .fallback = "60 s",
     CLOD_AT(O, checkpoint_interval),
     .help = "Time on the clock between two checkpoints.",
     .source = "convention"},
    {.key = "contacts",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(O, contacts),
     .help = "Whether snapshots hold the contacts.",
     .source = "convention"},
    {.key = "energy",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(O, energy),
     .help = "Whether to keep the energy ledger: kinetic, potential and stored energy, what "
             "plasticity and adhesion, dash-pots, friction and rolling resistance lose, the "
             "work of the walls, and what is missing or too much, beside each row of the "
             "series. It costs time and changes no bit of the rest.",
     .source = "docs/theory/energy.md"},
    {.key = "leavers",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(O, leavers),
     .used = has_free_run,
     .unused = "no grain leaves a tester; remove this key",
     .help =
         "Whether to write leavers.csv: a row for each grain that leaves, with id, material, "
         "radius, mass, when it came, when it left, and by which way. A row has some 100 "
         "bytes: 100 MB for a million grains.",
     .source = "docs/inlets.md"},
    {.key = "surfaces",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(O, surfaces),
     .help =
         "Whether to sum what grains do to the walls, for each facet of a mesh and each other "
         "shape: force, pressure, shear and impact work, impacts, wear. In snapshots of the "
         "walls, and by surface in series, report and summary; impacts by angle and energy in "
         "impacts.csv. It costs time and changes no bit of the rest.",
     .source = "docs/theory/wear.md"},
};
const clod_table CLOD_TABLE_OUTPUT = {.title = "What is written, and how often.",
                                      CLOD_ROWS(OUTPUT_ROWS)};

static const clod_param CHANGE[] = {
    {.key = "velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .example = "0 0 -10 mm/s",
     CLOD_AT(W, velocity),
     .given = offsetof(W, has_velocity),
     .help = "New velocity of the whole wall.",
     .source = "convention"},
    {.key = "spin",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad/s",
     CLOD_FROM(-1e4, 1e4),
     .example = "2 rpm",
     CLOD_AT(W, spin),
     .given = offsetof(W, has_spin),
     .help = "New speed of rotation.",
     .source = "convention"},
    {.key = "surface_velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .example = "1.5 0 0 m/s",
     CLOD_AT(W, surface_velocity),
     .given = offsetof(W, has_surface_velocity),
     .help = "New velocity of the surface.",
     .source = "convention"},
    {.key = "force",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N",
     CLOD_FROM(0, 1e9),
     .example = "50 N",
     CLOD_AT(W, force),
     .given = offsetof(W, has_force),
     .help = "New force of the load; the wall must have one.",
     .source = "convention"},
    {.key = "stress",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_FROM(0, 1e9),
     .example = "10 kPa",
     CLOD_AT(W, stress),
     .given = offsetof(W, has_stress),
     .help = "New stress of the load; the wall must have a load with an area.",
     .source = "convention"},
};
static const clod_table CHANGE_TABLE = {.title =
                                            "What changes for a wall when the stage begins.",
                                        CLOD_ROWS(CHANGE),
                                        .size = sizeof(W)};

static const clod_param STAGE[] = {
    {.key = "name",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_REQUIRED,
     .example = "settle",
     CLOD_AT(S, name),
     .help = "Name of the stage in series and files.",
     .source = "convention"},
    {.key = "duration",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "s",
     CLOD_ABOVE(0, 1e6),
     .example = "0.2 s",
     CLOD_AT(S, duration),
     .help = "Simulated time of the stage, at most.",
     .source = "convention"},
    {.key = "adhesion",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1),
     .fallback = "100 %",
     .example = "10 %",
     CLOD_AT(S, adhesion),
     .help = "k_adh during this stage as a fraction of its value in contacts.",
     .source = "docs/theory/copper-ore.md"},
    {.key = "rest",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(0, 1e3),
     .fallback = "0 m/s",
     .example = "1 mm/s",
     CLOD_AT(S, rest),
     .help =
         "The stage ends early when the grains are at rest: some of them carry load, and "
         "none is faster than this at 5 checks in a row, 200 steps apart or more, so that all "
         "of them last longer than a grain in free fall is slow. 0 never ends it early.",
     .source = "convention"},
    {.key = "walls",
     .kind = CLOD_PARAM_MAP,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CHANGE_TABLE,
     CLOD_AT(S, walls),
     CLOD_COUNT(S, wall_count),
     .help = "Changes of walls when the stage begins, by name of the wall; what is not named "
             "stays.",
     .source = "convention"},
};
const clod_table CLOD_TABLE_STAGE = {
    .title = "Stages of a free run, one after the other.", CLOD_ROWS(STAGE), .size = sizeof(S)};
