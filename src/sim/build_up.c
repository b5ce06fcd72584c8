#include "sim/build_up.h"

#include <math.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "measure/resting_mass.h"
#include "state/wear.h"

/** One of what grains rest on: a wall, or a part of a mesh. */
typedef struct target {
    clod_resting_target on;
    size_t past; ///< number of its past
} target;

/** What is remembered of one. */
typedef struct past {
    double now, most, most_time; ///< kg, kg, s
    double sum;                  ///< kg s, over the steady time
    double mass[CLOD_BUILD_UP_POINTS];
} past;

/** The past of all; `of` goes on over all targets that may be: the walls of the case, whether they are
 *  there or not, then parts. */
typedef struct build_up {
    double sampled, steady; ///< s, time of the last sample; of the steady time until then
    int64_t samples, points, every; ///< in the steady time; a point at every so many
    double time[CLOD_BUILD_UP_POINTS];
    past of[];
} build_up;

static size_t most_targets(const clod_case *from)
{
    return from->wall_count + CLOD_BUILD_UP_PARTS;
}

static size_t build_up_size(const clod_case *from)
{
    return from->build_up.present ? sizeof(build_up) + most_targets(from) * sizeof(past) : 0;
}

static void build_up_begin(void *memory, const clod_case *from, const clod_state *state,
                           const clod_free_start *bed)
{
    (void)bed;
    build_up *self = memory;
    if (from->build_up.present) {
        self->every = 1;
        self->sampled = state->time;
    }
}

// ---- what grains rest on

/** Look at one target; `number` counts them from 0. */
typedef void (*target_visit)(void *context, size_t number, const target *self,
                             const clod_state *state);

/** Number of a wall of the case among those of now, or -1: a program may have removed it. */
static int32_t number_of(const clod_case *from, const clod_state *state, size_t w)
{
    const char *name = from->walls[w].name;
    const bool there =
        w < (size_t)state->walls.count && strcmp(state->walls.wall[w].name, name) == 0;
    return there ? (int32_t)w : clod_walls_find(&state->walls, name);
}

/** Whether a wall of the case has a mesh, which has parts. */
static bool has_mesh(const clod_case_wall *wall)
{
    bool any = false;
    for (size_t s = 0; s < wall->shape_count; s++) {
        any |= clod_shape_kinds_row((clod_shape_kind)wall->shapes[s].kind)->faceted;
    }
    return any;
}

/** Meshes have their pasts one behind the other: none of them may go. */
static bool build_up_needs(const clod_case *from, const char *wall, char *text, size_t size)
{
    for (size_t w = 0; from->build_up.present && w < from->wall_count; w++) {
        if (strcmp(from->walls[w].name, wall) == 0 && has_mesh(&from->walls[w])) {
            snprintf(text, size, "build_up, of the parts of its mesh");
            return true;
        }
    }
    return false;
}

/** All walls of the case, then their meshes' parts that have names, where there are several: one
 *  order. How many there are. */
static size_t visit_targets(const clod_case *from, const clod_state *state, target_visit visit,
                            void *context)
{
    size_t count = 0, slot = from->wall_count;
    const size_t walls = from->build_up.present ? from->wall_count : 0;
    for (size_t w = 0; w < walls; w++) {
        const int32_t number = number_of(from, state, w);
        if (number >= 0) {
            visit(context, count++, &(target){{number, 0, -1}, w}, state);
        }
    }
    for (size_t w = 0; w < walls; w++) {
        const int32_t number = has_mesh(&from->walls[w]) ? number_of(from, state, w) : -1;
        const clod_wall *wall = number >= 0 ? &state->walls.wall[number] : NULL;
        for (int32_t s = 0; wall != NULL && s < wall->shape_count; s++) {
            const clod_surface *surface = wall->shapes[s].surface;
            if (!clod_shape_begins_mesh(&wall->shapes[s]) || surface->part_count < 2) {
                continue;
            }
            for (size_t p = 0; p < surface->part_count && slot < most_targets(from); p++) {
                if (surface->part_name[p][0] != '\0') {
                    visit(context, count++, &(target){{number, s, (int32_t)p}, slot++}, state);
                }
            }
        }
    }
    return count;
}

/** What is weighed. */
typedef struct weighing {
    clod_resting_question *asked;
    size_t *past;     ///< [asked->count]
    clod_exact *mass; ///< [asked->count] kg
} weighing;

static void note_target(void *context, size_t number, const target *self,
                        const clod_state *state)
{
    (void)state;
    weighing *list = context;
    list->asked->target[number] = self->on;
    list->past[number] = self->past;
    list->asked->count = number + 1;
}

// ---- the past

/** Room for one more point: every second one goes. */
static void thin_out(build_up *self, size_t targets)
{
    const int64_t half = CLOD_BUILD_UP_POINTS / 2;
    for (int64_t k = 0; k < half; k++) {
        self->time[k] = self->time[2 * k + 1];
        for (size_t t = 0; t < targets; t++) {
            self->of[t].mass[k] = self->of[t].mass[2 * k + 1];
        }
    }
    self->points = half;
    self->every *= 2;
}

/** Note the masses of a sample; `steady` is how much of the steady time has passed since the one
 *  before [s], 0 before it begins. */
static void note(build_up *self, const weighing *sample, size_t targets, double time,
                 double steady)
{
    const bool counts = steady > 0.0;
    self->samples += counts;
    self->steady += steady;
    if (self->points == CLOD_BUILD_UP_POINTS) {
        thin_out(self, targets);
    }
    const bool point = counts && self->samples % self->every == 0;
    for (size_t t = 0; t < targets; t++) {
        self->of[t].now = 0.0; // of a wall that is gone
    }
    for (size_t k = 0; k < sample->asked->count; k++) {
        self->of[sample->past[k]].now = clod_exact_value(&sample->mass[k]);
    }
    for (size_t t = 0; t < targets; t++) {
        past *of = &self->of[t];
        of->sum += steady * of->now;
        if (of->now > of->most) {
            of->most = of->now;
            of->most_time = time;
        }
        if (point) {
            of->mass[self->points] = of->now;
        }
    }
    if (point) {
        self->time[self->points++] = time;
    }
}

double clod_build_up_rate(const double *time, const double *mass, int64_t count)
{
    double t_mean = 0.0, m_mean = 0.0, above = 0.0, below = 0.0;
    if (count < 3) {
        return (double)NAN;
    }
    for (int64_t k = 0; k < count; k++) {
        t_mean += time[k] / (double)count;
        m_mean += mass[k] / (double)count;
    }
    for (int64_t k = 0; k < count; k++) {
        above += (time[k] - t_mean) * (mass[k] - m_mean);
        below += (time[k] - t_mean) * (time[k] - t_mean);
    }
    return above / below;
}

// ---- the measure

static bool build_up_sample(void *memory, const clod_free_moment *now, clod_status *status)
{
    build_up *self = memory;
    if (!now->from->build_up.present) {
        return true;
    }
    const size_t most = most_targets(now->from);
    weighing sample = {.asked = clod_memory_alloc(1, sizeof *sample.asked +
                                                         most * sizeof(clod_resting_target)),
                       .past = clod_memory_alloc(most, sizeof *sample.past),
                       .mass = clod_memory_alloc(most, sizeof *sample.mass)};
    bool good =
        (sample.asked != NULL && sample.past != NULL && sample.mass != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for what rests on %zu walls", most);
    if (good) {
        sample.asked->speed = now->from->build_up.speed;
        visit_targets(now->from, now->state, note_target, &sample);
        good = clod_resting_mass(sample.asked, now->survey, sample.mass, status);
    }
    if (good) {
        note(self, &sample, most, now->state->time,
             clod_steady_time_within(&now->steady, self->sampled, now->state->time));
        self->sampled = now->state->time;
    }
    clod_memory_free(sample.asked);
    clod_memory_free(sample.past);
    clod_memory_free(sample.mass);
    return good;
}

static void name_target(const target *self, const clod_state *state, char *text, size_t size)
{
    const clod_wall *wall = &state->walls.wall[self->on.wall];
    if (self->on.part < 0) {
        snprintf(text, size, "%s", wall->name);
        return;
    }
    const clod_shape *first = &wall->shapes[self->on.first];
    clod_wear_name(wall, first->face + self->on.part, text, size);
}

static void pass_by(void *context, size_t number, const target *self, const clod_state *state)
{
    (void)context;
    (void)number;
    (void)self;
    (void)state;
}

static size_t build_up_columns(const clod_case *from, const clod_state *state)
{
    return visit_targets(from, state, pass_by, NULL);
}

/** A header that is asked for. */
typedef struct header {
    size_t number;
    char *text;
    size_t size;
} header;

static void put_header(void *context, size_t number, const target *self,
                       const clod_state *state)
{
    const header *asked = context;
    char name[CLOD_WEAR_NAME];
    if (number == asked->number) {
        name_target(self, state, name, sizeof name);
        snprintf(asked->text, asked->size, "%s.resting_mass [kg]", name);
    }
}

static void build_up_column(const clod_case *from, const clod_state *state, size_t k,
                            char *text, size_t size)
{
    visit_targets(from, state, put_header, &(header){k, text, size});
}

/** Where the values of a row go. */
typedef struct row_pen {
    double *row;
    const build_up *self;
} row_pen;

static void put_value(void *context, size_t number, const target *of, const clod_state *state)
{
    (void)state;
    const row_pen *pen = context;
    pen->row[number] = pen->self->of[of->past].now;
}

static void build_up_row(void *memory, const clod_free_moment *now, double *row)
{
    visit_targets(now->from, now->state, put_value, &(row_pen){row, memory});
}

/** Where lines of the report go. */
typedef struct line_pen {
    FILE *out;
    const build_up *self;
} line_pen;

static void put_line(void *context, size_t number, const target *of, const clod_state *state)
{
    (void)number;
    const line_pen *pen = context;
    const past *mass = &pen->self->of[of->past];
    const double rate = clod_build_up_rate(pen->self->time, mass->mass, pen->self->points);
    char name[CLOD_WEAR_NAME];
    name_target(of, state, name, sizeof name);
    fprintf(pen->out, "  resting on %-11s %.4g kg at the end, largest %.4g kg at %.4g s", name,
            mass->now, mass->most, mass->most_time);
    if (pen->self->steady > 0.0) {
        fprintf(pen->out, "; mean %.4g kg", mass->sum / pen->self->steady);
    }
    if (!isnan(rate)) {
        fprintf(pen->out, ", grows by %+.3g kg/s", rate);
    }
    fputs("\n", pen->out);
}

static void build_up_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    visit_targets(now->from, now->state, put_line, &(line_pen){out, memory});
}

/** Where the objects of the summary go. */
typedef struct json_pen {
    json_t *all;
    const build_up *self;
    double since; ///< s
} json_pen;

static void put_object(void *context, size_t number, const target *of, const clod_state *state)
{
    (void)number;
    const json_pen *pen = context;
    const past *mass = &pen->self->of[of->past];
    const double rate = clod_build_up_rate(pen->self->time, mass->mass, pen->self->points);
    char name[CLOD_WEAR_NAME];
    name_target(of, state, name, sizeof name);
    json_object_set_new(pen->all, name,
                        json_pack("{s:f, s:f, s:o, s:o, s:f, s:f}", "since_s", pen->since,
                                  "mass_kg", mass->now, "mean_kg",
                                  clod_json_number(mass->sum / pen->self->steady),
                                  "rate_kg_per_s", clod_json_number(rate), "largest_kg",
                                  mass->most, "largest_at_s", mass->most_time));
}

static bool build_up_told(const clod_case *from)
{
    return from->build_up.present;
}

static void add_paths(void *context, size_t number, const target *of, const clod_state *state)
{
    (void)number;
    char name[CLOD_WEAR_NAME];
    name_target(of, state, name, sizeof name);
    clod_free_paths_add(context, name,
                        "since_s mass_kg mean_kg rate_kg_per_s largest_kg largest_at_s");
}

static void build_up_paths(const clod_case *from, const clod_state *state,
                           clod_free_paths *paths)
{
    visit_targets(from, state, add_paths, paths);
}

static json_t *build_up_json(const void *memory, const clod_free_moment *now)
{
    json_t *all = json_object();
    visit_targets(now->from, now->state, put_object,
                  &(json_pen){all, memory, now->steady.since});
    return all;
}

const clod_free_measure CLOD_MEASURE_BUILD_UP = {.key = "build_up",
                                                 .size = build_up_size,
                                                 .begin = build_up_begin,
                                                 .needs = build_up_needs,
                                                 .look = build_up_sample,
                                                 .columns = build_up_columns,
                                                 .column = build_up_column,
                                                 .row = build_up_row,
                                                 .report = build_up_report,
                                                 .told = build_up_told,
                                                 .paths = build_up_paths,
                                                 .json = build_up_json};
