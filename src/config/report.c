#include "config/report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

#define MESSAGE_SIZE 1024
#define WINDOW 100 ///< bytes of a source line that are shown at most

/** Note the path of an error and all above it, "" too. */
static bool add_paths(clod_report *self, const char *path)
{
    size_t length = strlen(path);
    bool good = clod_index_add(&self->paths, &self->arena, path, length, 0);
    while (good && length > 0) {
        length--;
        if (length == 0 || path[length] == '.') {
            good = clod_index_add(&self->paths, &self->arena, path, length, 0);
        }
    }
    return good;
}

static bool reserve(clod_report *self)
{
    if (self->count < self->capacity) {
        return true;
    }
    const size_t capacity = self->capacity == 0 ? 16 : 2 * self->capacity;
    clod_report_item *items =
        clod_memory_grow(self->items, self->capacity, capacity, sizeof *items);
    if (items == NULL) {
        return false;
    }
    self->items = items;
    self->capacity = capacity;
    return true;
}

void clod_report_add(clod_report *self, clod_place place, const char *path, const char *format,
                     ...)
{
    char message[MESSAGE_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    clod_text_printable(message);
    char key[MESSAGE_SIZE + 64];
    const int start =
        snprintf(key, sizeof key, "%d:%d:%d:", place.source, place.line, place.column);
    const size_t length =
        (size_t)snprintf(key + start, sizeof key - (size_t)start, "%s", message) +
        (size_t)start;
    if (clod_index_find(&self->known, key, length, NULL)) {
        return;
    }
    clod_report_item item = {.place = place, .order = self->count};
    const char *copy = clod_arena_text(&self->arena, key, length);
    item.path = clod_arena_text(&self->arena, path, strlen(path));
    if (copy == NULL || item.path == NULL || !reserve(self) || !add_paths(self, item.path) ||
        !clod_index_add(&self->known, &self->arena, copy, length, 0)) {
        self->lost = true;
        return;
    }
    item.message = copy + start;
    self->items[self->count++] = item;
}

bool clod_report_clean(const clod_report *self, const char *path)
{
    return !clod_index_find(&self->paths, path, strlen(path), NULL);
}

static int compare(const void *left, const void *right)
{
    const clod_report_item *a = left;
    const clod_report_item *b = right;
    if (a->place.source != b->place.source) {
        return a->place.source < b->place.source ? -1 : 1;
    }
    if (a->place.source <= 0 && a->place.line != b->place.line) {
        return a->place.line < b->place.line ? -1 : 1;
    }
    if (a->place.source <= 0 && a->place.column != b->place.column) {
        return a->place.column < b->place.column ? -1 : 1;
    }
    return a->order < b->order ? -1 : a->order > b->order;
}

/** Start of a place's line, or NULL past the end. */
static const char *find_line(const clod_report *self, clod_place place, size_t *length)
{
    const bool included = place.source == CLOD_PLACE_INCLUDED;
    const char *at = included ? self->included_text : self->text;
    const char *end = at + (included ? self->included_length : self->length);
    for (int i = 1; i < place.line && at != NULL && at < end; i++) {
        at = memchr(at, '\n', (size_t)(end - at));
        at = at == NULL ? NULL : at + 1;
    }
    if (at == NULL || at >= end) {
        return NULL;
    }
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    *length = (size_t)((stop == NULL ? end : stop) - at);
    if (*length > 0 && at[*length - 1] == '\r') {
        (*length)--;
    }
    return at;
}

/** Byte offset of a column that counts characters. */
static size_t byte_of_column(const char *line, size_t length, int column)
{
    size_t at = 0;
    for (int i = 1; i < column && at < length; i++) {
        at++;
        while (at < length && ((unsigned char)line[at] & 0xC0) == 0x80) {
            at++;
        }
    }
    return at;
}

/** Where the character begins of which a byte is one. */
static size_t begin_of(const char *line, size_t length, size_t at)
{
    while (at > 0 && at < length && ((unsigned char)line[at] & 0xC0) == 0x80) {
        at--;
    }
    return at;
}

/** A piece of a line, with ? in place of what would spoil a terminal. */
static void put_line(FILE *out, const char *line, size_t length)
{
    for (size_t i = 0; i < length;) {
        const size_t size = clod_text_utf8(line + i, length - i);
        if (size == 0 || ((unsigned char)line[i] < ' ' && line[i] != '\t')) {
            fputc('?', out);
        } else {
            fwrite(line + i, 1, size, out);
        }
        i += size == 0 ? 1 : size;
    }
}

/** The source line and the caret under it, as two lines. */
static void print_source(FILE *out, const clod_report *self, clod_place place)
{
    size_t length = 0;
    const char *line = find_line(self, place, &length);
    if (line == NULL || length == 0) {
        return;
    }
    const size_t caret = byte_of_column(line, length, place.column);
    const size_t stop = byte_of_column(line, length, place.column + place.width);
    const size_t shown = begin_of(line, length, caret < WINDOW ? 0 : caret - WINDOW / 2);
    const size_t end =
        length - shown < WINDOW ? length : begin_of(line, length, shown + WINDOW);
    fputs("  ", out);
    put_line(out, line + shown, end - shown);
    fputs("\n  ", out);
    for (size_t i = shown; i < caret; i++) {
        if (((unsigned char)line[i] & 0xC0) != 0x80) {
            fputc(line[i] == '\t' ? '\t' : ' ', out);
        }
    }
    fputc('^', out);
    for (size_t i = caret + 1; i < stop && i < end; i++) {
        if (((unsigned char)line[i] & 0xC0) != 0x80) {
            fputc('~', out);
        }
    }
    fputc('\n', out);
}

static void print_item(FILE *out, const clod_report *self, const clod_report_item *item)
{
    const bool file = item->place.source <= 0;
    if (file) {
        const bool included = item->place.source == CLOD_PLACE_INCLUDED;
        fprintf(out, "%s:%d:%d: ", included ? self->included_name : self->name,
                item->place.line, item->place.column);
    } else {
        fprintf(out, "--set %s: ", self->overrides[item->place.source - 1]);
    }
    if (item->path[0] != '\0') {
        char path[MESSAGE_SIZE];
        snprintf(path, sizeof path, "%s", item->path);
        clod_text_printable(path);
        fprintf(out, "%s: ", path);
    }
    fprintf(out, "%s\n", item->message);
    if (file) {
        print_source(out, self, item->place);
    }
}

/** As many whole errors as fit into the status, then how many there are besides; false without
 *  memory. */
static bool print_all(const clod_report *self, clod_status *status)
{
    const size_t reserve_end = 64;
    size_t used = 0;
    size_t shown = 0;
    status->text[0] = '\0';
    for (; shown < self->count; shown++) {
        clod_text item;
        FILE *out = clod_text_open(&item);
        if (out == NULL) {
            return false;
        }
        print_item(out, self, &self->items[shown]);
        char *text = clod_text_close(&item);
        if (text == NULL) {
            return false;
        }
        const size_t size = strlen(text);
        const bool fits = used + size + reserve_end < sizeof status->text;
        if (fits) {
            memcpy(status->text + used, text, size + 1);
            used += size;
        }
        clod_memory_free(text);
        if (!fits) {
            break;
        }
    }
    if (shown < self->count) {
        snprintf(status->text + used, sizeof status->text - used, "and %zu more error%s\n",
                 self->count - shown, self->count - shown == 1 ? "" : "s");
    }
    const size_t length = strlen(status->text);
    if (length > 0 && status->text[length - 1] == '\n') {
        status->text[length - 1] = '\0';
    }
    return true;
}

bool clod_report_one(const clod_report *self, clod_place place, const char *path,
                     const char *message, clod_code code, clod_status *status)
{
    clod_report_item item = {.place = place, .path = path, .message = message};
    clod_report one = *self;
    one.items = &item;
    one.count = 1;
    status->code = code;
    return print_all(&one, status)
               ? false
               : clod_status_fail(status, CLOD_FAILED, "%s: out of memory", self->name);
}

bool clod_report_finish(clod_report *self, clod_status *status)
{
    if (self->lost) {
        return clod_status_fail(status, CLOD_FAILED, "%s: out of memory", self->name);
    }
    if (self->count == 0) {
        return true;
    }
    qsort(self->items, self->count, sizeof *self->items, compare);
    clod_status_fail(status, CLOD_USAGE, "%s", "");
    if (!print_all(self, status)) {
        return clod_status_fail(status, CLOD_FAILED, "%s: out of memory", self->name);
    }
    return false;
}

void clod_report_fini(clod_report *self)
{
    clod_memory_free(self->items);
    self->items = NULL;
    clod_arena_fini(&self->arena);
}
