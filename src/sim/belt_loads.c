#include "sim/belt_loads.h"

#include <math.h>
#include <string.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "sim/belt_work.h"
#include "sim/outputs.h"
#include "sim/steady_time.h"

/** Simulated time from one sample to the next [s]: blocks of the means begin at one. */
#define INTERVAL 1e-3

/** What one belt remembers; plain data. */
typedef struct belt_memory {
    clod_belt_work taken;
    double row_work, row_travel, row_time;
    double work[CLOD_STEADY_BLOCKS];   ///< J
    double travel[CLOD_STEADY_BLOCKS]; ///< m
    double time[CLOD_STEADY_BLOCKS];   ///< s
} belt_memory;

typedef struct belts {
    int64_t next; ///< step of the next sample
    belt_memory belt[];
} belts;

static bool is_still(const double v[3])
{
    return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

static bool surface_rests(const clod_case_surface *surface)
{
    return is_still(surface->velocity) && surface->speed == 0.0 && surface->spin == 0.0;
}

static bool shape_rests(const clod_case_shape *shape)
{
    bool rests = surface_rests(&shape->surface);
    for (size_t p = 0; p < shape->part_count; p++) {
        rests = rests && surface_rests(&shape->parts[p]);
    }
    return rests;
}

/** Whether a stage moves the wall. */
static bool is_moved(const clod_case *from, const char *name)
{
    for (size_t s = 0; s < from->stage_count; s++) {
        for (size_t c = 0; c < from->stages[s].wall_count; c++) {
            const clod_case_wall_change *change = &from->stages[s].walls[c];
            if (strcmp(change->name, name) == 0) {
                return true;
            }
        }
    }
    return false;
}

/** The one speed of a wall's belts; 0 when there is none. */
static double speed_of(const clod_case *from, const clod_case_wall *wall)
{
    double speed = 0.0;
    bool good = is_still(wall->velocity) && is_still(wall->surface_velocity) &&
                wall->spin == 0.0 && wall->load == CLOD_LOAD_NONE &&
                wall->oscillation.frequency == 0.0 && !is_moved(from, wall->name);
    for (size_t s = 0; s < wall->shape_count; s++) {
        const clod_case_shape *shape = &wall->shapes[s];
        if (shape->belt.run_count > 0) {
            good = good && (speed == 0.0 || speed == shape->belt.speed);
            speed = shape->belt.speed;
        } else {
            good = good && shape_rests(shape);
        }
    }
    return good ? speed : 0.0;
}

/** Wall of the belt with a number, from 0; its count when there are fewer. */
static size_t wall_of(const clod_case *from, size_t number)
{
    size_t w = 0;
    for (; w < from->wall_count; w++) {
        if (speed_of(from, &from->walls[w]) != 0.0 && number-- == 0) {
            break;
        }
    }
    return w;
}

static size_t count_of(const clod_case *from)
{
    size_t count = 0;
    while (wall_of(from, count) < from->wall_count) {
        count++;
    }
    return count;
}

/** Time for which a belt of this start-up would have run at full speed for its way so far. */
static double running_time(const clod_start_up *start_up, double time)
{
    const double since = fmax(0.0, time - start_up->at), ramp = start_up->duration;
    return since < ramp ? 0.5 * since * since / ramp : since - 0.5 * ramp;
}

static size_t belts_size(const clod_case *from)
{
    const size_t count = count_of(from);
    return count > 0 ? sizeof(belts) + count * sizeof(belt_memory) : 0;
}

static void belts_begin(void *memory, const clod_case *from, const clod_state *state,
                        const clod_free_start *bed)
{
    (void)bed;
    belts *self = memory;
    const size_t count = count_of(from);
    if (count == 0) {
        return;
    }
    self->next = state->step;
    for (size_t k = 0; k < count; k++) {
        self->belt[k].taken.since = state->time;
    }
}

static int64_t belts_plan(const void *memory, const clod_case *from, const clod_state *state,
                          const clod_steady_time *steady)
{
    (void)steady;
    const belts *self = memory;
    return count_of(from) > 0 && self->next > state->step ? self->next - state->step
                                                          : INT64_MAX;
}

/** Take what belt k has done since the last time. */
static void take(belts *self, const clod_free_moment *now, size_t k)
{
    const clod_case *from = now->from;
    const clod_state *state = now->state;
    const clod_case_wall *given = &from->walls[wall_of(from, k)];
    belt_memory *mine = &self->belt[k];
    const double since = mine->taken.since;
    const int block = clod_steady_time_block(&now->steady, since);
    const int32_t number = clod_walls_find(&state->walls, given->name);
    if (number < 0) { // a program has removed it before
        return;
    }
    const clod_wall *wall = &state->walls.wall[number];
    const double travel =
        fabs(speed_of(from, given)) *
        (running_time(&wall->start_up, state->time) - running_time(&wall->start_up, since));
    const clod_belt_portion portion = clod_belt_work_take(&mine->taken, wall, state);
    mine->row_work += portion.work;
    mine->row_travel += travel;
    mine->row_time += portion.time;
    if (block >= 0) {
        mine->work[block] += portion.work;
        mine->travel[block] += travel;
        mine->time[block] += portion.time;
    }
}

static bool belts_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)status;
    belts *self = memory;
    const size_t count = count_of(now->from);
    if (count == 0 || now->state->step != self->next) {
        return true;
    }
    self->next = clod_outputs_next(INTERVAL, now->state->dt, now->state->step);
    for (size_t k = 0; k < count; k++) {
        take(self, now, k);
    }
    return true;
}

static bool belts_need(const clod_case *from, const char *wall, char *text, size_t size)
{
    for (size_t k = 0; k < count_of(from); k++) {
        if (strcmp(from->walls[wall_of(from, k)].name, wall) == 0) {
            snprintf(text, size, "the column %s.pull", wall);
            return true;
        }
    }
    return false;
}

// ---- series, report, summary

static const char *const COLUMN[] = {"belt_speed [m/s]", "pull [N]"};
#define PER_BELT (sizeof COLUMN / sizeof *COLUMN)

static size_t belts_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return PER_BELT * count_of(from);
}

static void belts_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                         size_t size)
{
    (void)state;
    snprintf(text, size, "%s.%s", from->walls[wall_of(from, k / PER_BELT)].name,
             COLUMN[k % PER_BELT]);
}

static double over(double a, double b)
{
    return b > 0.0 ? a / b : (double)NAN;
}

/** What the belts have done up to now; the walls' sums begin anew after it. */
static void belts_sums_end(void *memory, const clod_free_moment *now)
{
    belts *self = memory;
    for (size_t k = 0; k < count_of(now->from); k++) {
        take(self, now, k);
        self->belt[k].taken.seen = 0.0;
    }
}

static void belts_row(void *memory, const clod_free_moment *now, double *row)
{
    belts *self = memory;
    belts_sums_end(memory, now);
    for (size_t k = 0; k < count_of(now->from); k++) {
        belt_memory *mine = &self->belt[k];
        row[PER_BELT * k] = over(mine->row_travel, mine->row_time);
        row[PER_BELT * k + 1] = over(mine->row_work, mine->row_travel);
        mine->row_work = mine->row_travel = mine->row_time = 0.0;
    }
}

/** Mean over the blocks, and their standard deviation, of one sum over another. */
static void spread(const double *a, const double *b, double found[2])
{
    double each[CLOD_STEADY_BLOCKS], sum_a = 0.0, sum_b = 0.0;
    for (int k = 0; k < CLOD_STEADY_BLOCKS; k++) {
        each[k] = over(a[k], b[k]);
        sum_a += a[k];
        sum_b += b[k];
    }
    found[0] = over(sum_a, sum_b);
    found[1] = clod_steady_time_deviation(each, CLOD_STEADY_BLOCKS);
}

static void belts_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const belts *self = memory;
    for (size_t k = 0; k < count_of(now->from); k++) {
        const belt_memory *mine = &self->belt[k];
        double power[2], pull[2];
        spread(mine->work, mine->time, power);
        spread(mine->work, mine->travel, pull);
        if (!isnan(power[0])) {
            char text[2][32];
            fprintf(
                out,
                "  belt %-16s power %.4g%s W, pull of the load %.4g%s N, +- standard deviation of ten blocks\n",
                now->from->walls[wall_of(now->from, k)].name, power[0],
                clod_prose_deviation(text[0], power[0], power[1]), pull[0],
                clod_prose_deviation(text[1], pull[0], pull[1]));
        }
    }
}

static bool belts_told(const clod_case *from)
{
    return count_of(from) > 0;
}

static void belts_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t b = 0; b < count_of(from); b++) {
        clod_free_paths_add(
            paths, from->walls[wall_of(from, b)].name,
            "speed_m_per_s power_W.mean power_W.deviation pull_N.mean pull_N.deviation");
    }
}

static json_t *belts_json(const void *memory, const clod_free_moment *now)
{
    const belts *self = memory;
    json_t *all = json_object();
    for (size_t k = 0; k < count_of(now->from); k++) {
        const belt_memory *mine = &self->belt[k];
        double power[2], pull[2], speed[2];
        spread(mine->work, mine->time, power);
        spread(mine->work, mine->travel, pull);
        spread(mine->travel, mine->time, speed);
        json_object_set_new(
            all, now->from->walls[wall_of(now->from, k)].name,
            json_pack("{s:o, s:{s:o, s:o}, s:{s:o, s:o}}", "speed_m_per_s",
                      clod_json_number(speed[0]), "power_W", "mean", clod_json_number(power[0]),
                      "deviation", clod_json_number(power[1]), "pull_N", "mean",
                      clod_json_number(pull[0]), "deviation", clod_json_number(pull[1])));
    }
    return all;
}

const clod_free_measure CLOD_MEASURE_BELT_LOADS = {.key = "belts",
                                                   .paths = belts_paths,
                                                   .size = belts_size,
                                                   .begin = belts_begin,
                                                   .act = belts_act,
                                                   .plan = belts_plan,
                                                   .needs = belts_need,
                                                   .columns = belts_columns,
                                                   .column = belts_column,
                                                   .row = belts_row,
                                                   .sums_end = belts_sums_end,
                                                   .report = belts_report,
                                                   .told = belts_told,
                                                   .json = belts_json};
