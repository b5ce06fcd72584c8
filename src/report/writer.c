#include "report/writer.h"

#include <stdbool.h>
#include <string.h>

#include "report/html.h"

void clod_writer_mark(clod_writer self, const char *page, const char *text)
{
    fputs(page, self.page);
    if (self.text != NULL) {
        fputs(text, self.text);
    }
}

void clod_writer_text(clod_writer self, const char *text)
{
    clod_html_text(self.page, text);
    for (const char *at = text != NULL ? text : "-"; self.text != NULL && *at != '\0'; at++) {
        fputc((unsigned char)*at < ' ' ? '?' : *at, self.text);
    }
}

void clod_writer_symbol(clod_writer self, const char *symbol)
{
    static const char *const GREEK[] = {"phi", "rho", "sigma", "tau"};
    const size_t length = strcspn(symbol, "_");
    char letter[16];
    bool greek = false;
    snprintf(letter, sizeof letter, "%.*s", (int)length, symbol);
    for (size_t k = 0; k < sizeof GREEK / sizeof *GREEK; k++) {
        greek = greek || strcmp(letter, GREEK[k]) == 0;
    }
    fputs(greek ? "&" : "", self.page);
    clod_html_text(self.page, letter);
    fputs(greek ? ";" : "", self.page);
    if (symbol[length] == '_') {
        fputs("<sub>", self.page);
        clod_html_text(self.page, symbol + length + 1);
        fputs("</sub>", self.page);
    }
    clod_writer_mark(self, "", symbol);
}

void clod_writer_words(clod_writer self, const char *words)
{
    const char *end;
    for (bool symbol = false; (end = strchr(words, '$')) != NULL; symbol = !symbol) {
        char piece[400];
        snprintf(piece, sizeof piece, "%.*s", (int)(end - words), words);
        (symbol ? clod_writer_symbol : clod_writer_text)(self, piece);
        words = end + 1;
    }
    clod_writer_text(self, words);
}

void clod_writer_cell(clod_writer self, const char *tag, const char *text)
{
    fprintf(self.page, "<%s>", tag);
    clod_writer_text(self, text);
    fprintf(self.page, "</%s>", tag);
    clod_writer_mark(self, "", "\t");
}
