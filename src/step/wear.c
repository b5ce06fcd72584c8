// Stage wear: what the grains did to each place of the walls in this step, onto its sums. A place's
// addends come law by law, form by form, in the order of grains: one order on any number of threads.
#include "state/wear.h"

#include <math.h>

#include "parallel/threads.h"
#include "step/step.h"

/** Places of all walls that a thread adds to: those of its share of the numbers. */
static bool is_mine(const clod_step *self, int32_t place, int part)
{
    return self->threads == 1 || place % self->threads == part;
}

static double length(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

/** What one contact did to its place in a step. */
static void add(double sum[CLOD_WEAR_SUMS], const clod_rub_block *rub, int lane, double dt)
{
    const double press = rub->press[lane], slip = rub->slip[lane];
    const double approach = rub->approach[lane], mass = rub->mass[lane];
    const double square = rub->speed2[lane];
    for (int a = 0; a < 3; a++) {
        sum[CLOD_WEAR_IMPULSE + a] += dt * rub->force[a][lane];
    }
    sum[CLOD_WEAR_PRESS] += dt * press;
    sum[CLOD_WEAR_SHEAR] += dt * rub->friction[lane];
    sum[CLOD_WEAR_SLIDING] += dt * fmax(press, 0.0) * slip;
    if (approach > 0.0) {
        const double force =
            length(rub->force[0][lane], rub->force[1][lane], rub->force[2][lane]);
        sum[CLOD_WEAR_SQUEEZE] += dt * fmax(press, 0.0) * approach;
        sum[CLOD_WEAR_CUTTING] +=
            2.0 * dt * force * length(approach, slip, 0.0) * clod_wear_finnie(approach, slip);
    }
    if (rub->closed[lane] > 1.5 && approach > 0.0) { // an impact begins
        const double energy = 0.5 * mass * approach * approach;
        sum[CLOD_WEAR_IMPACTS] += 1.0;
        sum[CLOD_WEAR_ENERGY] += energy;
        sum[CLOD_WEAR_ANGLE] += energy * asin(fmin(1.0, approach / sqrt(square)));
    }
}

/** Place of a contact among those of its wall. */
static int32_t place_of(const clod_step *self, const clod_wall *wall,
                        const clod_wall_block *block, clod_wall_form form, int lane)
{
    const int32_t first = clod_wall_rows_shape(&self->walls, block->wall[lane], 0);
    const int32_t shape = (block->shape[lane] - first) / CLOD_SHAPE_ROWS;
    const int32_t facet =
        form == CLOD_FORM_MESH ? self->near.touch.facet[block->touch[lane]] : 0;
    return wall->shapes[shape].place + facet;
}

static void add_group(clod_step *self, size_t group, clod_wall_form form, int part)
{
    const clod_near_blocks *walls = &self->near.walls;
    const size_t begin = walls->group_start[group];
    for (size_t c = 0; c < walls->group_count[group]; c++) {
        const clod_rub_block *rub = &walls->rub[begin + c / CLOD_LANES];
        const int lane = (int)(c % CLOD_LANES);
        if (rub->closed[lane] == 0.0) {
            continue;
        }
        const clod_wall_block *block =
            (const clod_wall_block *)walls->block + begin + c / CLOD_LANES;
        clod_wall *wall = &self->state->walls.wall[block->wall[lane]];
        const int32_t place = wall->wear != NULL ? place_of(self, wall, block, form, lane) : -1;
        if (place >= 0 && is_mine(self, place, part)) {
            add(wall->wear[place], rub, lane, self->view.dt);
        }
    }
}

void clod_step_wear(clod_step *self, int part)
{
    const clod_near *near = &self->near;
    for (int32_t l = 0; near->wear && l < near->laws; l++) {
        for (int form = 0; form < CLOD_FORMS; form++) {
            for (int p = 0; p < near->parts; p++) {
                add_group(self, clod_near_wall_group(near, p, l, (clod_wall_form)form),
                          (clod_wall_form)form, part);
            }
        }
    }
}
