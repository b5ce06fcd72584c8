#include "calibrate/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"

/** In the child, where only calls that are safe after fork may be made. Returns when it fails. */
static void become(char *const *arguments, int log)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0) {
        execv(arguments[0], arguments);
    }
}

/** Fork; the error of a child that could not become the program, 0 when it has. */
static int spawn(clod_child *self, char *const *arguments, int log)
{
    int ends[2]; // the writing one closes when the child becomes the program
    if (pipe(ends) != 0) {
        return errno;
    }
    (void)fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    (void)fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    self->began = clod_clock_now();
    self->process = fork();
    int error = self->process < 0 ? errno : 0;
    if (self->process == 0) {
        become(arguments, log);
        error = errno;
        (void)!write(ends[1], &error, sizeof error);
        kill(getpid(), SIGKILL); // no handler of the parent's may run here
    }
    close(ends[1]);
    if (self->process > 0 && read(ends[0], &error, sizeof error) == (ssize_t)sizeof error) {
        (void)waitpid(self->process, NULL, 0);
    }
    close(ends[0]);
    return error;
}

bool clod_child_start(clod_child *self, char *const *arguments, const char *log,
                      clod_status *status)
{
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) {
        return clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", log,
                                strerror(errno));
    }
    const int error = spawn(self, arguments, file);
    close(file);
    if (error != 0) {
        self->process = 0;
        return clod_status_fail(status, CLOD_FAILED, "%s: no process of %s: %s", log,
                                arguments[0], strerror(error));
    }
    return true;
}

bool clod_child_ended(clod_child *self, int *result)
{
    pid_t found;
    do {
        found = waitpid(self->process, result, WNOHANG);
    } while (found < 0 && errno == EINTR);
    if (found == 0) {
        return false;
    }
    if (found < 0) { // someone else has waited for it, or SIGCHLD is ignored
        *result = CLOD_CHILD_LOST;
    }
    self->process = 0;
    return true;
}

void clod_child_stop(const clod_child *self)
{
    if (self->process > 0) {
        kill(self->process, SIGTERM);
    }
}
