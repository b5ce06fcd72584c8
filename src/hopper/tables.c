#include "hopper/tables.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>

#include "analysis/bulk_density.h"
#include "analysis/csv.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/bulk_density.h"
#include "clod/locus.h"
#include "hopper/wall.h"

#define DEGREE (M_PI / 180.0)

/** A row of the flow function; 0: not there. */
typedef struct row {
    clod_curve_point strength, phi_e, phi_t, rho; ///< x: sigma_1, in strength alone
} row;

#define ROW(field) .offset = offsetof(row, field)

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
};

/** Columns that clod locus --csv and a uniaxial test write and a hopper does not need. */
static const char *const SKIPPED[] = {"seeds",
                                      "points",
                                      "r_squared",
                                      "flow",
                                      "sigma_p",
                                      "sigma_p_error",
                                      "tau_p",
                                      "tau_p_error",
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
                                      NULL};

static bool check_flow(const clod_csv *self, const void *of)
{
    const double rho = ((const row *)of)->rho.y;
    return rho == 0.0 || clod_bulk_density_check(self, rho); // 0: not there
}

static const clod_csv_kind FLOW_KIND = {
    .columns = FLOW,
    .count = sizeof FLOW / sizeof FLOW[0],
    .row = sizeof(row),
    .known = "sigma_1, f_c, phi_e, phi_t, rho_b, and each of them with _error",
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

/** Read a file of a kind; its rows are owned by the caller. */
static bool read_file(const char *path, const clod_csv_kind *kind, void **rows, size_t *count,
                      clod_status *status)
{
    *rows = NULL;
    *count = 0;
    char *text;
    size_t length;
    if (!clod_input_read(path, SIZE_MAX, &text, &length, status)) {
        return false;
    }
    clod_csv csv = {.kind = kind, .path = path, .status = status};
    const bool good = clod_csv_parse(&csv, text, length);
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

/** A value with its standard error; what is not known is 0. */
static void put(clod_curve_point *point, clod_locus_value value)
{
    point->y = isfinite(value.value) ? value.value : 0.0;
    point->y_error = isfinite(value.error) ? value.error : 0.0;
}

/** What clod locus says about a yield locus. */
static void take_notes(const clod_locus *locus, clod_tables_notes *notes)
{
    notes->one_specimen = notes->one_specimen || clod_locus_one_specimen(locus);
    for (size_t k = 0; k < locus->warning_count; k++) {
        clod_warning_list_add(notes->warnings,
                              "Yield locus at a preshear stress of %.3f kPa: %s",
                              1e-3 * locus->sigma_p.value, locus->warnings[k]);
    }
}

/** Refuse a yield locus without a strength, and say why it has none. */
static bool has_strength(const clod_locus *locus, clod_status *status)
{
    if (locus->phi_lin.value < 0.0) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "The yield locus at a preshear stress of %.3f kPa falls (phi_lin "
            "= %.1f deg): peak shear stress must rise with normal stress. "
            "Check the columns and units of its points.",
            1e-3 * locus->sigma_p.value, locus->phi_lin.value / DEGREE);
    }
    return !isnan(locus->sigma_c.value) ||
           clod_status_fail(status, CLOD_USAGE,
                            "The yield locus at a preshear stress of %.3f kPa has no "
                            "unconfined yield strength (its cohesion is below 0); "
                            "clod locus says more about its points.",
                            1e-3 * locus->sigma_p.value);
}

/** Refuse loci of which none has phi_e, where nothing else gives it. */
static bool has_phi_e(const clod_locus_study *study, clod_status *status)
{
    const clod_locus *first = &study->groups[0].locus;
    for (size_t g = 0; g < study->count; g++) {
        if (isfinite(study->groups[g].locus.phi_e.value)) {
            return true;
        }
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "phi_e is undefined in every yield locus, since sigma_2 is tension "
                            "(%.3f kPa at a preshear stress of %.3f kPa): their shear stresses "
                            "are too large for their normal stresses. Check the columns and "
                            "units of the points, or give the key effective_friction.",
                            1e-3 * first->sigma_2.value, 1e-3 * first->sigma_p.value);
}

/** Rows of the loci of a study. */
static bool take_study(const clod_locus_study *study, bool brings_phi_e, clod_solid *solid,
                       clod_tables_notes *notes, clod_status *status)
{
    row *rows = clod_memory_alloc(study->count, sizeof *rows);
    if (rows == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the loci.");
    }
    bool good = true;
    for (size_t g = 0; g < study->count && good; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        good = has_strength(locus, status);
        put(&rows[g].strength, locus->sigma_c);
        put(&rows[g].phi_e, locus->phi_e);
        put(&rows[g].phi_t, locus->phi_lin);
        put(&rows[g].rho, locus->rho_b);
        rows[g].strength.x = locus->sigma_1.value;
        rows[g].strength.x_error = isfinite(locus->sigma_1.error) ? locus->sigma_1.error : 0.0;
        take_notes(locus, notes);
    }
    if (study->warning[0] != '\0') {
        clod_warning_list_add(notes->warnings, "Flow function: %s", study->warning);
    }
    good = good && (!brings_phi_e || has_phi_e(study, status)) &&
           take_rows(rows, study->count, solid, status);
    clod_memory_free(rows);
    return good;
}

/** The file itself, or the table of this name in a results folder, which must have it. */
static bool find_table(const char *path, const char *table, char inside[PATH_MAX],
                       clod_status *status)
{
    struct stat kind;
    const bool folder = stat(path, &kind) == 0 && S_ISDIR(kind.st_mode);
    snprintf(inside, PATH_MAX, "%s%s%s", path, folder ? "/" : "", folder ? table : "");
    return !folder || stat(inside, &kind) == 0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: the folder has no %s: its run is not finished, or is no test "
               "that writes one. clod run goes on with a run that is not finished.",
               path, table);
}

/** Append the points of a test: of the file, or of points.csv in a results folder. */
static bool add_points(const char *path, clod_locus_point **all, size_t *count,
                       clod_status *status)
{
    char inside[PATH_MAX];
    clod_locus_point *points;
    size_t more;
    if (!find_table(path, "points.csv", inside, status) ||
        !clod_locus_read(inside, NULL, &points, &more, status)) {
        return false;
    }
    clod_locus_point *grown = clod_memory_grow(*all, *count, *count + more, sizeof **all);
    if (grown == NULL) {
        clod_locus_free(points);
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", more);
    }
    for (size_t i = 0; i < more; i++) {
        grown[*count + i] = points[i];
    }
    *all = grown;
    *count += more;
    clod_locus_free(points);
    return true;
}

static bool read_tests(const clod_hopper_case *of, clod_solid *solid, clod_tables_notes *notes,
                       clod_status *status)
{
    const clod_hopper_strength *from = &of->strength;
    clod_locus_point *points = NULL;
    size_t count = 0;
    bool good = true;
    for (size_t t = 0; t < from->test_count && good; t++) {
        good = add_points(from->tests[t].points, &points, &count, status);
    }
    clod_status why = {0};
    clod_locus_study *study = good ? clod_locus_study_create(points, count, &why) : NULL;
    if (good && !(study != NULL && take_study(study, !of->phi_e.present, solid, notes, &why))) {
        // of several files: the preshear stress says which
        good = clod_status_fail(status, why.code, "%s%s: %s", from->tests[0].points,
                                from->test_count > 1 ? " and those after it" : "", why.text);
    }
    clod_locus_study_destroy(&study);
    clod_memory_free(points);
    return good;
}

bool clod_tables_read_flow(const char *path, clod_solid *solid, clod_status *status)
{
    void *rows;
    size_t count;
    const bool good = read_file(path, &FLOW_KIND, &rows, &count, status) &&
                      take_rows(rows, count, solid, status);
    clod_memory_free(rows);
    return good;
}

static bool read_strength(const clod_hopper_case *of, clod_solid *solid,
                          clod_tables_notes *notes, clod_status *status)
{
    const char *file = of->strength.file;
    return file != NULL ? clod_tables_read_flow(file, solid, status)
                        : read_tests(of, solid, notes, status);
}

/** Read a property's file; the points are owned by the caller. */
typedef bool property_reader(const char *path, clod_curve *curve, clod_status *status);

static bool read_angles(const char *path, const clod_csv_kind *kind, clod_curve *curve,
                        clod_status *status)
{
    void *rows;
    const bool good = read_file(path, kind, &rows, &curve->count, status);
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

bool clod_tables_read_density(const char *path, clod_curve *curve, clod_status *status)
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
        return find_table(from->file, "wall_friction.csv", inside, status) &&
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

bool clod_tables_read(const clod_hopper_case *from, clod_solid *solid, clod_tables_notes *notes,
                      clod_status *status)
{
    *solid = (clod_solid){0};
    if (!read_strength(from, solid, notes, status) ||
        !read_property(&from->phi_e, read_phi_e, &solid->phi_e, status) ||
        !read_property(&from->phi_t, read_phi_t, &solid->phi_t, status) ||
        !read_property(&from->rho, clod_tables_read_density, &solid->rho, status) ||
        !read_wall(&from->wall, &solid->wall, notes, status)) {
        return false;
    }
    solid->strength.way = from->strength.curve == CLOD_HOPPER_STRENGTH_LINE
                              ? CLOD_CURVE_LINE
                              : CLOD_CURVE_EXTENDED;
    solid->wall.way = CLOD_CURVE_EXTENDED;
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_sort(&solid->curves[k]);
    }
    return true;
}

void clod_tables_fini(clod_solid *solid)
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_fini(&solid->curves[k]);
    }
}
