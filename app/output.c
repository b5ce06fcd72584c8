#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int put_error; ///< errno of the first clod_output_put that failed, or 0

/** Give a stream that came closed a file of which every read and write fails. */
static bool hold(int stream)
{
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) {
        return true;
    }
    // the lowest free number is this one: those below are held already
    return open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) == stream;
}

/** At the end, also at that of --help. A verb that failed has told why: nothing to add. */
static void finish(int status, void *unused)
{
    (void)unused;
    const bool lost = ferror(stdout) != 0;
    errno = 0;
    const bool closed = fclose(stdout) == 0;
    const int error = put_error != 0 ? put_error : errno;
    if (status != EXIT_SUCCESS) {
        return;
    }
    if (lost || !closed) {
        fprintf(stderr, "clod: standard output cannot be written%s%s\n", error != 0 ? ": " : "",
                error != 0 ? strerror(error) : "");
    }
    if (lost || !closed || ferror(stderr) != 0) {
        _exit(EXIT_FAILURE);
    }
}

bool clod_output_watch(void)
{
    return hold(STDIN_FILENO) && hold(STDOUT_FILENO) && hold(STDERR_FILENO) &&
           on_exit(finish, NULL) == 0;
}

void clod_output_put(const char *text)
{
    if ((fputs(text, stdout) == EOF || fflush(stdout) != 0) && put_error == 0) {
        put_error = errno;
    }
}
