/**
 * @file mesh_ply.c
 * PLY, text and binary: one list of vertices, then one of faces.
 */

#include "base/memory.h"
#include "mesh/mesh_source.h"
#include "mesh/mesh_words.h"

#define PROPERTIES_MOST 64

typedef enum form { FORM_TEXT, FORM_LITTLE, FORM_BIG } form;

typedef struct property {
    int size;    ///< bytes; of a list: of one item
    bool whole;  ///< an integer
    int counter; ///< bytes of the number of items; 0 = no list
} property;

typedef struct element {
    int64_t count;
    bool known;
    property properties[PROPERTIES_MOST];
    size_t property_count;
    int coordinates, lists; ///< how many of its properties are x, y or z, and lists
} element;

enum { VERTEX, FACE, ELEMENTS };

typedef struct reader {
    clod_mesh_source *source;
    clod_mesh_cursor at;
    form form;
    element elements[ELEMENTS];
    element *open; ///< that properties belong to
    clod_status *status;
} reader;

static const struct {
    const char *name;
    int size;
    bool whole;
} TYPES[] = {
    {"char", 1, true},   {"int8", 1, true},     {"uchar", 1, true},   {"uint8", 1, true},
    {"short", 2, true},  {"int16", 2, true},    {"ushort", 2, true},  {"uint16", 2, true},
    {"int", 4, true},    {"int32", 4, true},    {"uint", 4, true},    {"uint32", 4, true},
    {"float", 4, false}, {"float32", 4, false}, {"double", 8, false}, {"float64", 8, false},
};

static bool fail(const reader *r, clod_mesh_word word, const char *problem)
{
    return clod_status_fail(r->status, CLOD_USAGE, "%s:%zu: \"%.*s\": %s", r->source->path,
                            r->at.line, clod_mesh_words_shown(word), word.text, problem);
}

static bool read_format(reader *r)
{
    static const char *const FORMS[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const clod_mesh_word word = clod_mesh_words_in_line(&r->at);
    for (form f = FORM_TEXT; f <= FORM_BIG; f++) {
        if (clod_mesh_words_is(word, FORMS[f])) {
            r->form = f;
            return true;
        }
    }
    return fail(r, word, "the format must be ascii, binary_little_endian or binary_big_endian");
}

static bool read_element(reader *r)
{
    static const char *const NAMES[] = {"vertex", "face"};
    const clod_mesh_word name = clod_mesh_words_in_line(&r->at);
    const int which = clod_mesh_words_is(name, NAMES[VERTEX]) ? VERTEX : FACE;
    if (!clod_mesh_words_is(name, NAMES[which]) || r->elements[which].known ||
        (which == FACE && !r->elements[VERTEX].known)) {
        return fail(r, name,
                    "only vertices, and then faces, are read, each once; export without edges, "
                    "materials and other elements");
    }
    r->open = &r->elements[which];
    r->open->known = true;
    const clod_mesh_word count = clod_mesh_words_in_line(&r->at);
    if (!clod_mesh_words_whole(count, &r->open->count) || r->open->count < 0 ||
        r->open->count > (int64_t)r->source->length) {
        return fail(r, count,
                    "this cannot be how many there are: each takes some bytes of the "
                    "file");
    }
    return true;
}

/** Size of a type and whether it is whole; false for an unknown one. */
static bool read_type(reader *r, int *size, bool *whole)
{
    const clod_mesh_word word = clod_mesh_words_in_line(&r->at);
    for (size_t t = 0; t < sizeof TYPES / sizeof TYPES[0]; t++) {
        if (clod_mesh_words_is(word, TYPES[t].name)) {
            *size = TYPES[t].size;
            *whole = TYPES[t].whole;
            return true;
        }
    }
    return fail(r, word, "unknown type of a property");
}

static bool read_property(reader *r)
{
    const char *start = r->at.at;
    const clod_mesh_word kind = clod_mesh_words_in_line(&r->at);
    if (r->open == NULL || r->open->property_count == PROPERTIES_MOST) {
        return fail(r, kind, "a property belongs below an element, and 64 of them at most");
    }
    property *p = &r->open->properties[r->open->property_count++];
    const bool list = clod_mesh_words_is(kind, "list");
    bool whole = true;
    if (!list) {
        r->at.at = (char *)start;
    }
    if ((list && !read_type(r, &p->counter, &whole)) || !read_type(r, &p->size, &p->whole)) {
        return false;
    }
    const clod_mesh_word name = clod_mesh_words_in_line(&r->at);
    const bool corners =
        clod_mesh_words_is(name, "vertex_indices") || clod_mesh_words_is(name, "vertex_index");
    if (list && (r->open != &r->elements[FACE] || !corners || !whole || !p->whole)) {
        return fail(r, name,
                    "the only list that is read is vertex_indices of a face, of whole numbers; "
                    "export without textures");
    }
    if (!list && corners) {
        return fail(r, name, "the corners of a face must be a list");
    }
    r->open->lists += list;
    for (int c = 0; c < 3 && !list; c++) {
        r->open->coordinates += name.length == 1 && name.text[0] == "xyz"[c];
    }
    return true;
}

static bool read_header(reader *r)
{
    if (!clod_mesh_words_is(clod_mesh_words_in_line(&r->at), "ply")) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s: this is no PLY file: it does not begin with ply",
                                r->source->path);
    }
    bool formed = false;
    for (;;) {
        clod_mesh_words_rest(&r->at);
        const clod_mesh_word word = clod_mesh_words_next(&r->at);
        if (word.length == 0) {
            return clod_status_fail(r->status, CLOD_USAGE,
                                    "%s:%zu: the file ends before end_header; it was cut off",
                                    r->source->path, r->at.line);
        }
        if (clod_mesh_words_is(word, "end_header")) {
            return formed || fail(r, word, "there is no line that begins with format");
        }
        const bool is_format = clod_mesh_words_is(word, "format");
        const bool good =
            is_format                              ? read_format(r)
            : clod_mesh_words_is(word, "element")  ? read_element(r)
            : clod_mesh_words_is(word, "property") ? read_property(r)
            : clod_mesh_words_is(word, "comment") || clod_mesh_words_is(word, "obj_info")
                ? true
                : fail(r, word, "this is no line of a PLY header");
        if (!good) {
            return false;
        }
        formed = formed || is_format;
    }
}

static bool check_elements(const reader *r)
{
    const element *vertex = &r->elements[VERTEX], *face = &r->elements[FACE];
    if (vertex->coordinates != 3 || face->lists != 1) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s: the header must give vertices x, y and z, once each, and "
                                "faces one list vertex_indices",
                                r->source->path);
    }
    return true;
}

static bool fail_end(const reader *r, const char *what, int64_t number, int64_t count)
{
    return clod_status_fail(r->status, CLOD_USAGE,
                            "%s: the file ends in %s %lld of %lld; it was cut off: export or "
                            "copy it again",
                            r->source->path, what, (long long)number, (long long)count);
}

/** Corners of a face: how many, and each a vertex that there is. */
static bool check_count(const reader *r, int64_t face, uint64_t corners)
{
    return (corners >= 3 && corners <= CLOD_MESH_CORNERS_MOST) ||
           clod_status_fail(r->status, CLOD_USAGE,
                            "%s: face %lld has %llu corners; from 3 to %d are read: export "
                            "triangles",
                            r->source->path, (long long)face, (unsigned long long)corners,
                            CLOD_MESH_CORNERS_MOST);
}

static bool check_corner(const reader *r, int64_t face, uint64_t vertex)
{
    return vertex < (uint64_t)r->elements[VERTEX].count ||
           clod_status_fail(r->status, CLOD_USAGE,
                            "%s: face %lld: there is no vertex %llu; there are %lld, the first "
                            "has number 0",
                            r->source->path, (long long)face, (unsigned long long)vertex,
                            (long long)r->elements[VERTEX].count);
}

static bool read_whole(reader *r, clod_mesh_word word, uint64_t *value)
{
    int64_t number = -1;
    if (!clod_mesh_words_whole(word, &number) || number < 0) {
        return fail(r, word, "a whole number, 0 or more, is expected");
    }
    *value = (uint64_t)number;
    return true;
}

/** One line of a text: a value of each property. */
static bool check_text_line(reader *r, const element *kind, int64_t number)
{
    const bool face = kind == &r->elements[FACE];
    clod_mesh_word word = clod_mesh_words_next(&r->at);
    for (size_t p = 0; p < kind->property_count; p++) {
        uint64_t items = 1;
        const bool list = kind->properties[p].counter > 0;
        if (list) {
            if (word.length == 0) {
                return fail_end(r, "face", number, kind->count);
            }
            if (!read_whole(r, word, &items) || !check_count(r, number, items) ||
                !clod_mesh_source_add(r->source, items - 2, r->status)) {
                return false;
            }
            word = clod_mesh_words_in_line(&r->at);
        }
        for (uint64_t i = 0; i < items; i++) {
            uint64_t vertex = 0;
            if (word.length == 0) {
                return fail_end(r, face ? "face" : "vertex", number, kind->count);
            }
            if (list ? !read_whole(r, word, &vertex) || !check_corner(r, number, vertex)
                     : !clod_mesh_words_number(word) &&
                           !fail(r, word,
                                 "a finite number is expected; export the mesh again")) {
                return false;
            }
            word = clod_mesh_words_in_line(&r->at);
        }
    }
    return word.length == 0 ||
           fail(r, word, "there are more values in this line than the header has properties");
}

static bool check_text(reader *r)
{
    for (int e = VERTEX; e < ELEMENTS; e++) {
        for (int64_t k = 1; k <= r->elements[e].count; k++) {
            if (!check_text_line(r, &r->elements[e], k)) {
                return false;
            }
        }
    }
    const clod_mesh_word word = clod_mesh_words_next(&r->at);
    return word.length == 0 || fail(r, word,
                                    "this follows the last face that the header "
                                    "announces; export the mesh again");
}

static uint64_t number_at(const reader *r, const char *bytes, int size)
{
    uint64_t value = 0;
    for (int b = 0; b < size; b++) {
        const int at = r->form == FORM_BIG ? b : size - 1 - b;
        value = value << 8 | (unsigned char)bytes[at];
    }
    return value;
}

static bool check_face(reader *r, char **at, const char *end, int64_t number)
{
    const element *face = &r->elements[FACE];
    for (size_t p = 0; p < face->property_count; p++) {
        const property *own = &face->properties[p];
        uint64_t items = 1;
        if (end - *at < own->counter) {
            return fail_end(r, "face", number, face->count);
        }
        if (own->counter > 0) {
            items = number_at(r, *at, own->counter);
            if (!check_count(r, number, items) ||
                !clod_mesh_source_add(r->source, items - 2, r->status)) {
                return false;
            }
            *at += own->counter;
        }
        if ((uint64_t)(end - *at) < items * (uint64_t)own->size) {
            return fail_end(r, "face", number, face->count);
        }
        for (uint64_t i = 0; i < items && own->counter > 0; i++) {
            if (!check_corner(r, number,
                              number_at(r, *at + i * (uint64_t)own->size, own->size))) {
                return false;
            }
        }
        *at += items * (uint64_t)own->size;
    }
    return true;
}

static bool check_binary(reader *r)
{
    const element *vertex = &r->elements[VERTEX];
    char *at = r->at.at;
    char *end = r->at.end;
    size_t bytes = 0;
    for (size_t p = 0; p < vertex->property_count; p++) {
        bytes += (size_t)vertex->properties[p].size;
    }
    // x, y and z have some bytes (check_elements)
    const int64_t whole = bytes > 0 ? (int64_t)((size_t)(end - at) / bytes) : 0;
    if (whole < vertex->count) {
        return fail_end(r, "vertex", whole + 1, vertex->count);
    }
    at += bytes * (size_t)vertex->count;
    for (int64_t k = 1; k <= r->elements[FACE].count; k++) {
        if (!check_face(r, &at, end, k)) {
            return false;
        }
    }
    return at == end ||
           clod_status_fail(r->status, CLOD_USAGE,
                            "%s: %td bytes follow the last face that the header announces; "
                            "export the mesh again",
                            r->source->path, end - at);
}

bool clod_mesh_ply_check(clod_mesh_source *self, clod_status *status)
{
    reader *r = clod_memory_alloc(1, sizeof *r);
    if (r == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", self->path);
    }
    r->source = self;
    r->at = (clod_mesh_cursor){self->bytes, self->bytes + self->length, 1};
    r->status = status;
    bool good = read_header(r) && check_elements(r);
    if (good && r->form == FORM_TEXT) {
        good = check_text(r);
    } else if (good) {
        clod_mesh_words_rest(&r->at);
        r->at.at += r->at.at < r->at.end; // the end of the line
        good = check_binary(r);
    }
    clod_memory_free(r);
    return good;
}
