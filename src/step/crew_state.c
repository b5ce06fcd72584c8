#include "step/crew_state.h"

#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "mesh/surface_bytes.h"
#include "step/neighbour.h"

/** The numbers of a state. */
typedef struct numbers {
    clod_domain domain;
    double gravity[3];
    double dt, time, adhesion, build_motion, build_skin;
    int64_t step;
    clod_ledger ledger;
    clod_exchange exchange;
    bool keeps_gone;
    int32_t planes; ///< they follow
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
                    .ledger = from->ledger,
                    .exchange = from->exchange,
                    .keeps_gone = from->gone.kept,
                    .planes = from->planes.count};
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
    to->exchange = from->exchange;
    to->gone.kept = from->keeps_gone;
    to->planes.count = from->planes;
    memcpy(to->gravity, from->gravity, sizeof to->gravity);
}

static size_t plane_bytes(const numbers *n)
{
    return (size_t)n->planes * sizeof(clod_plane);
}

static size_t passed_bytes(const numbers *n)
{
    return (size_t)n->planes * sizeof(clod_passed);
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
    memcpy(to->planes.plane, from->planes.plane, plane_bytes(&n));
    memcpy(to->planes.passed, from->planes.passed, passed_bytes(&n));
    for (int32_t w = 0; w < to->walls.count; w++) {
        clod_wall *wall = &to->walls.wall[w];
        const clod_wall *other = &from->walls.wall[w];
        put_wall(wall, other);
        if (other->wear != NULL) {
            memcpy(wall->wear, other->wear, (size_t)other->wear_rows * sizeof *wall->wear);
        }
    }
    if (to->walls.count > 0) { // without walls there is no array
        memcpy(to->build_walls, from->build_walls,
               (size_t)to->walls.count * sizeof *to->build_walls);
    }
}

/** All pages of an array that exists. */
static void forget(void *array, size_t bytes)
{
    if (array != NULL) {
        clod_memory_give_back(array, bytes, bytes);
    }
}

void clod_crew_state_forget(clod_state *state)
{
    clod_row_column columns[CLOD_ROW_COLUMNS];
    const int count = clod_neighbour_columns(&state->grains, columns);
    for (int k = 0; k < count; k++) {
        const clod_row_column *before = k > 0 ? &columns[k - 1] : NULL;
        if (before == NULL || columns[k].array != before->array + before->size) {
            forget(columns[k].array, state->grains.capacity * columns[k].stride);
        } // else it is of the same array
    }
    forget(state->build_position, state->build_capacity * sizeof *state->build_position);
    forget(state->contacts, state->contact_capacity * sizeof *state->contacts);
    state->grains.count = state->contact_count = state->wall_contact_count = 0;
}

void clod_crew_state_tell(clod_ranks *ranks, clod_state *state)
{
    numbers n;
    get_numbers(&n, state);
    clod_ranks_tell(ranks, &n, sizeof n);
    put_numbers(state, &n);
    if (n.planes > 0) {
        clod_ranks_tell(ranks, state->planes.plane, plane_bytes(&n));
        clod_ranks_tell(ranks, state->planes.passed, passed_bytes(&n));
    }
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
        if (wall->wear_rows > 0) { // its sums are added by rank 0: it only says that there are
            wall->wear = clod_memory_alloc(1, sizeof *wall->wear);
            good = good && wall->wear != NULL;
        }
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

/** A surface of a wall that the shape before it does not have. */
static bool begins_surface(const clod_wall *wall, int32_t shape)
{
    const clod_surface *surface = wall->shapes[shape].surface;
    return surface != NULL && (shape == 0 || wall->shapes[shape - 1].surface != surface);
}

/** Bytes of all surfaces, of rank 0; false without memory. */
static bool pack_surfaces(const clod_walls *walls, clod_bytes *to)
{
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            if (begins_surface(&walls->wall[w], s)) {
                clod_surface_pack(walls->wall[w].shapes[s].surface, to);
            }
        }
    }
    return !to->lacks_memory;
}

/** Surfaces in place of the pointers that came from rank 0, or NULL if it is not `good`; whether
 *  it is. */
static bool unpack_surfaces(clod_wall *wall, bool good, const char **at)
{
    const clod_surface *before = NULL; // as rank 0 knows it
    clod_surface *surface = NULL;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape *shape = &wall->shapes[s];
        const clod_surface *there = shape->surface;
        if (there != NULL && there != before) {
            surface = good ? clod_surface_unpack(at) : NULL;
            good = surface != NULL;
            shape->surface = surface;
        } else if (there != NULL) {
            shape->surface = clod_surface_share(surface);
        }
        before = there;
    }
    return good;
}

static bool tell_surfaces(clod_ranks *ranks, clod_walls *walls, clod_status *status)
{
    clod_bytes all = {0};
    const bool first = ranks->rank == 0;
    bool good = !first || pack_surfaces(walls, &all);
    size_t bytes = all.count;
    clod_ranks_tell(ranks, &bytes, sizeof bytes);
    good = good && (first || clod_room_for(&all.data, &all.capacity, bytes, 1));
    good = clod_ranks_agree(ranks, good || fail(status), status);
    if (good) {
        clod_ranks_tell(ranks, all.data, bytes);
    }
    const char *at = all.data;
    bool unpacked = good;
    for (int32_t w = 0; !first && w < walls->count; w++) {
        unpacked = unpack_surfaces(&walls->wall[w], unpacked, &at);
    }
    clod_bytes_fini(&all);
    return good && clod_ranks_agree(ranks, unpacked || fail(status), status);
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
    return tell_shapes(ranks, &state->walls, status) &&
           tell_surfaces(ranks, &state->walls, status);
}
