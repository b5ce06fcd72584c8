#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "base/plural.h"
#include "measure/repose.h"
#include "setup/domain.h"
#include "sim/mixing.h"

#define DEGREE (180.0 / M_PI)

/** Columns of each angle. */
static const char *const COLUMN[] = {"repose_angle [deg]", "height [m]"};
#define COLUMNS (sizeof COLUMN / sizeof *COLUMN)

/** What one remembers. */
typedef struct repose_memory {
    clod_repose_angle now; ///< of the last look
    clod_mixing_mean mean; ///< of the angle [rad]
} repose_memory;

static size_t repose_size(const clod_case *from)
{
    return from->repose_count * sizeof(repose_memory);
}

/** A surface of the case; about the centre of mass of now where none is given. */
static bool surface_of(const clod_case_repose *from, const clod_survey *survey,
                       clod_repose *self, clod_status *status)
{
    *self = (clod_repose){.region = clod_setup_domain_region(&from->region),
                          .cell = from->cell,
                          .slope = from->has_direction,
                          .from = from->from,
                          .to = from->to};
    const double length = hypot(from->direction[0], from->direction[1]);
    for (int a = 0; self->slope && a < 2; a++) {
        self->direction[a] = from->direction[a] / length;
    }
    if (from->has_center) {
        memcpy(self->center, from->center, sizeof self->center);
    }
    return from->has_center || self->slope ||
           clod_repose_center(&self->region, survey, self->center, status);
}

static bool repose_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    repose_memory *self = memory;
    bool good = true;
    for (size_t k = 0; good && k < now->from->repose_count; k++) {
        clod_repose surface;
        good = surface_of(&now->from->reposes[k], now->survey, &surface, status) &&
               clod_repose_find(&surface, now->survey, &self[k].now, status);
        clod_mixing_mean_note(&self[k].mean, now, self[k].now.angle);
    }
    return good;
}

static size_t repose_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return from->repose_count * COLUMNS;
}

static void repose_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    (void)state;
    snprintf(text, size, "repose_%s.%s", from->reposes[k / COLUMNS].name, COLUMN[k % COLUMNS]);
}

static void repose_row(void *memory, const clod_free_moment *now, double *row)
{
    const repose_memory *self = memory;
    for (size_t k = 0; k < now->from->repose_count; k++) {
        *row++ = self[k].now.angle * DEGREE;
        *row++ = self[k].now.height;
    }
}

static void repose_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const repose_memory *self = memory;
    for (size_t k = 0; k < now->from->repose_count; k++) {
        const clod_repose_angle *of = &self[k].now;
        fprintf(out, "  repose %-14s angle of repose ", now->from->reposes[k].name);
        if (isnan(of->height)) {
            fputs("none at the end (no grain in the region), ", out);
        } else if (isnan(of->angle)) {
            fprintf(out, "none at the end (%" PRId64 " strip%s of the flank, 3 are needed), ",
                    of->strips, clod_plural((double)of->strips));
        } else {
            char text[32];
            const char *error =
                clod_prose_deviation(text, of->angle * DEGREE, of->error * DEGREE);
            fprintf(out, "%.4g%s deg at the end%s, ", of->angle * DEGREE, error,
                    error[0] != '\0' ? " (+- standard error of the line)" : "");
        }
        clod_mixing_mean_write(out, &self[k].mean, DEGREE, " deg");
        if (!isnan(of->height)) {
            fprintf(out, "; height %.4g m", of->height);
        }
        fputc('\n', out);
    }
}

static bool repose_told(const clod_case *from)
{
    return from->repose_count > 0;
}

static void repose_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t r = 0; r < from->repose_count; r++) {
        clod_free_paths_add(
            paths, from->reposes[r].name,
            "since_s angle_deg error_deg mean_deg deviation_deg height_m strips");
    }
}

static json_t *repose_json(const void *memory, const clod_free_moment *now)
{
    const repose_memory *self = memory;
    json_t *all = json_object();
    for (size_t k = 0; k < now->from->repose_count; k++) {
        const clod_repose_angle *of = &self[k].now;
        double mean, deviation;
        clod_mixing_mean_of(&self[k].mean, &mean, &deviation);
        json_object_set_new(
            all, now->from->reposes[k].name,
            json_pack("{s:f, s:o, s:o, s:o, s:o, s:o, s:I}", "since_s", now->steady.since,
                      "angle_deg", clod_json_number(of->angle * DEGREE), "error_deg",
                      clod_json_number(of->error * DEGREE), "mean_deg",
                      clod_json_number(mean * DEGREE), "deviation_deg",
                      clod_json_number(deviation * DEGREE), "height_m",
                      clod_json_number(of->height), "strips", (json_int_t)of->strips));
    }
    return all;
}

const clod_free_measure CLOD_MEASURE_REPOSE = {.key = "repose",
                                               .paths = repose_paths,
                                               .size = repose_size,
                                               .look = repose_look,
                                               .columns = repose_columns,
                                               .column = repose_column,
                                               .row = repose_row,
                                               .report = repose_report,
                                               .told = repose_told,
                                               .json = repose_json};
