#include "config/suggest.h"

#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define LONGEST 63

static size_t least(size_t a, size_t b, size_t c)
{
    const size_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/** Edit distance with neighbours swapped (Damerau, restricted); a change of case is free. */
static size_t distance(const char *a, const char *b)
{
    const size_t m = strlen(a);
    const size_t n = strlen(b);
    if (m > LONGEST || n > LONGEST) {
        return SIZE_MAX;
    }
    size_t rows[3][LONGEST + 1];
    for (size_t j = 0; j <= n; j++) {
        rows[0][j] = j;
    }
    for (size_t i = 1; i <= m; i++) {
        size_t *row = rows[i % 3];
        const size_t *above = rows[(i + 2) % 3];
        const size_t *above2 = rows[(i + 1) % 3];
        row[0] = i;
        for (size_t j = 1; j <= n; j++) {
            const int x = tolower((unsigned char)a[i - 1]);
            const int y = tolower((unsigned char)b[j - 1]);
            row[j] = least(above[j] + 1, row[j - 1] + 1, above[j - 1] + (x != y));
            if (i > 1 && j > 1 && x == tolower((unsigned char)b[j - 2]) &&
                y == tolower((unsigned char)a[i - 2]) && above2[j - 2] + 1 < row[j]) {
                row[j] = above2[j - 2] + 1;
            }
        }
    }
    return rows[m % 3][n];
}

clod_suggest clod_suggest_start(const char *word)
{
    return (clod_suggest){.word = word, .best = NULL, .distance = SIZE_MAX};
}

void clod_suggest_offer(clod_suggest *self, const char *known)
{
    const size_t d = distance(self->word, known);
    if (d < self->distance) {
        self->distance = d;
        self->best = known;
    }
}

bool clod_suggest_found(const clod_suggest *self)
{
    const size_t limit = strlen(self->word) < 4 ? 1 : (strlen(self->word) + 2) / 3;
    return self->best != NULL && self->distance <= limit;
}

const char *clod_suggest_text(const clod_suggest *self, char *buffer, size_t size)
{
    buffer[0] = '\0';
    if (clod_suggest_found(self)) {
        snprintf(buffer, size, "; did you mean %s?", self->best);
    }
    return buffer;
}
