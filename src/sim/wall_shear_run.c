#include "sim/wall_shear_run.h"

#include <stdio.h>

#include "sim/wall_shear_report.h"

static int64_t wall_plan(const void *data, const void *context, const clod_state *state)
{
    (void)context;
    return clod_wall_shear_plan(data, state);
}

static bool wall_sample(void *data, const void *context, clod_state *state,
                        const clod_survey *survey, double *row)
{
    (void)survey;
    (void)context;
    return clod_wall_shear_sample(data, state, row);
}

static const char *wall_phase_name(int phase)
{
    return phase >= 0 && phase <= (int)CLOD_WALL_SHEAR_DONE
               ? clod_wall_shear_phase_name((clod_wall_shear_phase)phase)
               : NULL;
}

static const char *wall_phase(const void *data, const void *context)
{
    (void)context;
    const clod_wall_shear *self = data;
    return wall_phase_name((int)self->phase);
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
                  .phase_name = wall_phase_name,
                  .fraction = wall_fraction,
                  .trouble = wall_trouble},
    .begin = wall_begin,
    .adopt = wall_adopt};

/**
 * The fillings of all seeds, then the shear of each: [2 seeds], owned (clod_parts_destroy), or NULL.
 * Names: `fill`, then `wall`; with several seeds `seed-3-fill`.
 */
static clod_part *make_parts(const clod_case *from, clod_status *status)
{
    const int seeds = (int)from->wall_friction.seeds;
    clod_part *parts = clod_parts_create(&CLOD_WALL_SHEAR_TESTER, from, 2 * seeds, status);
    for (int k = 0; parts != NULL && k < 2 * seeds; k++) {
        clod_part *part = &parts[k];
        const bool shear = k >= seeds;
        char prefix[24] = "";
        part->seed = from->seed + k % seeds;
        part->point = shear ? 0 : -1;
        if (seeds > 1) {
            snprintf(prefix, sizeof prefix, "seed-%lld-", (long long)part->seed);
        }
        snprintf(part->name, sizeof part->name, "%s%s", prefix, shear ? "wall" : "fill");
        snprintf(part->from, sizeof part->from, "%s%s", shear ? prefix : "",
                 shear ? "fill" : "");
    }
    return parts;
}

bool clod_wall_shear_try_origin(const clod_job_shared *sim, clod_status *status)
{
    clod_part *parts = make_parts(sim->from, status);
    const bool ok =
        parts != NULL && clod_parts_try_origin(&CLOD_WALL_SHEAR_TESTER, sim, parts,
                                               (int)sim->from->wall_friction.seeds, status);
    clod_parts_destroy(parts);
    return ok;
}

bool clod_wall_shear_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    const clod_parts_tester *tester = &CLOD_WALL_SHEAR_TESTER;
    const int seeds = (int)sim->from->wall_friction.seeds;
    clod_part *part = make_parts(sim->from, status);
    const bool ok = part != NULL && clod_parts_run(tester, sim, part, seeds, status) &&
                    clod_parts_run(tester, sim, part + seeds, seeds, status) &&
                    clod_wall_shear_report(sim, part, seeds, report, status);
    if (part != NULL && !ok && status->code != CLOD_INTERRUPTED) { // that one goes on
        clod_wall_shear_report_finished(sim, part, seeds, status->text);
    }
    clod_parts_destroy(part);
    return ok;
}
