#include "output/eventlog.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"

struct clod_eventlog {
    const clod_folder *folder; ///< borrowed
    int descriptor;            ///< of the file; -1: lines are collected
    clod_bytes *lines;         ///< borrowed
    int error;                 ///< errno of the first write that failed, or 0
    char *name;                ///< owned
    pthread_mutex_t lock;
};

/** Begin a new line when the last run was cut off within one; 0 or an errno value. */
static int end_line(int descriptor)
{
    struct stat info;
    char last = '\n';
    if (fstat(descriptor, &info) != 0) {
        return errno;
    }
    ssize_t got = 1;
    do {
        got = info.st_size > 0 ? pread(descriptor, &last, 1, info.st_size - 1) : 1;
    } while (got < 0 && errno == EINTR);
    if (got < 0) {
        return errno;
    }
    return last == '\n' || clod_file_write_all(descriptor, "\n", 1) ? 0 : errno;
}

clod_eventlog *clod_eventlog_open(const clod_folder *folder, const char *name,
                                  clod_status *status)
{
    const int descriptor =
        clod_folder_open_file(folder, name, O_RDWR | O_CREAT | O_APPEND, status);
    if (descriptor < 0) {
        return NULL;
    }
    clod_eventlog *self = clod_memory_alloc(1, sizeof *self);
    char *copy = clod_memory_text(name);
    const int error = self == NULL || copy == NULL ? ENOMEM : end_line(descriptor);
    if (error != 0) {
        clod_folder_fail(folder, "write", name, error, status);
        clod_file_close(descriptor);
        clod_memory_free(self);
        clod_memory_free(copy);
        return NULL;
    }
    self->folder = folder;
    self->descriptor = descriptor;
    self->name = copy;
    pthread_mutex_init(&self->lock, NULL);
    return self;
}

clod_eventlog *clod_eventlog_collect(clod_bytes *lines)
{
    clod_eventlog *self = clod_memory_alloc(1, sizeof *self);
    if (self != NULL) {
        self->descriptor = -1;
        self->lines = lines;
        pthread_mutex_init(&self->lock, NULL);
    }
    return self;
}

/** Whole lines, by one write. */
static void put_lines(clod_eventlog *self, const char *text, size_t bytes)
{
    if (self->lines != NULL) {
        clod_bytes_put(self->lines, text, bytes);
    } else if (!clod_file_write_all(self->descriptor, text, bytes)) {
        self->error = errno;
    }
}

void clod_eventlog_append(clod_eventlog *self, const char *lines, size_t bytes)
{
    if (self == NULL || bytes == 0) {
        return;
    }
    pthread_mutex_lock(&self->lock);
    if (self->error == 0) {
        put_lines(self, lines, bytes);
    }
    pthread_mutex_unlock(&self->lock);
}

void clod_eventlog_write_json(clod_eventlog *self, const char *event, json_t *fields)
{
    if (self == NULL) {
        json_decref(fields);
        return;
    }
    char now[CLOD_CLOCK_TEXT];
    clod_clock_date(now);
    json_t *line = json_object();
    json_object_set_new(line, "time", json_string(now));
    json_object_set_new(line, "event", json_string(event));
    json_object_update_missing(line, fields);
    json_decref(fields);
    char *text = clod_json_text(line, JSON_COMPACT | JSON_REAL_PRECISION(17));
    json_decref(line);
    pthread_mutex_lock(&self->lock);
    const size_t length = text == NULL ? 0 : strlen(text);
    if (self->error == 0 && text == NULL) {
        self->error = ENOMEM;
    } else if (self->error == 0) {
        text[length] = '\n'; // one write per line, the end of the text included
        put_lines(self, text, length + 1);
    }
    pthread_mutex_unlock(&self->lock);
    clod_memory_free(text);
}

/** Whether a line is this event with these fields, whatever its time. */
static bool is_line(const char *line, size_t length, const char *event, const json_t *fields)
{
    json_t *found = json_loadb(line, length, 0, NULL);
    const char *name = json_string_value(json_object_get(found, "event"));
    bool same = name != NULL && strcmp(name, event) == 0;
    if (same) {
        json_object_del(found, "time");
        json_object_del(found, "event");
        same = json_equal(found, fields) != 0;
    }
    json_decref(found);
    return same;
}

static bool has_line(const clod_eventlog *self, const char *event, const json_t *fields)
{
    void *bytes = NULL;
    size_t size = 0;
    bool found = false;
    clod_status unused; // a log that cannot be read is told when it is written to
    if (self->lines != NULL ||
        !clod_folder_read(self->folder, self->name, &bytes, &size, &unused)) {
        return false;
    }
    const char *text = bytes;
    for (size_t at = 0; !found && at < size;) {
        const char *end = memchr(text + at, '\n', size - at);
        const size_t length = end != NULL ? (size_t)(end - (text + at)) : size - at;
        found = is_line(text + at, length, event, fields);
        at += length + 1;
    }
    clod_memory_free(bytes);
    return found;
}

void clod_eventlog_write_once(clod_eventlog *self, const char *event, json_t *fields)
{
    if (self != NULL && has_line(self, event, fields)) {
        json_decref(fields);
        return;
    }
    clod_eventlog_write_json(self, event, fields);
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
    const int closing = log->descriptor >= 0 ? clod_file_close(log->descriptor) : 0;
    const int error = log->error != 0 ? log->error : closing;
    const bool good = log->lines != NULL || error == 0 ||
                      clod_folder_fail(log->folder, "write", log->name, error, status);
    pthread_mutex_destroy(&log->lock);
    clod_memory_free(log->name);
    clod_memory_free(log);
    return good;
}
