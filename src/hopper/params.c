#include "hopper/params.h"

#include "clod/hopper.h"
#include "config/unit.h"
#include "hopper/case.h"

#define C clod_hopper_case
#define P clod_hopper_property
#define HOWTO "docs/howto/hopper.md"
#define THEORY "docs/theory/hopper.md"

#define FILE_ROW(type, field, text)                                                            \
    {                                                                                          \
        .key = #field, .kind = CLOD_PARAM_FILE, .need = CLOD_PARAM_OPTIONAL,                   \
        .example = #field ".csv", CLOD_AT(type, field), .help = text, .source = HOWTO          \
    }
/** The range comes last, for its commas. */
#define REAL_ROW(type, name, field, si, word, text, ...)                                       \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = si,         \
        __VA_ARGS__, .example = word, CLOD_AT(type, field), .help = text, .source = THEORY     \
    }
#define DEFAULT_ROW(type, name, field, si, usual, text, ...)                                   \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = si,         \
        __VA_ARGS__, .fallback = usual, CLOD_AT(type, field), .help = text, .source = THEORY   \
    }
#define GIVEN .given = offsetof(P, has_value)

static const clod_param TEST[] = {
    {.key = "points",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_REQUIRED,
     .example = "run/ore-10kPa",
     CLOD_AT(clod_hopper_test, points),
     .help = "Results folder of a ring shear or Jenike test, or a CSV of shear points.",
     .source = HOWTO},
};
static const clod_table TEST_TABLE = {
    .title = "A shear test.", CLOD_ROWS(TEST), .size = sizeof(clod_hopper_test)};

static const char *const CURVES[] = {
    [CLOD_HOPPER_STRENGTH_LINE] = "line", [CLOD_HOPPER_STRENGTH_POINTS] = "points", NULL};

static const clod_param STRENGTH[] = {
    FILE_ROW(clod_hopper_strength, file,
             "Table with sigma_1 and f_c, their errors, and optionally phi_e, phi_t and rho_b; "
             "or what clod locus --csv printed."),
    {.key = "shear_tests",
     .kind = CLOD_PARAM_LIST,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &TEST_TABLE,
     CLOD_AT(clod_hopper_strength, tests),
     CLOD_COUNT(clod_hopper_strength, test_count),
     .help = "Shear tests at several preshear stresses, evaluated as clod locus does.",
     .source = HOWTO},
    {.key = "curve",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = CURVES,
     .fallback = "line",
     CLOD_AT(clod_hopper_strength, curve),
     .help =
         "line: least squares through the points, weighted by their errors; points: straight "
         "from point to point, repeats as their mean. Both go on beyond them.",
     .source = THEORY},
    {.key = "after_storage",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "after-24-h.csv",
     CLOD_AT(clod_hopper_strength, after_storage),
     .help =
         "Table with sigma_1, f_c and optionally phi_t of time yield loci, after storage at rest: the outlets "
         "and ratholes from which the stored solid flows. sigma_1 is that of the locus without storage.",
     .source = HOWTO},
};
static const clod_table STRENGTH_TABLE = {.title = "Flow function.", CLOD_ROWS(STRENGTH)};

#define ANGLE_ROWS(what, word)                                                                 \
    FILE_ROW(P, file, "Table of the " what "."),                                               \
        {.key = "angle",                                                                       \
         .kind = CLOD_PARAM_REAL,                                                              \
         .need = CLOD_PARAM_OPTIONAL,                                                          \
         .unit = "rad",                                                                        \
         CLOD_ABOVE(0, 85 * CLOD_UNIT_DEGREE),                                                 \
         .example = word,                                                                      \
         CLOD_AT(P, value),                                                                    \
         GIVEN,                                                                                \
         .help = "The " what ", the same at any stress.",                                      \
         .source = HOWTO},                                                                     \
        REAL_ROW(P, "error", error, "rad", "1 deg", "Standard error of angle.",                \
                 CLOD_FROM(0, 30 * CLOD_UNIT_DEGREE))

static const clod_param PHI_E[] = {
    ANGLE_ROWS("effective angle of internal friction", "45 deg")};
static const clod_table PHI_E_TABLE = {.title = "Effective angle of internal friction.",
                                       CLOD_ROWS(PHI_E)};
static const clod_param PHI_T[] = {ANGLE_ROWS("static angle of internal friction", "40 deg")};
static const clod_table PHI_T_TABLE = {
    .title = "Static angle of internal friction, for ratholes.", CLOD_ROWS(PHI_T)};
static const clod_param WALL[] = {ANGLE_ROWS("wall friction angle", "20 deg")};
static const clod_table WALL_TABLE = {.title = "Wall friction.", CLOD_ROWS(WALL)};

static const clod_param RHO[] = {
    FILE_ROW(P, file, "Table of the bulk density."),
    {.key = "value",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "kg/m3",
     CLOD_FROM(10, 15000),
     .example = "1650 kg/m3",
     CLOD_AT(P, value),
     GIVEN,
     .help = "The bulk density, the same at any stress.",
     .source = HOWTO},
    REAL_ROW(P, "error", error, "kg/m3", "20 kg/m3", "Standard error of value.",
             CLOD_FROM(0, 10000)),
};
static const clod_table RHO_TABLE = {.title = "Bulk density.", CLOD_ROWS(RHO)};

#define SHAPE_ROWS(text)                                                                       \
    {.key = "half_angle",                                                                      \
     .kind = CLOD_PARAM_REAL,                                                                  \
     .need = CLOD_PARAM_OPTIONAL,                                                              \
     .unit = "rad",                                                                            \
     CLOD_ABOVE(0, 60 * CLOD_UNIT_DEGREE),                                                     \
     .zero_word = "auto",                                                                      \
     .fallback = "auto",                                                                       \
     .example = "20 deg",                                                                      \
     CLOD_AT(clod_hopper_shape, half_angle),                                                   \
     .help = text,                                                                             \
     .source = THEORY},                                                                        \
        REAL_ROW(clod_hopper_shape, "outlet", outlet, "m", "300 mm",                           \
                 "Diameter or width of an outlet that is built: its margin against an arch, "  \
                 "and the half angle for its stresses.",                                       \
                 CLOD_ABOVE(0, 100))

static const clod_param CONE[] = {SHAPE_ROWS(
    "Angle of the wall from the vertical; auto: the limit of mass flow in a cone, at "
    "the outlet that is built, less margin. Where none is given and the solid would stick to "
    "the wall at the critical outlet: at the smallest measured sigma_1.")};
static const clod_table CONE_TABLE = {.title = "A conical hopper.", CLOD_ROWS(CONE)};
static const clod_param WEDGE[] = {
    SHAPE_ROWS(
        "Angle of the wall from the vertical; auto: limit or, without one, the limit of "
        "mass flow in a cone at the outlet that is built, less margin. Where none is given "
        "and the solid would stick to the wall at the critical outlet: at the smallest "
        "measured sigma_1."),
    REAL_ROW(
        clod_hopper_shape, "limit", limit, "rad", "35 deg",
        "Largest half angle of mass flow in a wedge, from a chart, at phi_e and wall friction "
        "angle of the outlet that is built.",
        CLOD_ABOVE(0, 60 * CLOD_UNIT_DEGREE)),
    REAL_ROW(clod_hopper_shape, "limit_error", limit_error, "rad", "1 deg",
             "Standard error of limit.", CLOD_FROM(0, 30 * CLOD_UNIT_DEGREE)),
};
static const clod_table WEDGE_TABLE = {.title = "A wedge-shaped hopper.", CLOD_ROWS(WEDGE)};

static const clod_param SILO[] = {
    {.key = "diameter",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1000),
     .example = "3 m",
     CLOD_AT(clod_hopper_silo, diameter),
     .help = "Inner diameter of the vertical part.",
     .source = THEORY},
    {.key = "height",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1000),
     .example = "8 m",
     CLOD_AT(clod_hopper_silo, height),
     .help = "Height of the solid in it.",
     .source = THEORY},
    DEFAULT_ROW(clod_hopper_silo, "stress_ratio", stress_ratio, "1", "0.4",
                "Horizontal over vertical stress.", CLOD_FROM(0.1, 1)),
};
static const clod_table SILO_TABLE = {.title = "The silo above the hopper, for ratholes.",
                                      CLOD_ROWS(SILO)};

static const clod_param INTERVAL[] = {
    DEFAULT_ROW(clod_hopper_interval, "level", level, "1", "90 %",
                "Share of the samples inside an interval, as many above it as below.",
                CLOD_FROM(0.5, 0.99)),
    {.key = "samples",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(100, 100000),
     .fallback = "4000",
     CLOD_AT(clod_hopper_interval, samples),
     .help =
         "How many times all measured values are drawn from their errors; what their number "
         "leaves open of the ends of the interval is printed.",
     .source = THEORY},
    {.key = "seed",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1e15),
     .fallback = "1",
     CLOD_AT(clod_hopper_interval, seed),
     .help = "Seed of the random numbers.",
     .source = THEORY},
};
static const clod_table INTERVAL_TABLE = {.title = "Propagation of errors.",
                                          CLOD_ROWS(INTERVAL)};

static const char *const ARCHES[] = {"arnold", "rhodes", NULL};

#define PROPERTY(name, field, rows, text, what)                                                \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_SECTION, .need = what, .table = &(rows),               \
        CLOD_AT(C, field), .given = offsetof(C, field.present), .help = text, .source = HOWTO  \
    }

static const clod_param ROWS[] = {
    {.key = "title",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "Copper ore on steel",
     CLOD_AT(C, title),
     .help = "Stands above the results.",
     .source = "convention"},
    {.key = "flow_function",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_REQUIRED,
     .table = &STRENGTH_TABLE,
     CLOD_AT(C, strength),
     .help = "Unconfined yield strength over the major principal stress of consolidation.",
     .source = HOWTO},
    PROPERTY("wall_friction", wall, WALL_TABLE, "Friction of the solid on the hopper's wall.",
             CLOD_PARAM_REQUIRED),
    PROPERTY(
        "effective_friction", phi_e, PHI_E_TABLE,
        "Effective angle of internal friction; needed where the flow function has no phi_e, "
        "which it replaces.",
        CLOD_PARAM_OPTIONAL),
    PROPERTY("static_friction", phi_t, PHI_T_TABLE,
             "Static angle of internal friction, for ratholes; replaces phi_t of the flow "
             "function.",
             CLOD_PARAM_OPTIONAL),
    PROPERTY("bulk_density", rho, RHO_TABLE,
             "Bulk density; needed where the flow function has no rho_b, which it replaces.",
             CLOD_PARAM_OPTIONAL),
    {.key = "cone",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_DEFAULTED,
     .table = &CONE_TABLE,
     CLOD_AT(C, cone),
     .help = "A conical hopper with a round outlet.",
     .source = THEORY},
    {.key = "wedge",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_DEFAULTED,
     .table = &WEDGE_TABLE,
     CLOD_AT(C, wedge),
     .help = "A wedge-shaped hopper with a slot at least three times as long as wide.",
     .source = THEORY},
    DEFAULT_ROW(C, "margin", margin, "rad", "3 deg",
                "How far a half angle stays below the limit of mass flow.",
                CLOD_FROM(0, 20 * CLOD_UNIT_DEGREE)),
    {.key = "arch_thickness",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = ARCHES,
     .fallback = "arnold",
     CLOD_AT(C, arch),
     .help =
         "Fit of Jenike's function H(theta): arnold (130 + theta)/65 and (200 + theta)/200, "
         "rhodes 2 + theta/60 and 1 + theta/180, theta in degrees, cone and wedge.",
     .source = THEORY},
    {.key = "silo",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &SILO_TABLE,
     CLOD_AT(C, silo),
     .given = offsetof(C, silo.present),
     .help = "The silo above the hopper, for the rathole after filling.",
     .source = THEORY},
    REAL_ROW(C, "largest_particle", largest_particle, "m", "25 mm",
             "Size of the largest particles, which can arch by themselves.", CLOD_ABOVE(0, 10)),
    {.key = "interval",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_DEFAULTED,
     .table = &INTERVAL_TABLE,
     CLOD_AT(C, interval),
     .help = "How the errors of the measured values are carried to the results.",
     .source = THEORY},
};

static void put_head(FILE *out)
{
    fputs(
        "The case that `clod hopper` reads ([howto/hopper.md](howto/hopper.md)); units, names and `--set` as in a "
        "case file.\n",
        out);
}

const clod_schema *clod_hopper_schema(void)
{
    static const clod_schema OF_HOPPER = {.keys = "Keys of the case of a hopper",
                                          .name = "in the case of a hopper (clod hopper)",
                                          .top = "The hopper",
                                          .verb = "hopper",
                                          .table = &CLOD_TABLE_HOPPER,
                                          .head = put_head};
    return &OF_HOPPER;
}

const clod_table CLOD_TABLE_HOPPER = {.title = "A hopper.", CLOD_ROWS(ROWS), .size = sizeof(C)};
