#include "sim/free_run.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "base/text.h"
#include "measure/contacts.h"
#include "output/checkpoint.h"
#include "output/folder_files.h"
#include "setup/grains.h"
#include "setup/state.h"
#include "setup/walls.h"
#include "sim/free_stages.h"
#include "sim/inlets.h"
#include "sim/job_store.h"
#include "sim/leavers.h"
#include "sim/origin.h"
#include "sim/residence.h"

/** Columns before those of the walls, and of each wall. */
static const char *const FIRST[] = {"time [s]", "stage [1]", "kinetic_energy [J]",
                                    "max_speed [m/s]"};
static const char *const PER_WALL[] = {"force_x [N]",    "force_y [N]",    "force_z [N]",
                                       "torque_x [N m]", "torque_y [N m]", "torque_z [N m]",
                                       "power [W]",      "shift_x [m]",    "shift_y [m]",
                                       "shift_z [m]",    "angle [rad]"};
#define FIRST_COUNT (sizeof FIRST / sizeof *FIRST)
#define PER_WALL_COUNT (sizeof PER_WALL / sizeof *PER_WALL)
#define COLUMN_TEXT 80

/** Data of the procedure: where it is, and how each stage that is over ended. */
typedef struct free_data {
    clod_free_stages at;
    clod_inlets inlets;
    clod_free_stage_end ended[]; ///< [stage_count]; step 0: not yet
} free_data;

static int64_t free_plan(const void *data, const void *context, const clod_state *state)
{
    const free_data *self = data;
    const int64_t stage = clod_free_stages_plan(&self->at, context, state);
    const int64_t inlet = clod_inlets_plan(&self->inlets, context, state);
    return stage < inlet ? stage : inlet;
}

static bool free_act(void *data, const void *context, clod_state *state, clod_status *status)
{
    free_data *self = data;
    return clod_inlets_act(&self->inlets, context, state, status);
}

static bool free_look(void *data, const void *context, const clod_state *state)
{
    free_data *self = data;
    return clod_free_stages_look(&self->at, context, state);
}

static void wall_columns(const clod_wall *wall, double *row)
{
    const double steps = (double)(wall->sum_steps > 0 ? wall->sum_steps : 1);
    const clod_vec3 f = clod_vec3_scale(wall->sum_force, 1.0 / steps);
    const clod_vec3 t = clod_vec3_scale(wall->sum_torque, 1.0 / steps);
    const double values[PER_WALL_COUNT] = {f.x,
                                           f.y,
                                           f.z,
                                           t.x,
                                           t.y,
                                           t.z,
                                           wall->sum_power / steps,
                                           wall->shift.x,
                                           wall->shift.y,
                                           wall->shift.z,
                                           wall->angle};
    memcpy(row, values, sizeof values);
}

static bool free_sample(void *data, const void *context, clod_state *state, double *row)
{
    free_data *self = data;
    const char *names[CLOD_LEAVERS_COLUMNS];
    const size_t leavers = clod_leavers_columns(context, names);
    const double first[FIRST_COUNT] = {state->time, (double)self->at.stage,
                                       clod_measure_kinetic_energy(state),
                                       clod_measure_max_speed(state)};
    memcpy(row, first, sizeof first);
    clod_leavers_row(context, state, row + FIRST_COUNT);
    double *next = row + FIRST_COUNT + leavers;
    next += clod_inlets_row(&self->inlets, context, next);
    next += clod_leavers_outlets_row(context, state, next);
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_columns(&state->walls.wall[w], next + (size_t)w * PER_WALL_COUNT);
    }
    if (self->at.end != CLOD_FREE_GOES_ON) {
        self->ended[self->at.stage] =
            (clod_free_stage_end){.step = state->step, .reason = self->at.end};
    }
    return clod_free_stages_next(&self->at, context, state);
}

static void trial_begin(const clod_case *from, const clod_part *part, clod_state *state)
{
    free_data *self = part->test;
    clod_free_stages_begin(&self->at, from, state);
    clod_inlets_begin(&self->inlets, from, state);
}

static bool trial_sample(void *data, const void *context, clod_state *state, double *row)
{
    (void)row;
    free_data *self = data;
    return clod_free_stages_next(&self->at, context, state);
}

const clod_parts_tester CLOD_FREE_TRIAL = {.procedure = {.size = sizeof(free_data),
                                                         .act = free_act,
                                                         .plan = free_plan,
                                                         .look = free_look,
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

/** Columns of a series that do not belong to a wall. */
static size_t columns_before_walls(const clod_case *from)
{
    const char *names[CLOD_LEAVERS_COLUMNS];
    return FIRST_COUNT + clod_leavers_columns(from, names) +
           CLOD_INLETS_COLUMNS * clod_setup_grains_coming(from) +
           CLOD_OUTLET_COLUMNS * from->outlet_count;
}

/** Header texts: fixed ones, then NAME.force_x [N] and so on; one block of owned text. */
static char (*make_columns(const clod_case *from, const clod_state *state,
                           const char **columns))[COLUMN_TEXT]
{
    const size_t inlets = CLOD_INLETS_COLUMNS * clod_setup_grains_coming(from);
    const size_t outlets = CLOD_OUTLET_COLUMNS * from->outlet_count;
    const size_t before = inlets + outlets;
    const size_t made = before + PER_WALL_COUNT * (size_t)state->walls.count;
    const size_t first = columns_before_walls(from) - before;
    char(*text)[COLUMN_TEXT] = clod_memory_alloc(made + 1, COLUMN_TEXT);
    if (text == NULL) {
        return NULL;
    }
    memcpy(columns, FIRST, sizeof FIRST);
    clod_leavers_columns(from, columns + FIRST_COUNT);
    for (size_t k = 0; k < inlets; k++) {
        clod_inlets_column(from, k / CLOD_INLETS_COLUMNS, (int)(k % CLOD_INLETS_COLUMNS),
                           text[k], COLUMN_TEXT);
    }
    for (size_t k = 0; k < outlets; k++) {
        clod_leavers_outlet_column(from, k / CLOD_OUTLET_COLUMNS,
                                   (int)(k % CLOD_OUTLET_COLUMNS), text[inlets + k],
                                   COLUMN_TEXT);
    }
    for (size_t k = 0; before + k < made; k++) {
        snprintf(text[before + k], COLUMN_TEXT, "%s.%s",
                 state->walls.wall[k / PER_WALL_COUNT].name, PER_WALL[k % PER_WALL_COUNT]);
    }
    for (size_t k = 0; k < made; k++) {
        columns[first + k] = text[k];
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

/** Owned text; NULL without memory. */
static char *make_report(const clod_job *job)
{
    const clod_state *state = &job->state;
    const clod_measure_contacts bed = clod_job_bed(job);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out,
            "time %.6g s, %lld step%s, %zu grain%s, %zu contact%s, coordination %.2f, largest "
            "overlap %.3g %% of a radius\n",
            state->time, (long long)state->step, clod_plural((double)state->step),
            state->grains.count, clod_plural((double)state->grains.count), bed.pairs,
            clod_plural((double)bed.pairs), bed.coordination, 100.0 * bed.max_overlap);
    report_stages(out, job);
    const free_data *data = job->procedure.data;
    clod_inlets_report(out, &data->inlets, job->sim->from, state->dt);
    clod_leavers_report(out, job->sim->from, state);
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        fprintf(out, "  wall %-16s force (%.4g, %.4g, %.4g) N\n", wall->name, wall->force.x,
                wall->force.y, wall->force.z);
    }
    return clod_text_close(&text);
}

static json_t *wall_json(const clod_wall *wall)
{
    return json_pack("{s:s, s:[fff], s:[fff], s:[fff], s:f}", "name", wall->name, "force_N",
                     wall->force.x, wall->force.y, wall->force.z, "torque_Nm", wall->torque.x,
                     wall->torque.y, wall->torque.z, "shift_m", wall->shift.x, wall->shift.y,
                     wall->shift.z, "angle_rad", wall->angle);
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

static bool write_summary(const clod_job *job, clod_status *status)
{
    const clod_state *state = &job->state;
    const clod_measure_contacts bed = clod_job_bed(job);
    json_t *walls = json_array();
    for (int32_t w = 0; w < state->walls.count; w++) {
        json_array_append_new(walls, wall_json(&state->walls.wall[w]));
    }
    const char *title = job->sim->from->title;
    json_t *root =
        json_pack("{s:s, s:s, s:f, s:f, s:I, s:I, s:I, s:f, s:f, s:f, s:f, s:o, s:o}", "title",
                  title != NULL ? title : "", "version", job->memory.version, "time_s",
                  state->time, "dt_s", state->dt, "steps", (json_int_t)state->step, "grains",
                  (json_int_t)state->grains.count, "contacts", (json_int_t)bed.pairs,
                  "coordination", bed.coordination, "max_overlap", bed.max_overlap,
                  "kinetic_energy_J", clod_measure_kinetic_energy(state), "wall_clock_s",
                  job->memory.wall_clock, "stages", stages_json(job), "walls", walls);
    const clod_job_shared *sim = job->sim;
    if (job->memory.origin[0] != '\0') {
        json_object_set_new(root, "from", json_string(job->memory.origin));
    }
    json_t *outlets = clod_leavers_outlets_json(sim->from, state);
    if (outlets != NULL) {
        json_object_set_new(root, "outlets", outlets);
    }
    json_t *residence = clod_residence_json(&state->exchange);
    if (residence != NULL) {
        json_object_set_new(root, "residence", residence);
    }
    json_t *left = clod_leavers_json(sim->from, state);
    if (left != NULL) {
        json_object_set_new(root, "left", left);
    }
    const free_data *data = job->procedure.data;
    json_t *inlets = clod_inlets_json(&data->inlets, sim->from, state->dt);
    if (inlets != NULL) {
        json_object_set_new(root, "inlets", inlets);
    }
    const bool ok = root != NULL
                        ? clod_folder_write_json(sim->folder, "summary.json", root, status)
                        : clod_status_fail(status, CLOD_FAILED, "no memory for %s/summary.json",
                                           sim->directory);
    json_decref(root);
    return ok;
}

/** The state to begin with; only its walls when everything else is in a checkpoint. */
static bool make_state(clod_job *job, clod_status *status)
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
        if (!clod_setup_state(sim->from, sim->from->seed, &job->state, status)) {
            return false;
        }
        char text[512];
        if (clod_setup_grains_say_off(sim->from, &job->state.grains, text, sizeof text)) {
            clod_job_tell(job, text);
        }
        return true;
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

static bool run_stages(clod_job *job, clod_status *status)
{
    if (!job->resumed) {
        free_data *data = job->procedure.data;
        clod_free_stages_begin(&data->at, job->sim->from, &job->state);
        clod_inlets_begin(&data->inlets, job->sim->from, &job->state);
    }
    return clod_job_run(job, status);
}

bool clod_free_try_origin(const clod_job_shared *sim, clod_status *status)
{
    return clod_origin_try(sim->origin, sim->from, sim->options, status);
}

bool clod_free_run(const clod_job_shared *sim, char **report, clod_status *status)
{
    const size_t stages = sim->from->stage_count;
    const size_t data_size = sizeof(free_data) + stages * sizeof(clod_free_stage_end);
    free_data *data = clod_memory_alloc(1, data_size);
    clod_job job = {.sim = sim, .name = "run", .threads = sim->options->threads};
    bool ok = make_state(&job, status);
    const size_t count =
        columns_before_walls(sim->from) + PER_WALL_COUNT * (size_t)job.state.walls.count;
    const char **columns = clod_memory_alloc(count, sizeof *columns);
    char(*text)[COLUMN_TEXT] =
        ok && columns != NULL ? make_columns(sim->from, &job.state, columns) : NULL;
    if (ok && (text == NULL || data == NULL)) {
        ok = clod_status_fail(status, CLOD_FAILED, "no memory for %zu columns", count);
    }
    job.procedure = (clod_procedure){.data = data,
                                     .size = data_size,
                                     .context = sim->from,
                                     .columns = columns,
                                     .column_count = count,
                                     .act = free_act,
                                     .plan = free_plan,
                                     .look = free_look,
                                     .sample = free_sample,
                                     .phase = free_phase,
                                     .fraction = free_fraction,
                                     .reason = free_reason};
    ok = ok && clod_job_resume(&job, status) && run_stages(&job, status) &&
         write_summary(&job, status);
    if (ok) {
        *report = make_report(&job);
    }
    clod_memory_free(text);
    clod_memory_free(columns);
    clod_memory_free(data);
    clod_job_fini(&job);
    return ok;
}
