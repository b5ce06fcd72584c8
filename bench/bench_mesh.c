/**
 * @file bench_mesh.c
 * What a contact with triangles costs beside one with a plane, and beside one with the cylinder
 * that the triangles stand for, as rows of a table.
 *
 *   bench_mesh [--steps N] [--speed V] [--only SCENE]
 *
 * The same grains, apart from each other, each in contact with one surface: they roll over it
 * aslant, without weight (a fast grain leaves the roller then). A contact's cost is the time of the grains with the surface less that
 * without any, over the number of contacts: lists, closest points, law and sums. One thread, law
 * mepa of bed.h, processor time. All scenes take their turn in every take, and a ratio is the
 * median of those of the takes. --only steps one scene, for a program that counts instructions.
 */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/memory.h"
#include "bed.h"
#include "clod/mesh.h"
#include "geometry/wall_gap.h"
#include "mesh/surface_touch.h"
#include "step/step.h"

#define TIME_STEP 1e-6 // s
#define ROWS 64        // grains along the axis, and across it
#define RADIUS 0.003   // m, of a grain
#define APART 2.5      // radii between two of them
#define ROUND 0.25     // m, radius of trough and roller
#define SIDE 0.6       // m, of the sheet; length of trough and roller
#define OVERLAP 1e-7   // m
#define SMOOTH 0.35    // rad, as a case has it
#define TAKES 15       // odd

typedef enum form {
    FORM_NONE,   ///< no surface
    FORM_FLAT,   ///< grains on a plane
    FORM_TROUGH, ///< grains in a cylinder
    FORM_ROLLER, ///< grains on a cylinder
} form;

/** A surface; without facets the analytic one. */
typedef struct scene {
    const char *name;
    form form;
    int around, along; ///< strips of facets, of two each
} scene;

static const scene SCENES[] = {
    {"none", FORM_NONE, 0, 0},
    {"plane", FORM_FLAT, 0, 0},
    {"plane-2", FORM_FLAT, 1, 1},
    {"plane-200", FORM_FLAT, 10, 10},
    {"plane-20000", FORM_FLAT, 100, 100},
    {"trough", FORM_TROUGH, 0, 0},
    {"trough-144", FORM_TROUGH, 72, 1},
    {"trough-28800", FORM_TROUGH, 360, 40},
    {"roller", FORM_ROLLER, 0, 0},
    {"roller-144", FORM_ROLLER, 72, 1},
    {"roller-28800", FORM_ROLLER, 360, 40},
};
#define SCENE_COUNT (sizeof SCENES / sizeof *SCENES)
#define PLANE 1 // its number

typedef struct options {
    int64_t steps;
    double speed; ///< m/s
    const char *only;
} options;

typedef struct run {
    clod_state state;
    clod_step step;
    size_t facets, patches;
    double seconds[TAKES]; ///< per step
} run;

static void give_up(const char *text)
{
    fprintf(stderr, "bench_mesh: %s\n", text);
    exit(2);
}

// ---- the surface

/** A corner of the facets: a sheet at z = 0, or a cylinder about the y axis. */
static void corner(const scene *s, int around, int along, double p[3])
{
    const double turn = 2.0 * M_PI * around / s->around;
    const bool flat = s->form == FORM_FLAT;
    p[0] = flat ? SIDE * ((double)around / s->around - 0.5) : ROUND * sin(turn);
    p[1] = SIDE * ((double)along / s->along - 0.5);
    p[2] = flat ? 0.0 : ROUND * cos(turn);
}

static void write_facet(FILE *file, const double a[3], const double b[3], const double c[3])
{
    const double *corners[] = {a, b, c};
    fputs("facet normal 0 0 0\nouter loop\n", file);
    for (int k = 0; k < 3; k++) {
        fprintf(file, "vertex %.9g %.9g %.9g\n", corners[k][0], corners[k][1], corners[k][2]);
    }
    fputs("endloop\nendfacet\n", file);
}

static clod_surface *make_surface(const scene *s, run *self)
{
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    fputs("solid made\n", file);
    for (int i = 0; i < s->around; i++) {
        for (int j = 0; j < s->along; j++) {
            double p[4][3];
            for (int k = 0; k < 4; k++) {
                corner(s, i + (k == 1 || k == 2), j + (k >= 2), p[k]);
            }
            write_facet(file, p[0], p[1], p[2]);
            write_facet(file, p[0], p[2], p[3]);
        }
    }
    fputs("endsolid made\n", file);
    fclose(file);
    clod_status status = {0};
    const clod_mesh_placing placing = {.unit = 1.0, .scale = 1.0};
    clod_mesh *mesh = clod_mesh_parse("made.stl", text, length, &placing, &status);
    free(text);
    clod_surface *surface =
        mesh == NULL ? NULL : clod_surface_make(mesh, NULL, SMOOTH, &status);
    if (surface == NULL) {
        give_up(status.text);
    }
    self->facets = clod_mesh_look(mesh)->facet_count;
    self->patches = surface->patch_count;
    clod_mesh_destroy(&mesh);
    return surface;
}

/** Shape number s of a mesh, as setup/walls.c makes them. */
static clod_shape patch_shape(clod_surface *surface, int32_t s)
{
    const clod_surface_patch *patch = &surface->patches[s / CLOD_SURFACE_SLOTS];
    const clod_vec3 low = clod_vec3_of(patch->low), high = clod_vec3_of(patch->high);
    return (clod_shape){
        .kind = CLOD_SHAPE_MESH,
        .center = clod_vec3_scale(clod_vec3_add(low, high), 0.5),
        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
        .half = {0.5 * (high.x - low.x), 0.5 * (high.y - low.y), 0.5 * (high.z - low.z)},
        .surface = clod_surface_share(surface),
        .patch = s / CLOD_SURFACE_SLOTS,
        .slot = s % CLOD_SURFACE_SLOTS};
}

static clod_shape analytic_shape(const scene *s)
{
    const bool flat = s->form == FORM_FLAT;
    const clod_vec3 x = {1.0, 0.0, 0.0}, y = {0.0, 1.0, 0.0}, z = {0.0, 0.0, 1.0};
    return (clod_shape){.kind = flat ? CLOD_SHAPE_PLANE : CLOD_SHAPE_CYLINDER,
                        .center = {0.0, flat ? 0.0 : -0.5 * SIDE, 0.0},
                        .axis = {flat ? x : z, flat ? y : x, flat ? z : y},
                        .outer = flat ? 0.0 : ROUND,
                        .half = {0.0, 0.0, flat ? 0.0 : 0.5 * SIDE},
                        .side = s->form == FORM_TROUGH ? CLOD_SIDE_INSIDE : CLOD_SIDE_OUTSIDE};
}

static void add_wall(const scene *s, run *self)
{
    clod_surface *surface = s->around > 0 ? make_surface(s, self) : NULL;
    const size_t shapes = surface != NULL ? CLOD_SURFACE_SLOTS * surface->patch_count : 1;
    clod_wall *wall = clod_memory_alloc(1, sizeof *wall);
    clod_shape *shape = clod_memory_alloc(shapes, sizeof *shape);
    if (wall == NULL || shape == NULL) {
        give_up("no memory for the walls");
    }
    snprintf(wall->name, sizeof wall->name, "wall");
    wall->spin_axis = wall->load_axis = (clod_vec3){0.0, 0.0, 1.0};
    wall->shapes = shape;
    wall->shape_count = (int32_t)shapes;
    for (size_t k = 0; k < shapes; k++) {
        shape[k] = surface != NULL ? patch_shape(surface, (int32_t)k) : analytic_shape(s);
    }
    clod_surface_release(surface);
    self->state.walls = (clod_walls){1, wall};
}

// ---- the grains

/** Distance of a point that is near it from the surface. */
static double gap_of(const clod_walls *walls, clod_vec3 p)
{
    double least = INFINITY;
    for (int32_t k = 0; k < walls->wall[0].shape_count; k++) {
        const clod_shape *shape = &walls->wall[0].shapes[k];
        if (shape->surface == NULL) {
            least = fmin(least, clod_wall_gap(shape, p).distance);
        } else if (shape->slot == 0) {
            const uint32_t at = (uint32_t)shape->patch;
            const double most = 2.0 * RADIUS;
            least =
                fmin(least, clod_surface_patch_closest(shape->surface, at, p, most).distance);
        }
    }
    return least;
}

/** Place a grain: `n` is the way off the surface, `p` is near it. */
static void add_grain(const scene *s, run *self, clod_vec3 p, clod_vec3 n, double speed)
{
    for (int k = 0; s->form != FORM_NONE && k < 4;
         k++) { // within facets: by the exact distance
        p = clod_vec3_axpy(p, RADIUS - OVERLAP - gap_of(&self->state.walls, p), n);
    }
    const clod_vec3 y = {0.0, 1.0, 0.0};
    const clod_vec3 aslant = clod_vec3_add(y, clod_vec3_cross(y, n));
    const clod_vec3 v = clod_vec3_scale(aslant, speed / sqrt(2.0));
    const clod_vec3 w = clod_vec3_scale(clod_vec3_cross(n, v), 1.0 / RADIUS);
    clod_status status = {0};
    if (!clod_grains_add(&self->state.grains, (double[4]){p.x, p.y, p.z, RADIUS},
                         (double[3]){v.x, v.y, v.z}, (double[3]){w.x, w.y, w.z}, 2481.3, 0,
                         self->state.grains.count, &status)) {
        give_up(status.text);
    }
}

static void add_grains(const scene *s, run *self, double speed)
{
    const double apart = APART * RADIUS;
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j < ROWS; j++) {
            const double x = (i - 0.5 * ROWS + 0.5) * apart, y = (j - 0.5 * ROWS + 0.5) * apart;
            const double turn = x / ROUND;
            const double side = s->form == FORM_TROUGH ? -1.0 : 1.0;
            const double at = side * (ROUND + side * RADIUS);
            const bool flat = s->form == FORM_FLAT || s->form == FORM_NONE;
            const clod_vec3 n = {flat ? 0.0 : sin(turn), 0.0, flat ? 1.0 : cos(turn)};
            const clod_vec3 p = {flat ? x : at * n.x, y, flat ? RADIUS : at * n.z};
            add_grain(s, self, p, n, speed);
        }
    }
}

static void begin(const scene *s, const options *o, const clod_laws *laws, run *self)
{
    clod_status status = {0};
    self->state = (clod_state){.build_motion = -1.0, .dt = TIME_STEP};
    for (int a = 0; a < 3; a++) {
        self->state.domain.min[a] = -0.5;
        self->state.domain.max[a] = 0.5;
    }
    if (s->form != FORM_NONE) {
        add_wall(s, self);
    }
    add_grains(s, self, o->speed);
    const clod_step_options step = {.threads = 1};
    if (!clod_step_init(&self->step, &self->state, laws, &step, &status) ||
        !clod_step_advance(&self->step, 100, &status)) {
        give_up(status.text);
    }
}

// ---- the clock

static double processor_time(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double advance(run *self, int64_t steps)
{
    clod_status status = {0};
    const double before = processor_time();
    if (!clod_step_advance(&self->step, steps, &status)) {
        give_up(status.text);
    }
    return (processor_time() - before) / (double)steps;
}

static double contacts_of(run *self)
{
    size_t pairs, walls;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&self->step, &reader);
    contacts.begin(contacts.context, &pairs, &walls);
    return (double)(pairs + walls);
}

/** Sorts the values. */
static double median(double values[TAKES])
{
    for (int k = 1; k < TAKES; k++) {
        const double v = values[k];
        int at = k;
        for (; at > 0 && v < values[at - 1]; at--) {
            values[at] = values[at - 1];
        }
        values[at] = v;
    }
    return values[TAKES / 2];
}

/** Time of a contact in a step, in one take [ns]. */
static double cost(const run *runs, const double *contacts, size_t s, int take)
{
    return 1e9 * (runs[s].seconds[take] - runs[0].seconds[take]) / contacts[s];
}

static void report(run *runs)
{
    double contacts[SCENE_COUNT];
    puts("| surface | facets | patches | contacts | ns/contact | of the plane's | of its "
         "analytic twin's |");
    puts("|---|---|---|---|---|---|---|");
    size_t twin = PLANE;
    for (size_t s = 0; s < SCENE_COUNT; s++) {
        contacts[s] = contacts_of(&runs[s]);
        twin = SCENES[s].around == 0 ? s : twin;
        double ns[TAKES], plane[TAKES], own[TAKES];
        for (int t = 0; s > 0 && t < TAKES; t++) {
            ns[t] = cost(runs, contacts, s, t);
            plane[t] = ns[t] / cost(runs, contacts, PLANE, t);
            own[t] = ns[t] / cost(runs, contacts, twin, t);
        }
        if (s > 0) {
            printf("| %s | %zu | %zu | %.0f | %.1f | %.2f | %.2f |\n", SCENES[s].name,
                   runs[s].facets, runs[s].patches, contacts[s], median(ns), median(plane),
                   median(own));
        }
    }
}

static const struct option OPTIONS[] = {
    {"steps", required_argument, NULL, 's'},
    {"speed", required_argument, NULL, 'v'},
    {"only", required_argument, NULL, 'o'},
    {0},
};

static options read_options(int argc, char **argv)
{
    options o = {.steps = 300, .speed = 0.1};
    int key;
    while ((key = getopt_long(argc, argv, "", OPTIONS, NULL)) != -1) {
        switch (key) {
        case 's':
            o.steps = strtoll(optarg, NULL, 10);
            break;
        case 'v':
            o.speed = strtod(optarg, NULL);
            break;
        case 'o':
            o.only = optarg;
            break;
        default:
            exit(2);
        }
    }
    if (optind != argc || o.steps < 1 || o.speed < 0.0) {
        give_up("usage: bench_mesh [options], see bench/bench_mesh.c");
    }
    return o;
}

int main(int argc, char **argv)
{
    static run runs[SCENE_COUNT];
    const options o = read_options(argc, argv);
    clod_status status = {0};
    clod_law law;
    if (!bench_bed_law("mepa", &law, &status)) {
        give_up(status.text);
    }
    const clod_laws laws = {.materials = 1, .count = 1, .law = &law};
    for (size_t s = 0; s < SCENE_COUNT; s++) {
        if (o.only != NULL && strcmp(o.only, SCENES[s].name) != 0) {
            continue;
        }
        begin(&SCENES[s], &o, &laws, &runs[s]);
        if (o.only != NULL) {
            advance(&runs[s], o.steps);
            printf("%.0f\n", contacts_of(&runs[s]));
            return 0;
        }
    }
    if (o.only != NULL) {
        give_up("--only: no such scene, see the table SCENES of bench/bench_mesh.c");
    }
    for (int t = 0; t < TAKES; t++) {
        for (size_t s = 0; s < SCENE_COUNT; s++) {
            runs[s].seconds[t] = advance(&runs[s], o.steps);
        }
    }
    report(runs);
    return 0;
}
