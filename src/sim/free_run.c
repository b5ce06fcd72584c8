#include "sim/free_run.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "base/plural.h"
#include "base/text.h"
#include "config/grain_solid.h"
#include "measure/contacts.h"
#include "output/checkpoint.h"
#include "output/folder_files.h"
#include "setup/belt_doubts.h"
#include "setup/flush_walls.h"
#include "setup/grains.h"
#include "setup/region_walls.h"
#include "setup/state.h"
#include "setup/walls.h"
#include "sim/deal.h"
#include "sim/free_measures.h"
#include "sim/free_stages.h"
#include "sim/job_store.h"
#include "sim/mesh_doubts.h"
#include "sim/origin.h"
#include "sim/warning_box.h"

/** Columns before those of the measures. */
static const char *const FIRST[] = {"time [s]", "stage [1]", "kinetic_energy [J]",
                                    "max_speed [m/s]"};
#define FIRST_COUNT (sizeof FIRST / sizeof *FIRST)

/** Data of the procedure: where it is, and how each stage that is over ended. What the measures
 *  remember lies behind it. */
typedef struct free_data {
    clod_free_stages at;
    _Alignas(16) clod_free_stage_end ended[]; ///< [stage_count]; step 0: not yet
} free_data;

static_assert(sizeof(clod_free_stage_end) % 16 == 0, "the measures' memory is aligned");

/** Bytes before what the measures remember. */
static size_t stages_size(const clod_case *from)
{
    return sizeof(free_data) + from->stage_count * sizeof(clod_free_stage_end);
}

static void *measures_of(const void *data, const clod_case *from)
{
    return (unsigned char *)data + stages_size(from);
}

/** What the measures look at. */
static clod_free_moment moment_of(const void *data, const clod_case *from, clod_state *state,
                                  const clod_survey *survey)
{
    return clod_free_measures_moment(measures_of(data, from), from, state, survey);
}

static int64_t free_plan(const void *data, const void *context, const clod_state *state)
{
    const free_data *self = data;
    const int64_t stage = clod_free_stages_plan(&self->at, context, state);
    const int64_t next = clod_free_measures_plan(measures_of(data, context), context, state);
    return stage < next ? stage : next;
}

static void free_sight(const void *data, const void *context, const clod_state *state,
                       clod_sight *sees)
{
    clod_state *seen = (clod_state *)state; // a moment may change it; nobody does here
    const clod_free_moment now = moment_of(data, context, seen, NULL);
    clod_free_measures_sight(measures_of(data, context), &now, sees);
}

static bool free_act(void *data, const void *context, clod_state *state,
                     const clod_survey *survey, clod_status *status)
{
    const clod_free_moment now = moment_of(data, context, state, survey);
    return clod_free_measures_act(measures_of(data, context), &now, status);
}

static bool free_news(void *data, const void *context, const clod_state *state, clod_news *news)
{
    return clod_free_measures_news(measures_of(data, context), context, state, news);
}

static bool free_look(void *data, const void *context, const clod_state *state,
                      const clod_survey *survey)
{
    free_data *self = data;
    return clod_free_stages_look(&self->at, context, state, survey);
}

static bool free_measure(void *data, const void *context, clod_state *state,
                         const clod_survey *survey, clod_status *status)
{
    const clod_free_moment now = moment_of(data, context, state, survey);
    return clod_free_measures_look(measures_of(data, context), &now, status);
}

static bool free_picture(void *data, const void *context, clod_state *state,
                         const clod_survey *survey, const clod_frame *frame,
                         clod_status *status)
{
    const clod_free_moment now = moment_of(data, context, state, survey);
    return clod_free_measures_picture(measures_of(data, context), &now, frame, status);
}

static bool free_sample(void *data, const void *context, clod_state *state,
                        const clod_survey *survey, double *row)
{
    free_data *self = data;
    const clod_measure_motion bed = clod_measure_motion_from(survey);
    clod_free_moment now = moment_of(data, context, state, survey);
    now.motion = &bed;
    const double first[FIRST_COUNT] = {state->time, (double)self->at.stage, bed.kinetic_energy,
                                       bed.max_speed};
    memcpy(row, first, sizeof first);
    clod_free_measures_row(measures_of(data, context), &now, row + FIRST_COUNT);
    if (self->at.end != CLOD_FREE_GOES_ON) {
        self->ended[self->at.stage] =
            (clod_free_stage_end){.step = state->step, .reason = self->at.end};
    }
    return clod_free_stages_next(&self->at, context, state);
}

static int64_t trial_plan(const void *data, const void *context, const clod_state *state)
{
    return clod_free_stages_plan(data, context, state);
}

static bool trial_look(void *data, const void *context, const clod_state *state,
                       const clod_survey *survey)
{
    return clod_free_stages_look(data, context, state, survey);
}

static void trial_begin(const clod_case *from, const clod_part *part, clod_state *state)
{
    clod_free_stages_begin(part->test, from, state);
}

static bool trial_sample(void *data, const void *context, clod_state *state,
                         const clod_survey *survey, double *row)
{
    (void)survey;
    (void)row;
    return clod_free_stages_next(data, context, state);
}

const clod_parts_tester CLOD_FREE_TRIAL = {.procedure = {.size = sizeof(clod_free_stages),
                                                         .plan = trial_plan,
                                                         .look = trial_look,
                                                         .sample = trial_sample},
                                           .begin = trial_begin};

static const char *free_phase(const void *data, const void *context)
{
    const free_data *self = data;
    return clod_free_stages_name(&self->at, context);
}

static double free_fraction(const void *data, const void *context)
{
    const free_data *self = data;
    return clod_free_stages_fraction(&self->at, context);
}

/** Why the stage that ended last did. */
static const char *free_reason(const void *data)
{
    const free_data *self = data;
    const int64_t last =
        self->at.end != CLOD_FREE_GOES_ON ? self->at.stage : self->at.stage - 1;
    return clod_free_stages_reason((clod_free_end)self->ended[last].reason);
}

/** Header texts, fixed ones and those of the measures; one block of owned text. */
static char (*make_columns(const clod_case *from, const clod_state *state,
                           const char **columns))[CLOD_FREE_COLUMN_TEXT]
{
    const size_t made = clod_free_measures_columns(from, state);
    char(*text)[CLOD_FREE_COLUMN_TEXT] = clod_memory_alloc(made + 1, CLOD_FREE_COLUMN_TEXT);
    if (text == NULL) {
        return NULL;
    }
    memcpy(columns, FIRST, sizeof FIRST);
    for (size_t k = 0; k < made; k++) {
        clod_free_measures_column(from, state, k, text[k], CLOD_FREE_COLUMN_TEXT);
        columns[FIRST_COUNT + k] = text[k];
    }
    return text;
}

/** A line for each stage: when and why it ended. */
static void report_stages(FILE *out, const clod_job *job)
{
    const clod_case *from = job->sim->from;
    const free_data *data = job->procedure.data;
    for (size_t s = 0; s < from->stage_count; s++) {
        const clod_free_stage_end *end = &data->ended[s];
        fprintf(out, "  stage %-15s ended at %.6g s: %s\n", from->stages[s].name,
                (double)end->step * job->state.dt,
                clod_free_stages_reason((clod_free_end)end->reason));
    }
}

/** What is to be said beside the results: a new list of texts. */
static json_t *warnings_of(const clod_job *job, const clod_free_moment *now)
{
    json_t *list = json_array();
    char text[CLOD_SOLID_TEXT];
    if (clod_grain_solid_missed(now->from, text, sizeof text)) {
        json_array_append_new(list, json_string(text));
    }
    clod_free_measures_warn(list, measures_of(job->procedure.data, now->from), now);
    return list;
}

/** Owned text; NULL without memory. */
static char *make_report(clod_job *job)
{
    clod_state *state = &job->state;
    const clod_measure_contacts bed = clod_job_bed(job);
    const size_t grains = (size_t)clod_job_motion(job).grains;
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out,
            "time %.6g s, %lld step%s, %zu grain%s, %zu contact%s, coordination %.2f, largest "
            "overlap %.3g %% of a radius\n",
            state->time, (long long)state->step, clod_plural((double)state->step), grains,
            clod_plural((double)grains), bed.pairs, clod_plural((double)bed.pairs),
            bed.coordination, 100.0 * bed.max_overlap);
    report_stages(out, job);
    const clod_free_moment now = moment_of(job->procedure.data, job->sim->from, state, NULL);
    clod_free_measures_report(out, measures_of(job->procedure.data, now.from), &now);
    json_t *warnings = warnings_of(job, &now);
    clod_warning_box_put(out, warnings);
    json_decref(warnings);
    char *report = clod_text_close(&text);
    if (clod_json_lacks_memory()) { // a warning is not there
        clod_memory_free(report);
        report = NULL;
    }
    return report;
}

static json_t *stages_json(const clod_job *job)
{
    const free_data *data = job->procedure.data;
    json_t *stages = json_array();
    for (size_t s = 0; s < job->sim->from->stage_count; s++) {
        const clod_free_stage_end *end = &data->ended[s];
        json_array_append_new(
            stages, json_pack("{s:s, s:f, s:s}", "name", job->sim->from->stages[s].name,
                              "end_s", (double)end->step * job->state.dt, "reason",
                              clod_free_stages_reason((clod_free_end)end->reason)));
    }
    return stages;
}

static bool write_summary(clod_job *job, clod_status *status)
{
    clod_state *state = &job->state;
    const clod_measure_contacts bed = clod_job_bed(job);
    const clod_measure_motion motion = clod_job_motion(job);
    const char *title = job->sim->from->title;
    json_t *root =
        json_pack("{s:s, s:s, s:f, s:f, s:I, s:I, s:I, s:f, s:f, s:f, s:f, s:f, s:o}", "title",
                  title != NULL ? title : "", "version", job->memory.version, "time_s",
                  state->time, "dt_s", state->dt, "steps", (json_int_t)state->step, "grains",
                  (json_int_t)motion.grains, "contacts", (json_int_t)bed.pairs, "coordination",
                  bed.coordination, "max_overlap", bed.max_overlap, "stable_step_s",
                  clod_job_stable_step(job), "kinetic_energy_J", motion.kinetic_energy,
                  "wall_clock_s", job->memory.wall_clock, "stages", stages_json(job));
    const clod_job_shared *sim = job->sim;
    if (job->memory.origin[0] != '\0') {
        json_object_set_new(root, "from", json_string(job->memory.origin));
    }
    const clod_free_moment now = moment_of(job->procedure.data, sim->from, state, NULL);
    const void *measures = measures_of(job->procedure.data, sim->from);
    json_t *warnings = warnings_of(job, &now);
    if (json_array_size(warnings) > 0) {
        json_object_set(root, "warnings", warnings);
    }
    json_decref(warnings);
    clod_free_measures_json(root, measures, &now);
    const bool ok = clod_free_measures_write(sim->folder, measures, &now, status) &&
                    clod_folder_write_json(sim->folder, "summary.json", root, status);
    json_decref(root);
    return ok;
}

/** The state that the case asks for; several ranks get its grains as they are made. */
static bool make_fresh(clod_job *job, clod_setup_bed *bed, clod_status *status)
{
    const clod_job_shared *sim = job->sim;
    char text[512];
    clod_deal deal;
    const clod_setup_taker *taker = clod_deal_begin(&deal, sim->options->ranks, sim->from);
    const bool good =
        clod_setup_state_give(sim->from, sim->from->seed, taker, &job->state, bed, status);
    job->dealt = good && taker != NULL;
    if (good && clod_setup_grains_say_off(sim->from, bed, text, sizeof text)) {
        clod_job_tell(job, text);
    }
    clod_deal_fini(&deal);
    return good;
}

/** The state to begin with; only its walls when everything else is in a checkpoint.
 *  @param bed  [out] of grains that have been dealt */
static bool make_state(clod_job *job, clod_setup_bed *bed, clod_status *status)
{
    const clod_job_shared *sim = job->sim;
    char *told;
    bool exists;
    if (!clod_checkpoint_exists(sim->folder, "restart", &exists, status)) {
        return false;
    }
    if (exists) {
        job->state = (clod_state){.build_motion = -1.0};
        return clod_setup_walls(sim->from, &job->state.walls, status);
    }
    if (sim->origin == NULL) {
        return make_fresh(job, bed, status);
    }
    if (!clod_origin_open(sim->origin, sim, status)) {
        return false;
    }
    const bool ok = clod_origin_state(sim->origin, sim->from, &job->state, &told, status);
    if (ok && told != NULL) {
        clod_job_tell(job, told);
    }
    clod_memory_free(told);
    return ok;
}

/** A doubt about a mesh, or what is worth a look. */
static void doubt(void *job, bool wrong, const char *text)
{
    char line[CLOD_SETUP_FLUSH_TEXT + 16];
    snprintf(line, sizeof line, "%s%s", wrong ? "warning: " : "", text);
    clod_job_tell(job, line);
}

/** A wall that cuts a region of grains, has a face in common with another one, or a belt with
 *  another side up. */
static void doubt_wall(void *job, const char *text)
{
    doubt(job, true, text);
}

/** What is doubtful about meshes and walls, beside the grains that there are. */
static bool doubt_walls(clod_job *job, const clod_setup_bed *bed, clod_status *status)
{
    const clod_case *from = job->sim->from;
    const double radius = bed->grains > 0 ? bed->radius_sum / (double)bed->grains : 0.0;
    if (!clod_mesh_doubts(from, radius, doubt, job, status)) {
        return false;
    }
    clod_setup_regions_doubts(from, &job->state.walls, job->sim->origin == NULL, doubt_wall,
                              job);
    clod_setup_belts_doubts(from, doubt_wall, job);
    clod_setup_flush_doubts(from, &job->state.walls, radius, doubt_wall, job);
    return true;
}

static bool run_stages(clod_job *job, const clod_setup_bed *bed, clod_status *status)
{
    if (!job->resumed && !doubt_walls(job, bed, status)) {
        return false;
    }
    if (!job->resumed) {
        free_data *data = job->procedure.data;
        clod_free_stages_begin(&data->at, job->sim->from, &job->state);
        const clod_free_start start = {.grains = (int64_t)bed->grains,
                                       .mass = clod_exact_value(&bed->mass_sum),
                                       .last_id = bed->last_id};
        clod_free_measures_begin_with(measures_of(data, job->sim->from), job->sim->from,
                                      &job->state, &start);
    }
    const clod_free_moment now =
        moment_of(job->procedure.data, job->sim->from, &job->state, NULL);
    job->state.exchange.residence_since = now.steady.since;
    return clod_job_run(job, status);
}

bool clod_free_try_origin(const clod_job_shared *sim, clod_status *status)
{
    return clod_origin_try(sim->origin, sim->from, sim->options, status);
}

bool clod_free_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    const size_t own = stages_size(sim->from), measures = clod_free_measures_size(sim->from);
    free_data *data = clod_memory_alloc(1, own + measures);
    clod_job job = {.sim = sim, .name = "run", .threads = sim->options->threads};
    clod_setup_bed bed = {0};
    bool ok = make_state(&job, &bed, status);
    const size_t count = FIRST_COUNT + clod_free_measures_columns(sim->from, &job.state);
    const char **columns = clod_memory_alloc(count, sizeof *columns);
    char(*text)[CLOD_FREE_COLUMN_TEXT] =
        ok && columns != NULL ? make_columns(sim->from, &job.state, columns) : NULL;
    if (ok && (text == NULL || data == NULL)) {
        ok = clod_status_fail(status, CLOD_FAILED, "no memory for %zu columns", count);
    }
    job.procedure = (clod_procedure){.data = data,
                                     .size = own,
                                     .measures_size = measures,
                                     .context = sim->from,
                                     .columns = columns,
                                     .column_count = count,
                                     .act = free_act,
                                     .plan = free_plan,
                                     .sight = free_sight,
                                     .news = free_news,
                                     .look = free_look,
                                     .measure = free_measure,
                                     .sample = free_sample,
                                     .picture = free_picture,
                                     .phase = free_phase,
                                     .fraction = free_fraction,
                                     .reason = free_reason};
    ok = ok && clod_job_resume(&job, status);
    if (ok && !job.dealt) {
        bed = clod_setup_bed_of(&job.state);
    }
    ok = ok && run_stages(&job, &bed, status) && write_summary(&job, status);
    if (ok) {
        *report = make_report(&job);
    }
    clod_memory_free(text);
    clod_memory_free(columns);
    clod_memory_free(data);
    clod_job_fini(&job);
    return ok;
}
