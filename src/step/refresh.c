// Stage near: whether motion has used up what a list allows, so that it must be made anew.
#include <math.h>

#include "parallel/threads.h"
#include "step/remake.h"
#include "step/spread.h"

/** What a near list costs for each grain, over what a pair costs in a step (docs/adr/0020). */
#define LIST_COST 47.0
/** What a contact with a wall costs in a step over one of grains. */
#define WALL_COST 4.0
/** What of the fastest speed a slow grain may get between two lists. */
#define SUDDEN 0.2
/** What of its speed a wall may get. */
#define WALL_SUDDEN 1.3
/** The thinnest skin, as a fraction of the smallest radius: next to no pairs. */
#define NEAR_LEAST 1e-3

/** Mean speed of the grains [m/s]. */
static double mean_speed(const clod_grains *grains)
{
    double sum = 0.0;
    for (size_t g = 0; g < grains->count; g++) {
        const double *v = grains->velocity[g];
        sum += sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sum / fmax((double)grains->count, 1.0);
}

/** Fastest speed of any point of a wall [m/s]. */
static double wall_speed(const clod_walls *walls)
{
    double fastest = 0.0;
    for (int32_t w = 0; w < walls->count; w++) {
        fastest = fmax(fastest, clod_wall_speed_bound(&walls->wall[w]));
    }
    return fastest;
}

clod_near_skins clod_step_skins(const clod_step *self, double speed)
{
    const clod_neighbour *wide = &self->neighbour;
    const double pairs = (double)wide->pairs.count + WALL_COST * (double)wide->walls.count;
    const double grains = (double)self->state->grains.count;
    const double some = SUDDEN * speed;
    const double typical = mean_speed(&self->state->grains) + some;
    // pairs within a skin are taken to grow with it
    const double time = typical > 0.0 ? sqrt(LIST_COST * grains * self->state->dt * wide->skin /
                                             (2.0 * typical * fmax(pairs, 1.0)))
                                      : 0.0;
    const double least = 0.5 * NEAR_LEAST * wide->radius_min, most = 0.5 * wide->skin;
    const double walls = WALL_SUDDEN * time * wall_speed(&self->state->walls);
    return (clod_near_skins){.time = time,
                             .least = fmin(fmax(least, time * some), most),
                             .most = most,
                             .wall = fmin(fmax(least, walls), most)};
}

void clod_step_begin_motion(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    mine->near_motion = mine->wall_motion = 0.0;
    mine->near_slack = self->near.least_skin;
}

/** The least that is left of a skin on any rank, to that of thread 0. */
static void least_of_ranks(clod_step *self, int part)
{
    if (part == 0) {
        double least = self->near.wall_skin - self->thread[0].wall_motion;
        for (int t = 0; t < self->threads; t++) {
            least = fmin(least, self->thread[t].slack);
        }
        self->thread[0].slack = clod_spread_least(self->spread, least);
    }
    clod_barrier_wait(&self->barrier);
}

/** Whether a grain or a wall has moved by more than its skin; each thread checks its grains. */
static bool is_used_up(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    const clod_chunk parts = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    mine->slack = clod_near_slack(&self->near, self->state, self->near.part_start[parts.begin],
                                  self->near.part_start[parts.end]);
    clod_barrier_wait(&self->barrier);
    if (self->spread != NULL) { // ranks look together, and make lists together
        least_of_ranks(self, part);
    }
    mine->near_motion = 0.0;
    mine->near_slack = self->near.wall_skin - mine->wall_motion;
    for (int t = 0; t < self->threads; t++) {
        mine->near_slack = fmin(mine->near_slack, self->thread[t].slack);
    }
    return mine->near_slack < 0.0;
}

/** Every thread takes the same decision from the same numbers; all make the lists. */
void clod_step_near(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    double speed2 = 0.0;
    bool finite = true;
    for (int t = 0; t < self->threads; t++) {
        speed2 = fmax(speed2, self->thread[t].max_speed2);
        finite &= self->thread[t].finite;
    }
    mine->all_finite = finite;
    const double speed = sqrt(speed2);
    mine->build_motion += speed * self->state->dt;
    mine->near_motion += speed * self->state->dt;
    const bool again = 2.0 * mine->build_motion > self->neighbour.skin;
    mine->wall_motion += self->thread[0].wall_speed * self->state->dt;
    const size_t grains =
        self->spread == NULL ? self->state->grains.count : self->spread->bed.count;
    if (!finite || grains == 0) { // what is not finite cannot be sorted; the next change makes
        return;                   // lists of grains that come
    }
    if (!again && (mine->near_motion <= mine->near_slack || !is_used_up(self, part))) {
        return;
    }
    if (part == 0) {
        clod_remake_begin(self, again, speed);
    }
    clod_barrier_wait(&self->barrier);
    clod_remake_lists(self, part);
    clod_step_begin_motion(self, part);
    mine->build_motion = again ? 0.0 : mine->build_motion;
}
