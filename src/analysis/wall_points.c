/**
 * @file wall_points.c
 * Wall yield loci from a CSV file, simulated or measured, with units in its header.
 */

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "analysis/csv.h"
#include "analysis/measured_header.h"
#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/wall_locus.h"

#define ANGLE_MOST 80.0  ///< deg, of phi_x: beyond it columns or units are wrong
#define ANGLES_APART 1.0 ///< deg, of phi_x from tau_w/sigma_w: more than tables are rounded by
#define DEGREES (180.0 / M_PI)

/** A row: a table says what is steady, a point what is not; and it may have angles in place of shear stresses, or
 *  beside them. */
typedef struct row {
    clod_wall_locus_point point;
    int64_t steady;
    double phi_x, phi_x_error; ///< rad; NAN: it has no angle
} row;

static const row FIRST = {.steady = 1, .phi_x = (double)NAN};

enum { SIGMA = 1, TAU, ANGLE_COUNT = 7, COLUMN_COUNT };

#define POINT(field) .offset = offsetof(row, point.field)

static const clod_csv_column COLUMNS[COLUMN_COUNT] = {
    {.names = {"seed"}, .unit = "", POINT(seed)},
    [SIGMA] =
        {.names = {"sigma_w"}, .unit = "Pa", .positive = true, .required = true, POINT(sigma)},
    [TAU] = {.names = {"tau_w"}, .unit = "Pa", .required = true, POINT(tau)},
    {.names = {"sigma_w_error"}, .unit = "Pa", POINT(sigma_error)},
    {.names = {"tau_w_error"}, .unit = "Pa", POINT(tau_error)},
    {.names = {"wall_stress"}, .unit = "Pa", POINT(wall_stress)},
    {.names = {"steady"}, .unit = "", .offset = offsetof(row, steady)},
    {.names = {"phi_x"}, .unit = "rad", .offset = offsetof(row, phi_x)},
};

/** The same with the angle of each point, as many laboratories print it. */
static const clod_csv_column ANGLES[ANGLE_COUNT] = {
    {.names = {"seed"}, .unit = "", POINT(seed)},
    [SIGMA] =
        {.names = {"sigma_w"}, .unit = "Pa", .positive = true, .required = true, POINT(sigma)},
    {.names = {"phi_x"},
     .unit = "rad",
     .positive = true,
     .required = true,
     .below = ANGLE_MOST / DEGREES,
     .offset = offsetof(row, phi_x)},
    {.names = {"sigma_w_error"}, .unit = "Pa", POINT(sigma_error)},
    {.names = {"phi_x_error"}, .unit = "rad", .offset = offsetof(row, phi_x_error)},
    {.names = {"wall_stress"}, .unit = "Pa", POINT(wall_stress)},
    {.names = {"steady"}, .unit = "", .offset = offsetof(row, steady)},
};

/** Columns that a wall friction test and clod locus --csv write and nobody reads here. */
static const char *const SKIPPED[] = {"phi_x_error", "line", "rho_b", "displacement", NULL};

static bool check_row(const clod_csv *self, const void *of)
{
    const row *at = of;
    const clod_wall_locus_point *p = &at->point;
    if (at->steady != 0 && at->steady != 1) {
        return clod_status_fail(
            self->status, CLOD_USAGE,
            "%s:%zu: column steady: %lld must be 1, shear was steady, or 0, "
            "it was not.",
            self->path, self->line, (long long)at->steady);
    }
    const double angle = DEGREES * atan2(p->tau, p->sigma);
    const double told = DEGREES * at->phi_x;
    if (self->kind->columns == COLUMNS && fabs(told - angle) > ANGLES_APART) {
        return clod_status_fail(
            self->status, CLOD_USAGE,
            "%s:%zu: phi_x = %.1f deg, but tau_w = %.6g Pa at sigma_w = %.6g Pa is an angle of "
            "%.1f deg. Correct the one that is wrong, or leave out its column.",
            self->path, self->line, told, p->tau, p->sigma, angle);
    }
    return angle <= ANGLE_MOST ||
           clod_status_fail(self->status, CLOD_USAGE,
                            "%s:%zu: tau_w = %.6g Pa at sigma_w = %.6g Pa is a wall friction "
                            "angle of %.1f deg; no wall has more than %.0f deg. Have the two "
                            "columns been exchanged, or has one another unit?",
                            self->path, self->line, p->tau, p->sigma, angle, ANGLE_MOST);
}

static const clod_csv_kind POINTS = {
    .columns = COLUMNS,
    .count = COLUMN_COUNT,
    .row = sizeof(row),
    .known = "sigma_w, tau_w, phi_x, seed, sigma_w_error, tau_w_error, phi_x_error, "
             "wall_stress, steady",
    .example = "sigma_w [kPa],tau_w [kPa]",
    .item = "wall yield locus point",
    .skipped = SKIPPED,
    .check_row = check_row,
};

static const clod_csv_kind POINTS_OF_ANGLES = {
    .columns = ANGLES,
    .count = ANGLE_COUNT,
    .row = sizeof(row),
    .known = "sigma_w, phi_x, seed, sigma_w_error, phi_x_error, wall_stress, steady",
    .example = "sigma_w [kPa],phi_x [deg]",
    .item = "wall yield locus point",
    .skipped = SKIPPED + 1, // all but the error of the angle
    .check_row = check_row,
};

/** The shear stress of an angle, sigma tan(phi_x). */
static void take_angle(const row *from, clod_wall_locus_point *to)
{
    const double tangent = tan(from->phi_x);
    to->of_angle = true;
    to->tau = to->sigma * tangent;
    to->tau_error = to->sigma * (1.0 + tangent * tangent) * from->phi_x_error;
}

/** Points of rows; owned, NULL without memory. */
static clod_wall_locus_point *points_of(const row *rows, size_t count, bool angles)
{
    clod_wall_locus_point *points = clod_memory_alloc(count, sizeof *points);
    for (size_t i = 0; points != NULL && i < count; i++) {
        points[i] = rows[i].point;
        points[i].unsteady = rows[i].steady == 0;
        if (angles) {
            take_angle(&rows[i], &points[i]);
        }
    }
    return points;
}

bool clod_wall_locus_parse(const char *path, const char *text, size_t length,
                           clod_wall_locus_point **points, size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    *points = NULL;
    *count = 0;
    const bool angles =
        clod_measured_has(text, length, "phi_x") && !clod_measured_has(text, length, "tau_w");
    clod_csv self = {.kind = angles ? &POINTS_OF_ANGLES : &POINTS,
                     .path = path,
                     .status = status,
                     .first = &FIRST};
    if (!clod_csv_parse(&self, text, length)) {
        return false;
    }
    *points = points_of(self.rows, self.count, angles);
    *count = *points != NULL ? self.count : 0;
    clod_memory_free(self.rows);
    return *points != NULL ||
           clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", self.count);
}

bool clod_wall_locus_read(const char *path, clod_wall_locus_point **points, size_t *count,
                          clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    *points = NULL;
    *count = 0;
    char *text;
    size_t size;
    if (!clod_input_read_named(&path, &text, &size, status)) {
        return false;
    }
    const bool done = clod_wall_locus_parse(path, text, size, points, count, status);
    clod_memory_free(text);
    return done;
}
