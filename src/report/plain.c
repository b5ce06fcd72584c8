#include "report/plain.h"

#include <stdbool.h>
#include <string.h>

#include "base/text.h"

#define BETWEEN 2 ///< blanks between columns
#define MOST 64   ///< columns that are aligned

static size_t *width_of(size_t width[MOST], size_t column)
{
    return &width[column < MOST ? column : MOST - 1];
}

/** End each cell with a 0, and find the widths of columns. */
static void measure(char *table, const char *end, size_t width[MOST])
{
    size_t column = 0;
    for (char *at = table; at < end; at++) {
        if (*at == '\n') {
            column = 0;
            continue;
        }
        char *tab = at + strcspn(at, "\t");
        *tab = '\0';
        clod_text_printable(at);
        const size_t own = clod_text_characters(at);
        size_t *most = width_of(width, column++);
        *most = own > *most ? own : *most;
        at = tab;
    }
}

/** Write a table; what is behind it. */
static char *put_table(FILE *out, char *table)
{
    char *const end = table + strcspn(table, "\f");
    size_t width[MOST] = {0};
    measure(table, end, width);
    size_t column = 0;
    for (const char *at = table; at < end; at++) {
        const int blanks = (int)(*width_of(width, column) - clod_text_characters(at));
        const bool last = at[strlen(at) + 1] == '\n';
        if (column == 0) { // names begin a line
            fprintf(out, "  %s%*s", at, last ? 0 : blanks, "");
        } else {
            fprintf(out, "%*s%s", blanks + BETWEEN, "", at);
        }
        fputs(last ? "\n" : "", out);
        column = last ? 0 : column + 1;
        at += strlen(at) + (last ? 1 : 0);
    }
    return end + 1;
}

void clod_plain_put(FILE *out, char *text)
{
    while (*text != '\0') {
        char *end = text + strcspn(text, "\n\t");
        if (*end == '\t') {
            text = put_table(out, text);
        } else {
            const bool more = *end != '\0';
            *end = '\0';
            clod_text_printable(text);
            fprintf(out, more ? "%s\n" : "%s", text);
            text = end + more;
        }
    }
}
