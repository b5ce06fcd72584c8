#include "sim/free_paths.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"

#define LIST 2048 ///< bytes of a list of words

static bool add_word(clod_free_paths *self, const char *before, const char *word, size_t length)
{
    const char *const names[] = {self->key, before};
    size_t size = length + 1;
    for (int k = 0; k < 2; k++) {
        size += names[k] != NULL ? strlen(names[k]) + 1 : 0;
    }
    char *text = clod_memory_alloc(size, 1);
    if (text == NULL ||
        !clod_room_for_one(&self->path, &self->room, self->count, sizeof *self->path)) {
        clod_memory_free(text);
        return false;
    }
    size_t used = 0;
    for (int k = 0; k < 2; k++) {
        used +=
            names[k] != NULL ? (size_t)snprintf(text + used, size - used, "%s.", names[k]) : 0;
    }
    memcpy(text + used, word, length);
    self->path[self->count++] = (clod_free_path){text, text + used};
    return true;
}

void clod_free_paths_add(clod_free_paths *self, const char *before, const char *list, ...)
{
    char words[LIST];
    va_list values;
    va_start(values, list);
    const int length = vsnprintf(words, sizeof words, list, values);
    va_end(values);
    CLOD_ASSERT(length > 0 && length < LIST);
    for (const char *word = words; *word != '\0';) {
        const size_t size = strcspn(word, " ");
        self->lost = !add_word(self, before, word, size) || self->lost;
        word += size + (word[size] == ' ' ? 1 : 0);
    }
}

void clod_free_paths_fini(clod_free_paths *self)
{
    for (size_t k = 0; k < self->count; k++) {
        clod_memory_free(self->path[k].text);
    }
    clod_memory_free(self->path);
    *self = (clod_free_paths){0};
}
