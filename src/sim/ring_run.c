#include "sim/ring_run.h"

#include <stdio.h>

#include "sim/ring_report.h"

static int64_t ring_plan(const void *data, const void *context, const clod_state *state)
{
    (void)context;
    return clod_ring_shear_plan(data, state);
}

static bool ring_sample(void *data, const void *context, clod_state *state,
                        const clod_survey *survey, double *row)
{
    (void)survey;
    (void)context;
    return clod_ring_shear_sample(data, state, row);
}

static const char *ring_phase_name(int phase)
{
    return phase >= 0 && phase <= (int)CLOD_RING_SHEAR_TWIST
               ? clod_ring_shear_phase_name((clod_ring_shear_phase)phase)
               : NULL;
}

static const char *ring_phase(const void *data, const void *context)
{
    (void)context;
    const clod_ring_shear *self = data;
    return ring_phase_name((int)self->phase);
}

static double ring_fraction(const void *data, const void *context)
{
    (void)context;
    return clod_ring_shear_progress(data);
}

static bool ring_trouble(const void *data, char *text, size_t size)
{
    return clod_ring_shear_trouble(data, text, size);
}

/** Names: `preshear`, `reverse`, `point-1`; with several seeds `seed-3-preshear`. */
static void name_part(const clod_case *from, int64_t seed, int64_t point, char name[48])
{
    char prefix[24] = "";
    if (clod_case_shear(from)->seeds > 1) {
        snprintf(prefix, sizeof prefix, "seed-%lld-", (long long)seed);
    }
    if (point >= 0) {
        snprintf(name, 48, "%spoint-%lld", prefix, (long long)point + 1);
    } else {
        snprintf(name, 48, "%s%s", prefix, point == CLOD_RING_REVERSE ? "reverse" : "preshear");
    }
}

static void ring_begin(const clod_case *from, const clod_part *part, clod_state *state)
{
    if (part->point >= 0) {
        const double stress = clod_case_shear(from)->shear_stresses[part->point];
        clod_ring_shear_branch(part->test, stress, state);
    } else if (part->point == CLOD_RING_REVERSE) {
        clod_ring_shear_reverse(part->test, state);
    } else {
        clod_ring_shear_begin(part->test, from, state);
    }
}

/** What a preparation of another run does not know: how this case shears to the points. */
static void ring_adopt(const clod_case *from, const clod_part *part)
{
    const clod_case_programme *programme = clod_case_shear(from);
    clod_ring_shear *test = part->test;
    test->shear_max = programme->shear_max;
    clod_peak_init(&test->peak, programme->peak_window, programme->beyond_peak);
}

const clod_parts_tester CLOD_RING_TESTER = {
    .procedure = {.size = sizeof(clod_ring_shear),
                  .columns = clod_ring_shear_columns,
                  .column_count = CLOD_RING_SHEAR_COLUMNS,
                  .plan = ring_plan,
                  .sample = ring_sample,
                  .phase = ring_phase,
                  .phase_name = ring_phase_name,
                  .fraction = ring_fraction,
                  .trouble = ring_trouble},
    .begin = ring_begin,
    .adopt = ring_adopt};

/** Preshears first, then their reversals, then the points of each seed. */
static void name_parts(const clod_case *from, clod_part *part)
{
    const int seeds = (int)clod_case_shear(from)->seeds;
    const int per_seed = (int)clod_case_shear(from)->shear_stress_count;
    for (int k = 0; k < seeds * (2 + per_seed); k++) {
        const int point = k - 2 * seeds;
        const int preparation = k < seeds ? CLOD_RING_PRESHEAR : CLOD_RING_REVERSE;
        part[k].seed = from->seed + (point < 0 ? k % seeds : point / per_seed);
        part[k].point = point < 0 ? preparation : point % per_seed;
        name_part(from, part[k].seed, part[k].point, part[k].name);
        if (preparation == CLOD_RING_REVERSE) {
            name_part(from, part[k].seed, point < 0 ? CLOD_RING_PRESHEAR : CLOD_RING_REVERSE,
                      part[k].from);
        }
    }
}

/** Preshears and reversals of all seeds. */
static int count_preparations(const clod_case *from)
{
    return 2 * (int)clod_case_shear(from)->seeds;
}

static int count_points(const clod_case *from)
{
    const clod_case_programme *programme = clod_case_shear(from);
    return (int)programme->seeds * (int)programme->shear_stress_count;
}

/** All parts of a test; owned (clod_parts_destroy), or NULL. */
static clod_part *make_parts(const clod_case *from, clod_status *status)
{
    clod_part *part = clod_parts_create(&CLOD_RING_TESTER, from,
                                        count_preparations(from) + count_points(from), status);
    if (part != NULL) {
        name_parts(from, part);
    }
    return part;
}

bool clod_ring_try_origin(const clod_job_shared *sim, clod_status *status)
{
    clod_part *part = make_parts(sim->from, status);
    const bool ok =
        part != NULL && clod_parts_try_origin(&CLOD_RING_TESTER, sim, part,
                                              count_preparations(sim->from), status);
    clod_parts_destroy(part);
    return ok;
}

bool clod_ring_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    const clod_parts_tester *tester = &CLOD_RING_TESTER;
    const int before = count_preparations(sim->from);
    const int points = count_points(sim->from);
    clod_part *part = make_parts(sim->from, status);
    const bool ok = part != NULL && clod_parts_run(tester, sim, part, before / 2, status) &&
                    clod_parts_run(tester, sim, part + before / 2, before / 2, status) &&
                    clod_parts_run(tester, sim, part + before, points, status) &&
                    clod_ring_report(sim, part, before, points, report, status);
    if (part != NULL && !ok && status->code != CLOD_INTERRUPTED) { // that one goes on
        clod_ring_report_finished(sim, part, before, points, status->text);
    }
    clod_parts_destroy(part);
    return ok;
}
