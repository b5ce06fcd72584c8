#include "hopper/tables.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>

#include "analysis/bulk_density.h"
#include "analysis/csv.h"
#include "analysis/measured_header.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/bulk_density.h"
#include "clod/locus.h"
#include "hopper/line_fit.h"
#include "hopper/loci.h"
#include "hopper/repeats.h"
#include "hopper/scatter.h"
#include "hopper/storage.h"
#include "hopper/table_kind.h"
#include "hopper/tables_note.h"
#include "hopper/wall.h"

#define MANY 1000 ///< specimens: they tell their scatter as good as exactly

typedef clod_loci_row row;

#define ROW(field) .offset = offsetof(row, field)
#define PAIR(k, ...)                                                                           \
    {                                                                                          \
        .names = {__VA_ARGS__}, .unit = "1", .least = -1.0, .most = 1.0, ROW(correlation[k])   \
    }

static const clod_csv_column FLOW[] = {
    {.names = {"sigma_1"}, .unit = "Pa", .positive = true, .required = true, ROW(strength.x)},
    {.names = {"f_c", "sigma_c", "fc"}, .unit = "Pa", .required = true, ROW(strength.y)},
    {.names = {"sigma_1_error"}, .unit = "Pa", ROW(strength.x_error)},
    {.names = {"f_c_error", "sigma_c_error", "fc_error"}, .unit = "Pa", ROW(strength.y_error)},
    {.names = {"phi_e"}, .unit = "rad", .positive = true, .below = M_PI_2, ROW(phi_e.y)},
    {.names = {"phi_e_error"}, .unit = "rad", ROW(phi_e.y_error)},
    {.names = {"phi_t", "phi_lin"},
     .unit = "rad",
     .positive = true,
     .below = M_PI_2,
     ROW(phi_t.y)},
    {.names = {"phi_t_error", "phi_lin_error"}, .unit = "rad", ROW(phi_t.y_error)},
    {.names = {"rho_b", "rho"}, .unit = "kg/m3", .positive = true, ROW(rho.y)},
    {.names = {"rho_b_error"}, .unit = "kg/m3", ROW(rho.y_error)},
    {.names = {"rho_inside"}, .unit = "kg/m3", .positive = true, ROW(rho.inside)},
    {.names = {"tau_p"}, .unit = "Pa", ROW(tau_p)},
    {.names = {"tau_p_error"}, .unit = "Pa", ROW(tau_p_error)},
    {.names = {"seeds"}, .unit = "", ROW(seeds)},
    PAIR(0, "correlation_sigma_1_sigma_c", "correlation_sigma_1_f_c"),
    PAIR(1, "correlation_sigma_1_phi_e"),
    PAIR(2, "correlation_sigma_1_phi_lin", "correlation_sigma_1_phi_t"),
    PAIR(3, "correlation_sigma_c_phi_e", "correlation_f_c_phi_e"),
    PAIR(4, "correlation_sigma_c_phi_lin", "correlation_f_c_phi_t"),
    PAIR(5, "correlation_phi_e_phi_lin", "correlation_phi_e_phi_t"),
};

/** Columns that clod locus --csv and a uniaxial test write and a hopper does not need; the number of a specimen. */
static const char *const SKIPPED[] = {"seed",
                                      "points",
                                      "r_squared",
                                      "flow",
                                      "sigma_p",
                                      "sigma_p_error",
                                      "c",
                                      "c_error",
                                      "phi_sf",
                                      "phi_sf_error",
                                      "sigma_2",
                                      "sigma_2_error",
                                      "ffc",
                                      "ffc_error",
                                      "sigma_1_base",
                                      "sigma_c_base",
                                      "consolidation_stress",
                                      "solid_fraction",
                                      "void_ratio",
                                      "strain_at_peak",
                                      "rho_inside_error",
                                      NULL};

static bool check_flow(const clod_csv *self, const void *of)
{
    row at = *(const row *)of;
    if ((at.rho.y != 0.0 &&
         !clod_bulk_density_check(self, "rho_b", at.rho.y)) || // 0: not there
        (at.rho.inside != 0.0 && !clod_bulk_density_check(self, "rho_inside", at.rho.inside))) {
        return false;
    }
    return clod_loci_join(&at) ||
           clod_status_fail(
               self->status, CLOD_USAGE,
               "%s:%zu: no errors have these correlations together: of three, two that are close "
               "to 1 or -1 leave little to the third. Take all of them from one evaluation, or "
               "none.",
               self->path, self->line);
}

/** A row before it is read. */
static const row UNKNOWN = {.correlation = {NAN, NAN, NAN, NAN, NAN, NAN}};

static const clod_csv_kind FLOW_KIND = {
    .columns = FLOW,
    .count = sizeof FLOW / sizeof FLOW[0],
    .row = sizeof(row),
    .known =
        "sigma_1, sigma_c (or f_c), phi_e, phi_t, rho_b, and each of them with _error; rho_inside",
    .example = "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],phi_e [deg],rho_b [kg/m3]",
    .item = "flow function point",
    .skipped = SKIPPED,
    .check_row = check_flow,
};

#define POINT(field) .offset = offsetof(clod_curve_point, field)
#define SIGMA(name)                                                                            \
    {                                                                                          \
        .names = {name}, .unit = "Pa", .positive = true, .required = true, POINT(x)            \
    }
#define SIGMA_ERROR(name)                                                                      \
    {                                                                                          \
        .names = {name}, .unit = "Pa", POINT(x_error)                                          \
    }
#define ANGLE(...)                                                                             \
    {                                                                                          \
        .names = {__VA_ARGS__}, .unit = "rad", .positive = true, .required = true,             \
        .below = M_PI_2, POINT(y)                                                              \
    }
#define ERROR(si, ...)                                                                         \
    {                                                                                          \
        .names = {__VA_ARGS__}, .unit = si, POINT(y_error)                                     \
    }
#define KIND(table, names, line, what)                                                         \
    {                                                                                          \
        .columns = table, .count = sizeof(table) / sizeof((table)[0]),                         \
        .row = sizeof(clod_curve_point), .known = names, .example = line, .item = what         \
    }

static const clod_csv_column PHI_E[] = {SIGMA("sigma_1"), SIGMA_ERROR("sigma_1_error"),
                                        ANGLE("phi_e"), ERROR("rad", "phi_e_error")};
static const clod_csv_column PHI_T[] = {SIGMA("sigma_1"), SIGMA_ERROR("sigma_1_error"),
                                        ANGLE("phi_t", "phi_lin"),
                                        ERROR("rad", "phi_t_error", "phi_lin_error")};
static const clod_csv_kind PHI_E_KIND =
    KIND(PHI_E, "sigma_1, phi_e, sigma_1_error, phi_e_error", "sigma_1 [kPa],phi_e [deg]",
         "phi_e point");
static const clod_csv_kind PHI_T_KIND =
    KIND(PHI_T, "sigma_1, phi_t, sigma_1_error, phi_t_error", "sigma_1 [kPa],phi_t [deg]",
         "phi_t point");

/** Whether a table has columns that a uniaxial test alone writes. */
static bool is_uniaxial(const char *text, size_t length)
{
    return clod_measured_has(text, length, "strain_at_peak") ||
           clod_measured_has(text, length, "sigma_c_base") ||
           clod_measured_has(text, length, "consolidation_stress");
}

/** Read a file of a kind; its rows are owned by the caller. @param uniaxial [out] whether a uniaxial test made it */
static bool read_file(const char *path, const clod_csv_kind *kind, void **rows, size_t *count,
                      bool *uniaxial, clod_status *status)
{
    *rows = NULL;
    *count = 0;
    char *text;
    size_t length;
    if (!clod_input_read(path, SIZE_MAX, &text, &length, status)) {
        return false;
    }
    clod_csv csv = {.kind = kind,
                    .first = kind == &FLOW_KIND ? &UNKNOWN : NULL,
                    .path = path,
                    .status = status};
    const bool good = clod_csv_parse(&csv, text, length);
    *uniaxial = is_uniaxial(text, length);
    clod_memory_free(text);
    *rows = csv.rows;
    *count = csv.count;
    return good;
}

/** A curve of one property of the rows, where they have it. */
static bool take(const row *rows, size_t count, size_t offset, clod_curve *curve,
                 clod_status *status)
{
    curve->points = clod_memory_alloc(count, sizeof *curve->points);
    if (curve->points == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
    }
    for (size_t i = 0; i < count; i++) {
        clod_curve_point point =
            *(const clod_curve_point *)(const void *)((const char *)&rows[i] + offset);
        point.x = rows[i].strength.x;
        point.x_error = rows[i].strength.x_error;
        point.x_spread = rows[i].strength.x_spread;
        point.row = i + 1;
        point.set = i;
        if (point.y > 0.0 || offset == offsetof(row, strength)) {
            curve->points[curve->count++] = point;
        }
    }
    return true;
}

static bool take_rows(const row *rows, size_t count, clod_solid *solid, clod_status *status)
{
    return take(rows, count, offsetof(row, strength), &solid->strength, status) &&
           take(rows, count, offsetof(row, phi_e), &solid->phi_e, status) &&
           take(rows, count, offsetof(row, phi_t), &solid->phi_t, status) &&
           take(rows, count, offsetof(row, rho), &solid->rho, status);
}

/** What a row says of the loci that it comes of, as clod_loci_read has it of their points. */
static void take_origin(row *at, clod_tables_notes *notes)
{
    const bool has_errors = at->strength.x_error > 0.0;
    (void)clod_loci_join(at); // they were checked line by line
    at->strength.unsure = at->strength.joint || at->seeds > 0;
    clod_curve_point *const points[] = {&at->strength, &at->phi_e, &at->phi_t, &at->rho};
    for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
        points[k]->freedom = at->seeds > 1 && at->seeds <= MANY ? (size_t)at->seeds - 1 : 0;
    }
    if (at->seeds == 1 && has_errors) { // of which tester they are it does not tell
        notes->specimen = CLOD_LOCUS_ONE_SPECIMEN ", " CLOD_LOCUS_UNLESS_JENIKE;
    }
    notes->preshear_untold =
        notes->preshear_untold || (at->tau_p > 0.0 && at->tau_p_error == 0.0 && has_errors);
}

bool clod_tables_read_flow(const char *path, clod_solid *solid, clod_tables_notes *notes,
                           clod_status *status)
{
    void *rows;
    size_t count;
    bool good = read_file(path, &FLOW_KIND, &rows, &count, &notes->uniaxial, status);
    for (size_t i = 0; i < count; i++) {
        take_origin((row *)rows + i, notes);
    }
    good = good && take_rows(rows, count, solid, status);
    clod_memory_free(rows);
    return good;
}

/** Hand the specimens of the shear tests on to the solid, which owns them then. */
static void share(clod_solid *solid, clod_specimens *of)
{
    const clod_curve *rows = &solid->strength; // it has all of them, in their order
    clod_specimens_sort(rows->points, rows->count, of->count);
    for (size_t k = 0; k < CLOD_SOLID_WALL; k++) {
        clod_curve *curve = &solid->curves[k];
        curve->specimens = of->count;
        curve->test = CLOD_CURVE_SHEAR;
        for (size_t i = 0; i < curve->count; i++) {
            const clod_curve_point *from = &rows->points[curve->points[i].row - 1];
            curve->points[i].set = from->set;
            curve->points[i].freedom = from->freedom;
        }
    }
    solid->strength.spread = of->spread;
    solid->seeds = of->seeds;
    of->spread = NULL;
    of->seeds = NULL;
}

static bool read_strength(const clod_hopper_case *of, clod_solid *solid,
                          clod_tables_notes *notes, clod_status *status)
{
    if (of->strength.file != NULL) {
        return clod_tables_read_flow(of->strength.file, solid, notes, status);
    }
    clod_loci loci;
    const bool good = clod_loci_read(of, &loci, notes, status) &&
                      take_rows(loci.rows, loci.count, solid, status);
    if (good && loci.specimens.spread != NULL) {
        share(solid, &loci.specimens);
    }
    clod_loci_fini(&loci);
    return good;
}

/** Read a property's file; the points are owned by the caller. */
typedef bool property_reader(const char *path, clod_curve *curve, clod_status *status);

static bool read_angles(const char *path, const clod_csv_kind *kind, clod_curve *curve,
                        clod_status *status)
{
    void *rows;
    bool uniaxial;
    const bool good = read_file(path, kind, &rows, &curve->count, &uniaxial, status);
    curve->points = rows;
    return good;
}

static bool read_phi_e(const char *path, clod_curve *curve, clod_status *status)
{
    return read_angles(path, &PHI_E_KIND, curve, status);
}

static bool read_phi_t(const char *path, clod_curve *curve, clod_status *status)
{
    return read_angles(path, &PHI_T_KIND, curve, status);
}

static bool make_points(clod_curve *curve, size_t count, clod_status *status)
{
    curve->points = clod_memory_alloc(count, sizeof *curve->points);
    curve->count = curve->points != NULL ? count : 0;
    return curve->points != NULL ||
           clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
}

/** Bulk densities, also a loose one at 0. */
static bool read_density(const char *path, clod_curve *curve, clod_status *status)
{
    char *text;
    size_t length, count;
    clod_bulk_density_point *points;
    if (!clod_input_read(path, SIZE_MAX, &text, &length, status)) {
        return false;
    }
    bool good = clod_bulk_density_parse(path, text, length, &points, &count, status);
    clod_memory_free(text);
    good = good && make_points(curve, count, status);
    for (size_t i = 0; good && i < count; i++) {
        curve->points[i] = (clod_curve_point){.x = points[i].sigma_1,
                                              .y = points[i].rho_b,
                                              .x_error = points[i].sigma_1_error,
                                              .y_error = points[i].rho_b_error};
    }
    clod_locus_free(points);
    return good;
}

bool clod_tables_read_density(const char *path, clod_curve *curve, clod_status *status)
{
    bool good = read_density(path, curve, status);
    for (size_t i = 0; good && i < curve->count; i++) {
        good = clod_bulk_density_consolidated(path, curve->points[i].x, status);
    }
    return good;
}

/** A property of its own, in place of what the flow function brought. */
static bool read_property(const clod_hopper_property *from, property_reader *read,
                          clod_curve *curve, clod_status *status)
{
    if (!from->present) {
        return true;
    }
    clod_curve_fini(curve);
    if (from->file != NULL) {
        return read(from->file, curve, status);
    }
    if (!make_points(curve, 1, status)) {
        return false;
    }
    curve->points[0] = (clod_curve_point){.x = 1.0, .y = from->value, .y_error = from->error};
    return true;
}

/** A wall yield locus, of a file or of a results folder; or an angle, as a line from 0. */
static bool read_wall(const clod_hopper_property *from, clod_curve *wall,
                      clod_tables_notes *notes, clod_status *status)
{
    if (from->file != NULL) {
        char inside[PATH_MAX];
        return clod_loci_find(from->file, "wall_friction.csv", inside, status) &&
               clod_wall_read(inside, wall, notes->warnings, status);
    }
    if (!from->present) {
        return true;
    }
    if (!make_points(wall, 1, status)) {
        return false;
    }
    const double tangent = tan(from->value);
    wall->points[0] = (clod_curve_point){
        .x = 1.0, .y = tangent, .y_error = (1.0 + tangent * tangent) * from->error};
    return true;
}

bool clod_tables_take_scatter(clod_curve *strength, const char *what, clod_tables_notes *notes,
                              clod_status *status)
{
    clod_repeats_warn(strength, what, notes->warnings);
    const bool good =
        clod_scatter_take(strength) ||
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", strength->count);
    if (strength->way == CLOD_CURVE_EXTENDED) {
        clod_repeats_pool(strength);
    }
    return good;
}

bool clod_tables_read(const clod_hopper_case *from, clod_solid *solid, clod_tables_notes *notes,
                      clod_status *status)
{
    *solid = (clod_solid){0};
    if (!clod_table_kind_check(from, status) || !read_strength(from, solid, notes, status)) {
        return false;
    }
    clod_tables_note_uniaxial(from->strength.file, "Flow function", notes);
    clod_tables_note_blanks(from, solid, notes);
    clod_tables_note_replaced(from, solid, notes);
    if (!read_property(&from->phi_e, read_phi_e, &solid->phi_e, status) ||
        !read_property(&from->phi_t, read_phi_t, &solid->phi_t, status) ||
        !read_property(&from->rho, read_density, &solid->rho, status) ||
        !read_wall(&from->wall, &solid->wall, notes, status)) {
        return false;
    }
    clod_tables_note_light(from, solid, notes);
    solid->strength.way = from->strength.curve == CLOD_HOPPER_STRENGTH_LINE
                              ? CLOD_CURVE_LINE
                              : CLOD_CURVE_EXTENDED;
    solid->wall.way = CLOD_CURVE_EXTENDED;
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_sort(&solid->curves[k]);
    }
    if (!clod_tables_take_scatter(&solid->strength, "Flow function", notes, status)) {
        return false;
    }
    clod_line_fit_weigh(&solid->strength);
    const char *stored = from->strength.after_storage;
    if (stored == NULL) {
        return true;
    }
    const bool good = clod_storage_read(stored, !from->phi_t.present, solid, notes, status);
    clod_line_fit_weigh(&solid->strength);
    return good;
}

void clod_tables_fini(clod_solid *solid)
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_fini(&solid->curves[k]);
    }
    clod_memory_free(solid->seeds);
    solid->seeds = NULL;
}
