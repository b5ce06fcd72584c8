#include "join.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

static clod_ranks *ranks; ///< of this program

static void close_ranks(void)
{
    clod_ranks_close(&ranks);
}

/** What rank 0 asks for; its signals are for rank 0 to act on. */
static void serve(void)
{
    static const int SIGNALS[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};
    for (size_t k = 0; k < sizeof SIGNALS / sizeof *SIGNALS; k++) {
        signal(SIGNALS[k], SIG_IGN);
    }
    clod_ranks_serve(ranks);
}

clod_ranks *clod_app_join(const char *verb, int *result)
{
    clod_status status = {0};
    ranks = clod_ranks_open(&status);
    if (ranks == NULL) {
        fprintf(stderr, "%s: %s\n", verb, status.text);
        *result = (int)status.code;
        return NULL;
    }
    atexit(close_ranks);
    if (clod_ranks_number(ranks) > 0) {
        serve();
        exit(EXIT_SUCCESS);
    }
    return ranks;
}
