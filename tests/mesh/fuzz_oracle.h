#pragma once
/**
 * @file fuzz_oracle.h
 * A second reader of the formats that are texts, for the fuzzer: small, slow, and sharing nothing
 * with the one that it checks. It reads files that the other accepted, so it asks for no grammar.
 */

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define ORACLE_MOST 65536 ///< words, vertices, corners, triangles

/** The corners of the polygons of a file, and the polygon of each of its triangles. */
typedef struct oracle {
    char *word[ORACLE_MOST]; ///< NULL: a line ends
    size_t word_count;
    double place[ORACLE_MOST][3];
    int64_t place_count;
    int64_t corner[ORACLE_MOST]; ///< a place
    size_t corner_count;
    size_t first[ORACLE_MOST], corners[ORACLE_MOST]; ///< of the polygon of a triangle
    size_t triangle_count;
} oracle;

/** Cut a text into words; false where it goes on below a backslash, or there is no room. */
static inline bool oracle_cut(oracle *self, char *text)
{
    self->word_count = 0;
    if (strchr(text, '\\') != NULL || strlen(text) > ORACLE_MOST / 4) {
        return false;
    }
    for (char *line = text; line != NULL;) {
        char *end = strchr(line, '\n');
        if (end != NULL) {
            *end = '\0';
        }
        char *rest = NULL;
        for (char *word = strtok_r(line, " \t\r\v\f", &rest); word != NULL;
             word = strtok_r(NULL, " \t\r\v\f", &rest)) {
            self->word[self->word_count++] = word;
        }
        self->word[self->word_count++] = NULL;
        line = end != NULL ? end + 1 : NULL;
    }
    return true;
}

static inline bool oracle_is(const oracle *self, size_t word, const char *name)
{
    return word < self->word_count && self->word[word] != NULL &&
           strcasecmp(self->word[word], name) == 0;
}

/** Skip what is left of a line. */
static inline size_t oracle_line(const oracle *self, size_t word)
{
    while (word < self->word_count && self->word[word] != NULL) {
        word++;
    }
    return word;
}

/** The next word, in this line or below. */
static inline size_t oracle_next(const oracle *self, size_t word)
{
    while (word < self->word_count && self->word[word] == NULL) {
        word++;
    }
    return word;
}

/** The last `count` corners are a polygon. */
static inline void oracle_polygon(oracle *self, size_t count)
{
    for (size_t t = 2; t < count; t++) {
        self->first[self->triangle_count] = self->corner_count - count;
        self->corners[self->triangle_count++] = count;
    }
}

static inline void oracle_obj(oracle *self)
{
    for (size_t w = 0; w < self->word_count; w = oracle_line(self, w) + 1) {
        if (oracle_is(self, w, "v")) {
            for (size_t k = 0; k < 3; k++) {
                self->place[self->place_count][k] = strtod(self->word[w + 1 + k], NULL);
            }
            self->place_count++;
        } else if (oracle_is(self, w, "f") || oracle_is(self, w, "fo")) {
            size_t count = 0;
            for (w++; self->word[w] != NULL && self->word[w][0] != '#'; w++, count++) {
                const int64_t given = strtoll(self->word[w], NULL, 10);
                self->corner[self->corner_count++] =
                    given > 0 ? given - 1 : self->place_count + given;
            }
            oracle_polygon(self, count);
        }
    }
}

static inline void oracle_stl(oracle *self)
{
    for (size_t w = 0; w < self->word_count; w++) {
        if (oracle_is(self, w, "solid") || oracle_is(self, w, "endsolid")) {
            w = oracle_line(self, w);
        } else if (oracle_is(self, w, "normal")) {
            w += 3;
        } else if (oracle_is(self, w, "vertex")) {
            for (size_t k = 0; k < 3; k++) {
                self->place[self->place_count][k] = strtod(self->word[++w], NULL);
            }
            self->corner[self->corner_count++] = self->place_count++;
            if (self->corner_count % 3 == 0) {
                oracle_polygon(self, 3);
            }
        }
    }
}

/** What the header of a PLY says. */
typedef struct oracle_header {
    int64_t vertices, faces;
    size_t properties, axis[3]; ///< of a vertex; which of them are its coordinates
    size_t lists;               ///< of a face
    bool plain;                 ///< text; vertices, then faces of one list alone
    size_t end;                 ///< first word behind it
} oracle_header;

static inline oracle_header oracle_ply_header(const oracle *self)
{
    oracle_header header = {.plain = true};
    bool of_faces = false;
    size_t w = 0;
    for (; w < self->word_count && !oracle_is(self, w, "end_header");
         w = oracle_line(self, w) + 1) {
        if (oracle_is(self, w, "format")) {
            header.plain = header.plain && oracle_is(self, w + 1, "ascii");
        } else if (oracle_is(self, w, "element")) {
            of_faces = oracle_is(self, w + 1, "face");
            int64_t *count = of_faces ? &header.faces : &header.vertices;
            *count = strtoll(self->word[w + 2], NULL, 10);
        } else if (oracle_is(self, w, "property") && of_faces) {
            header.plain = header.plain && oracle_is(self, w + 1, "list");
            header.lists++;
        } else if (oracle_is(self, w, "property")) {
            for (size_t k = 0; k < 3; k++) {
                const char name[2] = {"xyz"[k], '\0'};
                header.axis[k] =
                    oracle_is(self, w + 2, name) ? header.properties : header.axis[k];
            }
            header.properties++;
        }
    }
    header.plain = header.plain && header.lists == 1;
    header.end = oracle_line(self, w);
    return header;
}

static inline bool oracle_ply(oracle *self)
{
    const oracle_header header = oracle_ply_header(self);
    size_t w = header.end;
    for (int64_t v = 0; header.plain && v < header.vertices; v++) {
        w = oracle_next(self, w);
        for (size_t k = 0; k < 3; k++) {
            self->place[v][k] = strtod(self->word[w + header.axis[k]], NULL);
        }
        w += header.properties;
    }
    for (int64_t f = 0; header.plain && f < header.faces; f++) {
        w = oracle_next(self, w);
        const size_t count = strtoull(self->word[w++], NULL, 10);
        for (size_t k = 0; k < count; k++, w++) {
            self->corner[self->corner_count++] = strtoll(self->word[w], NULL, 10);
        }
        oracle_polygon(self, count);
    }
    return header.plain;
}

/** Read a file by its extension; false where the oracle does not know it. */
static inline bool oracle_read(oracle *self, const char *extension, char *text)
{
    self->place_count = 0;
    self->corner_count = self->triangle_count = 0;
    if (!oracle_cut(self, text)) {
        return false;
    }
    if (strcmp(extension, "ply") == 0) {
        return oracle_ply(self);
    }
    strcmp(extension, "obj") == 0 ? oracle_obj(self) : oracle_stl(self);
    return true;
}

/** Whether a triangle of the file has a corner at a place; `unit` is that of the file [m]. */
static inline bool oracle_has(const oracle *self, size_t triangle, const double place[3],
                              double unit, double tolerance)
{
    for (size_t k = 0; k < self->corners[triangle]; k++) {
        const double *at = self->place[self->corner[self->first[triangle] + k]];
        if (fabs(unit * at[0] - place[0]) <= tolerance &&
            fabs(unit * at[1] - place[1]) <= tolerance &&
            fabs(unit * at[2] - place[2]) <= tolerance) {
            return true;
        }
    }
    return false;
}
