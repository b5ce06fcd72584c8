#include "output/eventlog.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"

struct clod_eventlog {
    int descriptor;
    int error;  ///< errno of the first write that failed, or 0
    char *path; ///< owned
    pthread_mutex_t lock;
};

/** Whether the last run was cut off within a line. */
static bool ends_within_line(int descriptor)
{
    struct stat info;
    char last;
    return fstat(descriptor, &info) == 0 && info.st_size > 0 &&
           pread(descriptor, &last, 1, info.st_size - 1) == 1 && last != '\n';
}

clod_eventlog *clod_eventlog_open(const char *path, clod_status *status)
{
    clod_eventlog *self = clod_memory_alloc(1, sizeof *self);
    char *copy = clod_memory_text(path);
    const int descriptor = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    bool good = descriptor >= 0;
    if (good && ends_within_line(descriptor)) {
        good = clod_file_write_all(descriptor, "\n", 1);
    }
    if (!good || self == NULL || copy == NULL) {
        clod_file_fail(status, "write", path, good ? ENOMEM : errno);
        if (descriptor >= 0) {
            close(descriptor);
        }
        clod_memory_free(self);
        clod_memory_free(copy);
        return NULL;
    }
    self->descriptor = descriptor;
    self->path = copy;
    pthread_mutex_init(&self->lock, NULL);
    return self;
}

/** Owned JSON text of the moment, UTC with milliseconds. */
static json_t *now_text(void)
{
    struct timespec now;
    struct tm parts;
    char day[40], text[64];
    clock_gettime(CLOCK_REALTIME, &now);
    gmtime_r(&now.tv_sec, &parts);
    strftime(day, sizeof day, "%Y-%m-%dT%H:%M:%S", &parts);
    snprintf(text, sizeof text, "%s.%03dZ", day, (int)(now.tv_nsec / 1000000));
    return json_string(text);
}

void clod_eventlog_write_json(clod_eventlog *self, const char *event, json_t *fields)
{
    if (self == NULL) {
        json_decref(fields);
        return;
    }
    json_t *line = json_object();
    json_object_set_new(line, "time", now_text());
    json_object_set_new(line, "event", json_string(event));
    json_object_update_missing(line, fields);
    json_decref(fields);
    char *text = json_dumps(line, JSON_COMPACT | JSON_REAL_PRECISION(17));
    json_decref(line);
    pthread_mutex_lock(&self->lock);
    const size_t length = text == NULL ? 0 : strlen(text);
    if (self->error == 0 && text == NULL) {
        self->error = ENOMEM;
    } else if (self->error == 0) {
        text[length] = '\n'; // one write per line, the end of the text included
        if (!clod_file_write_all(self->descriptor, text, length + 1)) {
            self->error = errno;
        }
    }
    pthread_mutex_unlock(&self->lock);
    free(text);
}

void clod_eventlog_write(clod_eventlog *self, const char *event, const char *format, ...)
{
    json_t *fields = NULL;
    if (format != NULL) {
        json_error_t error;
        va_list args;
        va_start(args, format);
        fields = json_vpack_ex(&error, 0, format, args);
        va_end(args);
        if (fields == NULL) { // a number that JSON cannot hold, for instance: keep the event
            fields = json_pack("{s:s}", "fields_lost", error.text);
        }
    }
    clod_eventlog_write_json(self, event, fields);
}

bool clod_eventlog_close(clod_eventlog **self, clod_status *status)
{
    clod_eventlog *log = *self;
    *self = NULL;
    if (log == NULL) {
        return true;
    }
    if (close(log->descriptor) != 0 && log->error == 0) {
        log->error = errno;
    }
    const bool good = log->error == 0 || clod_file_fail(status, "write", log->path, log->error);
    pthread_mutex_destroy(&log->lock);
    clod_memory_free(log->path);
    clod_memory_free(log);
    return good;
}
