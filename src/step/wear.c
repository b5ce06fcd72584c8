// Stage wear: what the grains did to each place of the walls in this step, onto its sums. A place's
// addends come law by law, form by form, in the order of grains: one order on any number of threads,
// and of ranks (spread_wear.c).
#include "state/wear.h"

#include "parallel/threads.h"
#include "step/impact.h"
#include "step/spread_wear.h"

/** Places, and surfaces, of all walls that a thread adds to: its share of the numbers. */
static bool is_mine(const clod_step *self, int32_t number, int thread)
{
    return self->threads == 1 || number % self->threads == thread;
}

/** What one contact did to its place in a step. */
static void add(double sum[CLOD_WEAR_SUMS], const double did[CLOD_WEAR_STEP_SUMS])
{
    for (int c = 0; c < CLOD_WEAR_STEP_SUMS; c++) {
        sum[c] += did[c];
    }
}

static void add_impact(double sum[CLOD_WEAR_SUMS], const clod_impact *impact)
{
    sum[CLOD_WEAR_IMPACTS] += 1.0;
    sum[CLOD_WEAR_ENERGY] += impact->normal;
    sum[CLOD_WEAR_ANGLE] += impact->normal * impact->angle;
}

/** Place of a contact among those of its wall. */
static clod_wear_place place_of(const clod_step *self, const clod_wall *wall,
                                const clod_wall_block *block, clod_wall_form form, int lane)
{
    const int32_t first = clod_wall_rows_shape(&self->walls, block->wall[lane], 0);
    const int32_t number = (block->shape[lane] - first) / CLOD_SHAPE_ROWS;
    const clod_shape *shape = &wall->shapes[number];
    clod_wear_place at = {number, shape->place, shape->face};
    if (form == CLOD_FORM_MESH) {
        const int32_t facet = self->near.touch.facet[block->touch[lane]];
        at.place += facet;
        at.face += (int32_t)shape->surface->part[facet];
    }
    return at;
}

/** Note what a contact did, for rank 0 to add. */
static void note(clod_step *self, int part, size_t group, size_t number, clod_wear_place at)
{
    const clod_near_blocks *walls = &self->near.walls;
    const size_t b = walls->group_start[group] + number / CLOD_LANES;
    const int lane = (int)(number % CLOD_LANES);
    const clod_rub_block *rub = &walls->rub[b];
    const clod_wall_block *block = (const clod_wall_block *)walls->block + b;
    clod_wear_record *record = clod_spread_wear_note(self, group, block->i[lane]);
    if (record == NULL) {
        return;
    }
    record->wall = block->wall[lane];
    record->place = at.place;
    record->face = at.face;
    add(record->sum, rub->did[lane]);
    if (rub->closed[lane] > 1.5 && clod_impact_begins(&self->near, part, group, number)) {
        record->begins = 1;
        record->impact =
            clod_impact_of(rub->mass[lane], rub->approach[lane], rub->speed2[lane]);
        add_impact(record->sum, &record->impact);
    }
}

/** Contacts of one part of the list. */
static void add_group(clod_step *self, int part, size_t group, clod_wall_form form, int thread)
{
    const clod_near_blocks *walls = &self->near.walls;
    const size_t begin = walls->group_start[group];
    for (size_t c = 0; c < walls->group_count[group]; c++) {
        const clod_rub_block *rub = &walls->rub[begin + c / CLOD_LANES];
        const int lane = (int)(c % CLOD_LANES);
        const clod_wall_block *block =
            (const clod_wall_block *)walls->block + begin + c / CLOD_LANES;
        clod_wall *wall = &self->state->walls.wall[block->wall[lane]];
        if (rub->closed[lane] == 0.0 || wall->wear == NULL) {
            continue;
        }
        const clod_wear_place at = place_of(self, wall, block, form, lane);
        if (self->spread != NULL) {
            note(self, part, group, c, at);
            continue;
        }
        const bool mine = is_mine(self, at.place, thread);
        if (mine) {
            add(wall->wear[at.place], rub->did[lane]);
        }
        if (rub->closed[lane] > 1.5 && (mine || is_mine(self, at.face, thread)) &&
            clod_impact_begins(&self->near, part, group, c)) {
            const clod_impact impact =
                clod_impact_of(rub->mass[lane], rub->approach[lane], rub->speed2[lane]);
            if (mine) {
                add_impact(wall->wear[at.place], &impact);
            }
            if (is_mine(self, at.face, thread)) {
                clod_impacts_add(clod_wear_impacts(wall, at.face), &impact);
            }
        }
    }
}

void clod_step_wear(clod_step *self, int thread)
{
    const clod_near *near = &self->near;
    if (self->spread != NULL && thread > 0) {
        return; // one thread of each rank notes what it has, for rank 0 to add
    }
    for (int32_t l = 0; near->wear && l < near->laws; l++) {
        for (int form = 0; form < CLOD_FORMS; form++) {
            for (int p = 0; p < near->parts; p++) {
                add_group(self, p, clod_near_wall_group(near, p, l, (clod_wall_form)form),
                          (clod_wall_form)form, thread);
            }
        }
    }
    if (near->wear && self->spread != NULL) {
        clod_spread_wear_add(self);
    }
}
