#include "sim/wall_shear_run.h"

#include <stdio.h>

#include "base/memory.h"
#include "sim/wall_shear_report.h"

static int64_t wall_plan(const void *data, const void *context, const clod_state *state)
{
    (void)context;
    return clod_wall_shear_plan(data, state);
}

static bool wall_sample(void *data, const void *context, clod_state *state, double *row)
{
    (void)context;
    return clod_wall_shear_sample(data, state, row);
}

static const char *wall_phase(const void *data, const void *context)
{
    (void)context;
    const clod_wall_shear *self = data;
    return clod_wall_shear_phase_name((clod_wall_shear_phase)self->phase);
}

static double wall_fraction(const void *data, const void *context)
{
    (void)context;
    return clod_wall_shear_progress(data);
}

static bool wall_trouble(const void *data, char *text, size_t size)
{
    return clod_wall_shear_trouble(data, text, size);
}

static void wall_begin(const clod_case *from, const clod_part *part, clod_state *state)
{
    if (part->point >= 0) {
        clod_wall_shear_branch(part->test, state);
    } else {
        clod_wall_shear_begin(part->test, from, state);
    }
}

/** What a filling of another run does not know: the stresses and ways of this case. */
static void wall_adopt(const clod_case *from, const clod_part *part)
{
    clod_wall_shear_programme(part->test, from);
}

const clod_parts_tester CLOD_WALL_SHEAR_TESTER = {
    .procedure = {.size = sizeof(clod_wall_shear),
                  .columns = clod_wall_shear_columns,
                  .column_count = CLOD_WALL_SHEAR_COLUMNS,
                  .plan = wall_plan,
                  .sample = wall_sample,
                  .phase = wall_phase,
                  .fraction = wall_fraction,
                  .trouble = wall_trouble},
    .begin = wall_begin,
    .adopt = wall_adopt};

/** The parts of a test: the fillings of all seeds, then the shear of each. */
typedef struct wall_parts {
    int seeds;
    clod_part *part;       ///< [2 * seeds] owned
    clod_wall_shear *test; ///< [2 * seeds] owned
} wall_parts;

/** Names: `fill`, then `wall`; with several seeds `seed-3-fill`. */
static void name_parts(const clod_case *from, const wall_parts *self)
{
    for (int k = 0; k < 2 * self->seeds; k++) {
        clod_part *part = &self->part[k];
        const bool shear = k >= self->seeds;
        char prefix[24] = "";
        part->test = &self->test[k];
        part->seed = from->seed + k % self->seeds;
        part->point = shear ? 0 : -1;
        if (self->seeds > 1) {
            snprintf(prefix, sizeof prefix, "seed-%lld-", (long long)part->seed);
        }
        snprintf(part->name, sizeof part->name, "%s%s", prefix, shear ? "wall" : "fill");
        snprintf(part->from, sizeof part->from, "%s%s", shear ? prefix : "",
                 shear ? "fill" : "");
    }
}

static bool make_parts(wall_parts *self, const clod_case *from, clod_status *status)
{
    self->seeds = (int)from->wall_friction.seeds;
    self->part = clod_memory_alloc(2 * (size_t)self->seeds, sizeof *self->part);
    self->test = clod_memory_alloc(2 * (size_t)self->seeds, sizeof *self->test);
    if (self->part == NULL || self->test == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the parts of the test");
    }
    name_parts(from, self);
    return true;
}

static void free_parts(wall_parts *self)
{
    clod_memory_free(self->part);
    clod_memory_free(self->test);
}

bool clod_wall_shear_try_origin(const clod_job_shared *sim, clod_status *status)
{
    wall_parts parts;
    const bool ok =
        make_parts(&parts, sim->from, status) &&
        clod_parts_try_origin(&CLOD_WALL_SHEAR_TESTER, sim, parts.part, parts.seeds, status);
    free_parts(&parts);
    return ok;
}

static bool run_parts(const clod_job_shared *sim, const wall_parts *parts, char **report,
                      clod_status *status)
{
    const clod_parts_tester *tester = &CLOD_WALL_SHEAR_TESTER;
    clod_part *part = parts->part;
    const int seeds = parts->seeds;
    const bool ok = clod_parts_run(tester, sim, part, seeds, status) &&
                    clod_parts_run(tester, sim, part + seeds, seeds, status) &&
                    clod_wall_shear_report(sim, part, seeds, report, status);
    if (!ok && status->code != CLOD_INTERRUPTED) { // that one goes on
        clod_wall_shear_report_finished(sim, part, seeds, status->text);
    }
    return ok;
}

bool clod_wall_shear_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    wall_parts parts;
    const bool ok =
        make_parts(&parts, sim->from, status) && run_parts(sim, &parts, report, status);
    free_parts(&parts);
    return ok;
}
