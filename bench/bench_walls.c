/**
 * @file bench_walls.c
 * What walls cost that no grain is near, and those of which many are: time of a step and of a
 * rebuild of a packing among boxes, as rows of a table.
 *
 *   bench_walls PACKING.csv PACKING.box [STEPS] [REBUILDS]
 *
 * The boxes are small cubes, all shapes of one wall or each a wall of its own, at rest: far
 * above the bed (`far`), or at random places in its pores (`in`). One thread, best instruction
 * set, law mepa of bed.h. Both times are the least of five takes, the bed goes on between them.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "bed.h"
#include "stages.h"
#include "step/step.h"

#define TIME_STEP 1e-7 // s, as in bench_step
#define TAKES 5
/** Half size of the boxes and their least distance from a grain, over the largest radius. */
#define HALF 0.02
#define ROOM 0.04

typedef struct field {
    int boxes;
    bool inside; ///< in the pores of the bed
    bool single; ///< each box is a wall
} field;

static const field FIELDS[] = {
    {0, false, false},  {100, false, false},  {10000, false, false}, {10000, true, false},
    {100, false, true}, {10000, false, true}, {10000, true, true},
};

static void give_up(const char *text)
{
    fprintf(stderr, "bench_walls: %s\n", text);
    exit(2);
}

static double fraction(void)
{
    static uint64_t seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u; // Knuth's MMIX
    return (double)(seed >> 11) * 0x1p-53;
}

static double largest_radius(const clod_grains *grains)
{
    double most = 0.0;
    for (size_t g = 0; g < grains->count; g++) {
        most = fmax(most, grains->position[g][3]);
    }
    return most;
}

/** Whether a point is farther than `room` from the surface of every grain. */
static bool is_pore(const clod_state *state, const double p[3], double room)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *at = state->grains.position[g];
        double apart2 = 0.0;
        for (int a = 0; a < 3; a++) {
            apart2 += (p[a] - at[a]) * (p[a] - at[a]);
        }
        if (apart2 < (at[3] + room) * (at[3] + room)) {
            return false;
        }
    }
    return true;
}

static clod_shape box_at(const clod_state *state, const field *f, double radius)
{
    const double *size = state->domain.max;
    double p[3];
    do {
        for (int a = 0; a < 3; a++) {
            p[a] = fraction() * size[a];
        }
    } while (f->inside && !is_pore(state, p, ROOM * radius));
    const double lift = f->inside ? 0.0 : 3.0 * size[2];
    return (clod_shape){.kind = CLOD_SHAPE_BOX,
                        .center = {p[0], p[1], p[2] + lift},
                        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                        .half = {HALF * radius, HALF * radius, HALF * radius}};
}

static void add_boxes(clod_state *state, const field *f)
{
    if (f->boxes == 0) {
        return;
    }
    const double radius = largest_radius(&state->grains);
    const int each = f->single ? 1 : f->boxes;
    const int walls = f->boxes / each;
    state->walls.wall = clod_memory_alloc((size_t)walls, sizeof *state->walls.wall);
    for (int w = 0; state->walls.wall != NULL && w < walls; w++) {
        clod_wall *wall = &state->walls.wall[w];
        snprintf(wall->name, sizeof wall->name, "wall %d", w);
        wall->spin_axis = wall->load_axis = (clod_vec3){0.0, 0.0, 1.0};
        wall->shapes = clod_memory_alloc((size_t)each, sizeof *wall->shapes);
        if (wall->shapes == NULL) {
            break;
        }
        wall->shape_count = each;
        for (int s = 0; s < each; s++) {
            wall->shapes[s] = box_at(state, f, radius);
        }
        state->walls.count = w + 1;
    }
    if (state->walls.count != walls) {
        give_up("no memory for the walls");
    }
}

/** Least time of a step [s], of some calls of so many steps each; each call rebuilds first. */
static double least_time(clod_step *step, int64_t calls, int64_t steps, bool rebuild)
{
    clod_status status = {0};
    double least = INFINITY;
    for (int take = 0; take < TAKES; take++) {
        const double begin = bench_now();
        for (int64_t k = 0; k < calls; k++) {
            if (rebuild) {
                step->state->build_motion = INFINITY;
            }
            if (!clod_step_advance(step, steps, &status)) {
                give_up(status.text);
            }
        }
        least = fmin(least, (bench_now() - begin) / (double)(calls * steps));
    }
    return least;
}

static void measure(char **files, const field *f, int64_t steps, int64_t rebuilds)
{
    clod_status status = {0};
    clod_state state;
    clod_law law;
    clod_step step;
    if (!bench_bed_law("mepa", &law, &status) ||
        !bench_bed_read(files[0], files[1], &state, &status)) {
        give_up(status.text);
    }
    add_boxes(&state, f);
    state.dt = TIME_STEP;
    const clod_laws laws = {.materials = 1, .count = 1, .law = &law};
    const clod_step_options options = {.threads = 1};
    if (!clod_step_init(&step, &state, &laws, &options, &status) ||
        !clod_step_advance(&step, steps / 10 + 1, &status)) {
        give_up(status.text);
    }
    const int64_t before = step.rebuilds;
    const double one = least_time(&step, 1, steps, false);
    const double seen = (double)(step.rebuilds - before);
    const double again = least_time(&step, rebuilds, 1, true);
    printf("| %d %s | %d | %zu | %.1f | %.0f | %.2f |\n", f->boxes, f->inside ? "in" : "far",
           state.walls.count, step.neighbour.walls.count, 1e6 * one, seen, 1e3 * again);
    clod_step_fini(&step);
    clod_state_fini(&state);
}

int main(int argc, char **argv)
{
    const int64_t steps = argc > 3 ? strtoll(argv[3], NULL, 10) : 2000;
    const int64_t rebuilds = argc > 4 ? strtoll(argv[4], NULL, 10) : 10;
    if (argc < 3 || steps < 1 || rebuilds < 1) {
        give_up("usage: bench_walls PACKING.csv PACKING.box [STEPS] [REBUILDS]");
    }
    puts("| boxes | walls | candidates | us/step | rebuilds in these | ms/step with a rebuild "
         "|");
    puts("|---|---|---|---|---|---|");
    for (size_t k = 0; k < sizeof FIELDS / sizeof *FIELDS; k++) {
        measure(argv + 1, &FIELDS[k], steps, rebuilds);
        fflush(stdout);
    }
    return 0;
}
