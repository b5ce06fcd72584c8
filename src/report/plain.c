#include "report/plain.h"

#include <stdbool.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

#define BETWEEN 2 ///< blanks between columns

/** A cell of the table that is being read. */
typedef struct cell {
    size_t row, column;
    char *text; ///< owned
} cell;

typedef struct table {
    cell *cell; ///< [count] owned
    size_t count, rows, column;
} table;

/** Whether the text goes on with this. */
static bool begins(const char *at, const char *with)
{
    return strncmp(at, with, strlen(with)) == 0;
}

/** Write the character of an entity, "&sigma;" as its name; the place behind it. */
static const char *put_entity(FILE *out, const char *at)
{
    static const char *const KNOWN[][2] = {{"&amp;", "&"},        {"&lt;", "<"},
                                           {"&gt;", ">"},         {"&quot;", "\""},
                                           {"&nbsp;", " "},       {"&plusmn;", "\u00b1"},
                                           {"&sup2;", "\u00b2"},  {"&sup3;", "\u00b3"},
                                           {"&radic;", "\u221a"}, {"&middot;", "\u00b7"}};
    for (size_t k = 0; k < sizeof KNOWN / sizeof *KNOWN; k++) {
        if (begins(at, KNOWN[k][0])) {
            fputs(KNOWN[k][1], out);
            return at + strlen(KNOWN[k][0]);
        }
    }
    const size_t length = strcspn(at, "; \n<");
    if (at[length] != ';') { // none of a page
        fputc('&', out);
        return at + 1;
    }
    fwrite(at + 1, 1, length - 1, out);
    return at + length + 1;
}

/** The text of an element, up to where it is closed, without the elements in it; owned, NULL without memory. A subscript
 *  begins with _. @param end  [out] behind the element */
static char *text_of(const char *at, const char *close, const char **end)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    const char *stop = strstr(at, close);
    stop = stop != NULL ? stop : at + strlen(at);
    *end = *stop != '\0' ? stop + strlen(close) : stop;
    while (out != NULL && at < stop) {
        if (*at == '<') {
            fputs(begins(at, "<sub>") ? "_" : "", out);
            at += strcspn(at, ">") + 1;
        } else if (*at == '&') {
            at = put_entity(out, at);
        } else {
            fputc(*at++, out);
        }
    }
    char *whole = out != NULL ? clod_text_close(&text) : NULL;
    if (whole != NULL) {
        clod_text_printable(whole);
    }
    return whole;
}

static bool add_cell(table *self, char *text)
{
    cell *grown = clod_memory_grow(self->cell, self->count, self->count + 1, sizeof *grown);
    if (grown == NULL || text == NULL || self->rows == 0) {
        self->cell = grown != NULL ? grown : self->cell;
        clod_memory_free(text);
        return false;
    }
    self->cell = grown;
    self->cell[self->count++] = (cell){self->rows - 1, self->column++, text};
    return true;
}

static size_t width_of(const table *self, size_t column)
{
    size_t width = 0;
    for (size_t k = 0; k < self->count; k++) {
        const size_t own = clod_text_characters(self->cell[k].text);
        width = self->cell[k].column == column && own > width ? own : width;
    }
    return width;
}

static void put_cells(FILE *out, const table *self, const size_t *width)
{
    for (size_t k = 0; k < self->count; k++) {
        const cell *one = &self->cell[k];
        const size_t blanks = width[one->column] - clod_text_characters(one->text);
        const bool last = k + 1 == self->count || self->cell[k + 1].row != one->row;
        if (one->column == 0) { // names begin a line
            fprintf(out, "  %s%*s", one->text, last ? 0 : (int)blanks, "");
        } else {
            fprintf(out, "%*s%s", (int)(blanks + BETWEEN), "", one->text);
        }
        fputs(last ? "\n" : "", out);
    }
}

/** Write a table and forget it; false: no memory. */
static bool end_table(FILE *out, table *self)
{
    size_t columns = 0;
    for (size_t k = 0; k < self->count; k++) {
        columns = self->cell[k].column >= columns ? self->cell[k].column + 1 : columns;
    }
    size_t *width = clod_memory_alloc(columns + 1, sizeof *width);
    for (size_t c = 0; width != NULL && c < columns; c++) {
        width[c] = width_of(self, c);
    }
    if (width != NULL) {
        put_cells(out, self, width);
    }
    for (size_t k = 0; k < self->count; k++) {
        clod_memory_free(self->cell[k].text);
    }
    clod_memory_free(self->cell);
    *self = (table){0};
    clod_memory_free(width);
    return width != NULL;
}

/** A note, or a heading with an empty line above: a line of its own. */
static bool put_line(FILE *out, bool heading, char *text)
{
    if (text != NULL) {
        fprintf(out, heading ? "\n%s\n" : "%s\n", text);
    }
    clod_memory_free(text);
    return text != NULL;
}

bool clod_plain_put(FILE *out, const char *html)
{
    table self = {0};
    bool good = true;
    for (const char *at = strchr(html, '<'); good && at != NULL; at = strchr(at, '<')) {
        const char *inside = at + strcspn(at, ">");
        inside += *inside != '\0';
        if (begins(at, "<h3") || begins(at, "<p")) {
            const bool heading = begins(at, "<h3");
            good = put_line(out, heading, text_of(inside, heading ? "</h3>" : "</p>", &at));
        } else if (begins(at, "<th>") || begins(at, "<th ")) {
            good = add_cell(&self, text_of(inside, "</th>", &at));
        } else if (begins(at, "<td")) {
            good = add_cell(&self, text_of(inside, "</td>", &at));
        } else {
            self.rows += begins(at, "<tr");
            self.column = begins(at, "<tr") ? 0 : self.column;
            good = !begins(at, "</table") || end_table(out, &self);
            at = inside;
        }
    }
    return (self.count == 0 || end_table(out, &self)) && good;
}
