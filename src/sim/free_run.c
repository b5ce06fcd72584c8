#include "sim/free_run.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "measure/contacts.h"
#include "output/folder.h"
#include "setup/state.h"
#include "sim/free_stages.h"

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

static int64_t free_plan(const void *data, const void *context, const clod_state *state)
{
    return clod_free_stages_plan(data, context, state);
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
    const clod_free_stages *stages = data;
    const double first[FIRST_COUNT] = {state->time, (double)stages->stage,
                                       clod_measure_kinetic_energy(state),
                                       clod_measure_max_speed(state)};
    memcpy(row, first, sizeof first);
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_columns(&state->walls.wall[w], row + FIRST_COUNT + (size_t)w * PER_WALL_COUNT);
    }
    return clod_free_stages_next(data, context, state);
}

static const char *free_phase(const void *data, const void *context)
{
    return clod_free_stages_name(data, context);
}

static double free_fraction(const void *data, const void *context)
{
    return clod_free_stages_fraction(data, context);
}

/** Header texts: fixed ones, then NAME.force_x [N] and so on; one block of owned text. */
static char (*make_columns(const clod_state *state, const char **columns))[COLUMN_TEXT]
{
    const size_t walls = (size_t)state->walls.count;
    char(*text)[COLUMN_TEXT] = clod_memory_alloc(walls * PER_WALL_COUNT + 1, COLUMN_TEXT);
    for (size_t c = 0; text != NULL && c < FIRST_COUNT; c++) {
        columns[c] = FIRST[c];
    }
    for (size_t k = 0; text != NULL && k < walls * PER_WALL_COUNT; k++) {
        snprintf(text[k], COLUMN_TEXT, "%s.%s", state->walls.wall[k / PER_WALL_COUNT].name,
                 PER_WALL[k % PER_WALL_COUNT]);
        columns[FIRST_COUNT + k] = text[k];
    }
    return text;
}

static char *make_report(const clod_state *state)
{
    const size_t size = 512 + 160 * (size_t)state->walls.count;
    char *text = clod_memory_alloc(size, 1);
    if (text == NULL) {
        return NULL;
    }
    const clod_measure_contacts bed = clod_measure_contacts_of(state);
    int used = snprintf(text, size,
                        "time %.6g s, %lld steps, %zu grains, %zu contacts, coordination %.2f, "
                        "largest overlap %.3g %% of a radius\n",
                        state->time, (long long)state->step, state->grains.count, bed.pairs,
                        bed.coordination, 100.0 * bed.max_overlap);
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        used += snprintf(text + used, size - (size_t)used,
                         "  wall %-16s force (%.4g, %.4g, %.4g) N\n", wall->name, wall->force.x,
                         wall->force.y, wall->force.z);
    }
    return text;
}

static json_t *wall_json(const clod_wall *wall)
{
    return json_pack("{s:s, s:[fff], s:[fff], s:[fff], s:f}", "name", wall->name, "force_N",
                     wall->force.x, wall->force.y, wall->force.z, "torque_Nm", wall->torque.x,
                     wall->torque.y, wall->torque.z, "shift_m", wall->shift.x, wall->shift.y,
                     wall->shift.z, "angle_rad", wall->angle);
}

static bool write_summary(const clod_job *job, clod_status *status)
{
    char path[4096];
    const clod_state *state = &job->state;
    const clod_measure_contacts bed = clod_measure_contacts_of(state);
    json_t *walls = json_array();
    for (int32_t w = 0; w < state->walls.count; w++) {
        json_array_append_new(walls, wall_json(&state->walls.wall[w]));
    }
    const char *title = job->sim->from->title;
    json_t *root =
        json_pack("{s:s, s:s, s:f, s:f, s:I, s:I, s:I, s:f, s:f, s:f, s:f, s:o}", "title",
                  title != NULL ? title : "", "version", job->memory.version, "time_s",
                  state->time, "dt_s", state->dt, "steps", (json_int_t)state->step, "grains",
                  (json_int_t)state->grains.count, "contacts", (json_int_t)bed.pairs,
                  "coordination", bed.coordination, "max_overlap", bed.max_overlap,
                  "kinetic_energy_J", clod_measure_kinetic_energy(state), "wall_clock_s",
                  job->memory.wall_clock, "walls", walls);
    snprintf(path, sizeof path, "%s/summary.json", job->sim->directory);
    const bool ok = root != NULL
                        ? clod_folder_write_json(path, root, status)
                        : clod_status_fail(status, CLOD_FAILED, "no memory for %s", path);
    json_decref(root);
    return ok;
}

static bool run_stages(clod_job *job, clod_free_stages *stages, clod_status *status)
{
    if (!job->resumed) {
        clod_free_stages_begin(stages, job->sim->from, &job->state);
    }
    return clod_job_run(job, status);
}

bool clod_free_run(const clod_sim *sim, char **report, clod_status *status)
{
    clod_free_stages stages = {0};
    clod_job job = {.sim = sim, .name = "run", .threads = sim->options->threads};
    bool ok = clod_setup_state(sim->from, sim->from->seed, &job.state, status);
    const size_t count = FIRST_COUNT + PER_WALL_COUNT * (size_t)job.state.walls.count;
    const char **columns = clod_memory_alloc(count, sizeof *columns);
    char(*text)[COLUMN_TEXT] = ok && columns != NULL ? make_columns(&job.state, columns) : NULL;
    if (ok && text == NULL) {
        ok = clod_status_fail(status, CLOD_FAILED, "no memory for %zu columns", count);
    }
    job.procedure = (clod_procedure){&stages,   sizeof stages, sim->from,  columns,       count,
                                     free_plan, free_sample,   free_phase, free_fraction, NULL};
    ok = ok && clod_job_resume(&job, status) && run_stages(&job, &stages, status) &&
         write_summary(&job, status);
    if (ok) {
        *report = make_report(&job.state);
    }
    clod_memory_free(text);
    clod_memory_free(columns);
    clod_job_fini(&job);
    return ok;
}
