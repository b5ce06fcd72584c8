// Ranks by MPI. Its own errors end all ranks with its message (MPI_ERRORS_ARE_FATAL).
#include "parallel/ranks_mpi.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"

/** What the starters say of the number of processes: Open MPI; MPICH, Intel; Slurm with PMIx. */
static const char *const STARTERS[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};

bool clod_ranks_mpi_started(void)
{
    bool started = false;
    for (size_t k = 0; k < sizeof STARTERS / sizeof *STARTERS; k++) {
        started = started || getenv(STARTERS[k]) != NULL;
    }
    return started;
}

/** How many processes MPI knows of, if it runs in this one; else 0. */
static int known_processes(void);

/** Whether this process began with a variable that it has now: MPI in a process alone sets PMIX_RANK
 *  itself. Where the system does not tell, it did. */
static bool began_with(const char *name)
{
    FILE *in = fopen("/proc/self/environ", "re");
    char *entry = NULL;
    size_t room = 0;
    const size_t length = strlen(name);
    bool found = in == NULL;
    while (!found && getdelim(&entry, &room, '\0', in) > 0) {
        found = strncmp(entry, name, length) == 0 && entry[length] == '=';
    }
    free(entry); // getdelim's own
    if (in != NULL) {
        fclose(in);
    }
    return found;
}

int clod_ranks_mpi_processes(void)
{
    // of srun there are numbers of tasks in a plain batch script too
    const char *text = getenv("OMPI_COMM_WORLD_SIZE");
    text = text != NULL ? text : getenv("PMI_SIZE");
    text = text != NULL || getenv("PMIX_RANK") == NULL ? text : getenv("SLURM_STEP_NUM_TASKS");
    const long processes = text != NULL ? strtol(text, NULL, 10) : 0;
    if (processes >= 1 && processes <= INT_MAX) {
        return (int)processes;
    }
    if (!clod_ranks_mpi_started()) {
        return 1;
    }
    return began_with("PMIX_RANK") ? 0 : known_processes();
}

/** Whether a process that sees no other one is alone; `cause` may be why it sees none. */
static bool check_alone(const char *cause, clod_status *status)
{
    const int processes = clod_ranks_mpi_processes();
    if (processes > 1) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%d processes were started together, but this one does not "
                                "see the others, and each would compute all: %s",
                                processes, cause);
    }
    return processes == 1 ||
           clod_status_fail(status, CLOD_USAGE,
                            "several processes may have been started together (the launcher "
                            "does not say how many), but this one sees no other, and each "
                            "would compute all: %s",
                            cause);
}

#ifdef CLOD_MPI

#include <mpi.h>

/** Bytes of one piece of a message: MPI counts in int. A test sets fewer (clod_pieces). */
#ifndef CLOD_MPI_PIECE
#define CLOD_MPI_PIECE ((size_t)1 << 30)
#endif
#define PIECE ((size_t)CLOD_MPI_PIECE)

/** Tags of messages that are exchanged once, again and again, and of words. */
enum { ONCE, KEPT, POSTED };

typedef struct mpi_group {
    MPI_Comm all;         ///< of these ranks alone: nobody else's messages come between
    bool began;           ///< MPI, for these ranks: it ends with them
    MPI_Request *request; ///< of the pieces of an exchange
    size_t room;
    MPI_Request *kept; ///< [kept_count] of those that are repeated
    size_t kept_count, kept_room;
} mpi_group;

static size_t pieces_of(const clod_message *message, int count)
{
    size_t pieces = 0;
    for (int k = 0; k < count; k++) {
        pieces += (message[k].bytes + PIECE - 1) / PIECE;
    }
    return pieces;
}

/** Begin with the pieces of a message, which arrive in their order. */
static MPI_Request *begin(MPI_Comm all, const clod_message *message, bool out,
                          MPI_Request *request)
{
    for (size_t at = 0; at < message->bytes; at += PIECE) {
        const size_t left = message->bytes - at;
        const int bytes = (int)(left < PIECE ? left : PIECE);
        char *data = (char *)message->data + at;
        if (out) {
            MPI_Isend(data, bytes, MPI_BYTE, message->peer, ONCE, all, request++);
        } else {
            MPI_Irecv(data, bytes, MPI_BYTE, message->peer, ONCE, all, request++);
        }
    }
    return request;
}

static void exchange(clod_ranks *self, const clod_message *out, int outs,
                     const clod_message *in, int ins)
{
    mpi_group *group = self->group;
    const size_t pieces = pieces_of(out, outs) + pieces_of(in, ins);
    if (!clod_room_for(&group->request, &group->room, pieces, sizeof *group->request)) {
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE); // the others wait: there is no other way out
    }
    MPI_Request *next = group->request;
    for (int k = 0; k < ins; k++) {
        next = begin(group->all, &in[k], false, next);
    }
    for (int k = 0; k < outs; k++) {
        next = begin(group->all, &out[k], true, next);
    }
    MPI_Waitall((int)pieces, group->request, MPI_STATUSES_IGNORE);
}

static void drop_kept(mpi_group *group)
{
    for (size_t k = 0; k < group->kept_count; k++) {
        MPI_Request_free(&group->kept[k]);
    }
    group->kept_count = 0;
}

/** Requests of the pieces of a message that is repeated. */
static void keep_message(mpi_group *group, const clod_message *message, bool out)
{
    for (size_t at = 0; at < message->bytes; at += PIECE) {
        const size_t left = message->bytes - at;
        const int bytes = (int)(left < PIECE ? left : PIECE);
        char *data = (char *)message->data + at;
        MPI_Request *request = &group->kept[group->kept_count++];
        if (out) {
            MPI_Send_init(data, bytes, MPI_BYTE, message->peer, KEPT, group->all, request);
        } else {
            MPI_Recv_init(data, bytes, MPI_BYTE, message->peer, KEPT, group->all, request);
        }
    }
}

static bool keep(clod_ranks *self, const clod_message *out, int outs, const clod_message *in,
                 int ins)
{
    mpi_group *group = self->group;
    drop_kept(group);
    const size_t pieces = pieces_of(out, outs) + pieces_of(in, ins);
    if (!clod_room_for(&group->kept, &group->kept_room, pieces, sizeof *group->kept)) {
        return false;
    }
    for (int k = 0; k < ins; k++) { // first, so that nothing comes unawaited
        keep_message(group, &in[k], false);
    }
    for (int k = 0; k < outs; k++) {
        keep_message(group, &out[k], true);
    }
    return true;
}

static void start(clod_ranks *self)
{
    mpi_group *group = self->group;
    if (group->kept_count > 0) { // no array of none, which MPI_Startall refuses
        MPI_Startall((int)group->kept_count, group->kept);
    }
}

static void finish(clod_ranks *self)
{
    mpi_group *group = self->group;
    if (group->kept_count > 0) {
        MPI_Waitall((int)group->kept_count, group->kept, MPI_STATUSES_IGNORE);
    }
}

static int known_processes(void)
{
    int begun, ended, processes = 0;
    MPI_Initialized(&begun);
    MPI_Finalized(&ended);
    if (begun && !ended) {
        MPI_Comm_size(MPI_COMM_WORLD, &processes);
    }
    return processes;
}

/** MPI has begun, by others or now; and not ended. */
static bool begin_mpi(mpi_group *group, clod_status *status)
{
    int begun, ended, level;
    MPI_Initialized(&begun);
    MPI_Finalized(&ended);
    if (ended) {
        return clod_status_fail(status, CLOD_USAGE,
                                "MPI has ended in this process, and cannot begin again: open "
                                "ranks once, for all simulations, or begin MPI yourself "
                                "before (MPI_Init_thread, mpi4py)");
    }
    if (begun) {
        MPI_Query_thread(&level);
    } else {
        MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &level);
        group->began = true;
    }
    return level >= MPI_THREAD_FUNNELED ||
           clod_status_fail(status, CLOD_FAILED,
                            "this MPI allows no threads: it gives level %d, "
                            "MPI_THREAD_FUNNELED is needed",
                            level);
}

/** A communicator that MPI knows by this number, and that can be one of ranks. */
static bool find_communicator(int number, MPI_Comm *from, clod_status *status)
{
    int between = 0;
    if (known_processes() == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "a communicator was given, but MPI does not run in this "
                                "process: it has not begun, has ended, or is another MPI than "
                                "that which clod was built with");
    }
    *from = MPI_Comm_f2c(number);
    if (*from != MPI_COMM_NULL) {
        MPI_Comm_test_inter(*from, &between);
    }
    return (*from != MPI_COMM_NULL && !between) ||
           clod_status_fail(status, CLOD_USAGE,
                            *from == MPI_COMM_NULL
                                ? "the communicator is MPI_COMM_NULL: this process is not in "
                                  "the group; only those that are may ask for its ranks"
                                : "the communicator lies between two groups; ranks need one "
                                  "group");
}

static void post(clod_ranks *self, int to, int word)
{
    static const int WORDS[] = {0, 1, 2, 3, 4, 5, 6, 7}; // they stay until they are sent
    const mpi_group *group = self->group;
    MPI_Request request;
    CLOD_ASSERT(word >= 0 && word < (int)(sizeof WORDS / sizeof *WORDS));
    MPI_Isend(&WORDS[word], 1, MPI_INT, to, POSTED, group->all, &request);
    MPI_Request_free(&request);
}

static bool look(clod_ranks *self, int from, int *word)
{
    const mpi_group *group = self->group;
    int there;
    MPI_Iprobe(from, POSTED, group->all, &there, MPI_STATUS_IGNORE);
    if (there) {
        MPI_Recv(word, 1, MPI_INT, from, POSTED, group->all, MPI_STATUS_IGNORE);
    }
    return there;
}

static bool split(clod_ranks *self, int colour, clod_ranks *part, clod_status *status);

/** Ranks of a communicator of their own. */
static void join(clod_ranks *self, mpi_group *group)
{
    *self = (clod_ranks){.exchange = exchange,
                         .keep = keep,
                         .start = start,
                         .finish = finish,
                         .split = split,
                         .part = clod_ranks_mpi_close,
                         .post = post,
                         .look = look,
                         .group = group};
    MPI_Comm_set_errhandler(group->all, MPI_ERRORS_ARE_FATAL);
    MPI_Comm_rank(group->all, &self->rank);
    MPI_Comm_size(group->all, &self->size);
}

static bool split(clod_ranks *self, int colour, clod_ranks *part, clod_status *status)
{
    const mpi_group *from = self->group;
    mpi_group *group = clod_memory_alloc(1, sizeof *group);
    bool good = group != NULL || clod_status_fail(status, CLOD_FAILED, "no memory for MPI");
    if (!clod_ranks_agree(self, good, status)) {
        clod_memory_free(group);
        return false;
    }
    MPI_Comm_split(from->all, colour, self->rank, &group->all);
    join(part, group);
    good = clod_ranks_init(part, status);
    if (!clod_ranks_agree(self, good, status)) {
        clod_ranks_mpi_close(part);
        return false;
    }
    return true;
}

bool clod_ranks_mpi_open(clod_ranks *self, const int *communicator, clod_status *status)
{
    mpi_group *group = clod_memory_alloc(1, sizeof *group);
    if (group == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for MPI");
    }
    MPI_Comm from = MPI_COMM_WORLD;
    if ((communicator != NULL && !find_communicator(*communicator, &from, status)) ||
        !begin_mpi(group, status)) {
        if (group->began) {
            MPI_Finalize();
        }
        clod_memory_free(group);
        return false;
    }
    MPI_Comm_dup(from, &group->all);
    join(self, group);
    const bool good =
        (communicator != NULL || self->size > 1 ||
         check_alone("start them with the mpirun of the MPI that clod was built with, or one "
                     "alone without mpirun",
                     status)) &&
        clod_ranks_init(self, status);
    if (!good) {
        clod_ranks_mpi_close(self);
    }
    return good;
}

void clod_ranks_mpi_close(clod_ranks *self)
{
    mpi_group *group = self->group;
    int ended;
    MPI_Finalized(&ended);
    if (!ended) {
        drop_kept(group);
        MPI_Comm_free(&group->all);
        if (group->began) {
            MPI_Finalize();
        }
    }
    clod_memory_free(group->kept);
    clod_memory_free(group->request);
    clod_memory_free(group);
    clod_ranks_fini(self);
}

#else

static int known_processes(void)
{
    return 0;
}

bool clod_ranks_mpi_open(clod_ranks *self, const int *communicator, clod_status *status)
{
    *self = (clod_ranks){.size = 1};
    if (communicator != NULL) {
        return clod_status_fail(status, CLOD_USAGE,
                                "a communicator was given, but this clod was built without "
                                "MPI: build it where libopenmpi-dev is installed");
    }
    return check_alone("this clod was built without MPI: run it without mpirun, or build it "
                       "where libopenmpi-dev is installed",
                       status);
}

void clod_ranks_mpi_close(clod_ranks *self)
{
    clod_ranks_fini(self);
}

#endif
