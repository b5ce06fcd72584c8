/**
 * @file mesh_ply.c
 * PLY, text and binary: one list of vertices, then one of faces.
 */

#include "mesh/mesh_ply.h"

#include "base/memory.h"

static const struct {
    const char *name;
    int size;
    bool whole, negative; ///< an integer; one that may be below 0
} TYPES[] = {
    {"char", 1, true, true},      {"int8", 1, true, true},      {"uchar", 1, true, false},
    {"uint8", 1, true, false},    {"short", 2, true, true},     {"int16", 2, true, true},
    {"ushort", 2, true, false},   {"uint16", 2, true, false},   {"int", 4, true, true},
    {"int32", 4, true, true},     {"uint", 4, true, false},     {"uint32", 4, true, false},
    {"float", 4, false, false},   {"float32", 4, false, false}, {"double", 8, false, false},
    {"float64", 8, false, false},
};

static bool fail(const clod_mesh_ply *r, clod_mesh_word word, const char *problem)
{
    if (word.length == 0) {
        return clod_status_fail(r->status, CLOD_USAGE, "%s:%zu: the line ends too early: %s",
                                r->source->path, r->at.line, problem);
    }
    return clod_status_fail(r->status, CLOD_USAGE, "%s:%zu: \"%.*s\": %s", r->source->path,
                            r->at.line, clod_mesh_words_shown(word), word.text, problem);
}

static bool read_format(clod_mesh_ply *r)
{
    static const char *const FORMS[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const clod_mesh_word word = clod_mesh_words_in_line(&r->at);
    for (clod_mesh_ply_form f = CLOD_MESH_PLY_TEXT; f <= CLOD_MESH_PLY_BIG; f++) {
        if (clod_mesh_words_same(word, FORMS[f])) {
            r->form = f;
            clod_mesh_words_in_line(&r->at); // the version, 1.0
            return true;
        }
    }
    return fail(r, word, "the format must be ascii, binary_little_endian or binary_big_endian");
}

static bool read_element(clod_mesh_ply *r)
{
    static const char *const NAMES[] = {"vertex", "face"};
    const clod_mesh_word name = clod_mesh_words_in_line(&r->at);
    const int which = clod_mesh_words_same(name, NAMES[CLOD_MESH_PLY_VERTEX])
                          ? CLOD_MESH_PLY_VERTEX
                          : CLOD_MESH_PLY_FACE;
    if (!clod_mesh_words_same(name, NAMES[which]) || r->elements[which].known ||
        (which == CLOD_MESH_PLY_FACE && !r->elements[CLOD_MESH_PLY_VERTEX].known)) {
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
    if (r->open->count > CLOD_MESH_VERTICES_MOST) {
        return fail(r, count, "too many; at most 15 million vertices are read");
    }
    return true;
}

/** Look up a type; false for an unknown one. */
static bool read_type(clod_mesh_ply *r, int *size, bool *whole, bool *negative)
{
    const clod_mesh_word word = clod_mesh_words_in_line(&r->at);
    for (size_t t = 0; t < sizeof TYPES / sizeof TYPES[0]; t++) {
        if (clod_mesh_words_same(word, TYPES[t].name)) {
            *size = TYPES[t].size;
            *whole = TYPES[t].whole;
            *negative = TYPES[t].negative;
            return true;
        }
    }
    return fail(r, word, "unknown type of a property");
}

/** A list: of corners, and of a face, or it is refused. */
static bool read_list(clod_mesh_ply *r, clod_mesh_ply_property *p)
{
    bool whole = false, negative = false;
    if (!read_type(r, &p->counter, &whole, &negative) ||
        !read_type(r, &p->size, &p->whole, &p->negative)) {
        return false;
    }
    const clod_mesh_word name = clod_mesh_words_in_line(&r->at);
    const bool corners = clod_mesh_words_same(name, "vertex_indices") ||
                         clod_mesh_words_same(name, "vertex_index");
    if (r->open != &r->elements[CLOD_MESH_PLY_FACE] || !corners || !whole || !p->whole) {
        return fail(r, name,
                    "the only list that is read is vertex_indices of a face, of whole numbers; "
                    "export without textures");
    }
    r->open->lists++;
    return true;
}

static bool read_property(clod_mesh_ply *r)
{
    char *start = r->at.at;
    const clod_mesh_word kind = clod_mesh_words_in_line(&r->at);
    if (r->open == NULL || r->open->property_count == CLOD_MESH_PLY_PROPERTIES) {
        return fail(r, kind, "a property belongs below an element, and 64 of them at most");
    }
    clod_mesh_ply_property *p = &r->open->properties[r->open->property_count++];
    p->axis = -1;
    if (clod_mesh_words_same(kind, "list")) {
        return read_list(r, p);
    }
    r->at.at = start;
    if (!read_type(r, &p->size, &p->whole, &p->negative)) {
        return false;
    }
    const clod_mesh_word name = clod_mesh_words_in_line(&r->at);
    if (clod_mesh_words_same(name, "vertex_indices") ||
        clod_mesh_words_same(name, "vertex_index")) {
        return fail(r, name, "the corners of a face must be a list");
    }
    for (int c = 0; c < 3; c++) {
        if (name.length == 1 && name.text[0] == "xyz"[c]) {
            p->axis = c;
            r->open->axes[c]++;
        }
    }
    return true;
}

/** A remark; Assimp gets it without its text. */
static bool read_remark(clod_mesh_ply *r, clod_mesh_word keyword)
{
    const clod_mesh_word rest = clod_mesh_words_rest(&r->at);
    memset(keyword.text, ' ', keyword.length);
    memcpy(keyword.text, "comment", 7); // no longer than obj_info
    memset(rest.text, ' ', rest.length);
    return true;
}

static bool read_header_line(clod_mesh_ply *r, clod_mesh_word word)
{
    if (clod_mesh_words_same(word, "comment") || clod_mesh_words_same(word, "obj_info")) {
        return read_remark(r, word);
    }
    const bool good = clod_mesh_words_same(word, "format")    ? read_format(r)
                      : clod_mesh_words_same(word, "element") ? read_element(r)
                      : clod_mesh_words_same(word, "property")
                          ? read_property(r)
                          : fail(r, word, "this is no line of a PLY header");
    if (!good) {
        return false;
    }
    const clod_mesh_word more = clod_mesh_words_in_line(&r->at);
    return more.length == 0 || fail(r, more, "there is one word too many in this line");
}

static bool read_header(clod_mesh_ply *r)
{
    if (!clod_mesh_words_same(clod_mesh_words_in_line(&r->at), "ply")) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s: this is no PLY file: it does not begin with ply",
                                r->source->path);
    }
    bool formed = false;
    for (;;) {
        const clod_mesh_word word = clod_mesh_words_next(&r->at);
        if (word.length == 0) {
            return clod_status_fail(r->status, CLOD_USAGE,
                                    "%s:%zu: the file ends before end_header; it was cut off",
                                    r->source->path, r->at.line);
        }
        if (clod_mesh_words_same(word, "end_header")) {
            return formed || fail(r, word, "there is no line that begins with format");
        }
        formed = formed || clod_mesh_words_same(word, "format");
        if (!read_header_line(r, word)) {
            return false;
        }
    }
}

static bool check_elements(const clod_mesh_ply *r)
{
    const clod_mesh_ply_element *vertex = &r->elements[CLOD_MESH_PLY_VERTEX],
                                *face = &r->elements[CLOD_MESH_PLY_FACE];
    if (vertex->axes[0] != 1 || vertex->axes[1] != 1 || vertex->axes[2] != 1 ||
        face->lists != 1) {
        return clod_status_fail(r->status, CLOD_USAGE,
                                "%s: the header must give vertices x, y and z, once each, and "
                                "faces one list vertex_indices",
                                r->source->path);
    }
    return true;
}

bool clod_mesh_ply_fail_end(const clod_mesh_ply *r, const char *what, int64_t number,
                            int64_t count)
{
    return clod_status_fail(r->status, CLOD_USAGE,
                            "%s: the file ends in %s %lld of %lld; it was cut off: export or "
                            "copy it again",
                            r->source->path, what, (long long)number, (long long)count);
}

bool clod_mesh_ply_check_count(const clod_mesh_ply *r, int64_t face, uint64_t corners)
{
    return (corners >= 3 && corners <= CLOD_MESH_CORNERS_MOST) ||
           clod_status_fail(r->status, CLOD_USAGE,
                            "%s: face %lld has %llu corners; from 3 to %d are read: export "
                            "triangles",
                            r->source->path, (long long)face, (unsigned long long)corners,
                            CLOD_MESH_CORNERS_MOST);
}

bool clod_mesh_ply_check_corner(const clod_mesh_ply *r, int64_t face, uint64_t vertex)
{
    return vertex < (uint64_t)r->elements[CLOD_MESH_PLY_VERTEX].count ||
           clod_status_fail(r->status, CLOD_USAGE,
                            "%s: face %lld: there is no vertex %llu; there are %lld, the first "
                            "has number 0",
                            r->source->path, (long long)face, (unsigned long long)vertex,
                            (long long)r->elements[CLOD_MESH_PLY_VERTEX].count);
}

static bool read_whole(clod_mesh_ply *r, clod_mesh_word word, uint64_t *value)
{
    int64_t number = -1;
    if (!clod_mesh_words_whole(word, &number) || number < 0) {
        return fail(r, word, "a whole number, 0 or more, is expected");
    }
    *value = (uint64_t)number;
    return true;
}

/** The next line of a text; Assimp wants no empty one between two. */
static bool next_line(clod_mesh_ply *r)
{
    clod_mesh_words_in_line(&r->at);
    if (r->at.at < r->at.end) {
        r->at.at++;
        r->at.line++;
    }
    return r->at.at < r->at.end;
}

/** A value of a text that is no corner. */
static bool check_value(clod_mesh_ply *r, const clod_mesh_ply_property *own,
                        clod_mesh_word word)
{
    int64_t whole = 0;
    return (own->whole ? clod_mesh_words_whole(word, &whole) : clod_mesh_words_number(word)) ||
           fail(r, word,
                own->whole ? "a whole number is expected"
                           : "a finite number is expected; export the mesh again");
}

/** A list of corners in a text. */
static bool check_list(clod_mesh_ply *r, int64_t face)
{
    uint64_t corners = 0;
    if (!read_whole(r, clod_mesh_words_in_line(&r->at), &corners) ||
        !clod_mesh_ply_check_count(r, face, corners)) {
        return false;
    }
    for (uint64_t c = 0; c < corners; c++) {
        uint64_t vertex = 0;
        if (!read_whole(r, clod_mesh_words_in_line(&r->at), &vertex) ||
            !clod_mesh_ply_check_corner(r, face, vertex)) {
            return false;
        }
    }
    return clod_mesh_source_add(r->source, corners - 2, r->status);
}

/** One line of a text: a value of each property. */
static bool check_text_line(clod_mesh_ply *r, const clod_mesh_ply_element *kind, int64_t number)
{
    if (!next_line(r)) {
        return clod_mesh_ply_fail_end(
            r, kind == &r->elements[CLOD_MESH_PLY_FACE] ? "face" : "vertex", number,
            kind->count);
    }
    for (size_t p = 0; p < kind->property_count; p++) {
        const clod_mesh_ply_property *own = &kind->properties[p];
        const bool list = own->counter > 0;
        if (list ? !check_list(r, number)
                 : !check_value(r, own, clod_mesh_words_in_line(&r->at))) {
            return false;
        }
    }
    const clod_mesh_word more = clod_mesh_words_in_line(&r->at);
    return more.length == 0 ||
           fail(r, more, "there are more values in this line than the header has properties");
}

static bool check_text(clod_mesh_ply *r)
{
    for (int e = CLOD_MESH_PLY_VERTEX; e < CLOD_MESH_PLY_ELEMENTS; e++) {
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

bool clod_mesh_ply_check(clod_mesh_source *self, clod_status *status)
{
    clod_mesh_ply *r = clod_memory_alloc(1, sizeof *r);
    if (r == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", self->path);
    }
    r->source = self;
    r->at = (clod_mesh_cursor){self->bytes, self->bytes + self->length, 1};
    r->status = status;
    bool good = read_header(r) && check_elements(r);
    if (good && r->form == CLOD_MESH_PLY_TEXT) {
        good = check_text(r);
    } else if (good) {
        clod_mesh_words_rest(&r->at);
        r->at.at += r->at.at < r->at.end; // the end of the line
        good = clod_mesh_ply_binary_check(r);
    }
    clod_memory_free(r);
    return good;
}
