#include "sim/group.h"

#include <stdatomic.h>
#include <time.h>

#include "sim/group_words.h"
#include "step/crew.h"

#define PAUSE_NS 5000000 ///< between two looks for words

int clod_group_leader(const clod_group *self, int group)
{
    return (int)((int64_t)group * self->all->size / self->count);
}

int clod_group_best(int ranks, int parts)
{
    int groups = parts < ranks ? parts : ranks;
    // turns that the largest share takes, times groups, is the time of all
    while (groups > 1 && 4 * ((parts + groups - 1) / groups * groups) > 5 * parts) {
        groups--;
    }
    return groups;
}

int clod_group_count(const clod_ranks *all, int parts)
{
    return all == NULL || all->split == NULL ? 1 : clod_group_best(all->size, parts);
}

bool clod_group_join(clod_group *self, clod_ranks *all, int groups, clod_status *status)
{
    *self = (clod_group){.all = all, .count = groups, .working = groups - 1};
    while (self->number + 1 < groups &&
           clod_group_leader(self, self->number + 1) <= all->rank) {
        self->number++;
    }
    return all->split(all, self->number, &self->ranks, status);
}

void clod_group_leave(clod_group *self)
{
    const clod_ranks_count *part = &self->ranks.count;
    const clod_ranks_evenness *even = &self->ranks.evenness;
    clod_ranks_count *count = &self->all->count;
    clod_ranks_evenness *sum = &self->all->evenness;
    count->merges += part->merges;
    count->exchanges += part->exchanges;
    count->messages += part->messages;
    count->bytes += part->bytes;
    count->merge_messages += part->merge_messages;
    count->merge_bytes += part->merge_bytes;
    count->waited += part->waited;
    count->spun += part->spun;
    sum->looks += even->looks;
    sum->cuts += even->cuts;
    sum->moved += even->moved;
    sum->sum += even->sum;
    sum->most = even->most > sum->most ? even->most : sum->most;
    self->ranks.part(&self->ranks);
}

/** A word of rank 0 to all other leaders. */
static void tell_leaders(clod_group *self, clod_group_word word)
{
    for (int g = 1; g < self->count; g++) {
        self->all->post(self->all, clod_group_leader(self, g), (int)word);
    }
}

/** What rank 0 hears from users and leaders, and tells the leaders. */
static void hear_first(clod_group *self)
{
    const clod_run_options *asked = self->asked;
    if (!self->stopped && asked->stop != NULL && atomic_load(asked->stop) != 0) {
        self->stopped = true;
        tell_leaders(self, CLOD_GROUP_STOP);
    }
    const int save = asked->save != NULL ? atomic_load(asked->save) : 0;
    if (save != self->saved) {
        self->saved = save;
        tell_leaders(self, CLOD_GROUP_SAVE);
    }
    for (int g = 1; g < self->count; g++) {
        int word;
        while (self->all->look(self->all, clod_group_leader(self, g), &word)) {
            self->failed |= word == CLOD_GROUP_FAILED;
            self->working -= word == CLOD_GROUP_DONE;
        }
    }
    if (self->failed && !self->told_failed) {
        self->told_failed = true;
        tell_leaders(self, CLOD_GROUP_FAILED);
    }
}

/** What another leader hears from rank 0, and tells it. */
static void hear_other(clod_group *self)
{
    int word;
    if (self->failed && !self->told_failed) {
        self->told_failed = true;
        self->all->post(self->all, 0, CLOD_GROUP_FAILED);
    }
    while (!self->ended && self->all->look(self->all, 0, &word)) {
        if (word == CLOD_GROUP_STOP) {
            atomic_store(&self->stop, 1);
        } else if (word == CLOD_GROUP_SAVE) {
            atomic_fetch_add(&self->save, 1);
        } else if (word == CLOD_GROUP_FAILED) {
            self->failed = self->told_failed = true;
        } else {
            self->ended = true;
        }
    }
}

void clod_group_hear(clod_group *self)
{
    if (self != NULL) {
        if (self->number == 0) {
            hear_first(self);
        } else {
            hear_other(self);
        }
    }
}

/** Wait a little for the others. */
static void pause_shortly(void)
{
    const struct timespec pause = {.tv_nsec = PAUSE_NS};
    nanosleep(&pause, NULL);
}

void clod_group_wait(clod_group *self)
{
    clod_group_hear(self);
    if (self->number == 0) {
        for (; self->working > 0; clod_group_hear(self)) {
            pause_shortly();
        }
        tell_leaders(self, CLOD_GROUP_DONE);
        return;
    }
    self->all->post(self->all, 0, CLOD_GROUP_DONE);
    for (; !self->ended; clod_group_hear(self)) {
        pause_shortly();
    }
}

void clod_group_take_share(clod_group *self, const clod_parts_tester *tester,
                           const clod_job_shared *sim, clod_part *part, int count)
{
    clod_run_options options = *sim->options;
    clod_job_shared own = *sim;
    options.ranks = &self->ranks;
    if (sim->any_threads) { // as of ranks: a group of one rank has one too
        options.threads = 1;
        own.any_threads = false;
    }
    own.options = &options;
    own.group = self;
    for (int p = self->number; p < count; p += self->count) {
        clod_parts_run_one(tester, &own, &part[p]);
        self->failed |= !part[p].ok && part[p].status.code != CLOD_INTERRUPTED;
        clod_group_hear(self);
    }
    if (self->ranks.size > 1) {
        clod_crew_dismiss(&self->ranks);
    }
    clod_group_wait(self);
}
