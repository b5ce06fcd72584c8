#pragma once
/**
 * @file near.h
 * The pairs of the force loop, as blocks of one law each: candidates that can touch before one of
 * the two grains has left its course by more than its own skin. Made anew when a grain has. Pairs
 * that do not touch add exactly zero, so the list itself never changes a bit.
 *
 * The grains are cut into parts, runs of rows with about as much work each, one part for each
 * thread. Blocks lie in groups: for each part and law the contacts within the part, then for
 * each part and law those with grains of earlier parts; within a group contacts ascend by
 * (i, j). Contacts with walls lie in a group for each part, law and form of shape, ascending
 * by (i, wall, shape).
 */

#include "step/kernel.h"
#include "step/neighbour.h"
#include "step/passages.h"
#include "step/touch_lists.h"

typedef struct clod_near_blocks {
    void *block; ///< clod_contact_block or clod_wall_block
    size_t count, capacity;
    size_t *group_start; ///< [groups + 1] first block of each group
    size_t *group_count; ///< [groups] contacts of each group; behind them scratch [groups]
    clod_dissipation_block *dissipated; ///< [count] with the ledger, else NULL
    size_t dissipated_capacity;
    clod_rub_block *rub; ///< [count] of walls with the sums of surfaces, else NULL
    size_t rub_capacity;
} clod_near_blocks;

/** Contacts [begin, end) of a later part's group whose i are in one earlier part. */
typedef struct clod_near_run {
    int later;
    size_t begin, end;
} clod_near_run;

/** Contacts between two parts: i's shares wait in rows until the earlier part takes them. */
typedef struct clod_near_between {
    double (*share)[8]; ///< of each lane of these groups
    clod_near_run *run; ///< by law, earlier part, later part
    size_t *run_start;  ///< [laws * parts + 1] first run of each law and earlier part
    size_t share_capacity, run_capacity;
} clod_near_between;

/** Contacts of one group, or of a run of one, as a cursor goes along them (near_cursor.h). */
typedef struct clod_near_source {
    const char *block; ///< first block of the group
    uint64_t key;      ///< of the contact that it is at; UINT64_MAX: at its end
    size_t at, end;    ///< contacts of the group
    size_t given;      ///< bytes of the list's array up to which memory is given back
} clod_near_source;

/** Contacts of one part in the state's list. */
typedef struct clod_near_range {
    size_t pair, pairs; ///< the first, and how many
    size_t wall, walls;
} clod_near_range;

/** What is known of a run of rows since they were last looked at (near_skins.h). */
typedef struct clod_near_watch {
    double left;    ///< m, no more than the least that was left of a skin then
    double motion;  ///< m, no less than what a grain can have left its course by since
    double fastest; ///< m/s, of their courses
    bool noted;     ///< what there is to know of planes, in `passage`
} clod_near_watch;

typedef struct clod_near {
    float (*origin)[3]; ///< [grains] m, where each was then, from its place at the last rebuild
    float (*course)[4]; ///< [grains] m/s, as each moved then; m, by which it may leave that
    clod_near_watch *watch; ///< [rows and cuts: clod_near_watches]
    clod_passage *passage;  ///< [rows and cuts: clod_near_watches][planes]
    size_t origin_capacity, course_capacity, watch_capacity, passage_capacity;
    bool follow;      ///< grains are expected to go on along their courses; else to stay
    double horizon;   ///< s, that the list holds at most when they are
    double rounding;  ///< m, no less than what the two above are wrong by
    double wall_skin; ///< m, by which walls may move
    int32_t laws;
    int parts;          ///< set before the first list
    size_t *part_start; ///< [parts + 1] first grain of each part
    clod_near_blocks pairs, walls;
    clod_near_between between;
    int32_t *weight; ///< scratch [grains]: work of each grain
    size_t weight_capacity;
    clod_touch touch;     ///< contacts with meshes
    clod_fixed *wall_sum; ///< [sum_start[walls]] forces of the grains of a part on a wall
    int32_t *sum_start;   ///< [walls + 1] first sum of each wall; one for each part that it has
    int32_t *part_sum;    ///< [parts][walls] number of a part's sum of a wall, or -1
    bool crowded;         ///< a sum may get more than CLOD_FIXED_ADDENDS in a step
    size_t wall_sum_capacity, sum_start_capacity, part_sum_capacity;
    clod_near_source *source;  ///< scratch of cursors: [parts][clod_near_sources]
    size_t *part_fill;         ///< scratch [parts][groups]: where a part's next pair goes
    clod_near_range *gathered; ///< scratch [parts]: contacts of each part
    bool made;                 ///< the list stands; false: the histories are in the state
    bool ledger;               ///< keep room for what the contacts dissipate
    bool wear;                 ///< keep room for how grains rub walls
} clod_near;

/** Group of a law's contacts within a part. */
static inline size_t clod_near_group(const clod_near *self, int part, int32_t law)
{
    return (size_t)part * (size_t)self->laws + (size_t)law;
}

/** Group of a law's contacts of grains of a part, as j, with grains of earlier ones. */
static inline size_t clod_near_group_between(const clod_near *self, int later, int32_t law)
{
    return clod_near_group(self, self->parts + later, law);
}

/** Groups of one list. */
static inline size_t clod_near_groups(const clod_near *self)
{
    return clod_near_group(self, 2 * self->parts, 0);
}

/** Group of a law's contacts of grains of a part with shapes of a form. */
static inline size_t clod_near_wall_group(const clod_near *self, int part, int32_t law,
                                          clod_wall_form form)
{
    return clod_near_group(self, part, law) * CLOD_FORMS + (size_t)form;
}

/** Groups of the list of walls. */
static inline size_t clod_near_wall_groups(const clod_near *self)
{
    return clod_near_wall_group(self, self->parts, 0, (clod_wall_form)0);
}

/** Most groups and runs that a part's contacts of one list lie in. */
static inline size_t clod_near_sources(const clod_near *self)
{
    const size_t most = self->parts > CLOD_FORMS ? (size_t)self->parts : CLOD_FORMS;
    return (size_t)self->laws * most;
}

/** What the own skin of each grain follows from: it may leave its course by that until a list is
 *  made anew (docs/adr/0037, 0044). */
typedef struct clod_near_skins {
    double time;        ///< s, a grain's speed times this
    double least, most; ///< m, and the first added, at most the second
    bool follow;        ///< grains are expected to go on along their courses; else to stay
    double horizon;     ///< s, that the list holds at most when they are
    double wall;        ///< m, the same of walls
    double largest;     ///< m, radius of the largest grain
} clod_near_skins;

/** What goes through the making of one list, for all threads. */
typedef struct clod_near_job {
    clod_near *near;
    clod_neighbour *neighbour; ///< candidates; it is noted which are near
    clod_state *state;
    const clod_laws *laws;
    const clod_wall_rows *walls; ///< where they are now
    clod_near_skins skins;
    size_t runs; ///< of rows that are this rank's own; 1 without ranks
} clod_near_job;

/**
 * Make the near list, in steps: those with a `part` for every part, in any order or at the same
 * time; the others once. The histories of state->contacts go into the blocks, and the state's
 * list is empty then; without memory they stay there, and there is no list.
 *
 * @return  false without memory
 * Errors  CLOD_FAILED.   Test  tests/step/test_near_parts.c, test_same_bits.c
 */
bool clod_near_begin(const clod_near_job *job, clod_status *status);
void clod_near_mark(const clod_near_job *job, int part); ///< which candidates are near
void clod_near_cut(const clod_near_job *job);            ///< parts of about the same work
void clod_near_count(const clod_near_job *job, int part);
bool clod_near_layout(const clod_near_job *job, clod_status *status); ///< and all walls
void clod_near_place(const clod_near_job *job, int part);
void clod_near_end(const clod_near_job *job);

/** Give skins, courses and origins of a large bed back to the system: the next list has new ones. */
void clod_near_give_skins_back(clod_near *self);

/** All of that by one thread. */
bool clod_near_make(const clod_near_job *job, clod_status *status);

/** Room for what each contact of the list dissipates, when `ledger` is set, and for how it rubs. */
bool clod_near_reserve_dissipated(clod_near *self);

/**
 * Copy every contact with its history into state->contacts (emptied first): pairs ascending by
 * (i, j), then walls by (i, wall, shape). In steps, as the making of a list.
 *
 * @param walls    the rows that the list was made with
 * @param release  the list is not needed any more: its memory is given back as it is read
 * @return         false without memory; nothing is lost
 */
void clod_near_gather_count(clod_near *self, int part);
bool clod_near_gather_room(clod_near *self, clod_state *state, clod_status *status);
void clod_near_gather_copy(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                           int part, bool release);

/** The list is no more: the histories are in the state. */
void clod_near_gather_end(clod_near *self);

/** Room in the state for so many contacts of pairs and with walls; false without memory. */
bool clod_near_gather_reserve(const clod_near *self, clod_state *state, size_t pairs,
                              size_t walls, clod_status *status);

/** Copy by one thread, and the list stays; nothing to do when there is none. */
bool clod_near_gather(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                      clod_status *status);

void clod_near_fini(clod_near *self);
