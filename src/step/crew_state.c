#include "step/crew_state.h"

#include <string.h>

#include "base/memory.h"

/** The numbers of a state. */
typedef struct numbers {
    clod_domain domain;
    double gravity[3];
    double dt, time, adhesion, build_motion, build_skin;
    int64_t step;
    clod_ledger ledger;
} numbers;

static void get_numbers(numbers *to, const clod_state *from)
{
    *to = (numbers){.domain = from->domain,
                    .dt = from->dt,
                    .time = from->time,
                    .adhesion = from->adhesion,
                    .build_motion = from->build_motion,
                    .build_skin = from->build_skin,
                    .step = from->step,
                    .ledger = from->ledger};
    memcpy(to->gravity, from->gravity, sizeof to->gravity);
}

static void put_numbers(clod_state *to, const numbers *from)
{
    to->domain = from->domain;
    to->dt = from->dt;
    to->time = from->time;
    to->adhesion = from->adhesion;
    to->build_motion = from->build_motion;
    to->build_skin = from->build_skin;
    to->step = from->step;
    to->ledger = from->ledger;
    memcpy(to->gravity, from->gravity, sizeof to->gravity);
}

/** A wall as another one is, but for what it owns. */
static void put_wall(clod_wall *to, const clod_wall *from)
{
    const clod_wall own = *to;
    *to = *from;
    to->shapes = own.shapes;
    to->wear = own.wear;
}

void clod_crew_state_copy(clod_state *to, const clod_state *from)
{
    numbers n;
    get_numbers(&n, from);
    put_numbers(to, &n);
    for (int32_t w = 0; w < to->walls.count; w++) {
        put_wall(&to->walls.wall[w], &from->walls.wall[w]);
    }
    memcpy(to->build_walls, from->build_walls,
           (size_t)to->walls.count * sizeof *to->build_walls);
}

void clod_crew_state_tell(clod_ranks *ranks, clod_state *state)
{
    numbers n;
    get_numbers(&n, state);
    clod_ranks_tell(ranks, &n, sizeof n);
    put_numbers(state, &n);
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall wall = state->walls.wall[w];
        clod_ranks_tell(ranks, &wall, sizeof wall);
        put_wall(&state->walls.wall[w], &wall);
    }
    clod_ranks_tell(ranks, state->build_walls,
                    (size_t)state->walls.count * sizeof *state->build_walls);
}

static bool fail(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for the walls of another rank");
}

/** Shapes of all walls, of which rank 0 has told the numbers. */
static bool tell_shapes(clod_ranks *ranks, clod_walls *walls, clod_status *status)
{
    bool good = true;
    for (int32_t w = 0; ranks->rank > 0 && w < walls->count; w++) {
        clod_wall *wall = &walls->wall[w];
        wall->shapes = clod_memory_alloc((size_t)wall->shape_count, sizeof *wall->shapes);
        good = good && wall->shapes != NULL;
    }
    if (!clod_ranks_agree(ranks, good || fail(status), status)) {
        return false;
    }
    for (int32_t w = 0; w < walls->count; w++) {
        clod_wall *wall = &walls->wall[w];
        clod_ranks_tell(ranks, wall->shapes, (size_t)wall->shape_count * sizeof *wall->shapes);
    }
    return true;
}

bool clod_crew_state_begin(clod_ranks *ranks, clod_state *state, clod_laws *laws,
                           clod_status *status)
{
    int32_t counts[3] = {state->walls.count, laws->materials, laws->count};
    clod_ranks_tell(ranks, counts, sizeof counts);
    const size_t count = (size_t)counts[0];
    if (ranks->rank > 0) {
        state->walls.wall = clod_memory_alloc(count + 1, sizeof *state->walls.wall);
        state->build_walls = clod_memory_alloc(count + 1, sizeof *state->build_walls);
        *laws = (clod_laws){.materials = counts[1], .count = counts[2]};
        laws->law = clod_memory_alloc((size_t)laws->count, sizeof *laws->law);
    }
    const bool good =
        state->walls.wall != NULL && state->build_walls != NULL && laws->law != NULL;
    if (!clod_ranks_agree(ranks, good || count == 0 || fail(status), status)) {
        return false;
    }
    state->walls.count = counts[0];
    clod_ranks_tell(ranks, laws->law, (size_t)laws->count * sizeof *laws->law);
    clod_crew_state_tell(ranks, state);
    return tell_shapes(ranks, &state->walls, status);
}
