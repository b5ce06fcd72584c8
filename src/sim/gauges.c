#include "sim/gauges.h"

#include <math.h>
#include <string.h>

#include "measure/gauge_pass.h"
#include "setup/domain.h"
#include "sim/gauges_plane.h"
#include "sim/outputs.h"

clod_gauge clod_gauges_make(const clod_case *from, const clod_case_gauge *gauge)
{
    const clod_outlet region = clod_setup_domain_region(&gauge->region);
    return clod_gauge_of(&region, gauge->direction, gauge->across, from->gravity);
}

bool clod_gauges_has(const clod_case *from, const clod_case_gauge *gauge, int value)
{
    const clod_gauge made = clod_gauges_make(from, gauge);
    switch (CLOD_GAUGE_VALUE[value].need) {
    case CLOD_GAUGE_DIRECTION:
        return clod_vec3_length(made.direction) > 0.0;
    case CLOD_GAUGE_ACROSS:
        return clod_vec3_length(made.across) > 0.0;
    case CLOD_GAUGE_ALARM:
        return gauge->has_blocked;
    case CLOD_GAUGE_BELT:
        return gauge->belt != NULL;
    default:
        return true;
    }
}

static size_t gauges_size(const clod_case *from)
{
    return from->gauge_count > 0
               ? sizeof(clod_gauges) + from->gauge_count * sizeof(clod_gauge_memory)
               : 0;
}

static void gauges_begin(void *memory, const clod_case *from, const clod_state *state,
                         const clod_free_start *bed)
{
    (void)bed;
    clod_gauges *self = memory;
    if (from->gauge_count == 0) {
        return;
    }
    self->next = state->step;
    for (size_t k = 0; k < from->gauge_count; k++) {
        self->gauge[k].work.since = state->time;
        self->gauge[k].alarm = (clod_gauge_alarm){.slow_since = -1, .first = -1};
    }
    clod_gauges_plane_begin(self, from, state);
}

static int64_t gauges_plan(const void *memory, const clod_case *from, const clod_state *state,
                           const clod_steady_time *steady)
{
    const clod_gauges *self = memory;
    if (from->gauge_count == 0) {
        return INT64_MAX;
    }
    const int64_t edge = clod_gauges_plane_plan(self, from, state, steady);
    const int64_t sample = self->next > state->step ? self->next - state->step : INT64_MAX;
    return edge < sample ? edge : sample;
}

// ---- one sample

static void add_sums(double *to, const double *sums)
{
    for (int k = 0; k < CLOD_GAUGE_SUMS; k++) {
        to[k] += sums[k];
    }
}

/** Speed that the first belt of a wall has now [m/s]; it rises during a start-up. */
static double speed_now(const clod_case *from, const clod_wall *wall)
{
    for (size_t w = 0; w < from->wall_count; w++) {
        const clod_case_wall *asked = &from->walls[w];
        for (size_t s = 0; strcmp(asked->name, wall->name) == 0 && s < asked->shape_count;
             s++) {
            if (asked->shapes[s].belt.run_count > 0) {
                return asked->shapes[s].belt.speed * (1.0 - wall->belt_lag);
            }
        }
    }
    return 0.0; // checked at load: it has a belt
}

/** Note how fast the belt runs below what is inside. */
static void take_speed(const clod_case *from, const clod_case_gauge *gauge,
                       const clod_state *state, double *sums)
{
    const int32_t w = gauge->belt != NULL ? clod_walls_find(&state->walls, gauge->belt) : -1;
    if (w >= 0) {
        sums[CLOD_GAUGE_BELT_SPEED] =
            sums[CLOD_GAUGE_MASS] * speed_now(from, &state->walls.wall[w]);
    }
}

/** What the belt has done since this was asked last. */
static void take_work(clod_gauge_memory *self, const clod_case_gauge *gauge,
                      const clod_state *state, double *sums)
{
    const int32_t w = gauge->belt != NULL ? clod_walls_find(&state->walls, gauge->belt) : -1;
    if (w >= 0) { // a program may have removed it before
        const clod_belt_portion portion =
            clod_belt_work_take(&self->work, &state->walls.wall[w], state);
        sums[CLOD_GAUGE_WORK] = portion.work;
        sums[CLOD_GAUGE_TIME] = portion.time;
    }
}

/** All gauges in one pass over the grains; bins count only in the steady time. */
static bool sample(clod_gauges *self, const clod_free_moment *now, bool steady,
                   double (*sums)[CLOD_GAUGE_SUMS], clod_status *status)
{
    const clod_case *from = now->from;
    clod_gauge_part parts[CLOD_CASE_GAUGES];
    for (size_t k = 0; k < from->gauge_count; k++) {
        const clod_case_gauge *asked = &from->gauges[k];
        const clod_gauge gauge = clod_gauges_make(from, asked);
        clod_gauge_memory *mine = &self->gauge[k];
        parts[k] = (clod_gauge_part){
            .gauge = gauge,
            .sums = sums[k],
            .profile = steady && asked->profile_bins > 0 ? &mine->profile : NULL,
            .trajectory = steady && asked->trajectory_bins > 0 ? &mine->trajectory : NULL,
            .across = clod_gauge_axis_of(&gauge, gauge.across, asked->profile_bins),
            .along = clod_gauge_axis_of(&gauge, gauge.direction, asked->trajectory_bins)};
    }
    return clod_gauge_pass(parts, from->gauge_count, now->survey, status);
}

static bool gauges_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_gauges *self = memory;
    const clod_case *from = now->from;
    const clod_state *state = now->state;
    if (from->gauge_count == 0) {
        return true;
    }
    clod_gauges_plane_note(self, now);
    if (state->step != self->next) {
        return true;
    }
    self->next = clod_outputs_next(CLOD_GAUGES_INTERVAL, state->dt, state->step);
    const int block = clod_steady_time_block(&now->steady, state->time);
    double sums[CLOD_CASE_GAUGES][CLOD_GAUGE_SUMS];
    if (!sample(self, now, block >= 0, sums, status)) {
        return false;
    }
    for (size_t k = 0; k < from->gauge_count; k++) {
        clod_gauge_memory *mine = &self->gauge[k];
        sums[k][CLOD_GAUGE_BLOCKED] =
            clod_gauges_watch(&mine->alarm, &from->gauges[k], sums[k], state);
        take_work(mine, &from->gauges[k], state, sums[k]);
        take_speed(from, &from->gauges[k], state, sums[k]);
        add_sums(mine->row, sums[k]);
        if (block >= 0) {
            add_sums(mine->block[block], sums[k]);
        }
    }
    return true;
}

/** Rows with no sample since the last one have that of their own moment. */
static bool gauges_sample(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_gauges *self = memory;
    const clod_case *from = now->from;
    double sums[CLOD_CASE_GAUGES][CLOD_GAUGE_SUMS];
    if (from->gauge_count == 0) {
        return true;
    }
    clod_gauges_plane_note(self, now); // the end of the run is seen here: after it nothing acts
    if (self->gauge[0].row[CLOD_GAUGE_SAMPLES] > 0.0) {
        return true; // all are sampled together
    }
    if (!sample(self, now, false, sums, status)) {
        return false;
    }
    for (size_t k = 0; k < from->gauge_count; k++) {
        clod_gauge_memory *mine = &self->gauge[k];
        sums[k][CLOD_GAUGE_BLOCKED] = (double)mine->alarm.on;
        add_sums(mine->row, sums[k]);
    }
    return true;
}

/** The belt of a gauge. */
static bool gauges_need(const clod_case *from, const char *wall, char *text, size_t size)
{
    for (size_t k = 0; k < from->gauge_count; k++) {
        const char *belt = from->gauges[k].belt;
        if (belt != NULL && strcmp(belt, wall) == 0) {
            snprintf(text, size, "gauges.%s.belt", from->gauges[k].name);
            return true;
        }
    }
    return false;
}

// ---- the series

/** Number of columns of one gauge. */
static size_t columns_of(const clod_case *from, const clod_case_gauge *gauge)
{
    size_t count = 0;
    for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
        count += clod_gauges_has(from, gauge, v);
    }
    return count + (gauge->has_plane ? CLOD_GAUGES_PLANE_COLUMNS : 0);
}

static size_t gauges_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    size_t count = 0;
    for (size_t k = 0; k < from->gauge_count; k++) {
        count += columns_of(from, &from->gauges[k]);
    }
    return count;
}

static void gauges_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    (void)state;
    const clod_case_gauge *gauge = from->gauges;
    for (size_t columns; k >= (columns = columns_of(from, gauge)); gauge++) {
        k -= columns;
    }
    const size_t planes = gauge->has_plane ? CLOD_GAUGES_PLANE_COLUMNS : 0;
    const size_t first = columns_of(from, gauge) - planes; // of the plane
    if (k >= first) {
        snprintf(text, size, "gauge_%s.%s", gauge->name, clod_gauges_plane_column(k - first));
        return;
    }
    int value = 0;
    for (; !clod_gauges_has(from, gauge, value) || k > 0; value++) {
        k -= clod_gauges_has(from, gauge, value);
    }
    snprintf(text, size, "gauge_%s.%s [%s]", gauge->name, CLOD_GAUGE_VALUE[value].name,
             CLOD_GAUGE_VALUE[value].unit);
}

/** The work up to now counts in this row; after it the walls' sums begin anew. */
static void take_rest(clod_gauge_memory *self, const clod_case_gauge *gauge,
                      const clod_state *state, int block)
{
    double sums[CLOD_GAUGE_SUMS] = {0};
    take_work(self, gauge, state, sums);
    self->work.seen = 0.0;
    add_sums(self->row, sums);
    if (block >= 0) {
        add_sums(self->block[block], sums);
    }
}

static void gauges_sums_end(void *memory, const clod_free_moment *now)
{
    clod_gauges *self = memory;
    const int block = clod_steady_time_block(&now->steady, now->state->time);
    for (size_t k = 0; k < now->from->gauge_count; k++) {
        take_rest(&self->gauge[k], &now->from->gauges[k], now->state, block);
    }
}

static void gauges_row(void *memory, const clod_free_moment *now, double *row)
{
    clod_gauges *self = memory;
    const clod_case *from = now->from;
    gauges_sums_end(memory, now);
    for (size_t k = 0; k < from->gauge_count; k++) {
        clod_gauge_memory *mine = &self->gauge[k];
        const clod_gauge gauge = clod_gauges_make(from, &from->gauges[k]);
        double values[CLOD_GAUGE_VALUES];
        clod_gauge_values(&gauge, mine->row, values);
        memset(mine->row, 0, sizeof mine->row);
        for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
            if (clod_gauges_has(from, &from->gauges[k], v)) {
                *row++ = values[v];
            }
        }
        if (from->gauges[k].has_plane) {
            clod_gauges_plane_row(self, now, k, row);
            row += CLOD_GAUGES_PLANE_COLUMNS;
        }
    }
}

static bool gauges_told(const clod_case *from)
{
    return from->gauge_count > 0;
}

const clod_free_measure CLOD_MEASURE_GAUGES = {.key = "gauges",
                                               .size = gauges_size,
                                               .begin = gauges_begin,
                                               .act = gauges_act,
                                               .plan = gauges_plan,
                                               .needs = gauges_need,
                                               .news = clod_gauges_news,
                                               .look = gauges_sample,
                                               .columns = gauges_columns,
                                               .column = gauges_column,
                                               .row = gauges_row,
                                               .sums_end = gauges_sums_end,
                                               .report = clod_gauges_report,
                                               .warn = clod_gauges_warn,
                                               .told = gauges_told,
                                               .paths = clod_gauges_paths,
                                               .json = clod_gauges_json,
                                               .write = clod_gauges_write};
