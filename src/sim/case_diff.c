#include "sim/case_diff.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"

#define DEPTH 24
#define KEY 512

/** A line of a case that has a value, and its whole key. */
typedef struct line {
    char key[KEY];
    char *value; ///< owned with the text
} line;

/** Keys of the sections that are open, by the column in which they begin. */
typedef struct outline {
    int depth;
    size_t column[DEPTH];
    char name[DEPTH][64];
    int item[DEPTH]; ///< number of the list item at this column
} outline;

static void enter(outline *self, size_t column, const char *name)
{
    while (self->depth > 0 && self->column[self->depth - 1] > column) {
        self->depth--;
    }
    const bool beside = self->depth > 0 && self->column[self->depth - 1] == column;
    if (!beside && self->depth < DEPTH) {
        self->column[self->depth] = column;
        self->item[self->depth] = -1;
        self->depth++;
    }
    if (name != NULL) {
        snprintf(self->name[self->depth - 1], sizeof self->name[0], "%s", name);
    } else { // a list item
        const int number = ++self->item[self->depth - 1];
        snprintf(self->name[self->depth - 1], sizeof self->name[0], "%d", number);
    }
}

static void join(const outline *self, char key[KEY])
{
    size_t used = 0;
    key[0] = '\0';
    for (int d = 0; d < self->depth && used < KEY; d++) {
        used +=
            (size_t)snprintf(key + used, KEY - used, "%s%s", d > 0 ? "." : "", self->name[d]);
    }
}

/** Split a text, which is cut up, into lines; returns how many. */
static size_t read_lines(char *text, line *lines)
{
    outline at = {0};
    size_t count = 0;
    char *rest = text;
    for (char *row; (row = strsep(&rest, "\n")) != NULL;) {
        size_t column = strspn(row, " ");
        while (strncmp(row + column, "- ", 2) == 0) {
            enter(&at, column, NULL);
            column += 2;
        }
        char *colon = strchr(row + column, ':');
        if (row[column] == '#' || colon == NULL) {
            continue;
        }
        char *value = colon + 1 + strspn(colon + 1, " ");
        *colon = '\0';
        enter(&at, column, row + column);
        if (*value != '\0') { // else it is the name of a section
            join(&at, lines[count].key);
            lines[count++].value = value;
        }
    }
    return count;
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

static void compare(char *texts[2], line *lines[2], clod_case_difference visit, void *context)
{
    const size_t there = read_lines(texts[0], lines[0]);
    const size_t here = read_lines(texts[1], lines[1]);
    for (size_t n = 0; n < there; n++) {
        const line *other = find(lines[1], here, lines[0][n].key);
        if (other == NULL || strcmp(other->value, lines[0][n].value) != 0) {
            visit(context, lines[0][n].key, lines[0][n].value,
                  other != NULL ? other->value : NULL);
        }
    }
    for (size_t n = 0; n < here; n++) {
        if (find(lines[0], there, lines[1][n].key) == NULL) {
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
    const bool room =
        texts[0] != NULL && texts[1] != NULL && lines[0] != NULL && lines[1] != NULL;
    if (room) {
        compare(texts, lines, visit, context);
    }
    for (int t = 0; t < 2; t++) {
        clod_memory_free(texts[t]);
        clod_memory_free(lines[t]);
    }
    return room || clod_status_fail(status, CLOD_FAILED, "no memory to compare two cases");
}
