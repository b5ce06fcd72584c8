/**
 * @file mesh_obj.c
 * OBJ: vertices, faces, names. The content is written anew in its own place with nothing but
 * lines `v x y z` and `f i j k ...`, so that Assimp neither opens material files nor splits the
 * mesh by material.
 *
 * Assimp drops a vertex without a word where it takes a coordinate for no number, and those behind
 * it move up. So numbers are written as it reads them (`.5` as `0.5`), and one more vertex and
 * facet stand behind all others (CLOD_MESH_END): they tell whether it counted every vertex.
 */

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/mesh_source.h"
#include "mesh/mesh_words.h"

typedef struct reader {
    clod_mesh_source *source;
    clod_mesh_cursor at;
    char *out; ///< end of what was written; never beyond what was read, which begins behind it
    int64_t vertices;
    clod_status *status;
} reader;

/** Words that would silently be missing in the mesh: curved surfaces, other files. */
static const char *const UNREAD[] = {"surf", "curv", "curv2", "call",
                                     "bzp",  "bsp",  "cdc",   "res"};

static bool fail(const reader *r, clod_mesh_word word, const char *problem)
{
    return clod_status_fail(r->status, CLOD_USAGE, "%s:%zu: \"%.*s\": %s", r->source->path,
                            r->at.line, clod_mesh_words_shown(word), word.text, problem);
}

/** The next word of a line, which goes on below a backslash. */
static clod_mesh_word next_word(reader *r)
{
    for (;;) {
        clod_mesh_word word = clod_mesh_words_in_line(&r->at);
        const bool more = word.length > 0 && word.text[word.length - 1] == '\\' &&
                          r->at.at < r->at.end && *r->at.at == '\n';
        if (!more) {
            return word;
        }
        r->at.at++;
        r->at.line++;
        if (--word.length > 0) {
            return word;
        }
    }
}

/** Write a blank and a word; no unread byte is overwritten, since both were read. */
static void put(reader *r, const char *text, size_t length)
{
    *r->out++ = ' ';
    memmove(r->out, text, length);
    r->out += length;
}

/** Write a number with a digit in front, where Assimp looks for one. */
static void put_number(reader *r, clod_mesh_word word)
{
    const bool pointed = word.text[0] == '.'; // put may write over it
    put(r, word.text, word.length);
    if (pointed) {
        char *at = r->out - word.length;
        memmove(at + 1, at, word.length); // into what make_room left free
        *at = '0';
        r->out++;
    }
}

/** A fourth number is a weight, 1 for anything but rational curves; colours may follow. */
static bool skip_rest_of_vertex(reader *r)
{
    clod_mesh_word extra[2] = {next_word(r), {NULL, 0}};
    if (extra[0].length == 0) {
        return true;
    }
    extra[1] = next_word(r);
    if (extra[1].length == 0) {
        static const char *const ONES[] = {"1",     "1.",     "1.0",     "1.00",
                                           "1.000", "1.0000", "1.00000", "1.000000"};
        for (size_t k = 0; k < sizeof ONES / sizeof ONES[0]; k++) {
            if (clod_mesh_words_is(extra[0], ONES[k])) {
                return true;
            }
        }
        return fail(r, extra[0],
                    "a vertex with a weight other than 1 is not read; export plain "
                    "vertices: v x y z");
    }
    clod_mesh_words_rest(&r->at);
    return true;
}

static bool read_vertex(reader *r)
{
    if (r->vertices == CLOD_MESH_VERTICES_MOST) {
        return fail(r, (clod_mesh_word){r->at.at, 0},
                    "too many vertices, 15 million are read; export a coarser mesh");
    }
    *r->out++ = 'v';
    for (int c = 0; c < 3; c++) {
        const clod_mesh_word word = next_word(r);
        if (word.length == 0) {
            return clod_status_fail(
                r->status, CLOD_USAGE,
                "%s:%zu: vertex %lld has %d coordinates, three are expected; "
                "was the file cut off?",
                r->source->path, r->at.line, (long long)r->vertices + 1, c);
        }
        if (!clod_mesh_words_number(word)) {
            return fail(r, word, "a coordinate must be a finite number; export the mesh again");
        }
        put_number(r, word);
    }
    r->vertices++;
    if (!skip_rest_of_vertex(r)) {
        return false;
    }
    *r->out++ = '\n';
    return true;
}

/** A corner: number of a vertex, from 1 or back from the last; `/` and what follows is dropped. */
static bool read_corner(reader *r, clod_mesh_word word)
{
    const char *slash = memchr(word.text, '/', word.length);
    const clod_mesh_word index = {word.text,
                                  slash != NULL ? (size_t)(slash - word.text) : word.length};
    int64_t value = 0;
    if (!clod_mesh_words_whole(index, &value)) {
        return fail(r, word, "a corner of a facet must be the number of a vertex");
    }
    if (value == 0 || value > r->vertices || -value > r->vertices) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s:%zu: facet %zu: there is no vertex %lld; %lld stand above "
                                "this line, the first has number 1",
                                r->source->path, r->at.line, r->source->facets + 1,
                                (long long)value, (long long)r->vertices);
    }
    put(r, index.text, index.length);
    return true;
}

static bool read_face(reader *r)
{
    size_t corners = 0;
    *r->out++ = 'f';
    for (clod_mesh_word word = next_word(r); word.length > 0 && word.text[0] != '#';
         word = next_word(r)) {
        if (!read_corner(r, word)) {
            return false;
        }
        corners++;
    }
    clod_mesh_words_rest(&r->at); // a remark
    if (corners < 3 || corners > CLOD_MESH_CORNERS_MOST) {
        return clod_status_fail(
            r->status, CLOD_USAGE,
            "%s:%zu: facet %zu has %zu corners; from 3 to %d are read: export "
            "triangles",
            r->source->path, r->at.line, r->source->facets + 1, corners,
            CLOD_MESH_CORNERS_MOST);
    }
    *r->out++ = '\n';
    return clod_mesh_source_add(r->source, corners - 2, r->status);
}

static bool read_line(reader *r)
{
    const clod_mesh_word word = next_word(r);
    if (clod_mesh_words_is(word, "v")) {
        return read_vertex(r);
    }
    if (clod_mesh_words_is(word, "f") || clod_mesh_words_is(word, "fo")) {
        return read_face(r);
    }
    if (clod_mesh_words_is(word, "o") || clod_mesh_words_is(word, "g")) {
        const clod_mesh_word name = clod_mesh_words_rest(&r->at);
        return clod_mesh_source_part(r->source, name.text, name.length, r->at.line, r->status);
    }
    for (size_t k = 0; k < sizeof UNREAD / sizeof UNREAD[0]; k++) {
        if (clod_mesh_words_is(word, UNREAD[k])) {
            return fail(r, word,
                        "curved surfaces and other files are not read; export triangles");
        }
    }
    clod_mesh_words_rest(&r->at);
    return true;
}

/** Bytes for the last lines. */
#define END_MOST 64

/** Words that begin with a point: each may be written with one byte more than it has. */
static size_t count_points(const clod_mesh_source *self)
{
    size_t count = 0;
    for (size_t k = 1; k < self->length; k++) {
        const char before = self->bytes[k - 1];
        count += self->bytes[k] == '.' && (before == '\n' || clod_mesh_words_blank(before));
    }
    return count;
}

/** Room before the content, as much as numbers grow by, and behind it; where the content begins. */
static char *make_room(clod_mesh_source *self, clod_status *status)
{
    const size_t before = count_points(self);
    const size_t room = before + self->length + END_MOST;
    char *bytes = clod_memory_grow(self->bytes, self->length + 1, room, 1);
    if (bytes == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", self->path);
        return NULL;
    }
    memmove(bytes + before, bytes, self->length);
    self->bytes = bytes;
    return bytes + before;
}

/** The last vertex, and a facet of it alone. */
static void put_end(reader *r)
{
    if (r->source->facets == 0) {
        return; // it is refused
    }
    r->source->extra = 1;
    const long long number = (long long)r->vertices + 1;
    r->out += snprintf(r->out, END_MOST, "v %d %d %d\nf %lld %lld %lld\n", CLOD_MESH_END[0],
                       CLOD_MESH_END[1], CLOD_MESH_END[2], number, number, number);
}

bool clod_mesh_obj_check(clod_mesh_source *self, clod_status *status)
{
    const char *zero = memchr(self->bytes, '\0', self->length);
    if (zero != NULL) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: byte %td is zero, but an OBJ file is a text; is it another "
            "format with a wrong name, or damaged?",
            self->path, zero - self->bytes + 1);
    }
    char *begin = make_room(self, status);
    if (begin == NULL) {
        return false;
    }
    reader r = {self, {begin, begin + self->length, 1}, self->bytes, 0, status};
    if (self->length >= 3 && memcmp(begin, "\xEF\xBB\xBF", 3) == 0) {
        r.at.at += 3;
    }
    while (r.at.at < r.at.end) {
        if (!read_line(&r)) {
            return false;
        }
        if (r.at.at < r.at.end) { // its end
            r.at.at++;
            r.at.line++;
        }
    }
    put_end(&r);
    self->length = (size_t)(r.out - self->bytes);
    *r.out = '\0';
    return true;
}
