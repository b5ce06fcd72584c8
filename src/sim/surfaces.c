#include "sim/surfaces.h"

#include <math.h>
#include <string.h>

#include "sim/surface_impacts.h"
#include "state/wear.h"

/** Columns of each surface: means over the time since the last row; behind them its impacts. */
static const char *const PER_FACE[] = {"force_x [N]",     "force_y [N]",     "force_z [N]",
                                       "press [N]",       "shear_power [W]", "impacts [1/s]",
                                       "impact_power [W]"};
static const int SUM_OF[] = {CLOD_WEAR_IMPULSE, CLOD_WEAR_IMPULSE + 1, CLOD_WEAR_IMPULSE + 2,
                             CLOD_WEAR_PRESS,   CLOD_WEAR_SHEAR,       CLOD_WEAR_IMPACTS,
                             CLOD_WEAR_ENERGY};
#define MEANS (sizeof PER_FACE / sizeof *PER_FACE)
#define PER_FACE_COUNT (MEANS + CLOD_SURFACE_IMPACTS_COLUMNS)

// ---- totals of surfaces

/** Totals of a surface. */
typedef struct face {
    double sum[CLOD_WEAR_SUMS];
    double area;                        ///< m2; 0: without bound
    double pressure;                    ///< Pa, largest mean of an element
    double archard, finnie;             ///< m3
    double archard_depth, finnie_depth; ///< m, of the element that wears most
    bool has_archard, has_finnie;       ///< a coefficient: else the four above mean nothing
    bool passes; ///< material goes through its places: they lose no depth
} face;

/** A surface of a wall as it is summed up. */
typedef struct summing {
    face *face;
    int32_t number;
    double time; ///< s, over which the sums go
} summing;

/** Whether the material of a shape goes on while its places stay, as that of a belt does. */
static bool material_passes(const clod_wall *wall, const clod_shape *shape)
{
    const clod_vec3 all = wall->surface_velocity;
    return clod_belt_moves(&shape->belt) || clod_vec3_dot(all, all) > 0.0;
}

static void add_element(void *context, const clod_wall *wall, clod_wear_place at)
{
    const summing *self = context;
    face *to = self->face;
    const double *sum = wall->wear[at.place];
    const clod_shape *shape = &wall->shapes[at.shape];
    if (at.face != self->number) {
        return;
    }
    for (int c = 0; c < CLOD_WEAR_SUMS; c++) {
        to->sum[c] += sum[c];
    }
    const double area = clod_wear_area(wall, at.shape, at.place);
    const double archard = shape->archard * sum[CLOD_WEAR_SLIDING];
    const double finnie = shape->finnie * sum[CLOD_WEAR_CUTTING];
    to->area += area;
    to->archard += archard;
    to->finnie += finnie;
    to->has_archard = to->has_archard || shape->archard > 0.0;
    to->has_finnie = to->has_finnie || shape->finnie > 0.0;
    to->passes = to->passes || material_passes(wall, shape);
    if (area > 0.0 && self->time > 0.0) {
        to->pressure = fmax(to->pressure, sum[CLOD_WEAR_PRESS] / (area * self->time));
        to->archard_depth = fmax(to->archard_depth, archard / area);
        to->finnie_depth = fmax(to->finnie_depth, finnie / area);
    }
}

/** Totals of one surface of a wall. */
static face face_of(const clod_wall *wall, int32_t number, double now)
{
    face total = {.area = 0.0};
    summing self = {&total, number, now - wall->wear_since};
    clod_wear_visit(wall, add_element, &self);
    return total;
}

/** Angle of impact, weighted with energy [deg]; there was one. */
static double angle_of(const face *self)
{
    return 180.0 / M_PI * self->sum[CLOD_WEAR_ANGLE] / self->sum[CLOD_WEAR_ENERGY];
}

// ---- when the sums begin

static void surfaces_begin(void *memory, const clod_case *from, const clod_state *state,
                           const clod_free_start *bed)
{
    (void)bed;
    (void)memory;
    for (int32_t w = 0; from->output.surfaces && w < state->walls.count; w++) {
        clod_wear_reset(&state->walls.wall[w], state->time);
    }
}

/** In the first step of the steady time they begin anew. */
static bool surfaces_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    (void)status;
    clod_state *state = now->state;
    if (now->from->output.surfaces &&
        clod_steady_time_steps(now->steady.since, state->time, state->dt) == 0) {
        for (int32_t w = 0; w < state->walls.count; w++) {
            clod_wear_reset(&state->walls.wall[w], state->time);
        }
    }
    return true;
}

static int64_t surfaces_plan(const void *memory, const clod_case *from, const clod_state *state,
                             const clod_steady_time *steady)
{
    (void)memory;
    const int64_t steps = clod_steady_time_steps(steady->since, state->time, state->dt);
    return from->output.surfaces && steps > 0 ? steps : INT64_MAX;
}

// ---- series

static size_t surfaces_columns(const clod_case *from, const clod_state *state)
{
    size_t faces = 0;
    for (int32_t w = 0; from->output.surfaces && w < state->walls.count; w++) {
        faces += (size_t)clod_wear_summed(&state->walls.wall[w]);
    }
    return PER_FACE_COUNT * faces;
}

static void surfaces_column(const clod_case *from, const clod_state *state, size_t k,
                            char *text, size_t size)
{
    (void)from;
    size_t number = k / PER_FACE_COUNT;
    int32_t w = 0;
    for (size_t faces; number >= (faces = (size_t)clod_wear_summed(&state->walls.wall[w]));
         w++) {
        number -= faces;
    }
    char name[CLOD_WEAR_NAME];
    clod_wear_name(&state->walls.wall[w], (int32_t)number, name, sizeof name);
    const size_t c = k % PER_FACE_COUNT;
    snprintf(text, size, "surface_%s.%s", name,
             c < MEANS ? PER_FACE[c] : CLOD_SURFACE_IMPACTS_COLUMN[c - MEANS]);
}

/** Sums of each surface of a wall: at the last row, and now. */
static double (*last_of(const clod_wall *wall))[CLOD_WEAR_SUMS]
{
    return wall->wear + wall->wear_places;
}

static double (*now_of(const clod_wall *wall))[CLOD_WEAR_SUMS]
{
    return last_of(wall) + clod_wear_faces(wall);
}

static void add_sums(void *context, const clod_wall *wall, clod_wear_place at)
{
    double(*to)[CLOD_WEAR_SUMS] = context;
    for (int c = 0; c < CLOD_WEAR_SUMS; c++) {
        to[at.face][c] += wall->wear[at.place][c];
    }
}

static bool surfaces_sample(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    (void)status;
    for (int32_t w = 0; now->from->output.surfaces && w < now->state->walls.count; w++) {
        clod_wall *wall = &now->state->walls.wall[w];
        if (wall->wear != NULL) {
            memset(now_of(wall), 0, (size_t)clod_wear_faces(wall) * sizeof *wall->wear);
            clod_wear_visit(wall, add_sums, now_of(wall));
        }
    }
    return true;
}

static void surfaces_row(void *memory, const clod_free_moment *now, double *row)
{
    (void)memory;
    for (int32_t w = 0; w < now->state->walls.count; w++) {
        clod_wall *wall = &now->state->walls.wall[w];
        const double time = now->state->time - wall->wear_row;
        const int32_t faces = clod_wear_summed(wall);
        if (faces == 0) {
            continue;
        }
        for (int32_t f = 0; f < faces; f++) {
            for (size_t c = 0; c < MEANS; c++) {
                const double sum = now_of(wall)[f][SUM_OF[c]] - last_of(wall)[f][SUM_OF[c]];
                *row++ = time > 0.0 ? sum / time : 0.0;
            }
            row = clod_surface_impacts_row(clod_wear_impacts(wall, f), row);
        }
        memcpy(last_of(wall), now_of(wall), (size_t)faces * sizeof *wall->wear);
        wall->wear_row = now->state->time;
    }
}

// ---- report and summary

/** A rate of wear [mm3/h], "-" without a coefficient. */
static const char *rate_text(bool known, double volume, double time, char text[16])
{
    snprintf(text, 16, known ? "%.4g" : "-", 1e9 * 3600.0 * volume / time);
    return text;
}

static void report_wall(FILE *out, const clod_wall *wall, double now)
{
    const double time = now - wall->wear_since;
    for (int32_t f = 0; time > 0.0 && f < clod_wear_summed(wall); f++) {
        const face total = face_of(wall, f, now), *of = &total;
        char name[CLOD_WEAR_NAME];
        clod_wear_name(wall, f, name, sizeof name);
        if (of->sum[CLOD_WEAR_IMPACTS] == 0.0 && of->sum[CLOD_WEAR_SHEAR] == 0.0) {
            continue;
        }
        char angle[16] = "-"; // no impact
        char archard[16], finnie[16];
        if (of->sum[CLOD_WEAR_ENERGY] > 0.0) {
            snprintf(angle, sizeof angle, "%.1f", angle_of(of));
        }
        fprintf(out, "  %-22s %9.4g %9.4g %9.4g %9.4g %9.4g %6s %10s %10s\n", name,
                of->sum[CLOD_WEAR_PRESS] / time, 1e-3 * of->pressure,
                of->sum[CLOD_WEAR_SHEAR] / time, of->sum[CLOD_WEAR_IMPACTS] / time,
                of->sum[CLOD_WEAR_ENERGY] / time, angle,
                rate_text(of->has_archard, of->archard, time, archard),
                rate_text(of->has_finnie, of->finnie, time, finnie));
    }
}

static void surfaces_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_walls *walls = &now->state->walls;
    if (!now->from->output.surfaces || walls->count == 0) {
        return;
    }
    char title[32];
    snprintf(title, sizeof title, "surface, from %.4g s", walls->wall[0].wear_since);
    fprintf(out,
            "  %-22s %9s %9s %9s %9s %9s %6s %10s %10s\n"
            "  %-22s %9s %9s %9s %9s %9s %6s %10s %10s\n",
            title, "press", "largest", "shear", "impacts", "impact", "angle", "Archard",
            "Finnie", "", "N", "kPa", "W", "1/s", "W", "deg", "mm3/h", "mm3/h");
    for (int32_t w = 0; w < walls->count; w++) {
        report_wall(out, &walls->wall[w], now->state->time);
    }
    clod_surface_impacts_report(out, walls);
}

static json_t *face_json(const clod_wall *wall, int32_t number, const face *of, double time)
{
    char name[CLOD_WEAR_NAME];
    clod_wear_name(wall, number, name, sizeof name);
    const double *sum = of->sum;
    json_t *one =
        json_pack("{s:s, s:f, s:[fff], s:f, s:f, s:f, s:f, s:f, s:f}", "name", name, "since_s",
                  wall->wear_since, "force_N", sum[0] / time, sum[1] / time, sum[2] / time,
                  "press_N", sum[CLOD_WEAR_PRESS] / time, "largest_pressure_Pa", of->pressure,
                  "shear_power_W", sum[CLOD_WEAR_SHEAR] / time, "squeeze_power_W",
                  sum[CLOD_WEAR_SQUEEZE] / time, "impacts_per_s", sum[CLOD_WEAR_IMPACTS] / time,
                  "impact_power_W", sum[CLOD_WEAR_ENERGY] / time);
    if (of->has_archard) {
        json_object_set_new(one, "archard_m3_per_s", json_real(of->archard / time));
    }
    if (of->has_finnie) {
        json_object_set_new(one, "finnie_m3_per_s", json_real(of->finnie / time));
    }
    if (of->has_archard && !of->passes) {
        json_object_set_new(one, "archard_depth_m_per_s", json_real(of->archard_depth / time));
    }
    if (of->has_finnie && !of->passes) {
        json_object_set_new(one, "finnie_depth_m_per_s", json_real(of->finnie_depth / time));
    }
    if (of->area > 0.0) {
        json_object_set_new(one, "area_m2", json_real(of->area));
    }
    if (sum[CLOD_WEAR_ENERGY] > 0.0) {
        json_object_set_new(one, "impact_angle_deg", json_real(angle_of(of)));
    }
    json_object_set_new(one, "impacts",
                        clod_surface_impacts_json(clod_wear_impacts(wall, number)));
    return one;
}

static bool surfaces_told(const clod_case *from)
{
    return from->output.surfaces;
}

/** Which numbers a surface has. */
typedef struct face_kind {
    bool bounded; ///< an area
    bool worn;    ///< depths
} face_kind;

static face_kind kind_of(const clod_wall *wall, int32_t number)
{
    const face total = face_of(wall, number, wall->wear_since);
    return (face_kind){.bounded = total.area > 0.0, .worn = !total.passes};
}

/** Paths of surfaces one behind the other that have the same numbers. */
static void add_faces(clod_free_paths *paths, size_t first, size_t count, face_kind kind)
{
    if (count > 0) {
        char faces[64];
        snprintf(faces, sizeof faces, "[%zu-%zu]", first, first + count - 1);
        clod_free_paths_add(
            paths, faces,
            "since_s force_N.[0-2] press_N largest_pressure_Pa shear_power_W squeeze_power_W "
            "impacts_per_s impact_power_W archard_m3_per_s finnie_m3_per_s impact_angle_deg%s%s",
            kind.worn ? " archard_depth_m_per_s finnie_depth_m_per_s" : "",
            kind.bounded ? " area_m2" : "");
        clod_surface_impacts_paths(paths, faces);
    }
}

static void surfaces_paths(const clod_case *from, const clod_state *state,
                           clod_free_paths *paths)
{
    size_t first = 0, count = 0; // of those alike so far
    face_kind kind = {false, false};
    (void)from;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t f = 0; f < clod_wear_summed(wall); f++) {
            const face_kind this_one = kind_of(wall, f);
            if (this_one.bounded != kind.bounded || this_one.worn != kind.worn) {
                add_faces(paths, first, count, kind);
                first += count;
                count = 0;
                kind = this_one;
            }
            count++;
        }
    }
    add_faces(paths, first, count, kind);
}

static json_t *surfaces_json(const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_walls *walls = &now->state->walls;
    json_t *all = json_array();
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        const double time = now->state->time - wall->wear_since;
        for (int32_t f = 0; time > 0.0 && f < clod_wear_summed(wall); f++) {
            const face total = face_of(wall, f, now->state->time);
            json_array_append_new(all, face_json(wall, f, &total, time));
        }
    }
    return all;
}

const clod_free_measure CLOD_MEASURE_SURFACES = {.key = "surfaces",
                                                 .begin = surfaces_begin,
                                                 .act = surfaces_act,
                                                 .plan = surfaces_plan,
                                                 .look = surfaces_sample,
                                                 .columns = surfaces_columns,
                                                 .column = surfaces_column,
                                                 .row = surfaces_row,
                                                 .report = surfaces_report,
                                                 .told = surfaces_told,
                                                 .paths = surfaces_paths,
                                                 .json = surfaces_json,
                                                 .write = clod_surface_impacts_write};
