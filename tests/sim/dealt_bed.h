#pragma once
/**
 * @file dealt_bed.h
 * A bed made by one process, and the same dealt to ranks while it is made; what each rank had in large
 * blocks at most. The program is linked so that calls for memory come here (tools/tests.cmake).
 */

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "clod/case.h"
#include "law/law.h"
#include "setup/grains.h"
#include "setup/state.h"
#include "sim/deal.h"
#include "step/crew.h"
#include "support/bits.h"
#include "support/case_of.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

// ---- what a rank has in large blocks at most

#define LARGE 65536 ///< bytes

static _Thread_local int64_t live, most;
/** Asks for memory that are granted before one is not; negative: all are. */
static _Thread_local int asks = -1;
static _Thread_local bool refused;

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names them
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void __real_free(void *memory);
void __wrap_free(void *memory);

static int64_t large_bytes(void *memory)
{
    const size_t bytes = memory != NULL ? malloc_usable_size(memory) : 0;
    return bytes >= LARGE ? (int64_t)bytes : 0;
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    const bool refuse = asks == 0;
    asks -= asks >= 0;
    refused = refused || refuse;
    void *memory = refuse ? NULL : __real_aligned_alloc(alignment, size);
    live += large_bytes(memory);
    most = live > most ? live : most;
    return memory;
}

void __wrap_free(void *memory)
{
    live -= large_bytes(memory);
    __real_free(memory);
}

// ---- beds

#define MATERIALS                                                                              \
    "materials:\n"                                                                             \
    "  ore: {density: 2000 kg/m3}\n"                                                           \
    "  sand: {density: 2600 kg/m3}\n"                                                          \
    "  steel: {}\n"                                                                            \
    "contacts:\n"                                                                              \
    "  default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.4}\n"
#define STAGES "stages:\n  - {name: settle, duration: 1 s}\n"
#define FLOOR                                                                                  \
    "walls:\n"                                                                                 \
    "  floor: {material: steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n"

/** A case made into a bed, and stepped a little. */
typedef struct made_bed {
    clod_state state;
    clod_setup_bed bed;
    clod_laws laws;
    clod_step step;
} made_bed;

/** The same by ranks. */
typedef struct dealt_bed {
    const clod_case *from;
    int64_t steps;
    size_t piece;
    int64_t
        most[RANKS_MOST]; ///< bytes of each rank in large blocks, before the bed is gathered
    int64_t made; ///< the same of rank 0 until the bed is made: ranks do not make lists yet
    made_bed *into;
} dealt_bed;

static inline void step(made_bed *self, const clod_case *from, int64_t steps,
                        clod_step_options how)
{
    clod_status status = {0};
    how.threads = 1;
    if (!clod_laws_init(&self->laws, from, &status) ||
        !clod_step_init(&self->step, &self->state, &self->laws, &how, &status) ||
        !clod_step_advance(&self->step, steps, &status)) {
        fail_msg("%s", status.text);
    }
}

static inline void gather(made_bed *self)
{
    clod_status status = {0};
    if (!clod_step_export(&self->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static inline void end(made_bed *self)
{
    clod_step_fini(&self->step);
    clod_laws_fini(&self->laws);
    clod_state_fini(&self->state);
}

static inline void make_alone(made_bed *self, const clod_case *from, int64_t steps)
{
    clod_status status = {0};
    *self = (made_bed){0};
    if (!clod_setup_state_give(from, 3, NULL, &self->state, &self->bed, &status)) {
        fail_msg("%s", status.text);
    }
    step(self, from, steps, (clod_step_options){0});
    gather(self);
}

/** Make the bed and deal it. */
static inline bool give(dealt_bed *self, clod_ranks *ranks, clod_status *status)
{
    clod_deal deal;
    assert_non_null(clod_deal_begin(&deal, ranks, self->from));
    deal.taker.piece = self->piece;
    const bool good = clod_setup_state_give(self->from, 3, &deal.taker, &self->into->state,
                                            &self->into->bed, status);
    clod_deal_fini(&deal);
    return good;
}

static inline void run_rank(clod_ranks *ranks, void *context)
{
    dealt_bed *how = context;
    live = most = 0;
    asks = -1;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        how->most[ranks->rank] = most;
        return;
    }
    clod_status status = {0};
    clod_crew_share share = {0};
    const clod_step_options options = {.ranks = ranks, .dealt = &share};
    *how->into = (made_bed){0};
    if (!give(how, ranks, &status)) {
        fail_msg("%s", status.text);
    }
    how->made = most;
    step(how->into, how->from, how->steps, options);
    how->most[0] = most;
    gather(how->into);
    clod_crew_end(&how->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** All that setup has asked of the grains, and all that followed from it. */
static inline void check_same_bed(const made_bed *one, const made_bed *several)
{
    check_same_bits(&one->state, &several->state);
    assert_memory_equal(&one->bed, &several->bed, sizeof one->bed);
    assert_memory_equal(&one->state.domain, &several->state.domain, sizeof one->state.domain);
    assert_memory_equal(&one->state.dt, &several->state.dt, sizeof one->state.dt);
    for (int32_t w = 0; w < one->state.walls.count; w++) {
        assert_true(one->state.walls.wall[w].damping == several->state.walls.wall[w].damping);
    }
}

/** No two grains overlap. */
static inline void check_apart(const clod_state *state)
{
    clod_status status = {0};
    clod_setup_overlap worst;
    assert_true(clod_setup_worst_overlap(state, &worst, &status));
    assert_true(worst.overlap == 0.0);
}

static inline void compare(const char *text, int64_t steps)
{
    static const int RANKS[] = {2, 3, 4, 7, 16};
    clod_case *from = case_of(text, NULL);
    made_bed one, several;
    make_alone(&one, from, steps);
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        if (left_out(k, 3)) {
            continue;
        }
        dealt_bed how = {.from = from, .steps = steps, .piece = 100, .into = &several};
        ranks_run(RANKS[k], run_rank, &how);
        check_same_bed(&one, &several);
        end(&several);
    }
    end(&one);
    clod_case_destroy(&from);
}

// A row has 32 bytes of position and radius, 32 of velocity and mass, 32 of spin and inertia, 64 of
// force and torque, 8 of id, 8 of birth, 2 of material, and 32 of its place at the last rebuild: 210. All
// rows on rank 0 would be beside what every other rank has, too.
#define ROW_BYTES 210

enum { LIST_RANKS = 8, LIST_PIECE = 2000 }; ///< of a bed in which lists would be seen

/** What ranks have in large blocks at most [bytes]. */
typedef struct byte_counts {
    int64_t made;   ///< rank 0, while the bed is made: before ranks move rows and make lists
    int64_t first;  ///< rank 0, until the end of the first steps
    int64_t others; ///< the most of another rank
} byte_counts;

/** What ranks have in large blocks while a bed is made, by rank 0 and the most of another, in bytes. */
static inline byte_counts count_bytes(const char *text, size_t grains)
{
    clod_case *from = case_of(text, NULL);
    made_bed one, several;
    make_alone(&one, from, 2);
    check_apart(&one.state);
    assert_int_equal(one.state.grains.count, grains);
    dealt_bed how = {.from = from, .steps = 2, .piece = LIST_PIECE, .into = &several};
    ranks_run(LIST_RANKS, run_rank, &how);
    check_same_bed(&one, &several);
    byte_counts found = {.made = how.made, .first = how.most[0]};
    for (int r = 1; r < LIST_RANKS; r++) {
        found.others = how.most[r] > found.others ? how.most[r] : found.others;
    }
    end(&several);
    end(&one);
    clod_case_destroy(&from);
    return found;
}
