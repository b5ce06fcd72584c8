#include "sim/free_run.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "measure/contacts.h"
#include "output/folder.h"
#include "setup/state.h"

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

/** Where the run is; plain data. */
typedef struct free_memory {
    int64_t stage;
    int64_t stage_start; ///< step
    int64_t rows;        ///< of this stage
} free_memory;

static double series_interval(const clod_case *from)
{
    return from->output.series_interval;
}

static int64_t stage_steps(const clod_case *from, int64_t stage, double dt)
{
    return (int64_t)fmax(1.0, round(from->stages[stage].duration / dt));
}

static void change_wall(const clod_case_wall_change *change, clod_wall *wall)
{
    if (change->has_velocity) {
        wall->velocity =
            (clod_vec3){change->velocity[0], change->velocity[1], change->velocity[2]};
    }
    if (change->has_surface_velocity) {
        const double *v = change->surface_velocity;
        wall->surface_velocity = (clod_vec3){v[0], v[1], v[2]};
    }
    if (change->has_spin) {
        wall->spin = change->spin;
    }
    if (change->has_force) {
        wall->load = CLOD_LOAD_FORCE;
        wall->load_force = change->force;
    }
    if (change->has_stress) {
        wall->load = CLOD_LOAD_STRESS;
        wall->load_force = change->stress * wall->area;
    }
}

static void begin_stage(const clod_case *from, int64_t stage, clod_state *state)
{
    const clod_case_stage *s = &from->stages[stage];
    state->adhesion = s->adhesion;
    for (size_t c = 0; c < s->wall_count; c++) {
        for (int32_t w = 0; w < state->walls.count; w++) {
            if (strcmp(state->walls.wall[w].name, s->walls[c].name) == 0) {
                change_wall(&s->walls[c], &state->walls.wall[w]);
            }
        }
    }
    clod_walls_reset_sums(&state->walls);
}

static int64_t free_plan(const void *data, const void *context, const clod_state *state)
{
    const free_memory *m = data;
    const clod_case *from = context;
    const int64_t end = stage_steps(from, m->stage, state->dt);
    const double next = (double)(m->rows + 1) * series_interval(from) / state->dt;
    const int64_t at = (int64_t)fmin(fmax(round(next), (double)m->rows + 1.0), (double)end);
    const int64_t done = state->step - m->stage_start;
    return at > done ? at - done : 1;
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
    free_memory *m = data;
    const clod_case *from = context;
    const double speed = clod_measure_max_speed(state);
    const double first[FIRST_COUNT] = {state->time, (double)m->stage,
                                       clod_measure_kinetic_energy(state), speed};
    memcpy(row, first, sizeof first);
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_columns(&state->walls.wall[w], row + FIRST_COUNT + (size_t)w * PER_WALL_COUNT);
    }
    clod_walls_reset_sums(&state->walls);
    m->rows++;
    const int64_t done = state->step - m->stage_start;
    const bool rested = speed < from->stages[m->stage].rest;
    if (done < stage_steps(from, m->stage, state->dt) && !rested) {
        return false;
    }
    if (m->stage + 1 == (int64_t)from->stage_count) {
        return true;
    }
    *m = (free_memory){.stage = m->stage + 1, .stage_start = state->step};
    begin_stage(from, m->stage, state);
    return false;
}

static const char *free_phase(const void *data, const void *context)
{
    const free_memory *m = data;
    const clod_case *from = context;
    return from->stages[m->stage].name;
}

static double free_fraction(const void *data, const void *context)
{
    const free_memory *m = data;
    const clod_case *from = context;
    double before = 0.0;
    double all = 0.0;
    for (size_t s = 0; s < from->stage_count; s++) {
        before += (int64_t)s < m->stage ? from->stages[s].duration : 0.0;
        all += from->stages[s].duration;
    }
    before += fmin((double)m->rows * series_interval(from), from->stages[m->stage].duration);
    return all > 0.0 ? before / all : 0.0;
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

static bool run_stages(clod_job *job, free_memory *memory, clod_status *status)
{
    if (!job->resumed) {
        *memory = (free_memory){0};
        begin_stage(job->sim->from, 0, &job->state);
    }
    return clod_job_run(job, status);
}

bool clod_free_run(const clod_sim *sim, char **report, clod_status *status)
{
    free_memory memory = {0};
    clod_job job = {.sim = sim, .name = "run", .threads = sim->options->threads};
    bool ok = clod_setup_state(sim->from, sim->from->seed, &job.state, status);
    const size_t count = FIRST_COUNT + PER_WALL_COUNT * (size_t)job.state.walls.count;
    const char **columns = clod_memory_alloc(count, sizeof *columns);
    char(*text)[COLUMN_TEXT] = ok && columns != NULL ? make_columns(&job.state, columns) : NULL;
    if (ok && text == NULL) {
        ok = clod_status_fail(status, CLOD_FAILED, "no memory for %zu columns", count);
    }
    job.procedure = (clod_procedure){&memory,   sizeof memory, sim->from,  columns,       count,
                                     free_plan, free_sample,   free_phase, free_fraction, NULL};
    ok = ok && clod_job_resume(&job, status) && run_stages(&job, &memory, status) &&
         write_summary(&job, status);
    if (ok) {
        *report = make_report(&job.state);
    }
    clod_memory_free(text);
    clod_memory_free(columns);
    clod_job_fini(&job);
    return ok;
}
