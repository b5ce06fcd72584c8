#include "sim/case_diff.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"

#define DEPTH 24

/** A line of a case that has a value, and its whole key. */
typedef struct line {
    char *key;         ///< owned
    const char *value; ///< in the text
} line;

/** A section or a list item that is open. */
typedef struct level {
    size_t column;    ///< in which it begins
    const char *name; ///< key, in the text; NULL: a list item
    int item;         ///< number of the list item at this column
} level;

/** Sections that are open, the outermost first. */
typedef struct outline {
    int depth;
    level levels[DEPTH];
} outline;

static void enter(outline *self, size_t column, const char *name)
{
    while (self->depth > 0 && self->levels[self->depth - 1].column > column) {
        self->depth--;
    }
    const bool beside = self->depth > 0 && self->levels[self->depth - 1].column == column;
    if (!beside && self->depth < DEPTH) {
        self->levels[self->depth++] = (level){.column = column, .item = -1};
    }
    level *last = &self->levels[self->depth - 1];
    last->name = name;
    last->item += name == NULL ? 1 : 0;
}

/** The whole key, with points between its names; owned. NULL without memory. */
static char *join(const outline *self)
{
    size_t size = 1;
    for (int d = 0; d < self->depth; d++) {
        const char *name = self->levels[d].name;
        size += 1 + (name != NULL ? strlen(name) : 3 * sizeof(int));
    }
    char *key = clod_memory_alloc(size, 1);
    size_t used = 0;
    for (int d = 0; key != NULL && d < self->depth; d++) {
        const level *one = &self->levels[d];
        const char *point = d > 0 ? "." : "";
        const int length = one->name != NULL
                               ? snprintf(key + used, size - used, "%s%s", point, one->name)
                               : snprintf(key + used, size - used, "%s%d", point, one->item);
        used += (size_t)length;
    }
    return key;
}

/** The colon behind a key, which may be in quotes as clod_case_echo writes them; NULL: none. */
static char *find_colon(char *key)
{
    if (*key == '"') {
        for (key++; *key != '"' && *key != '\0'; key++) {
            key += *key == '\\' && key[1] != '\0' ? 1 : 0;
        }
    }
    return strchr(key, ':');
}

/** Split a text, which is cut up, into lines; *count: how many. False without memory. */
static bool read_lines(char *text, line *lines, size_t *count)
{
    outline at = {0};
    char *rest = text;
    for (char *row; (row = strsep(&rest, "\n")) != NULL;) {
        size_t column = strspn(row, " ");
        while (strncmp(row + column, "- ", 2) == 0) {
            enter(&at, column, NULL);
            column += 2;
        }
        char *colon = find_colon(row + column);
        if (row[column] == '#' || colon == NULL) {
            continue;
        }
        const char *value = colon + 1 + strspn(colon + 1, " ");
        *colon = '\0';
        enter(&at, column, row + column);
        if (*value != '\0') { // else it is the name of a section
            lines[*count] = (line){join(&at), value};
            if (lines[(*count)++].key == NULL) {
                return false;
            }
        }
    }
    return true;
}

static const line *find(const line *lines, size_t count, const char *key)
{
    for (size_t n = 0; n < count; n++) {
        if (strcmp(lines[n].key, key) == 0) {
            return &lines[n];
        }
    }
    return NULL;
}

static size_t count_lines(const char *text)
{
    size_t count = 1;
    for (; *text != '\0'; text++) {
        count += *text == '\n' ? 1 : 0;
    }
    return count;
}

static void compare(line *const lines[2], const size_t counts[2], clod_case_difference visit,
                    void *context)
{
    for (size_t n = 0; n < counts[0]; n++) {
        const line *other = find(lines[1], counts[1], lines[0][n].key);
        if (other == NULL || strcmp(other->value, lines[0][n].value) != 0) {
            visit(context, lines[0][n].key, lines[0][n].value,
                  other != NULL ? other->value : NULL);
        }
    }
    for (size_t n = 0; n < counts[1]; n++) {
        if (find(lines[0], counts[0], lines[1][n].key) == NULL) {
            visit(context, lines[1][n].key, NULL, lines[1][n].value);
        }
    }
}

bool clod_case_differences(const char *there, const char *here, clod_case_difference visit,
                           void *context, clod_status *status)
{
    char *texts[2] = {clod_memory_text(there), clod_memory_text(here)};
    line *lines[2] = {clod_memory_alloc(count_lines(there), sizeof(line)),
                      clod_memory_alloc(count_lines(here), sizeof(line))};
    size_t counts[2] = {0, 0};
    bool room = true;
    for (int t = 0; t < 2; t++) {
        room = room && texts[t] != NULL && lines[t] != NULL &&
               read_lines(texts[t], lines[t], &counts[t]);
    }
    if (room) {
        compare(lines, counts, visit, context);
    }
    for (int t = 0; t < 2; t++) {
        for (size_t n = 0; n < counts[t]; n++) {
            clod_memory_free(lines[t][n].key);
        }
        clod_memory_free(texts[t]);
        clod_memory_free(lines[t]);
    }
    return room || clod_status_fail(status, CLOD_FAILED, "no memory to compare two cases");
}
