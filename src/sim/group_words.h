#pragma once
/**
 * @file group_words.h
 * What groups of ranks say to each other, and what they have in common (group.h).
 */

#include "sim/group.h"

/** Words between rank 0 and the first ranks of other groups. */
typedef enum clod_group_word {
    CLOD_GROUP_STOP = 1, ///< write checkpoints and end
    CLOD_GROUP_SAVE,     ///< each part writes a checkpoint that is kept
    CLOD_GROUP_FAILED,   ///< a part has: begin no further one
    CLOD_GROUP_DONE ///< the last word: from a group, its share is done; from rank 0, of all
} clod_group_word;

/** The first rank of a group, among all. */
int clod_group_leader(const clod_group *self, int group);

/** Be one of the ranks of a group. False on all alike. */
bool clod_group_join(clod_group *self, clod_ranks *all, int groups, clod_status *status);

/** The group ends, and its messages are counted with those of all. */
void clod_group_leave(clod_group *self);

/** Run the parts of this group, tell its other ranks that they are done, and wait for all
 *  groups. Threads: the first rank of each group. */
void clod_group_take_share(clod_group *self, const clod_parts_tester *tester,
                           const clod_job_shared *sim, clod_part *part, int count);

/** Wait until all groups are done. Threads: as before. */
void clod_group_wait(clod_group *self);
