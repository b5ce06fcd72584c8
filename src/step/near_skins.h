#pragma once
/**
 * @file near_skins.h
 * How long a near list holds: each grain has a course, the way that it is expected to go, and a skin
 * of its own, by which it may leave it. A run of rows is looked at only when its grains may have
 * used up a skin (docs/adr/0037, 0044).
 */

#include <math.h>

#include "step/near.h"

/** Most rows of a watch; it begins where their number is divided by that. */
#define CLOD_NEAR_WATCHED 64

/** What a look at some grains tells. */
typedef struct clod_near_seen {
    double left; ///< m, least left of their skins; below 0 a pair that is not listed may touch
    double fastest;    ///< m/s, of their courses
    double gone;       ///< m, sum of the ways from where they were when the list was made
    double off_course; ///< m, sum of the ways from where they were expected now
} clod_near_seen;

void clod_near_choose_skins(const clod_near_job *job, int part); ///< of the grains, and courses
void clod_near_note(const clod_near_job *job, int part);         ///< where the grains are

/** Watches of so many rows, cut by parts and by runs of own rows. */
static inline size_t clod_near_watches(size_t rows, size_t cuts)
{
    return rows / CLOD_NEAR_WATCHED + cuts + 1;
}

/**
 * Look at grains [begin, end).
 *
 * @param age  s, of the list
 * Errors  none.   Threads  pure.   Source  docs/adr/0044.   Test  tests/step/test_thin_skin.c
 */
clod_near_seen clod_near_look(const clod_near *self, const clod_state *state, double age,
                              size_t begin, size_t end);

/**
 * Where a grain can be while the list holds: within so much of a place, the middle of its course.
 *
 * @param middle  [out] m
 * @return        m
 */
static inline double clod_near_middle(const clod_near_job *job, size_t grain, double middle[3])
{
    const double *p = job->state->grains.position[grain];
    const float *course = job->near->course[grain];
    const double half = job->near->follow ? 0.5 * job->skins.horizon : 0.0;
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        const double way = half * (double)course[a];
        middle[a] = p[a] + way;
        square += way * way;
    }
    return (double)course[3] + sqrt(square);
}
