#pragma once
/**
 * @file kernel.h
 * The inner loops of the step. kernel.c is compiled once per instruction set; the set is chosen
 * at start-up. All sets give the same bits.
 */

#include <stdbool.h>
#include <stddef.h>

#include "geometry/wall_closest.h"
#include "law/law.h"
#include "parallel/fixed.h"
#include "state/contacts.h"

/** Arrays and numbers the contact loops read; rows as in state/grains.h. */
typedef struct clod_kernel_view {
    const double (*position)[4];
    const double (*velocity)[4];
    const double (*angular_velocity)[4];
    const double (*before)[8]; ///< loads of the last step, with the ledger
    double (*load)[8];         ///< where contacts add their force and torque on each grain
    clod_fixed *wall_sum;      ///< of forces on walls: columns below
    const double (*shape)[4];  ///< rows of the walls' shapes (geometry/wall_rows.h)
    const double (*touch)[4];  ///< direction and distance of contacts with meshes (touch.h)
    size_t lead;               ///< rows by which memory is prefetched
    double dt;                 ///< s
    double overlap_limit;      ///< fraction of the smaller radius
    double period[3];          ///< m; 0 where the domain is open
    double inverse_period[3];  ///< 1/m
} clod_kernel_view;

/** Columns of what each contact of a wall does to it. */
enum {
    CLOD_WALL_SUM_FORCE = 0,      ///< N, [3]: of the grain on the wall
    CLOD_WALL_SUM_BELT_POWER = 3, ///< W, of the belt on the grain
    CLOD_WALL_SUM_TORQUE = 4,     ///< N m, [3]: of the grain on the wall, about its origin
};

/** What the contacts of a block turned into heat in one step [J]. */
typedef struct clod_dissipation_block {
    double plastic[CLOD_LANES], dash_pot[CLOD_LANES], friction[CLOD_LANES], rolling[CLOD_LANES];
    double lag[CLOD_LANES]; ///< work beyond that, either sign (docs/theory/energy.md)
} clod_dissipation_block;

/** How the grains of a block rub and hit the surfaces of walls. */
typedef struct clod_rub_block {
    double did[CLOD_LANES][8];    ///< each contact in this step: its addends (state/wear.h)
    double normal[3][CLOD_LANES]; ///< of the contact, unit
    double approach[CLOD_LANES];  ///< speed of the centre towards the surface [m/s]
    double speed2[CLOD_LANES]; ///< squared velocity of the centre against the material [m2/s2]
    double mass[CLOD_LANES];   ///< of the grain [kg]
    double closed[CLOD_LANES]; ///< 0: open; 1: in contact; 2: since this step
} clod_rub_block;

/** What the contacts of a block store [J]. */
typedef struct clod_stored_block {
    double normal[CLOD_LANES], sliding[CLOD_LANES], rolling[CLOD_LANES];
} clod_stored_block;

/** Places among which those near one are searched. */
typedef struct clod_kernel_search {
    const double *place[4];   ///< x, y, z and radius of each [m]; readable 8 beyond the last
    const int32_t *row;       ///< of each
    double skin;              ///< m
    double period[3];         ///< m; 0 where the domain is open
    double inverse_period[3]; ///< 1/m
} clod_kernel_search;

/** Where grains are and will be while a near list holds (near_skins.h). */
typedef struct clod_kernel_courses {
    const double (*position)[4];
    const float (
        *course)[4];  ///< m/s, as each is expected to move; m, by which it may leave that
    double horizon;   ///< s, that the list holds at most; 0: all are expected to stay
    double period[3]; ///< m; 0 where the domain is open
    double inverse_period[3]; ///< 1/m
} clod_kernel_courses;

/** What drift saw: the fastest grain, and whether every number is finite. */
typedef struct clod_kernel_speed {
    double max_speed2; ///< m2/s2
    bool finite;
} clod_kernel_speed;

typedef struct clod_kernel {
    const char *name;
    int width;
    /**
     * Force of `contacts` contacts of one law, added to the loads in their order; true when an
     * overlap is beyond the limit.
     *
     * @param end    row behind the last one to prefetch: that of the part; 0: no rows are;
     *               histories always are
     * @param apart  NULL, or rows [contacts, whole blocks] that take i's shares instead of the
     *               loads; j's go into the loads
     */
    bool (*contact)(const clod_kernel_view *view, const clod_law *law,
                    clod_contact_block *blocks, size_t contacts, size_t end,
                    double (*apart)[8]);
    /**
     * Force of `contacts` wall contacts of one law, with shapes of one form; true when an
     * overlap is too large.
     *
     * @param rub       NULL, or blocks for how the grains rub and hit
     * @param contacts  at most CLOD_FIXED_ADDENDS
     */
    bool (*wall)(const clod_kernel_view *view, const clod_law *law, clod_wall_form form,
                 clod_wall_block *blocks, clod_rub_block *rub, size_t contacts);
    /** For the ledger, just before `contact` or `wall`: what the block dissipates in this step. */
    void (*contact_dissipate)(const clod_kernel_view *view, const clod_law *law,
                              clod_contact_block *block, clod_dissipation_block *dissipated);
    void (*wall_dissipate)(const clod_kernel_view *view, const clod_law *law,
                           clod_wall_form form, clod_wall_block *block,
                           clod_dissipation_block *dissipated);
    /** Between steps: what the block stores. */
    void (*contact_stored)(const clod_kernel_view *view, const clod_law *law,
                           clod_contact_block *block, clod_stored_block *stored);
    void (*wall_stored)(const clod_kernel_view *view, const clod_law *law, clod_wall_form form,
                        clod_wall_block *block, clod_stored_block *stored);
    /**
     * Half a kick and a whole drift of grains [begin, end); their loads begin anew at zero.
     * Rows begin at multiples of 32 bytes, here and in `kick`.
     *
     * @param gravity  NULL, or [3] m/s2: before that the weight and the half kick that the step
     *                 before has left to this one
     */
    clod_kernel_speed (*drift)(double (*position)[4], double (*velocity)[4],
                               double (*angular_velocity)[4], double (*load)[8],
                               const double gravity[3], double dt, size_t begin, size_t end);
    /** Weight onto the loads of grains [begin, end), and their second half kick. */
    void (*kick)(double (*velocity)[4], double (*angular_velocity)[4], double (*load)[8],
                 const double gravity[3], double dt, size_t begin, size_t end);
    /**
     * Rows beyond that of a grain at p [x, y, z, radius] whose grains are within their radii and the
     * skin of it.
     *
     * @param first, count  of those that are looked at, at most 64
     * @param found         [64] the rows, in any order
     * @return              how many
     */
    size_t (*within)(const clod_kernel_search *search, const double p[4], int32_t row,
                     size_t first, size_t count, int32_t *found);
    /**
     * Which of up to 64 pairs of rows can touch while a near list holds, because courses bring them
     * nearer to each other than radii and skins: bit k for the pair i[k], j[k].
     *
     * @param i, j  [count, whole vectors] rows
     */
    uint64_t (*can_touch)(const clod_kernel_courses *courses, const int32_t *i,
                          const int32_t *j, size_t count);
} clod_kernel;

/**
 * Kernel of an instruction set.
 *
 * @param name  "scalar", "avx2", "avx512", "neon", or NULL for the best one of this machine
 * @return      static kernel, or NULL when the set is unknown or this machine lacks it
 * Errors  NULL.   Threads  pure.
 */
const clod_kernel *clod_kernel_choose(const char *name);
