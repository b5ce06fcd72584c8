#include "picture_frames.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "output.h"

#define ROOM (PATH_MAX + 64) ///< of a path in a folder
#define MOVIE_SECONDS 4      ///< a movie of few frames lasts about so long, ...
#define MOVIE_RATE 25        ///< ... of many it has so many a second

/** Name of a frame's file. */
static void name_frame(char path[ROOM], const char *folder, size_t frame)
{
    snprintf(path, ROOM, "%s/frame_%06zu.png", folder, frame);
}

/** The name of the run, for files without another: last part of its path, part of the test. */
static void name_run(const clod_picture_options *options, char name[PATH_MAX])
{
    char *real = realpath(options->run, NULL);
    const char *slash = real != NULL ? strrchr(real, '/') : NULL;
    snprintf(name, PATH_MAX, "%s%s%s", slash != NULL && slash[1] != '\0' ? slash + 1 : "run",
             options->part != NULL ? "-" : "", options->part != NULL ? options->part : "");
    free(real);
}

/** Draw every jobs-th frame from `first` on. */
static bool draw_share(const clod_picture *picture, const char *folder, size_t first,
                       size_t jobs, clod_status *status)
{
    for (size_t k = first; k < clod_picture_count(picture); k += jobs) {
        char path[ROOM];
        name_frame(path, folder, k);
        if (!clod_picture_draw(picture, k, path, status)) {
            return false;
        }
    }
    return true;
}

/** A process that draws, and where it says what went wrong. */
typedef struct worker {
    pid_t process;
    int words; ///< read end of a pipe
} worker;

static bool start(worker *self, const clod_picture *picture, const char *folder, size_t first,
                  size_t jobs)
{
    int ends[2];
    if (pipe(ends) != 0) {
        return false;
    }
    self->process = fork();
    if (self->process == 0) {
        static clod_status status;
        close(ends[0]);
        const bool good = draw_share(picture, folder, first, jobs, &status);
        if (!good && write(ends[1], status.text, strlen(status.text)) < 0) {
            _exit(CLOD_FAILED);
        }
        _exit(good ? 0 : (int)status.code);
    }
    close(ends[1]);
    self->words = ends[0];
    if (self->process < 0) {
        close(ends[0]);
    }
    return self->process > 0;
}

/** Wait for a process; false with what it said, if nothing went wrong before. */
static bool finish(const worker *self, bool good, clod_status *status)
{
    static char text[CLOD_STATUS_TEXT];
    size_t used = 0;
    ssize_t got;
    while (used + 1 < sizeof text &&
           (got = read(self->words, text + used, sizeof text - 1 - used)) != 0) {
        if (got < 0 && errno != EINTR) {
            break;
        }
        used += got > 0 ? (size_t)got : 0;
    }
    text[used] = '\0';
    close(self->words);
    int ended = 0;
    while (waitpid(self->process, &ended, 0) < 0 && errno == EINTR) {
    }
    if (!good || (WIFEXITED(ended) && WEXITSTATUS(ended) == 0)) {
        return good;
    }
    if (used > 0) {
        const int code = WIFEXITED(ended) ? WEXITSTATUS(ended) : CLOD_FAILED;
        return clod_status_fail(status, (clod_code)code, "%s", text);
    }
    return clod_status_fail(status, CLOD_FAILED,
                            "A process that draws frames ended before it was done (%s %d). Was "
                            "there memory enough? --jobs 1 takes least.",
                            WIFSIGNALED(ended) ? "signal" : "exit status",
                            WIFSIGNALED(ended) ? WTERMSIG(ended) : WEXITSTATUS(ended));
}

static bool draw_all(const clod_app_frames_job *self, const clod_picture *picture,
                     const char *folder, clod_status *status)
{
    const size_t frames = clod_picture_count(picture);
    const size_t jobs = (size_t)self->jobs < frames ? (size_t)self->jobs : frames;
    if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
        return clod_status_fail(status, CLOD_FAILED, "%s: the folder cannot be made: %s.",
                                folder, strerror(errno));
    }
    static worker workers[CLOD_APP_FRAMES_JOBS];
    size_t started = 0;
    while (started < jobs && start(&workers[started], picture, folder, started, jobs)) {
        started++;
    }
    bool good =
        started == jobs ||
        clod_status_fail(status, CLOD_FAILED, "No process to draw with: %s.", strerror(errno));
    for (size_t k = 0; k < started; k++) {
        good = finish(&workers[k], good, status);
    }
    return good;
}

/** Run ffmpeg; its exit status, 127 when it is not there. */
static int run_ffmpeg(char *const *arguments)
{
    const pid_t process = fork();
    if (process == 0) {
        execvp(arguments[0], arguments);
        _exit(127);
    }
    int ended = 0;
    while (process > 0 && waitpid(process, &ended, 0) < 0 && errno == EINTR) {
    }
    return process > 0 && WIFEXITED(ended) ? WEXITSTATUS(ended) : 1;
}

static bool find_ffmpeg(clod_status *status)
{
    static char *const ASK[] = {"ffmpeg", "-loglevel", "error", "-h", NULL};
    fflush(NULL);
    const pid_t process = fork();
    if (process == 0) {
        if (freopen("/dev/null", "w", stdout) != NULL) {
            execvp(ASK[0], ASK);
        }
        _exit(127);
    }
    int ended = 0;
    while (process > 0 && waitpid(process, &ended, 0) < 0 && errno == EINTR) {
    }
    return (process > 0 && WIFEXITED(ended) && WEXITSTATUS(ended) == 0) ||
           clod_status_fail(status, CLOD_USAGE,
                            "--movie needs the program ffmpeg: apt install ffmpeg. Without it "
                            "--all draws the frames.");
}

static bool make_movie(const char *folder, size_t frames, const char *movie,
                       clod_status *status)
{
    char pattern[ROOM], rate[16], count[32];
    const size_t per_second = frames / MOVIE_SECONDS;
    snprintf(pattern, sizeof pattern, "%s/frame_%%06d.png", folder);
    snprintf(rate, sizeof rate, "%zu",
             per_second < 2            ? 2
             : per_second > MOVIE_RATE ? MOVIE_RATE
                                       : per_second);
    snprintf(count, sizeof count, "%zu", frames);
    char file[ROOM];
    snprintf(file, sizeof file, "file:%s", movie);
    char *arguments[] = {"ffmpeg",
                         "-y",
                         "-nostdin",
                         "-loglevel",
                         "error",
                         "-framerate",
                         rate,
                         "-start_number",
                         "0",
                         "-i",
                         pattern,
                         "-frames:v",
                         count,
                         "-vf",
                         "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white",
                         "-pix_fmt",
                         "yuv420p",
                         "-movflags",
                         "+faststart",
                         file,
                         NULL};
    return run_ffmpeg(arguments) == 0 ||
           clod_status_fail(status, CLOD_FAILED,
                            "%s: ffmpeg cannot make the movie; the frames are in %s.", movie,
                            folder);
}

static bool draw_film(const clod_app_frames_job *self, const clod_picture *picture,
                      const char *name, clod_status *status)
{
    char folder[PATH_MAX], said[2 * PATH_MAX];
    snprintf(folder, sizeof folder, "%.*s%s", PATH_MAX - 16,
             self->output != NULL ? self->output : name, self->output != NULL ? "" : "-frames");
    const size_t frames = clod_picture_count(picture);
    if (!draw_all(self, picture, folder, status) ||
        (self->movie != NULL && !make_movie(folder, frames, self->movie, status))) {
        return false;
    }
    snprintf(said, sizeof said, "%s: %zu frames from %.6g s to %.6g s\n", folder, frames,
             clod_picture_time(picture, 0), clod_picture_time(picture, frames - 1));
    clod_output_put(said);
    if (self->movie != NULL) {
        snprintf(said, sizeof said, "%s\n", self->movie);
        clod_output_put(said);
    }
    return true;
}

static bool draw_one(const clod_app_frames_job *self, const clod_picture *picture,
                     const char *name, clod_status *status)
{
    char path[PATH_MAX], said[PATH_MAX + 64];
    snprintf(path, sizeof path, "%.*s%s", PATH_MAX - 16,
             self->output != NULL ? self->output : name, self->output != NULL ? "" : ".png");
    if (!clod_picture_draw(picture, 0, path, status)) {
        return false;
    }
    snprintf(said, sizeof said, "%s: t = %.6g s\n", path, clod_picture_time(picture, 0));
    clod_output_put(said);
    return true;
}

bool clod_app_frames(const clod_app_frames_job *self, clod_status *status)
{
    if (self->movie != NULL && !find_ffmpeg(status)) {
        return false;
    }
    clod_picture *picture = clod_picture_open(self->options, status);
    if (picture == NULL) {
        return false;
    }
    char name[PATH_MAX];
    name_run(self->options, name);
    const bool done = self->options->all ? draw_film(self, picture, name, status)
                                         : draw_one(self, picture, name, status);
    clod_picture_close(&picture);
    return done;
}
