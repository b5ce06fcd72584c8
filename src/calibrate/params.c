#include "calibrate/params.h"

#include "calibrate/calibrate.h"
#include "calibrate/plan.h"

#define HOWTO "docs/howto/calibrate.md"
#define THEORY "docs/theory/calibration.md"

#define TEXT_ROW(type, name, field, wanted, word, text)                                        \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_TEXT, .need = wanted, .example = word,                 \
        CLOD_AT(type, field), .help = text, .source = HOWTO                                    \
    }

static const clod_param TEST[] = {
    {.key = "case",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_REQUIRED,
     .example = "ring.yaml",
     CLOD_AT(clod_plan_test, path),
     .help = "Case file that is run for each point of the design.",
     .source = HOWTO},
    {.key = "set",
     .kind = CLOD_PARAM_SETTINGS,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "{ring_shear.preshear_stress: 0.6 kPa}",
     CLOD_AT(clod_plan_test, set),
     CLOD_COUNT(clod_plan_test, set_count),
     .help =
         "Keys of the case that have another value in this test, as --set of clod run takes them: one "
         "case serves several preshear stresses.",
     .source = HOWTO},
};
static const clod_table TEST_TABLE = {
    .title = "A test.", CLOD_ROWS(TEST), .size = sizeof(clod_plan_test)};

static const char *const SCALES[] = {"linear", "log", NULL};

#define P clod_plan_parameter
static const clod_param PARAMETER[] = {
    TEXT_ROW(P, "key", key, CLOD_PARAM_REQUIRED, "contacts.default.k_adh",
             "Key of the cases, as --set takes it; all tests get the same value."),
    {.key = "multiples",
     .kind = CLOD_PARAM_SETTINGS,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "{contacts.ore-plate.friction: 1}",
     CLOD_AT(P, multiples),
     CLOD_COUNT(P, multiple_count),
     .help =
         "Other keys that move with it, and by what they are times its value: 1 is the same value.",
     .source = HOWTO},
    TEXT_ROW(
        P, "times", times, CLOD_PARAM_OPTIONAL, "k1",
        "Name of another parameter whose value is multiplied by this one, a pure number: a free ratio."),
    TEXT_ROW(P, "from", from, CLOD_PARAM_REQUIRED, "5e7 N/m^1.5", "Lower end of the range."),
    TEXT_ROW(P, "to", to, CLOD_PARAM_REQUIRED, "1e9 N/m^1.5",
             "Upper end of the range, in the same unit."),
    {.key = "scale",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = SCALES,
     .fallback = "linear",
     CLOD_AT(P, scale),
     .help =
         "How points are spread, and what is equally likely beforehand: equal steps or equal "
         "ratios.",
     .source = THEORY},
};
static const clod_table PARAMETER_TABLE = {
    .title = "A free parameter.", CLOD_ROWS(PARAMETER), .size = sizeof(P)};

#define W clod_plan_wish
static const clod_param WISH[] = {
    TEXT_ROW(W, "test", test, CLOD_PARAM_REQUIRED, "ring", "Name of the test."),
    TEXT_ROW(
        W, "number", number, CLOD_PARAM_OPTIONAL, "phi_e",
        "Which of its results: phi_lin, phi_e, phi_sf, c, tau_p, tau, sigma_1, sigma_2, sigma_c, "
        "ffc, rho_b, rho_inside (away from the walls) of a shear test; sigma_c, ffc, rho_b, rho_inside of a "
        "uniaxial test; phi_x, phi_w, tau_ad, rho_b of a wall friction test; a path in summary.json of a free run, for instance "
        "repose.heap.angle_deg."),
    TEXT_ROW(
        W, "value", value, CLOD_PARAM_OPTIONAL, "47.3 deg",
        "What was measured, with its unit. Of a number of a free run the unit may be left out: "
        "it is that of the name, deg for angle_deg; energies, powers and torques are given "
        "without one."),
    TEXT_ROW(
        W, "error", error, CLOD_PARAM_OPTIONAL, "2 deg",
        "Its standard error; with locus that of each point, or the table's where that is larger."),
    TEXT_ROW(
        W, "discrepancy", discrepancy, CLOD_PARAM_OPTIONAL, "1 deg",
        "Standard deviation of what the model is expected to miss at any parameters; none: 0."),
    {.key = "locus",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "lab.csv",
     CLOD_AT(W, locus),
     .help =
         "Table of measured points in place of value, as clod locus or, of a flow function, clod hopper reads "
         "it. Shear points: each prorated one with the case's preshear stress is a target tau; with number: rho_b "
         "(or rho_inside) the mean density of their specimens, with number: tau_p their mean preshear shear "
         "stress. A wall yield locus: each point is a target phi_x. Bulk densities "
         "(sigma_1, rho_b) and a flow function (sigma_1, sigma_c): targets rho_b (or rho_inside) and sigma_c. Of a uniaxial test "
         "each row is one; of a shear test the row at normal_stress, to which the test's number is moved along "
         "the table from its own sigma_1. Angles of repose (angle_of_repose): their mean is a target of the angle of a free run that "
         "number names. Repeats at one stress are one target, their mean.",
     .source = HOWTO},
    {.key = "normal_stress",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_ABOVE(0, 1e8),
     .example = "20 kPa",
     CLOD_AT(W, normal_stress),
     .help =
         "Of tau: the normal stress at shear; of a uniaxial test: the consolidation stress; of phi_x and "
         "rho_b of a wall friction test: one of its wall_stresses. With locus: the stress of the rows that are "
         "targets; of a table over sigma_1 that sigma_1.",
     .source = HOWTO},
    {.key = "held_back",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(W, held_back),
     .help = "Not used to calibrate, but predicted and compared.",
     .source = HOWTO},
};
static const clod_table WISH_TABLE = {
    .title = "A measured target.", CLOD_ROWS(WISH), .size = sizeof(W)};

static const clod_param SAMPLING[] = {
    {.key = "samples",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1000, 100000),
     .fallback = "5000",
     CLOD_AT(clod_plan_sampling, samples),
     .help = "Samples of each of the four Markov chains.",
     .source = THEORY},
    {.key = "level",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0.5, 0.99),
     .fallback = "90 %",
     CLOD_AT(clod_plan_sampling, level),
     .help = "Probability inside an interval, as much above it as below.",
     .source = THEORY},
};
static const clod_table SAMPLING_TABLE = {.title = "How the posterior is sampled.",
                                          CLOD_ROWS(SAMPLING)};

#define C clod_plan
#define ITEMS_ROW(name, which, rows, field, number, text)                                      \
    {                                                                                          \
        .key = name, .kind = which, .need = CLOD_PARAM_REQUIRED, .table = &(rows),             \
        CLOD_AT(C, field), CLOD_COUNT(C, number), .help = text, .source = HOWTO                \
    }

static const clod_param ROWS[] = {
    TEXT_ROW(C, "title", title, CLOD_PARAM_OPTIONAL, "Copper ore", "Stands above the results."),
    ITEMS_ROW("tests", CLOD_PARAM_MAP, TEST_TABLE, tests, test_count, "The tests, by name."),
    ITEMS_ROW("parameters", CLOD_PARAM_MAP, PARAMETER_TABLE, parameters, parameter_count,
              "What is calibrated, by name."),
    ITEMS_ROW("targets", CLOD_PARAM_LIST, WISH_TABLE, wishes, wish_count, "What was measured."),
    {.key = "budget",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1e8),
     .example = "2 h",
     CLOD_AT(C, budget),
     .help =
         "Time on the clock that the runs may take on all processors; the first point is timed, and "
         "tells how many points fit, 256 at most. Either this or points.",
     .source = HOWTO},
    {.key = "points",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(5, 1000),
     .example = "24",
     CLOD_AT(C, points),
     .help =
         "Number of points, in place of a budget: two thirds are the design. With at least 8 points, and 5 for each parameter, surrogates are Gaussian processes; with fewer, lines or quadratics.",
     .source = HOWTO},
    {.key = "seeds",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1, 20),
     .fallback = "1",
     CLOD_AT(C, seeds),
     .help = "Packings of each point, all different, and others in each test.",
     .source = THEORY},
    {.key = "seed",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1, 1e9),
     .fallback = "1",
     CLOD_AT(C, seed),
     .help =
         "Seed of the first packing of the first test, and of the Markov chains. Each further test begins 1e9 above.",
     .source = HOWTO},
    {.key = "sampling",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_DEFAULTED,
     .table = &SAMPLING_TABLE,
     CLOD_AT(C, sampling),
     .help = "Markov chains and intervals.",
     .source = THEORY},
};

static void put_head(FILE *out)
{
    fputs(
        "The plan that `clod calibrate` reads ([howto/calibrate.md](howto/calibrate.md)); units, names and "
        "`--set` as in a case file.\n",
        out);
}

const clod_schema *clod_calibrate_schema(void)
{
    static const clod_schema OF_PLAN = {.keys = "Keys of the plan of a calibration",
                                        .name = "in the plan of a calibration (clod calibrate)",
                                        .top = "The plan",
                                        .verb = "calibrate",
                                        .table = &CLOD_TABLE_PLAN,
                                        .head = put_head};
    return &OF_PLAN;
}

const clod_table CLOD_TABLE_PLAN = {
    .title = "The plan of a calibration.", CLOD_ROWS(ROWS), .size = sizeof(clod_plan)};
