#include "sim/uniaxial_run.h"

#include <stdio.h>

#include "sim/uniaxial_report.h"

static int64_t uniaxial_plan(const void *data, const void *context, const clod_state *state)
{
    (void)context;
    return clod_uniaxial_plan(data, state);
}

static bool uniaxial_sample(void *data, const void *context, clod_state *state,
                            const clod_survey *survey, double *row)
{
    (void)survey;
    (void)context;
    return clod_uniaxial_sample(data, state, row);
}

static const char *uniaxial_phase_name(int phase)
{
    return phase >= 0 && phase <= (int)CLOD_UNIAXIAL_DONE
               ? clod_uniaxial_phase_name((clod_uniaxial_phase)phase)
               : NULL;
}

static const char *uniaxial_phase(const void *data, const void *context)
{
    (void)context;
    const clod_uniaxial *self = data;
    return uniaxial_phase_name((int)self->phase);
}

static double uniaxial_fraction(const void *data, const void *context)
{
    (void)context;
    return clod_uniaxial_progress(data);
}

static bool uniaxial_trouble(const void *data, char *text, size_t size)
{
    return clod_uniaxial_trouble(data, text, size);
}

static void uniaxial_begin(const clod_case *from, const clod_part *part, clod_state *state)
{
    if (part->point >= 0) {
        const double stress = from->uniaxial.consolidation_stresses[part->point];
        clod_uniaxial_branch(part->test, stress, state);
    } else {
        clod_uniaxial_begin(part->test, from, state);
    }
}

/** What a filling of another run does not know: how this case crushes. */
static void uniaxial_adopt(const clod_case *from, const clod_part *part)
{
    clod_uniaxial *test = part->test;
    test->crush_max = from->uniaxial.crush_max;
    test->beyond_peak = from->uniaxial.beyond_peak;
}

const clod_parts_tester CLOD_UNIAXIAL_TESTER = {
    .procedure = {.size = sizeof(clod_uniaxial),
                  .columns = clod_uniaxial_columns,
                  .column_count = CLOD_UNIAXIAL_COLUMNS,
                  .plan = uniaxial_plan,
                  .sample = uniaxial_sample,
                  .phase = uniaxial_phase,
                  .phase_name = uniaxial_phase_name,
                  .fraction = uniaxial_fraction,
                  .trouble = uniaxial_trouble},
    .begin = uniaxial_begin,
    .adopt = uniaxial_adopt};

/** Parts, owned (clod_parts_destroy), or NULL: `fill`, then `stress-1` and so on as in the case. */
static clod_part *make_parts(const clod_case *from, int parts, clod_status *status)
{
    clod_part *part = clod_parts_create(&CLOD_UNIAXIAL_TESTER, from, parts, status);
    for (int k = 0; part != NULL && k < parts; k++) {
        part[k].seed = from->seed;
        part[k].point = k - 1;
        snprintf(part[k].name, sizeof part[k].name, k > 0 ? "stress-%d" : "fill", k);
        snprintf(part[k].from, sizeof part[k].from, "%s", k > 0 ? "fill" : "");
    }
    return part;
}

bool clod_uniaxial_try_origin(const clod_job_shared *sim, clod_status *status)
{
    clod_part *part = make_parts(sim->from, 1, status);
    const bool ok =
        part != NULL && clod_parts_try_origin(&CLOD_UNIAXIAL_TESTER, sim, part, 1, status);
    clod_parts_destroy(part);
    return ok;
}

bool clod_uniaxial_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    const clod_parts_tester *tester = &CLOD_UNIAXIAL_TESTER;
    const int points = (int)sim->from->uniaxial.consolidation_stress_count;
    clod_part *part = make_parts(sim->from, points + 1, status);
    const bool ok = part != NULL && clod_parts_run(tester, sim, part, 1, status) &&
                    clod_parts_run(tester, sim, part + 1, points, status) &&
                    clod_uniaxial_report(sim, part, points, report, status);
    if (part != NULL && !ok && status->code != CLOD_INTERRUPTED) { // that one goes on
        clod_uniaxial_report_finished(sim, part, points, status->text);
    }
    clod_parts_destroy(part);
    return ok;
}
