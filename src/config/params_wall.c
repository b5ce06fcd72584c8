/**
 * @file params_wall.c
 * Tables of walls: shapes, motion, load.
 */

#include "config/param.h"
#include "config/unit.h"

#define W clod_case_wall
#define O clod_case_oscillation

static bool has_force(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->load == CLOD_LOAD_FORCE;
}

static bool has_stress(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->load == CLOD_LOAD_STRESS;
}

static const clod_param LOAD[] = {
    {.key = "force",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N",
     CLOD_FROM(0, 1e9),
     .example = "50 N",
     CLOD_AT(W, force),
     .used = has_force,
     .help = "Force with which the load pushes (one of force, stress).",
     .source = "convention"},
    {.key = "stress",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_FROM(0, 1e9),
     .example = "10 kPa",
     CLOD_AT(W, stress),
     .used = has_stress,
     .help = "Stress with which the load pushes; times area it is the force (one of force, "
             "stress).",
     .source = "convention"},
    {.key = "area",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m2",
     CLOD_ABOVE(0, 1e6),
     .example = "25 cm2",
     CLOD_AT(W, area),
     .help = "Area on which stress acts; needed with stress.",
     .source = "convention"},
    {.key = "axis",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "0 0 -1",
     CLOD_AT(W, load_axis),
     .help = "Direction in which the load pushes the wall.",
     .source = "convention"},
    {.key = "mass",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "kg",
     CLOD_ABOVE(0, 1e6),
     .example = "1 kg",
     CLOD_AT(W, mass),
     .help =
         "Mass of the loaded wall. Its weight does not act: the force on the bed is the load "
         "alone; only the critical time step counts it with the load.",
     .source = "convention"},
    {.key = "damping",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 100),
     .fallback = "1",
     CLOD_AT(W, damping),
     .help = "Damping of the wall as a fraction of critical against the stiffness of the bed.",
     .source = "convention"},
};
static const clod_table LOAD_TABLE = {.title = "Load that presses a wall along an axis.",
                                      CLOD_ROWS(LOAD)};

static bool has_load(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->load != CLOD_LOAD_NONE;
}

static bool has_oscillation(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->oscillation.frequency != 0.0;
}

static bool has_start_up(const clod_case *whole, const void *self)
{
    (void)whole;
    const clod_case_start_up *start = &((const W *)self)->start_up;
    return start->at != 0.0 || start->duration != 0.0;
}

static bool has_amplitude(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const O *)self)->amplitude > 0.0;
}

static const clod_param OSCILLATION[] = {
    {.key = "direction",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "0 0 1",
     CLOD_AT(O, direction),
     .used = has_amplitude,
     .unused = "without amplitude nothing moves along it; remove this key, or give amplitude",
     .help = "Direction along which the wall moves to and fro.",
     .source = "convention"},
    {.key = "amplitude",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "0.5 mm",
     CLOD_AT(O, amplitude),
     .help = "Largest displacement along direction; the wall moves by amplitude "
             "sin(2 pi frequency t + phase) about the place where its shapes are given.",
     .source = "docs/theory/walls.md"},
    {.key = "angle",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_ABOVE(0, 360 * CLOD_UNIT_DEGREE),
     .example = "2 deg",
     CLOD_AT(O, angle),
     .help = "Largest angle of turning to and fro about spin_axis through spin_point, in step "
             "with the displacement.",
     .source = "docs/theory/walls.md"},
    {.key = "frequency",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "Hz",
     CLOD_ABOVE(0, 1e6),
     .example = "50 Hz",
     CLOD_AT(O, frequency),
     .help = "Periods in a second of simulated time; the time step must be at most 1/50 of a "
             "period.",
     .source = "docs/theory/walls.md"},
    {.key = "phase",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_FROM(-360 * CLOD_UNIT_DEGREE, 360 * CLOD_UNIT_DEGREE),
     .fallback = "0 deg",
     CLOD_AT(O, phase),
     .help = "Phase at the start of the run; at 0 deg the wall starts in the middle and moves "
             "along direction.",
     .source = "docs/theory/walls.md"},
};
static const clod_table OSCILLATION_TABLE = {
    .title = "Harmonic motion of a wall, beside its other motion.", CLOD_ROWS(OSCILLATION)};

#define R clod_case_rotation

static bool has_rotation(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->rotate.angle != 0.0;
}

static const clod_param ROTATION[] = {
    {.key = "axis",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .example = "[0, 1, 0]",
     CLOD_AT(R, axis),
     .help = "Direction of the axis.",
     .source = "convention"},
    {.key = "angle",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "rad",
     CLOD_FROM(-360 * CLOD_UNIT_DEGREE, 360 * CLOD_UNIT_DEGREE),
     .example = "30 deg",
     CLOD_AT(R, angle),
     .help = "Angle by the right-hand rule.",
     .source = "convention"},
    {.key = "point",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(R, point),
     .help = "A point of the axis.",
     .source = "convention"},
};
const clod_table CLOD_TABLE_ROTATION = {.title = "A rotation about an axis.",
                                        CLOD_ROWS(ROTATION)};

static const clod_param START_UP[] = {
    {.key = "at",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_FROM(0, 1e6),
     .fallback = "0 s",
     CLOD_AT(clod_case_start_up, at),
     .help = "Time from the start of the run until which they stand.",
     .source = "docs/belts.md"},
    {.key = "duration",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "s",
     CLOD_FROM(0, 1e6),
     .example = "2 s",
     CLOD_AT(clod_case_start_up, duration),
     .help = "Time in which their speed rises linearly to what is given for each.",
     .source = "docs/belts.md"},
};
static const clod_table START_UP_TABLE = {.title = "Start of the belts of a wall.",
                                          CLOD_ROWS(START_UP)};

static const clod_param WALL[] = {
    {.key = "material",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_REQUIRED,
     .example = "smooth",
     CLOD_AT(W, material),
     .help = "Name of a material; a shape can have its own (surface.material).",
     .source = "convention"},
    {.key = "shapes",
     .kind = CLOD_PARAM_LIST,
     .need = CLOD_PARAM_REQUIRED,
     .table = &CLOD_TABLE_SHAPE,
     CLOD_AT(W, shapes),
     CLOD_COUNT(W, shape_count),
     .help = "The surfaces of the wall; they move as one body.",
     .source = "convention"},
    {.key = "rotate",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CLOD_TABLE_ROTATION,
     CLOD_AT(W, rotate),
     .used = has_rotation,
     .help = "Turns all shapes of the wall before the run.",
     .source = "convention"},
    {.key = "move",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(W, move),
     .help = "Shifts all shapes of the wall before the run, after rotate.",
     .source = "convention"},
    {.key = "velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .fallback = "0 0 0 m/s",
     CLOD_AT(W, velocity),
     .help = "Velocity of the whole wall.",
     .source = "convention"},
    {.key = "spin",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad/s",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 rad/s",
     .example = "20 rpm",
     CLOD_AT(W, spin),
     .help = "Speed of rotation about spin_axis through spin_point, by the right-hand rule.",
     .source = "convention"},
    {.key = "spin_axis",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "0 0 1",
     CLOD_AT(W, spin_axis),
     .help = "Direction of the axis of rotation.",
     .source = "convention"},
    {.key = "spin_point",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(W, spin_point),
     .help = "A point of the axis of rotation; torque is reported about it.",
     .source = "convention"},
    {.key = "surface_velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .fallback = "0 0 0 m/s",
     CLOD_AT(W, surface_velocity),
     .help = "Velocity of the surface while the shape stays in place, as on a belt.",
     .source = "convention"},
    {.key = "oscillation",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &OSCILLATION_TABLE,
     CLOD_AT(W, oscillation),
     .used = has_oscillation,
     .help = "Motion to and fro, with an amplitude, an angle or both.",
     .source = "docs/theory/walls.md"},
    {.key = "start_up",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &START_UP_TABLE,
     CLOD_AT(W, start_up),
     .used = has_start_up,
     .help = "How the belts of its shapes begin; without it they run from the start.",
     .source = "docs/belts.md"},
    {.key = "load",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &LOAD_TABLE,
     .used = has_load,
     .help = "Load under which the wall moves freely along one axis.",
     .source = "docs/theory/walls.md"},
};

const clod_table CLOD_TABLE_WALL = {.title =
                                        "Walls, by name: rigid bodies of one or more shapes.",
                                    CLOD_ROWS(WALL),
                                    .size = sizeof(W)};
