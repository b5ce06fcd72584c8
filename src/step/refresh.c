// Stage near: whether motion has used up what a list allows, so that it must be made anew.
#include <math.h>

#include "parallel/threads.h"
#include "step/near_skins.h"
#include "step/remake.h"
#include "step/spread.h"

/** What a near list costs for each grain, over what a pair costs in a step (docs/adr/0020). */
#define LIST_COST 47.0
/** What a contact with a wall costs in a step over one of grains. */
#define WALL_COST 4.0
/** What of the fastest speed a slow grain may get between two lists. */
#define SUDDEN 0.2
/** The same, and what a grain's speed may change by, where grains follow their courses. */
#define FOLLOW_SUDDEN 0.05
#define FOLLOW_CHANGE 0.3
/** Grains are expected to follow their courses when that was so much nearer to where they got than
 *  where they began. */
#define FOLLOW 0.5
/** What of its speed a wall may get. */
#define WALL_SUDDEN 1.3
/** The thinnest skin, as a fraction of the smallest radius: next to no pairs. */
#define NEAR_LEAST 1e-3

/** What skins follow from; with several ranks that of all, so that all choose the same. */
typedef struct bed_sums {
    double speeds; ///< m/s, of all grains
    double grains, pairs;
    double smallest, largest; ///< m, radius
    double fastest;           ///< m/s, grain or point of a wall
    double gone, off_course;  ///< m, of the last list
} bed_sums;

static void merge_sums(const void *context, void *into, const void *from)
{
    (void)context;
    bed_sums *mine = into;
    const bed_sums *other = from;
    mine->speeds += other->speeds;
    mine->grains += other->grains;
    mine->pairs += other->pairs;
    mine->smallest = fmin(mine->smallest, other->smallest);
    mine->largest = fmax(mine->largest, other->largest);
    mine->fastest = fmax(mine->fastest, other->fastest);
    mine->gone += other->gone;
    mine->off_course += other->off_course;
}

static bed_sums sum_up(const clod_step *self, double fastest)
{
    const clod_grains *grains = &self->state->grains;
    const clod_neighbour *wide = &self->neighbour;
    bed_sums sums = {.grains = (double)grains->count,
                     .pairs = (double)wide->pairs.count + WALL_COST * (double)wide->walls.count,
                     .smallest = wide->radius_min,
                     .largest = wide->radius_max,
                     .fastest = fastest};
    for (size_t g = 0; g < grains->count; g++) {
        const double *v = grains->velocity[g];
        sums.speeds += sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    for (int t = 0; t < self->threads; t++) {
        sums.gone += self->thread[t].gone;
        sums.off_course += self->thread[t].off_course;
    }
    if (self->spread != NULL) {
        clod_ranks_merge(self->spread->ranks, &sums, sizeof sums, merge_sums, NULL);
    }
    return sums;
}

/** Fastest speed of any point of a wall [m/s]; no shape is looked at, a mesh may have many. */
static double wall_speed(const clod_walls *walls, const clod_wall_rows *rows)
{
    double fastest = 0.0;
    for (int32_t w = 0; w < walls->count; w++) {
        fastest = fmax(fastest, clod_wall_speed_within(&walls->wall[w], rows->reach[w]));
    }
    return fastest;
}

clod_near_skins clod_step_skins(const clod_step *self, double speed)
{
    const double skin = self->neighbour.skin;
    const bed_sums bed = sum_up(self, speed);
    const bool follow = bed.off_course < FOLLOW * bed.gone;
    const double change = follow ? FOLLOW_CHANGE : 1.0;
    const double some = (follow ? FOLLOW_SUDDEN : SUDDEN) * bed.fastest;
    const double typical = change * bed.speeds / fmax(bed.grains, 1.0) + some;
    // pairs within a skin are taken to grow with it
    const double time = typical > 0.0 ? sqrt(LIST_COST * bed.grains * self->state->dt * skin /
                                             (2.0 * typical * fmax(bed.pairs, 1.0)))
                                      : 0.0;
    const double least = 0.5 * NEAR_LEAST * bed.smallest, most = 0.5 * skin;
    const double last =
        bed.fastest > 0.0 ? most / bed.fastest : 0.0; // by then there is a rebuild
    const double walls = WALL_SUDDEN * time * wall_speed(&self->state->walls, &self->walls);
    return (clod_near_skins){.time = change * time,
                             .least = fmin(fmax(least, time * some), most),
                             .most = most,
                             .follow = follow,
                             .horizon = fmin(time, last),
                             .wall = fmin(fmax(least, walls), most),
                             .largest = bed.largest};
}

static void begin_motion(clod_step_thread *mine)
{
    mine->age = mine->wall_motion = 0.0;
    mine->gone = mine->off_course = 0.0;
    mine->used_up = false;
}

void clod_step_begin_motion(clod_step *self)
{
    for (int t = 0; t < self->threads; t++) {
        begin_motion(&self->thread[t]);
    }
}

/** Whether a grain or a wall has moved by more than its skin, or the list is too old. */
static bool is_used_up(const clod_step *self, const clod_step_thread *mine)
{
    bool used_up = mine->wall_motion > self->near.wall_skin ||
                   (self->near.follow && mine->age > self->near.horizon);
    for (int t = 0; t < self->threads; t++) {
        used_up = used_up || self->thread[t].used_up;
    }
    return used_up;
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
    const bool again = 2.0 * mine->build_motion > self->neighbour.skin;
    mine->wall_motion += self->thread[0].wall_speed * self->state->dt;
    const size_t grains =
        self->spread == NULL ? self->state->grains.count : self->spread->bed.count;
    if (!finite || grains == 0) { // what is not finite cannot be sorted; the next change makes
        return;                   // lists of grains that come
    }
    if (again || is_used_up(self, mine)) {
        if (part == 0) {
            clod_remake_begin(self, again, speed);
        }
        clod_barrier_wait(&self->barrier);
        clod_remake_lists(self, part);
        begin_motion(mine);
        mine->build_motion = again ? 0.0 : mine->build_motion;
    }
}
