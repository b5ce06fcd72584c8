#define _GNU_SOURCE // fopencookie

#include "base/text.h"

#include <ctype.h>
#include <string.h>

#include "base/memory.h"

#define ROOM 1024 ///< bytes to begin with

static bool reserve(clod_text *self, size_t size)
{
    if (size < self->capacity - self->length) { // the end fits too
        return true;
    }
    const size_t capacity = 2 * self->capacity + size;
    char *grown = clod_memory_grow(self->bytes, self->capacity, capacity, 1);
    if (grown == NULL) {
        return false;
    }
    self->bytes = grown;
    self->capacity = capacity;
    return true;
}

static ssize_t append(void *cookie, const char *bytes, size_t size)
{
    clod_text *self = cookie;
    self->lost = self->lost || !reserve(self, size);
    if (self->lost) {
        return 0; // the stream remembers it as an error
    }
    memcpy(self->bytes + self->length, bytes, size);
    self->length += size;
    return (ssize_t)size;
}

FILE *clod_text_open(clod_text *self)
{
    *self = (clod_text){.bytes = clod_memory_alloc(ROOM, 1), .capacity = ROOM};
    if (self->bytes != NULL) {
        self->out = fopencookie(self, "w", (cookie_io_functions_t){.write = append});
    }
    if (self->out == NULL) {
        clod_memory_free(self->bytes);
        self->bytes = NULL;
    }
    return self->out;
}

char *clod_text_close(clod_text *self)
{
    const bool whole = ferror(self->out) == 0;
    const bool closed = fclose(self->out) == 0;
    char *text = self->bytes;
    self->out = NULL;
    self->bytes = NULL;
    if (!whole || !closed || self->lost) {
        clod_memory_free(text);
        return NULL;
    }
    return text;
}

size_t clod_text_utf8(const char *text, size_t left)
{
    const unsigned char *at = (const unsigned char *)text;
    const unsigned char c = at[0];
    if (c < 0x80) {
        return 1;
    }
    const size_t length = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
    if (c < 0xC2 || c > 0xF4 || length > left) {
        return 0;
    }
    for (size_t i = 1; i < length; i++) {
        if ((at[i] & 0xC0) != 0x80) {
            return 0;
        }
    }
    const bool overlong = (c == 0xE0 && at[1] < 0xA0) || (c == 0xF0 && at[1] < 0x90);
    const bool surrogate = c == 0xED && at[1] > 0x9F;
    const bool too_large = c == 0xF4 && at[1] > 0x8F;
    return overlong || surrogate || too_large ? 0 : length;
}

static bool is_inside(char byte)
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

static size_t count(const char *text, size_t length)
{
    size_t characters = 0;
    for (size_t i = 0; i < length; i++) {
        characters += !is_inside(text[i]);
    }
    return characters;
}

size_t clod_text_characters(const char *text)
{
    return count(text, strlen(text));
}

void clod_text_fit(char *to, size_t size, size_t most, const char *from, size_t length)
{
    static const char POINTS[] = "...";
    const size_t points = sizeof POINTS - 1;
    if (length < size && count(from, length) <= most) {
        memcpy(to, from, length);
        to[length] = '\0';
        return;
    }
    size_t head = 0; // bytes of the beginning: whole characters of a third of the room
    for (size_t next = 1, used = 0; next <= (size - 1) / 3 && used < most / 3; next++) {
        if (next == length || !is_inside(from[next])) {
            head = next;
            used++;
        }
    }
    const size_t bytes = size - 1 - head - points;
    const size_t characters = most - count(from, head) - points;
    size_t tail = length; // where the end begins
    for (size_t at = length, used = 0; at > head && length - at < bytes && used < characters;) {
        at--;
        if (!is_inside(from[at])) {
            tail = at;
            used++;
        }
    }
    memcpy(to, from, head);
    memcpy(to + head, POINTS, points);
    memcpy(to + head + points, from + tail, length - tail);
    to[head + points + length - tail] = '\0';
}

#define MORE 32 ///< bytes that are kept for " and N more"

clod_text_names clod_text_names_begin(char *text, size_t size)
{
    text[0] = '\0';
    return (clod_text_names){.text = text, .size = size};
}

void clod_text_names_add(clod_text_names *self, const char *name)
{
    const char *comma = self->used > 0 ? ", " : "";
    const size_t length = strlen(comma) + strlen(name);
    if (self->more > 0 || length >= self->size - MORE - self->used) {
        self->more++;
        return;
    }
    snprintf(self->text + self->used, self->size - self->used, "%s%s", comma, name);
    self->used += length;
}

void clod_text_names_end(clod_text_names *self)
{
    if (self->more > 0) {
        snprintf(self->text + self->used, self->size - self->used, "%s%zu more",
                 self->used > 0 ? " and " : "", self->more);
    }
}

static const char *skip_digits(const char *at, const char *end)
{
    while (at < end && isdigit((unsigned char)*at)) {
        at++;
    }
    return at;
}

/** Behind the number that begins here: digits, decimals, exponent. */
static const char *skip_number(const char *at, const char *end)
{
    at = skip_digits(at, end);
    if (end - at > 1 && at[0] == '.' && isdigit((unsigned char)at[1])) {
        at = skip_digits(at + 1, end);
    }
    if (end - at > 2 && at[0] == 'e' && (at[1] == '-' || at[1] == '+') &&
        isdigit((unsigned char)at[2])) {
        at = skip_digits(at + 2, end);
    }
    return at;
}

bool clod_text_alike(const char *one, size_t one_length, const char *other, size_t other_length)
{
    const char *const one_end = one + one_length, *const other_end = other + other_length;
    while (one < one_end && other < other_end) {
        if (isdigit((unsigned char)*one) && isdigit((unsigned char)*other)) {
            one = skip_number(one, one_end);
            other = skip_number(other, other_end);
        } else if (*one++ != *other++) {
            return false;
        }
    }
    return one == one_end && other == other_end;
}

void clod_text_printable(char *text)
{
    for (size_t left = strlen(text); left > 0;) {
        const unsigned char c = (unsigned char)text[0];
        size_t length = clod_text_utf8(text, left);
        const bool high_control = c == 0xC2 && length == 2 && (unsigned char)text[1] < 0xA0;
        if (length == 0 || c < ' ' || c == 127 || high_control) {
            length = length == 0 ? 1 : length;
            memset(text, '?', length);
        }
        text += length;
        left -= length;
    }
}
