// What rank 0 tells the first ranks of groups so that they can run their parts, and what it gets back.
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/room.h"
#include "output/folder.h"
#include "output/folder_names.h"
#include "parallel/ranks_collect.h"
#include "sim/group_words.h"
#include "sim/identity.h"
#include "sim/part_measures.h"
#include "sim/ranks.h"
#include "sim/testers.h"
#include "step/crew.h"

/** A batch in numbers; texts and parts follow. */
typedef struct batch_head {
    int groups, count, threads;
    bool any_threads;
    char simd[16];
    double limit, used; ///< s, of the run
    clod_folder_mark folder;
} batch_head;

/** Texts in their order, each with the zero byte at its end. */
typedef struct batch_texts {
    const char *path, *complete, *identity, *directory;
} batch_texts;

// ---- what a part has become

/** Before the bytes of a part's test. */
typedef struct part_record {
    int number;
    size_t test; ///< bytes
    clod_part part;
} part_record;

static size_t test_size(const clod_parts_tester *tester, const clod_case *from)
{
    return tester->procedure.size + clod_part_measures_size(from);
}

/** Parts of this group, and behind them what was told. */
static void pack_share(const clod_group *self, const clod_part *part, int count, size_t test,
                       const clod_bytes *log, const clod_bytes *notices, clod_bytes *to)
{
    const size_t told[2] = {log->count, notices->count};
    for (int p = self->number; p < count; p += self->count) {
        part_record record;
        memset(&record, 0, sizeof record); // all bytes are sent
        record.number = p;
        record.test = test;
        record.part = part[p];
        clod_bytes_put(to, &record, sizeof record);
        clod_bytes_put(to, part[p].test, test);
    }
    clod_bytes_put(to, told, sizeof told);
    clod_bytes_put(to, log->data, log->count);
    clod_bytes_put(to, notices->data, notices->count);
}

/** The same of one group on rank 0. */
static void unpack_share(const clod_group *self, int group, const clod_job_shared *sim,
                         const char *at, clod_part *part, int count)
{
    size_t told[2];
    for (int p = group; p < count; p += self->count) {
        part_record record;
        void *test = part[p].test;
        memcpy(&record, at, sizeof record);
        at += sizeof record;
        part[p] = record.part;
        part[p].test = test;
        memcpy(test, at, record.test);
        at += record.test;
    }
    memcpy(told, at, sizeof told);
    at += sizeof told;
    clod_eventlog_append(sim->log, at, told[0]);
    at += told[0];
    for (const char *end = at + told[1]; at < end; at += strlen(at) + 1) {
        if (sim->options->notice != NULL) {
            sim->options->notice(sim->options->context, at);
        }
    }
}

// ---- rank 0

static void put_text(clod_bytes *to, const char *text)
{
    clod_bytes_put(to, text, strlen(text) + 1);
}

/** Bytes that others have to make room for; false on all alike. */
static bool tell_rest(clod_ranks *all, clod_bytes *rest, clod_status *status)
{
    size_t bytes = rest->count;
    clod_ranks_tell(all, &bytes, sizeof bytes);
    const bool good = clod_room_for(&rest->data, &rest->capacity, bytes, 1) ||
                      clod_status_fail(status, CLOD_FAILED, "no memory for parts of a test");
    if (!clod_ranks_agree(all, good, status)) {
        return false;
    }
    clod_ranks_tell(all, rest->data, bytes);
    return true;
}

/** The batch to all others. */
static bool tell_batch(const clod_job_shared *sim, const clod_part *part, int count, int groups,
                       clod_status *status)
{
    clod_ranks *all = sim->options->ranks;
    clod_bytes rest = {0};
    batch_head head;
    memset(&head, 0, sizeof head);
    if (!clod_folder_mark_of(sim->folder, &head.folder, status)) {
        return false;
    }
    char *complete = clod_identity_complete(sim->from, status);
    bool good = false;
    head.groups = groups;
    head.count = count;
    head.threads = sim->options->threads;
    head.any_threads = sim->any_threads;
    head.limit = sim->limit.all;
    head.used = clod_clock_now() - sim->limit.begin;
    snprintf(head.simd, sizeof head.simd, "%s",
             sim->options->simd != NULL ? sim->options->simd : "");
    if (complete != NULL) {
        put_text(&rest, sim->from->path);
        put_text(&rest, complete);
        put_text(&rest, sim->identity);
        put_text(&rest, sim->directory);
        clod_bytes_put(&rest, part, (size_t)count * sizeof *part);
        good = !rest.lacks_memory ||
               clod_status_fail(status, CLOD_FAILED, "no memory to tell ranks their parts");
    }
    if (good) { // else nobody hears of it
        clod_crew_dismiss(all);
        clod_ranks_word(all, CLOD_RANKS_PARTS);
        clod_ranks_tell(all, &head, sizeof head);
        good = tell_rest(all, &rest, status);
    }
    clod_memory_free(complete);
    clod_bytes_fini(&rest);
    return good;
}

/** What all groups have become; false: it could not be sent. */
static bool collect(const clod_group *self, const clod_job_shared *sim, clod_part *part,
                    int count, clod_status *status)
{
    clod_bytes none = {0}, all = {0};
    size_t *begin = clod_memory_alloc((size_t)self->all->size + 1, sizeof *begin);
    bool good = begin != NULL ||
                clod_status_fail(status, CLOD_FAILED, "no memory for parts of other ranks");
    good = clod_ranks_agree(self->all, good, status) &&
           clod_ranks_collect(self->all, &none, &all, begin, status);
    for (int g = 1; good && g < self->count; g++) {
        unpack_share(self, g, sim, all.data + begin[clod_group_leader(self, g)], part, count);
    }
    clod_bytes_fini(&all);
    clod_memory_free(begin);
    return good;
}

bool clod_group_run(const clod_parts_tester *tester, const clod_job_shared *sim,
                    clod_part *part, int count, int groups, clod_status *status)
{
    clod_group self;
    if (!tell_batch(sim, part, count, groups, status) ||
        !clod_group_join(&self, sim->options->ranks, groups, status)) {
        return false;
    }
    self.asked = sim->options;
    self.saved = sim->options->save != NULL ? atomic_load(sim->options->save) : 0;
    bool good = clod_ranks_agree(self.all, true, status); // that all groups can begin
    if (good) {
        clod_group_take_share(&self, tester, sim, part, count);
        good = collect(&self, sim, part, count, status);
    }
    clod_group_leave(&self);
    return good;
}

// ---- the others

/** What the first rank of a group needs to run parts. */
typedef struct share {
    clod_group *group;
    const batch_head *head;
    batch_texts text;
    clod_case *from;
    clod_folder *folder;
    clod_part *part; ///< [head.count]
    clod_bytes log, notices;
} share;

static void keep_notice(void *context, const char *text)
{
    share *self = context;
    put_text(&self->notices, text);
}

/** Texts, and the parts behind them, where they were told. */
static const char *find_texts(batch_texts *to, const char *at)
{
    const char **text[] = {&to->path, &to->complete, &to->identity, &to->directory};
    for (size_t k = 0; k < sizeof text / sizeof *text; k++) {
        *text[k] = at;
        at += strlen(at) + 1;
    }
    return at;
}

/** Whether the case is that of rank 0, which the files that it names belong to. */
static bool is_same_case(const share *self, clod_status *status)
{
    char *complete = clod_identity_complete(self->from, status);
    const bool same = complete != NULL && strcmp(complete, self->text.complete) == 0;
    if (complete != NULL && !same) {
        clod_status_fail(
            status, CLOD_FAILED,
            "%s: the case is another one here than on rank 0; are its files the same?",
            self->text.path);
    }
    clod_memory_free(complete);
    return same;
}

/** The folder, if it is that of rank 0. */
static clod_folder *find_folder(const share *self, clod_status *status)
{
    clod_folder_mark mark;
    clod_folder *folder = clod_folder_look(self->text.directory, status);
    bool good = folder != NULL && clod_folder_mark_of(folder, &mark, status);
    if (good && !clod_folder_mark_equals(&mark, &self->head->folder)) {
        good = clod_status_fail(
            status, CLOD_FAILED,
            "%s is another folder here than on rank 0: its %s is not the one that rank 0 has locked.",
            self->text.directory, CLOD_FOLDER_LOCK);
    }
    if (!good) {
        clod_folder_close(&folder);
    }
    return folder;
}

/** Case, folder and parts. */
static bool prepare(share *self, const char *told, clod_status *status)
{
    const char *parts = find_texts(&self->text, told);
    self->from = clod_case_parse(self->text.path, self->text.complete,
                                 strlen(self->text.complete), NULL, 0, status);
    self->folder =
        self->from != NULL && is_same_case(self, status) ? find_folder(self, status) : NULL;
    self->part = self->folder != NULL ? clod_parts_create(clod_testers_of(self->from)->first,
                                                          self->from, self->head->count, status)
                                      : NULL;
    for (int p = 0; self->part != NULL && p < self->head->count; p++) {
        void *test = self->part[p].test;
        memcpy(&self->part[p], parts + (size_t)p * sizeof *self->part, sizeof *self->part);
        self->part[p].test = test;
    }
    return self->part != NULL;
}

static void run_share(share *self)
{
    const batch_head *head = self->head;
    clod_eventlog *log = clod_eventlog_collect(&self->log);
    const clod_run_options options = {.threads = head->threads,
                                      .simd = head->simd[0] != '\0' ? head->simd : NULL,
                                      .stop = &self->group->stop,
                                      .save = &self->group->save,
                                      .notice = keep_notice,
                                      .context = self};
    const clod_job_shared sim = {.from = self->from,
                                 .options = &options,
                                 .directory = self->text.directory,
                                 .folder = self->folder,
                                 .identity = self->text.identity,
                                 .log = log,
                                 .limit = {clod_clock_now() - head->used, head->limit},
                                 .any_threads = head->any_threads};
    clod_status ignored;
    clod_group_take_share(self->group, clod_testers_of(self->from)->first, &sim, self->part,
                          head->count);
    clod_eventlog_close(&log, &ignored);
}

static void forget(share *self)
{
    clod_bytes_fini(&self->log);
    clod_bytes_fini(&self->notices);
    clod_parts_destroy(self->part);
    clod_folder_close(&self->folder);
    clod_case_destroy(&self->from);
}

/** Whether this rank can begin: the first of a group can if it has what its parts need. */
static bool begin(share *self, const char *told, clod_status *status)
{
    const clod_ranks *all = self->group->all;
    char why[sizeof status->text];
    if (self->group->ranks.rank > 0 || prepare(self, told, status)) {
        return true;
    }
    snprintf(why, sizeof why, "%s", status->text);
    return clod_status_fail(
        status, status->code,
        "rank %d%s%s: %s\nThe first rank of each group reads the case and "
        "writes files of its parts: every host needs the case and the folder.",
        all->rank, all->place != NULL ? " on " : "",
        all->place != NULL ? all->place[all->rank].host : "", why);
}

/** Compute with a group, or lead it; what its parts have become is in `to`. */
static void take_part(share *self, clod_bytes *to)
{
    clod_group *group = self->group;
    if (group->ranks.rank > 0) {
        clod_crew_serve(&group->ranks);
        return;
    }
    run_share(self);
    pack_share(group, self->part, self->head->count,
               test_size(clod_testers_of(self->from)->first, self->from), &self->log,
               &self->notices, to);
}

void clod_group_serve(clod_ranks *all)
{
    batch_head head;
    clod_group group;
    share self = {.group = &group, .head = &head};
    clod_status status = {0};
    clod_bytes told = {0}, mine = {0};
    clod_ranks_tell(all, &head, sizeof head);
    if (tell_rest(all, &told, &status) && clod_group_join(&group, all, head.groups, &status)) {
        if (clod_ranks_agree(all, begin(&self, told.data, &status), &status)) {
            take_part(&self, &mine);
            if (clod_ranks_agree(all, true, &status)) {
                clod_ranks_collect(all, &mine, NULL, NULL, &status);
            }
        }
        clod_group_leave(&group);
    }
    forget(&self);
    clod_bytes_fini(&told);
    clod_bytes_fini(&mine);
}
