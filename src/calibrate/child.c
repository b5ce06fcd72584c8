#include "calibrate/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"

/** In the child, where only calls that are safe after fork may be made. */
static void become(char *const *arguments, int log)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0) {
        execv(arguments[0], arguments);
    }
}

bool clod_child_start(clod_child *self, char *const *arguments, const char *log,
                      clod_status *status)
{
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) {
        return clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", log,
                                strerror(errno));
    }
    self->began = clod_clock_now();
    self->process = fork();
    if (self->process == 0) {
        become(arguments, file);
        kill(getpid(), SIGKILL); // no handler of the parent's may run here
    }
    close(file);
    if (self->process < 0) {
        self->process = 0;
        return clod_status_fail(status, CLOD_FAILED, "No process for %s: %s", log,
                                strerror(errno));
    }
    return true;
}

bool clod_child_ended(clod_child *self, int *result)
{
    pid_t found;
    do {
        found = waitpid(self->process, result, WNOHANG);
    } while (found < 0 && errno == EINTR);
    if (found == self->process) {
        self->process = 0;
        return true;
    }
    return false;
}

void clod_child_stop(const clod_child *self)
{
    if (self->process > 0) {
        kill(self->process, SIGTERM);
    }
}
