#include "step/near_skins.h"

#include <math.h>

#include "parallel/threads.h"

/** Rows [begin, end) of so many that are a part's to look at before there is a cut. */
static clod_chunk rows_of(const clod_near_job *job, int part)
{
    return clod_threads_chunk(job->state->grains.count, part, job->near->parts);
}

void clod_near_choose_skins(const clod_near_job *job, int part)
{
    const clod_near_skins *skins = &job->skins;
    const clod_chunk rows = rows_of(job, part);
    for (size_t g = rows.begin; g < rows.end; g++) {
        const double *v = job->state->grains.velocity[g];
        const double speed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        job->near->course[g][3] = (float)fmin(skins->least + skins->time * speed, skins->most);
        for (int a = 0; a < 3; a++) {
            job->near->course[g][a] = (float)v[a];
        }
    }
}

void clod_near_note(const clod_near_job *job, int part)
{
    const clod_grains *grains = &job->state->grains;
    const double(*built)[4] = clod_neighbour_places(job->neighbour, job->state);
    const clod_chunk rows = rows_of(job, part);
    for (size_t g = rows.begin; g < rows.end; g++) {
        for (int a = 0; a < 3; a++) {
            job->near->origin[g][a] = (float)(grains->position[g][a] - built[g][a]);
        }
    }
}

static double length_of(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

clod_near_seen clod_near_look(const clod_near *self, const clod_state *state, double age,
                              size_t begin, size_t end)
{
    clod_near_seen seen = {.left = INFINITY};
    for (size_t g = begin; g < end; g++) {
        const double *p = state->grains.position[g], *built = state->build_position[g];
        const float *origin = self->origin[g];
        const double x = p[0] - built[0] - (double)origin[0];
        const double y = p[1] - built[1] - (double)origin[1];
        const double z = p[2] - built[2] - (double)origin[2];
        const double u = (double)self->course[g][0], v = (double)self->course[g][1],
                     w = (double)self->course[g][2];
        const double gone = length_of(x, y, z);
        const double off = length_of(x - age * u, y - age * v, z - age * w);
        const double speed = u * u + v * v + w * w;
        const double left = (double)self->course[g][3] - (self->follow ? off : gone);
        seen.left = left < seen.left ? left : seen.left;
        seen.fastest = speed > seen.fastest ? speed : seen.fastest;
        seen.gone += gone;
        seen.off_course += off;
    }
    seen.left -= self->rounding;
    seen.fastest = self->follow ? sqrt(seen.fastest) : 0.0;
    return seen;
}
