#pragma once
/**
 * @file kernel_batch.h
 * The passes that contacts between grains and with walls share: a few blocks of one law at a
 * time, vector by vector. Included by kernel.c only.
 *
 * One contact is a long chain of operations that wait for each other, and a short pass has room
 * in the processor's window for the chains of several (docs/adr/0010, 0019, 0021).
 */

#include "law/law_contact.h"
#include "step/kernel.h"

/** Blocks whose contacts go through each pass together. */
#define KERNEL_BATCH 4

/** Blocks by which histories are prefetched into the second cache (docs/adr/0021). */
#define KERNEL_AHEAD 32

/** Where blocks of a kind have their histories [bytes]. */
typedef struct kernel_layout {
    size_t block, history;
} kernel_layout;

/** How a grain meets its partner. */
typedef struct kernel_meeting {
    clod_law_touch touch;
    vreal arm_i, arm_j; ///< as in clod_law_motion; for the torques
} kernel_meeting;

/** A few blocks of one law on their way through the passes. */
typedef struct kernel_batch {
    char *blocks;
    const char *end; ///< behind the last block of all batches
    int contacts;    ///< the last block may have lanes without one
    int vectors;
    kernel_meeting meeting[KERNEL_BATCH * CLOD_LANES / CLOD_WIDTH];
    clod_law_trial trial[KERNEL_BATCH * CLOD_LANES / CLOD_WIDTH];
} kernel_batch;

/** The block of a vector. */
static inline void *kernel_block(const kernel_batch *batch, kernel_layout layout, int k)
{
    return batch->blocks + (size_t)(k * CLOD_WIDTH / CLOD_LANES) * layout.block;
}

/** Its first lane there. */
static inline int kernel_lane(int k)
{
    return k * CLOD_WIDTH % CLOD_LANES;
}

static inline clod_history *kernel_history(const kernel_batch *batch, kernel_layout layout,
                                           int k)
{
    return (clod_history *)((char *)kernel_block(batch, layout, k) + layout.history);
}

static inline clod_law_memory kernel_memory(const kernel_batch *batch, kernel_layout layout,
                                            int k)
{
    return clod_law_memory_load(kernel_history(batch, layout, k), kernel_lane(k));
}

/** Begin with the blocks from number `first` of `contacts` on. */
static inline void kernel_batch_begin(kernel_batch *batch, kernel_layout layout, void *blocks,
                                      size_t first, size_t contacts)
{
    const size_t full = (size_t)KERNEL_BATCH * CLOD_LANES;
    batch->blocks = (char *)blocks + first / CLOD_LANES * layout.block;
    batch->end = (char *)blocks + (contacts + CLOD_LANES - 1) / CLOD_LANES * layout.block;
    batch->contacts = (int)(contacts - first < full ? contacts - first : full);
    batch->vectors = (batch->contacts + CLOD_WIDTH - 1) / CLOD_WIDTH;
}

/** Contacts of a vector. */
static inline int kernel_lanes(const kernel_batch *batch, int k)
{
    const int left = batch->contacts - k * CLOD_WIDTH;
    return left < CLOD_WIDTH ? left : CLOD_WIDTH;
}

/** Springs between two passes lie in the history. */
static inline void kernel_springs_store(const clod_law *law, clod_history *history, int lane,
                                        const clod_law_memory *memory)
{
    vreal3_store(history->spring, lane, memory->spring);
    if (clod_law_rolling_springs(law)) {
        vreal3_store(history->roll, lane, memory->roll);
    }
}

/** Prefetch the block that comes KERNEL_AHEAD behind that of a vector. */
static inline void kernel_prefetch_block(const kernel_batch *batch, kernel_layout layout, int k)
{
    const char *block = (const char *)kernel_block(batch, layout, k);
    if (kernel_lane(k) == 0 && batch->end - block > (ptrdiff_t)(KERNEL_AHEAD * layout.block)) {
        for (size_t at = 0; at < layout.block; at += 64) {
            __builtin_prefetch(block + KERNEL_AHEAD * layout.block + at, 1, 2);
        }
    }
}

/** Second pass: normal forces, and springs turned. Open contacts forget their P. */
CLOD_LAW_PASS void kernel_batch_press(const clod_law *law, double dt, kernel_layout layout,
                                      kernel_batch *batch)
{
    for (int k = 0; k < batch->vectors; k++) {
        kernel_prefetch_block(batch, layout, k);
        clod_history *history = kernel_history(batch, layout, k);
        const int lane = kernel_lane(k);
        clod_law_memory memory = kernel_memory(batch, layout, k);
        clod_law_press(law, &batch->meeting[k].touch, dt, &memory, &batch->trial[k]);
        const vmask closed = vmask_less(vreal_set(0.0), batch->meeting[k].touch.overlap);
        vreal_store(&history->plastic[lane],
                    vreal_select(closed, memory.plastic, vreal_set(0.0)));
        kernel_springs_store(law, history, lane, &memory);
    }
}

/** Third pass: springs as they stay. Open contacts forget them and their tangent. */
CLOD_LAW_PASS void kernel_batch_carry(const clod_law *law, double dt, kernel_layout layout,
                                      kernel_batch *batch)
{
    const vreal3 none = {vreal_set(0.0), vreal_set(0.0), vreal_set(0.0)};
    clod_law_memory next = kernel_memory(batch, layout, 0);
    clod_law_inverses inverses = clod_law_carry_begin(law, &batch->trial[0], &next);
    for (int k = 0; k < batch->vectors; k++) {
        const clod_law_inverses now = inverses;
        if (k + 1 < batch->vectors) {
            next = kernel_memory(batch, layout, k + 1);
            inverses = clod_law_carry_begin(law, &batch->trial[k + 1], &next);
        }
        clod_history *history = kernel_history(batch, layout, k);
        const int lane = kernel_lane(k);
        clod_law_memory memory = kernel_memory(batch, layout, k);
        clod_law_carry(law, &batch->meeting[k].touch, dt, &now, &memory, &batch->trial[k]);
        const vmask closed = vmask_less(vreal_set(0.0), batch->meeting[k].touch.overlap);
        vreal_store(&history->tangent[lane],
                    vreal_select(closed, memory.tangent, vreal_set(0.0)));
        memory.spring = vreal3_select(closed, memory.spring, none);
        memory.roll = vreal3_select(closed, memory.roll, none);
        kernel_springs_store(law, history, lane, &memory);
    }
}

/**
 * Last pass for one vector: limits of spring and dash-pot together.
 *
 * @param cuts  [in,out] of this vector; becomes those of the next one
 */
CLOD_LAW_PASS clod_law_result kernel_batch_limit(const clod_law *law, const kernel_batch *batch,
                                                 int k, clod_law_cuts *cuts)
{
    const clod_law_cuts now = *cuts;
    if (k + 1 < batch->vectors) {
        *cuts = clod_law_limit_begin(law, &batch->trial[k + 1]);
    }
    return clod_law_limit(law, &batch->meeting[k].touch, &batch->trial[k], &now);
}

/** A law with its choices as constants. */
static inline clod_law kernel_law_known(clod_law law, clod_law_kind kind, clod_rolling rolling)
{
    law.kind = kind;
    law.exponent_kind = CLOD_EXPONENT_THREE_HALVES;
    law.tangential = CLOD_TANGENTIAL_TANGENT;
    law.rolling = rolling;
    return law;
}

/** Whether these choices are those of kernel_law_known; the scalar set is the reference and
 * knows none (docs/adr/0021). */
static inline bool kernel_law_is(const clod_law *law, clod_law_kind kind, clod_rolling rolling)
{
    return CLOD_WIDTH > 1 && law->exponent_kind == CLOD_EXPONENT_THREE_HALVES &&
           law->tangential == CLOD_TANGENTIAL_TANGENT && law->kind == kind &&
           law->rolling == rolling;
}
