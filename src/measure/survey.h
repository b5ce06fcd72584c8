#pragma once
/**
 * @file survey.h
 * Sums over a bed, wherever its grains are. Who measures asks for a kind of sum; it is made where
 * the grains are, of own rows alone, and what all ranks have is merged. So every kind is exact, or
 * counts, or takes the most: the result has the same bits on any grouping.
 *
 * What is asked is plain data without pointers; so are the sums, all zero at first.
 */

#include <stddef.h>
#include <stdint.h>

#include "parallel/ranks.h"
#include "state/contact_source.h"

/** What of a bed is in this process. */
typedef struct clod_survey_part {
    const clod_state *state;             ///< own rows, and ghosts of other ranks' grains
    const clod_contact_source *contacts; ///< all that own grains have; NULL: none
    const int32_t *owner;                ///< [grains] rank of each row; NULL: all are own
    // where other ranks make the same sums at this moment; else NULL, with no owners
    clod_ranks *ranks;
    /** Rows of ghosts, in a column of up to 72 bytes a row, become those of their owners. */
    void (*share)(const void *context, void *column, size_t size);
    const void *context;
} clod_survey_part;

/** Whether a row counts here. A contact counts where its first grain does. Threads: pure. */
static inline bool clod_survey_has(const clod_survey_part *self, size_t row)
{
    return self->owner == NULL || self->owner[row] == self->ranks->rank;
}

/** Whether it went well on all ranks, see clod_ranks_agree. */
static inline bool clod_survey_agree(const clod_survey_part *self, bool good,
                                     clod_status *status)
{
    return self->ranks == NULL ? good : clod_ranks_agree(self->ranks, good, status);
}

/** Kinds of sums. */
typedef enum clod_survey_kind {
    CLOD_SURVEY_MOTION,       ///< clod_measure_motion_sums; nothing is asked
    CLOD_SURVEY_CONTACTS,     ///< clod_measure_contacts_sums; nothing is asked
    CLOD_SURVEY_GAUGES,       ///< gauge_pass.c
    CLOD_SURVEY_CONTINUUM,    ///< continuum_pass.c
    CLOD_SURVEY_MIXING,       ///< mixing_grid.c: grains counted
    CLOD_SURVEY_MIXING_MASS,  ///< mixing_grid.c: weighed
    CLOD_SURVEY_STOCK,        ///< stock.c
    CLOD_SURVEY_STRENGTH,     ///< strength_grid.c
    CLOD_SURVEY_CLUMPS,       ///< clumps_look.c
    CLOD_SURVEY_RESTING,      ///< resting_mass.c
    CLOD_SURVEY_REPOSE,       ///< repose.c: the surface
    CLOD_SURVEY_REPOSE_CENTER ///< repose.c
} clod_survey_kind;

typedef struct clod_survey_question {
    clod_survey_kind kind;
    const void *asked; ///< [asked_bytes]
    size_t asked_bytes;
    void *sums; ///< [sums_bytes] [out] zero before
    size_t sums_bytes;
} clod_survey_question;

/** A bed that can be asked. */
typedef struct clod_survey {
    const clod_state *state; ///< its walls and numbers are of now
    const clod_contact_source
        *contacts; ///< of the whole bed, for who has seen to it that it is here
    /** As clod_survey_ask; NULL: the whole bed is in the state. */
    bool (*ask)(void *context, const clod_survey_question *question, clod_status *status);
    void *context;
} clod_survey;

/** A bed that is in a state. @param contacts  NULL: it has none */
clod_survey clod_survey_of(const clod_state *state, const clod_contact_source *contacts);

/**
 * Get the sums over the whole bed.
 *
 * Errors  CLOD_FAILED: no memory, on any rank.   Threads  one per bed.
 * Test    tests/step/test_ranks_survey.c
 */
bool clod_survey_ask(const clod_survey *self, const clod_survey_question *question,
                     clod_status *status);

// ---- for who makes the sums

/** How sums of a kind are made. */
typedef struct clod_survey_way {
    /** Add what is here. The sums are zero before. Ranks may talk, all alike; then they fail alike. */
    bool (*add)(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status);
    /** Add other sums: those of `unit` bytes, or all of them. */
    void (*merge)(const clod_survey_question *question, void *into, const void *from);
    size_t unit;  ///< bytes of sums that are merged by themselves; 0: only all together
    bool motions; ///< of ghosts count too, or forces and gains of contacts that they have
} clod_survey_way;

/** The way of a kind. Threads: pure. */
const clod_survey_way *clod_survey_way_of(clod_survey_kind kind);
