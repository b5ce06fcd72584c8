/**
 * @file mesh_stl.c
 * STL, binary and text.
 */

#include <string.h>

#include "mesh/mesh_source.h"
#include "mesh/mesh_words.h"

#define HEADER 80
#define BODY 84 ///< first byte of the facets
#define FACET 50
#define LOOK 512 ///< bytes without a zero byte that make a text

static uint32_t little_endian(const char *bytes)
{
    uint32_t value = 0;
    for (int b = 3; b >= 0; b--) {
        value = value << 8 | (unsigned char)bytes[b];
    }
    return value;
}

static bool check_binary(clod_mesh_source *self, clod_status *status)
{
    memset(self->bytes, ' ', HEADER); // else Assimp looks for colours and byte order marks
    return clod_mesh_source_add(self, (self->length - BODY) / FACET, status);
}

/** Neither a text nor a binary file whose count of facets agrees with its size. */
static bool fail_size(const clod_mesh_source *self, clod_status *status)
{
    if (self->length < BODY) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: this is no STL file: it has %zu bytes, a binary one has %d "
            "and more, and a text begins with solid",
            self->path, self->length, BODY);
    }
    const uint32_t count = little_endian(self->bytes + HEADER);
    const size_t whole = (self->length - BODY) / FACET;
    const bool cut = BODY + (uint64_t)FACET * count > self->length;
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s: the header announces %u facets, which take %llu bytes, but the file has %zu, enough "
        "for %zu facets%s; %s",
        self->path, count, (unsigned long long)BODY + (unsigned long long)FACET * count,
        self->length, whole, cut ? "" : " and then some",
        cut ? "it was cut off, or is no STL file: export or copy it again"
            : "something follows the facets: export it again");
}

/** A word of the grammar is missing. */
static bool fail_word(const clod_mesh_source *self, const clod_mesh_cursor *at,
                      clod_mesh_word found, const char *expected, clod_status *status)
{
    if (found.length == 0 && at->at == at->end) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s:%zu: the file ends in facet %zu, where \"%s\" is expected; "
                                "it was cut off: export or copy it again",
                                self->path, at->line, self->facets + 1, expected);
    }
    if (found.length == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s:%zu: facet %zu: the line ends where \"%s\" is expected; "
                                "export the mesh again",
                                self->path, at->line, self->facets + 1, expected);
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "%s:%zu: facet %zu: \"%.*s\" where \"%s\" is expected; export the "
                            "mesh again",
                            self->path, at->line, self->facets + 1,
                            clod_mesh_words_shown(found), found.text, expected);
}

/** A word must be this keyword; it is written in small letters for Assimp. */
static bool accept(const clod_mesh_source *self, const clod_mesh_cursor *at,
                   clod_mesh_word word, const char *keyword, clod_status *status)
{
    if (!clod_mesh_words_is(word, keyword)) {
        return fail_word(self, at, word, keyword, status);
    }
    memcpy(word.text, keyword, word.length);
    return true;
}

/** The next word, in this line or below, must be this keyword. */
static bool expect(const clod_mesh_source *self, clod_mesh_cursor *at, const char *keyword,
                   clod_status *status)
{
    return accept(self, at, clod_mesh_words_next(at), keyword, status);
}

static bool check_vertex(const clod_mesh_source *self, clod_mesh_cursor *at,
                         clod_status *status)
{
    if (!expect(self, at, "vertex", status)) {
        return false;
    }
    for (int c = 0; c < 3; c++) {
        const clod_mesh_word word = clod_mesh_words_in_line(at);
        if (word.length == 0) {
            return fail_word(self, at, word, "coordinate", status);
        }
        if (!clod_mesh_words_number(word)) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s:%zu: facet %zu: coordinate %c is \"%.*s\", which is no "
                                    "finite number; export the mesh again",
                                    self->path, at->line, self->facets + 1, "xyz"[c],
                                    clod_mesh_words_shown(word), word.text);
        }
    }
    return true;
}

/** The rest of a facet; its normal is not used, whatever it is. */
static bool check_facet(clod_mesh_source *self, clod_mesh_cursor *at, clod_status *status)
{
    if (!accept(self, at, clod_mesh_words_in_line(at), "normal", status)) {
        return false;
    }
    for (int c = 0; c < 3; c++) {
        const clod_mesh_word word = clod_mesh_words_in_line(at);
        if (word.length == 0) {
            return fail_word(self, at, word, "normal", status);
        }
        memset(word.text, ' ', word.length);
        word.text[0] = '0';
    }
    return expect(self, at, "outer", status) && expect(self, at, "loop", status) &&
           check_vertex(self, at, status) && check_vertex(self, at, status) &&
           check_vertex(self, at, status) && expect(self, at, "endloop", status) &&
           expect(self, at, "endfacet", status) && clod_mesh_source_add(self, 1, status);
}

/** A solid behind its keyword `solid`; one without facets is blanked. */
static bool check_solid(clod_mesh_source *self, clod_mesh_cursor *at, char *begin,
                        clod_status *status)
{
    const size_t before = self->facets;
    const clod_mesh_word name = clod_mesh_words_rest(at);
    if (!clod_mesh_source_part(self, name.text, name.length, at->line, status)) {
        return false;
    }
    memset(name.text, ' ', name.length);
    for (;;) {
        const clod_mesh_word word = clod_mesh_words_next(at);
        if (clod_mesh_words_is(word, "endsolid")) {
            memcpy(word.text, "endsolid", word.length);
            break;
        }
        if (!clod_mesh_words_is(word, "facet")) {
            return fail_word(self, at, word, "facet or endsolid", status);
        }
        memcpy(word.text, "facet", word.length);
        if (!check_facet(self, at, status)) {
            return false;
        }
    }
    const clod_mesh_word again = clod_mesh_words_rest(at);
    memset(again.text, ' ', again.length);
    if (self->facets == before) {
        memset(begin, ' ', (size_t)(at->at - begin));
    }
    return true;
}

static bool check_text(clod_mesh_source *self, clod_mesh_cursor *at, clod_mesh_word first,
                       clod_status *status)
{
    self->begin = (size_t)(first.text - self->bytes);
    for (clod_mesh_word word = first; word.length > 0; word = clod_mesh_words_next(at)) {
        if (!clod_mesh_words_is(word, "solid")) {
            return fail_word(self, at, word, "solid", status);
        }
        memcpy(word.text, "solid", word.length);
        if (!check_solid(self, at, word.text, status)) {
            return false;
        }
        if (at->at < at->end) { // Assimp looks for the next solid in the line it stands in
            *at->at = self->facets == 0 ? ' ' : '\n';
            at->at++;
            at->line++;
        }
    }
    return true;
}

bool clod_mesh_stl_check(clod_mesh_source *self, clod_status *status)
{
    if (self->length >= BODY &&
        BODY + (uint64_t)FACET * little_endian(self->bytes + HEADER) == self->length) {
        return check_binary(self, status);
    }
    clod_mesh_cursor at = {self->bytes, self->bytes + self->length, 1};
    if (self->length >= 3 && memcmp(self->bytes, "\xEF\xBB\xBF", 3) == 0) {
        at.at += 3;
    }
    const clod_mesh_word first = clod_mesh_words_next(&at);
    const size_t look = self->length < LOOK ? self->length : LOOK;
    if (!clod_mesh_words_is(first, "solid") || memchr(self->bytes, '\0', look) != NULL) {
        return fail_size(self, status);
    }
    return check_text(self, &at, first, status);
}
