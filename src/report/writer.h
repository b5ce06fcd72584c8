#pragma once
/**
 * @file writer.h
 * What stands on a page and in a terminal, written once: as HTML, and as the text that plain.h lays out.
 */

#include <stdio.h>

typedef struct clod_writer {
    FILE *page; ///< HTML
    FILE *text; ///< as clod_plain_put takes it; NULL: none
} clod_writer;

/** One that writes a page only. */
static inline clod_writer clod_writer_page(FILE *page)
{
    return (clod_writer){.page = page};
}

/** Write what the two do not share: tags of the page; ends of cells, lines and tables of the text. */
void clod_writer_mark(clod_writer self, const char *page, const char *text);

/** Write a text as it is: escaped on the page, and in the text with ? for control characters. NULL: a dash. */
void clod_writer_text(clod_writer self, const char *text);

/** Write a symbol, "sigma_1", which has a Greek letter and a subscript on the page. */
void clod_writer_symbol(clod_writer self, const char *symbol);

/** Write words of clod with symbols in them, "flowability $sigma_1$/$sigma_c$".   Test  tests/report/test_plain.c */
void clod_writer_words(clod_writer self, const char *words);

/** Write a cell of a table, `tag` th or td. */
void clod_writer_cell(clod_writer self, const char *tag, const char *text);
