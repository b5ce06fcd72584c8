// Every way to write a number in the formats that are texts.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/text_maker.h"

/** A way to write a number. */
typedef struct written {
    const char *text;
    double value;
} written;

static const written NUMBERS[] = {
    {".5", 0.5},      {"-.5", -0.5},    {"+.5", 0.5},   {"5.", 5.0},       {"-5.", -5.0},
    {".5e-2", 0.005}, {"1E3", 1000.0},  {"+7", 7.0},    {"-.25E+1", -2.5}, {"00.5", 0.5},
    {"5.e-1", 0.5},   {"-.5e01", -5.0}, {"1.25", 1.25}, {"0.", 0.0},       {"-0", 0.0},
};

#define NUMBER_COUNT (sizeof NUMBERS / sizeof NUMBERS[0])
#define FORMS (3 * NUMBER_COUNT) ///< each number along each axis

/** The first corner of facet `form` of the mesh below. */
static void put_form(text *out, size_t form)
{
    static const char *const OTHERS[3] = {"11", "12.5", "-13"};
    for (size_t k = 0; k < 3; k++) {
        put(out, " %s", k == form % 3 ? NUMBERS[form / 3].text : OTHERS[k]);
    }
}

/** Facets of a corner with each number and of two more, which all share. */
static void put_forms(text *out, const char *extension)
{
    const bool stl = strcmp(extension, "stl") == 0, ply = strcmp(extension, "ply") == 0;
    out->length = 0;
    put(out, stl ? "solid\n" : "");
    if (ply) {
        put(out,
            "ply\nformat ascii 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"
            "property float z\nelement face %zu\nproperty list uchar int vertex_indices\n"
            "end_header\n",
            FORMS + 2, FORMS);
    }
    for (size_t f = 0; f < FORMS; f++) {
        put(out, stl ? "facet normal 0 0 1\nouter loop\nvertex" : ply ? "" : "v");
        put_form(out, f);
        put(out, stl ? "\nvertex 3 2 9\nvertex 4 8 1\nendloop\nendfacet\n" : "\n");
    }
    put(out, stl ? "endsolid\n" : ply ? "3 2 9\n4 8 1\n" : "v 3 2 9\nv 4 8 1\n");
    for (size_t f = 0; f < FORMS && !stl; f++) {
        const size_t first = ply ? 0 : 1;
        put(out, ply ? "3 %zu %zu %zu\n" : "f %zu %zu %zu\n", first + f, first + FORMS,
            first + FORMS + 1);
    }
}

/** Whether a facet has a corner at a place, within single precision. */
static bool has_corner(const clod_mesh_view *view, size_t facet, const double place[3])
{
    for (int c = 0; c < 3; c++) {
        const double *at = view->vertices[view->facets[facet][c]];
        if (fabs(at[0] - place[0]) <= 1e-7 * fabs(place[0]) &&
            fabs(at[1] - place[1]) <= 1e-7 * fabs(place[1]) &&
            fabs(at[2] - place[2]) <= 1e-7 * fabs(place[2])) {
            return true;
        }
    }
    return false;
}

// A vertex with a coordinate like .5 was dropped once, and the next ones moved up.
static void numbers_of_texts(void **state)
{
    (void)state;
    static text out;
    static const char *const NAMES[] = {"a.stl", "a.obj", "a.ply"};
    for (size_t n = 0; n < 3; n++) {
        put_forms(&out, NAMES[n] + 2);
        clod_mesh *mesh = parse(NAMES[n], &out, &METRES);
        const clod_mesh_view *view = clod_mesh_look(mesh);
        assert_int_equal(view->facet_count +
                             maker_report(mesh, 0.0).findings[CLOD_MESH_DUPLICATE].count,
                         FORMS);
        for (size_t f = 0; f < view->facet_count; f++) {
            const size_t form = view->number[f] - 1;
            double place[3] = {11.0, 12.5, -13.0};
            place[form % 3] = NUMBERS[form / 3].value;
            if (!has_corner(view, f, place)) {
                fail_msg("%s: facet %zu has no corner with %s", NAMES[n], form + 1,
                         NUMBERS[form / 3].text);
            }
        }
        clod_mesh_destroy(&mesh);
    }
}

// Lines of nothing but points have no room for a digit where they stand.
static void obj_of_points(void **state)
{
    (void)state;
    static text out;
    out.length = 0;
    put(&out, "v .5 .5 .5\\\n\nv .5 \\\n.25 .5\nv .25\t.5 .5\nf -1 -2 -3");
    clod_mesh *mesh = parse("a.obj", &out, &METRES);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->facet_count, 1);
    assert_true(has_corner(view, 0, (const double[3]){0.5, 0.5, 0.5}));
    assert_true(has_corner(view, 0, (const double[3]){0.5, 0.25, 0.5}));
    assert_true(has_corner(view, 0, (const double[3]){0.25, 0.5, 0.5}));
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_texts),
        cmocka_unit_test(obj_of_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
