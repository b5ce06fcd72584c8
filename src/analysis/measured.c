#include "clod/measured.h"

#include <stdio.h>
#include <string.h>

#include "analysis/bulk_density.h"
#include "analysis/measured_header.h"
#include "analysis/study_file.h"
#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"

static bool has_strength(const char *header)
{
    return clod_measured_header_has(header, "f_c") ||
           clod_measured_header_has(header, "sigma_c") ||
           clod_measured_header_has(header, "fc");
}

static bool is_density(const char *header)
{
    return clod_measured_header_has(header, "sigma_1") &&
           (clod_measured_header_has(header, "rho_b") ||
            clod_measured_header_has(header, "rho")) &&
           !has_strength(header);
}

static bool is_repose(const char *header)
{
    return clod_measured_header_has(header, "angle_of_repose");
}

/** A table that is none of the kinds, but known. */
static bool check_header(const char *path, const char *text, size_t length, clod_status *status)
{
    char header[CLOD_MEASURED_HEADER];
    clod_measured_header_of(text, length, header);
    if (clod_measured_header_is_wall(header) &&
        (clod_measured_header_has(header, "sigma_1") ||
         clod_measured_header_has(header, "sigma_sh"))) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: two tables are mixed: sigma_w and tau_w are of a wall yield locus, %s of %s. "
            "Put each into a file of its own.",
            path, clod_measured_header_has(header, "sigma_1") ? "sigma_1" : "sigma_sh",
            clod_measured_header_has(header, "sigma_1") ? "bulk densities or a flow function"
                                                        : "a yield locus");
    }
    if (clod_measured_header_has(header, "sigma_1") && has_strength(header) &&
        !clod_measured_header_has(header, "sigma_sh")) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: is a flow function, which is evaluated already; clod hopper reads it, as "
            "flow_function: {file: %s}, and clod calibrate, as locus of a target.",
            path, path);
    }
    return true;
}

/** What an evaluation says of a table, with its name. */
static bool fail_evaluation(const char *path, const clod_status *why, clod_status *status)
{
    return clod_status_fail(status, why->code, "%s: %s", path, why->text);
}

// ---- each kind

static bool read_shear(const char *path, const char *text, size_t length,
                       const clod_locus_defaults *defaults, clod_measured *self,
                       clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_parse(path, text, length, defaults, &points, &count, status)) {
        return false;
    }
    self->study = clod_study_of_points(path, points, count, status);
    clod_locus_free(points);
    return self->study != NULL;
}

static bool read_wall(const char *path, const char *text, size_t length,
                      const clod_locus_defaults *defaults, clod_measured *self,
                      clod_status *status)
{
    (void)defaults; // it has none
    clod_wall_locus_point *points;
    size_t count;
    if (!clod_wall_locus_parse(path, text, length, &points, &count, status)) {
        return false;
    }
    clod_status why = {0};
    const bool good = clod_wall_locus_of_table(points, count, &self->wall, &why);
    clod_locus_free(points);
    return good || fail_evaluation(path, &why, status);
}

static bool read_density(const char *path, const char *text, size_t length,
                         const clod_locus_defaults *defaults, clod_measured *self,
                         clod_status *status)
{
    (void)defaults; // it has none
    clod_bulk_density_point *points;
    size_t count;
    if (!clod_bulk_density_parse(path, text, length, &points, &count, status)) {
        return false;
    }
    bool good = true;
    for (size_t i = 0; good && i < count; i++) {
        good = clod_bulk_density_consolidated(path, points[i].sigma_1, status);
    }
    clod_status why = {0};
    const bool done = good && clod_bulk_density_evaluate(points, count, &self->density, &why);
    clod_locus_free(points);
    return done || (good && fail_evaluation(path, &why, status));
}

static bool read_repose(const char *path, const char *text, size_t length,
                        const clod_locus_defaults *defaults, clod_measured *self,
                        clod_status *status)
{
    (void)defaults; // it has none
    clod_repose_heap *heaps;
    size_t count;
    if (!clod_repose_angles_parse(path, text, length, &heaps, &count, status)) {
        return false;
    }
    const bool good = clod_repose_angles_evaluate(heaps, count, &self->repose, status);
    clod_locus_free(heaps);
    return good;
}

// ---- one row for each kind

typedef struct kind_row {
    const char *name;               ///< in messages
    const char *needs;              ///< columns, as messages name them
    bool preshear;                  ///< its stresses may be given beside the table
    bool (*is)(const char *header); ///< NULL: what is none of the others
    bool (*read)(const char *path, const char *text, size_t length,
                 const clod_locus_defaults *defaults, clod_measured *self, clod_status *status);
    char *(*table)(const clod_measured *self);
    char *(*json)(const clod_measured *self);
    char *(*csv)(const clod_measured *self);
} kind_row;

static char *shear_table(const clod_measured *self)
{
    return clod_locus_table(self->study);
}

static char *shear_json(const clod_measured *self)
{
    return clod_locus_json(self->study);
}

static char *shear_csv(const clod_measured *self)
{
    return clod_locus_csv(self->study);
}

static char *wall_table(const clod_measured *self)
{
    return clod_wall_locus_table(&self->wall);
}

static char *wall_json(const clod_measured *self)
{
    return clod_wall_locus_json(&self->wall);
}

static char *wall_csv(const clod_measured *self)
{
    return clod_wall_locus_csv(&self->wall);
}

static char *density_table(const clod_measured *self)
{
    return clod_bulk_density_table(&self->density);
}

static char *density_json(const clod_measured *self)
{
    return clod_bulk_density_json(&self->density);
}

static char *density_csv(const clod_measured *self)
{
    return clod_bulk_density_csv(&self->density);
}

static char *repose_table(const clod_measured *self)
{
    return clod_repose_angles_table(&self->repose);
}

static char *repose_json(const clod_measured *self)
{
    return clod_repose_angles_json(&self->repose);
}

static char *repose_csv(const clod_measured *self)
{
    return clod_repose_angles_csv(&self->repose);
}

static const kind_row KINDS[] = {
    [CLOD_MEASURED_SHEAR] = {.name = "table of shear points",
                             .needs =
                                 "sigma_pre [kPa], tau_pre [kPa], sigma_sh [kPa], tau_sh [kPa]",
                             .preshear = true,
                             .read = read_shear,
                             .table = shear_table,
                             .json = shear_json,
                             .csv = shear_csv},
    [CLOD_MEASURED_WALL] = {.name = "wall yield locus",
                            .needs = "sigma_w [kPa], tau_w [kPa] or phi_x [deg]",
                            .is = clod_measured_header_is_wall,
                            .read = read_wall,
                            .table = wall_table,
                            .json = wall_json,
                            .csv = wall_csv},
    [CLOD_MEASURED_DENSITY] = {.name = "table of bulk densities",
                               .needs = "sigma_1 [kPa], rho_b [kg/m3]",
                               .is = is_density,
                               .read = read_density,
                               .table = density_table,
                               .json = density_json,
                               .csv = density_csv},
    [CLOD_MEASURED_REPOSE] = {.name = "table of angles of repose",
                              .needs = "angle_of_repose [deg]",
                              .is = is_repose,
                              .read = read_repose,
                              .table = repose_table,
                              .json = repose_json,
                              .csv = repose_csv},
};

clod_measured_kind clod_measured_kind_of(const char *text, size_t length)
{
    char header[CLOD_MEASURED_HEADER];
    CLOD_NEED(text);
    clod_measured_header_of(text, length, header);
    for (int k = 0; k < (int)(sizeof KINDS / sizeof *KINDS); k++) {
        if (KINDS[k].is != NULL && KINDS[k].is(header)) {
            return (clod_measured_kind)k;
        }
    }
    return CLOD_MEASURED_SHEAR;
}

/** A preshear that was given for a table without one is a mistake. */
static bool check_defaults(const char *path, const clod_locus_defaults *defaults,
                           const kind_row *kind, clod_status *status)
{
    const bool given =
        defaults != NULL && (defaults->sigma_pre != NULL || defaults->tau_pre != NULL);
    return !given || kind->preshear ||
           clod_status_fail(status, CLOD_USAGE, "%s: a %s has no preshear; leave out --%s.",
                            path, kind->name,
                            defaults->sigma_pre != NULL ? "sigma-pre" : "tau-pre");
}

/** A header that says nothing of what its table is; one that is no text, or has no header, is left to the reader. */
static bool check_known(const char *path, const char *text, size_t length, clod_status *status)
{
    char header[CLOD_MEASURED_HEADER], kinds[CLOD_MEASURED_HEADER] = "";
    clod_measured_header_of(text, length, header);
    const clod_measured_stress stress = clod_measured_stress_of(text, length);
    if (header[0] == '\0' || memchr(text, '\0', length) != NULL || is_repose(header) ||
        clod_measured_header_has(header, "sigma_p") ||
        clod_measured_header_has(header, "tau_p") || stress == CLOD_MEASURED_OF_SHEAR ||
        stress == CLOD_MEASURED_OF_WALL || is_density(header) || has_strength(header)) {
        return true;
    }
    for (size_t k = 0; k < sizeof KINDS / sizeof *KINDS; k++) {
        const size_t used = strlen(kinds);
        snprintf(kinds + used, sizeof kinds - used, "%s%s: %s", k > 0 ? "; " : "",
                 KINDS[k].name, KINDS[k].needs);
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s: none of the columns in its header says what the table is. It "
        "may be one of these, with the columns that it needs: %s. clod locus "
        "--help lists the optional ones.",
        path, kinds);
}

static bool parse(const char *path, const char *text, size_t length,
                  const clod_locus_defaults *defaults, clod_measured *self, clod_status *status)
{
    self->kind = clod_measured_kind_of(text, length);
    const kind_row *kind = &KINDS[self->kind];
    return clod_measured_header_check(path, clod_measured_stress_of(text, length), status) &&
           check_known(path, text, length, status) &&
           check_header(path, text, length, status) &&
           check_defaults(path, defaults, kind, status) &&
           kind->read(path, text, length, defaults, self, status);
}

bool clod_measured_read(const char *path, const clod_locus_defaults *defaults,
                        clod_measured *self, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(self, status)) {
        return false;
    }
    memset(self, 0, sizeof *self);
    char *text;
    size_t size;
    if (!clod_input_read_named(&path, &text, &size, status)) {
        return false;
    }
    const bool good = parse(path, text, size, defaults, self, status);
    clod_memory_free(text);
    return good;
}

void clod_measured_fini(clod_measured *self)
{
    CLOD_NEED(self);
    clod_locus_study_destroy(&self->study);
    clod_wall_locus_fini(&self->wall);
    clod_bulk_density_fini(&self->density);
    clod_repose_angles_fini(&self->repose);
}

char *clod_measured_table(const clod_measured *self)
{
    CLOD_NEED(self);
    return KINDS[self->kind].table(self);
}

char *clod_measured_json(const clod_measured *self)
{
    CLOD_NEED(self);
    return KINDS[self->kind].json(self);
}

char *clod_measured_csv(const clod_measured *self)
{
    CLOD_NEED(self);
    return KINDS[self->kind].csv(self);
}

void clod_measured_warnings(const clod_measured *self, clod_measured_sink sink, void *context)
{
    CLOD_NEED(self);
    CLOD_NEED(sink);
    for (size_t k = 0; k < self->wall.warning_count; k++) {
        sink(context, self->wall.warnings[k]);
    }
    for (size_t k = 0; k < self->density.warning_count; k++) {
        sink(context, self->density.warnings[k]);
    }
    for (size_t g = 0; self->study != NULL && g < self->study->count; g++) {
        const clod_locus *locus = &self->study->groups[g].locus;
        for (size_t i = 0; i < locus->warning_count; i++) {
            char text[CLOD_LOCUS_WARNING_TEXT + 64];
            snprintf(text, sizeof text, "preshear at %.3f kPa: %s",
                     locus->sigma_p.value / 1000.0, locus->warnings[i]);
            sink(context, text);
        }
    }
    if (self->repose.warning[0] != '\0') {
        sink(context, self->repose.warning);
    }
    if (self->study != NULL && self->study->warning[0] != '\0') {
        sink(context, self->study->warning);
    }
}
