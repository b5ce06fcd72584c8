#include "sim/build_up.h"

#include <string.h>

#include "base/memory.h"
#include "parallel/exact.h"
#include "sim/resting.h"

/** One of what grains rest on: a wall, or a part of a mesh. */
typedef struct target {
    int32_t wall, first; ///< first shape of the mesh
    int32_t part;        ///< -1: all of the wall
} target;

/** What is remembered of one. */
typedef struct past {
    double now, most, most_time; ///< kg, kg, s
    double mass[CLOD_BUILD_UP_POINTS];
} past;

/** The past of all; `of` goes on over all targets that may be. */
typedef struct build_up {
    int64_t looks, points, every; ///< a point at every so many looks
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

static void build_up_begin(void *memory, const clod_case *from, const clod_state *state)
{
    (void)state;
    build_up *self = memory;
    if (from->build_up.present) {
        self->every = 1;
    }
}

// ---- what grains rest on

static bool begins_mesh(const clod_shape *shape)
{
    return shape->surface != NULL && shape->patch == 0 && shape->slot == 0;
}

/** All walls, then their meshes' parts that have names, where there are several. */
static size_t list_targets(target *to, const clod_case *from, const clod_state *state)
{
    size_t count = 0;
    const int32_t walls = state->walls.count < (int32_t)from->wall_count
                              ? state->walls.count
                              : (int32_t)from->wall_count;
    for (int32_t w = 0; w < walls; w++) {
        to[count++] = (target){w, 0, -1};
    }
    for (int32_t w = 0; w < walls; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_surface *surface = wall->shapes[s].surface;
            if (!begins_mesh(&wall->shapes[s]) || surface->part_count < 2) {
                continue;
            }
            for (size_t p = 0; p < surface->part_count && count < most_targets(from); p++) {
                if (surface->part_name[p][0] != '\0') {
                    to[count++] = (target){w, s, (int32_t)p};
                }
            }
        }
    }
    return count;
}

/** Whether a shape of a wall is of a target. */
static bool is_of(const target *self, const clod_state *state, const clod_resting *on)
{
    if (self->wall != on->wall || self->part < 0) {
        return self->wall == on->wall;
    }
    const clod_shape *shapes = state->walls.wall[on->wall].shapes;
    const clod_surface *surface = shapes[self->first].surface;
    const clod_shape *shape = &shapes[on->shape];
    return shape->surface == surface && on->shape >= self->first &&
           (int32_t)surface->patches[shape->patch].part == self->part;
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

/** Note the masses of a look. */
static void note(build_up *self, const clod_exact *mass, size_t targets, double time)
{
    self->looks++;
    if (self->points == CLOD_BUILD_UP_POINTS) {
        thin_out(self, targets);
    }
    const bool point = self->looks % self->every == 0;
    for (size_t t = 0; t < targets; t++) {
        past *of = &self->of[t];
        of->now = clod_exact_value(&mass[t]);
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

clod_build_up_line clod_build_up_rate(const double *time, const double *mass, int64_t count)
{
    clod_build_up_line line = {0};
    double t_mean = 0.0, m_mean = 0.0, above = 0.0, below = 0.0;
    int64_t first = 0;
    if (count < 3) {
        return line;
    }
    const double from = time[count - 1] - (time[count - 1] - time[0]) / 3.0;
    while (first < count - 3 && time[first] < from) {
        first++;
    }
    line.points = count - first;
    for (int64_t k = first; k < count; k++) {
        t_mean += time[k] / (double)line.points;
        m_mean += mass[k] / (double)line.points;
    }
    for (int64_t k = first; k < count; k++) {
        above += (time[k] - t_mean) * (mass[k] - m_mean);
        below += (time[k] - t_mean) * (time[k] - t_mean);
    }
    line.rate = above / below;
    return line;
}

// ---- the measure

/** Add the mass of each grain to what it rests on. */
static void weigh(clod_exact *mass, const target *targets, size_t count,
                  const clod_state *state, const clod_resting *on)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        for (size_t t = 0; on[g].wall >= 0 && t < count; t++) {
            if (is_of(&targets[t], state, &on[g])) {
                clod_exact_add(&mass[t], state->grains.velocity[g][3]);
            }
        }
    }
}

static bool build_up_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    if (!now->from->build_up.present) {
        return true;
    }
    const size_t most = most_targets(now->from);
    clod_resting *on = clod_memory_alloc(now->state->grains.count + 1, sizeof *on);
    target *targets = clod_memory_alloc(most, sizeof *targets);
    clod_exact *mass = clod_memory_alloc(most, sizeof *mass);
    bool good = on != NULL && targets != NULL && mass != NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for what rests of %zu grains",
                         now->state->grains.count);
    }
    good = good &&
           clod_resting_find(on, now->state, now->contacts, now->from->build_up.speed, status);
    if (good) {
        const size_t count = list_targets(targets, now->from, now->state);
        weigh(mass, targets, count, now->state, on);
        note(memory, mass, count, now->state->time);
    }
    clod_memory_free(on);
    clod_memory_free(targets);
    clod_memory_free(mass);
    return good;
}

/** The targets of a run, and how many; owned. */
static target *targets_of(const clod_case *from, const clod_state *state, size_t *count)
{
    target *targets =
        from->build_up.present ? clod_memory_alloc(most_targets(from), sizeof *targets) : NULL;
    *count = targets != NULL ? list_targets(targets, from, state) : 0;
    return targets;
}

static void name_target(const target *self, const clod_state *state, char *text, size_t size)
{
    const clod_wall *wall = &state->walls.wall[self->wall];
    if (self->part < 0) {
        snprintf(text, size, "%s", wall->name);
        return;
    }
    snprintf(text, size, "%s.%s", wall->name,
             wall->shapes[self->first].surface->part_name[self->part]);
    for (char *c = text; *c != '\0'; c++) { // a name of a mesh file may have anything in it
        if (strchr(" ,\"[]\t", *c) != NULL) {
            *c = '_';
        }
    }
}

static size_t build_up_columns(const clod_case *from, const clod_state *state)
{
    size_t count;
    clod_memory_free(targets_of(from, state, &count));
    return count;
}

static void build_up_column(const clod_case *from, const clod_state *state, size_t k,
                            char *text, size_t size)
{
    size_t count;
    char name[72] = "";
    target *targets = targets_of(from, state, &count);
    if (k < count) {
        name_target(&targets[k], state, name, sizeof name);
    }
    clod_memory_free(targets);
    snprintf(text, size, "%s.resting_mass [kg]", name);
}

static void build_up_row(void *memory, const clod_free_moment *now, double *row)
{
    const build_up *self = memory;
    const size_t count = build_up_columns(now->from, now->state);
    for (size_t t = 0; t < count; t++) {
        row[t] = self->of[t].now;
    }
}

static void build_up_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const build_up *self = memory;
    size_t count;
    target *targets = targets_of(now->from, now->state, &count);
    for (size_t t = 0; t < count; t++) {
        char name[72];
        const past *of = &self->of[t];
        name_target(&targets[t], now->state, name, sizeof name);
        const clod_build_up_line line = clod_build_up_rate(self->time, of->mass, self->points);
        fprintf(
            out,
            "  resting on %-11s %.4g kg, %+.3g kg/s over the last third; largest %.4g kg at "
            "%.4g s\n",
            name, of->now, line.rate, of->most, of->most_time);
    }
    clod_memory_free(targets);
}

static json_t *build_up_json(const void *memory, const clod_free_moment *now)
{
    const build_up *self = memory;
    size_t count;
    target *targets = targets_of(now->from, now->state, &count);
    if (!now->from->build_up.present) {
        return NULL;
    }
    json_t *all = json_object();
    for (size_t t = 0; t < count; t++) {
        char name[72];
        const past *of = &self->of[t];
        name_target(&targets[t], now->state, name, sizeof name);
        const clod_build_up_line line = clod_build_up_rate(self->time, of->mass, self->points);
        json_object_set_new(all, name,
                            json_pack("{s:f, s:f, s:f, s:f}", "mass_kg", of->now, "rate_kg_s",
                                      line.rate, "largest_kg", of->most, "largest_at_s",
                                      of->most_time));
    }
    clod_memory_free(targets);
    return all;
}

const clod_free_measure CLOD_MEASURE_BUILD_UP = {.key = "build_up",
                                                 .size = build_up_size,
                                                 .begin = build_up_begin,
                                                 .look = build_up_look,
                                                 .columns = build_up_columns,
                                                 .column = build_up_column,
                                                 .row = build_up_row,
                                                 .report = build_up_report,
                                                 .json = build_up_json};
