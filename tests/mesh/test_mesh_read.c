// The same box in every format, its parts and its place; and files that are wrong.

#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/mesh_maker.h"
#include "mesh/text_maker.h"

static const float POINTS[8][3] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0},
                                   {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}};
static const int SIDES[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/** It is the box of 2 by 3 by 5, closed, with nothing to find. */
static void check_box(const char *name, const text *content)
{
    clod_mesh *mesh = parse(name, content, &METRES);
    const clod_mesh_report report = maker_report(mesh, 0.0);
    assert_int_equal(report.read_facets, 12);
    assert_int_equal(clod_mesh_look(mesh)->vertex_count, 8);
    assert_true(report.volume == 30.0 && report.area == 62.0);
    assert_int_equal(maker_found(&report), 0);
    clod_mesh_destroy(&mesh);
}

static void put_solid(text *out, const char *name, int from, int to, const char *const words[7])
{
    put(out, "%s %s\n", words[0], name);
    for (int s = from; s < to; s++) {
        for (int t = 0; t < 2; t++) {
            const int corners[3] = {SIDES[s][0], SIDES[s][t + 1], SIDES[s][t + 2]};
            put(out, "  %s nan -nan 0\n  %s\n", words[1], words[2]);
            for (int c = 0; c < 3; c++) {
                const float *p = POINTS[corners[c]];
                put(out, "    %s %g %.3e %+g\n", words[3], (double)p[0], (double)p[1],
                    (double)p[2]);
            }
            put(out, "  %s\n  %s\n", words[4], words[5]);
        }
    }
    put(out, "%s %s\n", words[6], name);
}

static const char *const SMALL[7] = {"solid",   "facet normal", "outer loop", "vertex",
                                     "endloop", "endfacet",     "endsolid"};
static const char *const LARGE[7] = {"SOLID",   "FACET NORMAL", "OUTER LOOP", "VERTEX",
                                     "ENDLOOP", "ENDFACET",     "ENDSOLID"};

static void stl_texts(void **state)
{
    (void)state;
    for (int variant = 0; variant < 2; variant++) {
        static text out;
        out.length = 0;
        put(&out, variant == 0 ? "" : "\xEF\xBB\xBF \n");
        const char *const *words = variant == 0 ? SMALL : LARGE;
        put_solid(&out, "empty at first", 0, 0, words);
        put_solid(&out, "floor and lid", 0, 2, words);
        put_solid(&out, "", 0, 0, words);
        put_solid(&out, "sides \xC3\xA4 facet normal 1 2 3", 2, 5, words);
        put_solid(&out, "floor and lid", 5, 6, words); // a name again: one part
        out.length -= variant == 0 ? 1 : 0;            // no end of the last line
        check_box("box.stl", &out);
        clod_mesh *mesh = parse("BOX.STL", &out, &METRES);
        const clod_mesh_view *view = clod_mesh_look(mesh);
        assert_int_equal(view->part_count, 4);
        assert_string_equal(view->parts[1].name, "floor and lid");
        assert_int_equal(view->parts[1].facets, 6);
        assert_string_equal(view->parts[3].name, "sides \xC3\xA4 facet normal 1 2 3");
        assert_int_equal(view->parts[3].facets, 6);
        assert_int_equal(view->parts[0].facets + view->parts[2].facets, 0);
        for (uint32_t f = 0; f < 12; f++) {
            assert_int_equal(view->number[f], f + 1);
            assert_int_equal(view->part[f], f < 4 || f >= 10 ? 1 : 3);
        }
        clod_mesh_destroy(&mesh);
    }
}

// Byte order marks and colours in the header of a binary file mean nothing.
static void stl_binary(void **state)
{
    (void)state;
    static const char *const HEADERS[] = {"solid text?", "\xFF\xFE", "\xFF\xFE\x00\x00",
                                          "COLOR=\x01\x02\x03\x04", "\xEF\xBB\xBF"};
    for (size_t h = 0; h < sizeof HEADERS / sizeof HEADERS[0]; h++) {
        maker *made = maker_new();
        maker_box(made, (const float[3]){0, 0, 0}, (const float[3]){2, 3, 5});
        memcpy(made->bytes, HEADERS[h], strlen(HEADERS[h]));
        static text out;
        out.length = 0;
        put_bytes(&out, made->bytes, maker_length(made));
        check_box("box.stl", &out);
    }
}

static void put_vertices(text *out, const char *format)
{
    for (int p = 0; p < 8; p++) {
        put(out, format, (double)POINTS[p][0], (double)POINTS[p][1], (double)POINTS[p][2]);
    }
}

// Materials do not split, other files are not opened, numbers may count back from the last.
static void obj_files(void **state)
{
    (void)state;
    static text out;
    out.length = 0;
    put(&out, "# remark\r\nmtllib /dev/zero\nvt 0 nan\nvn x y z\n");
    put_vertices(&out, "v %g %g %g 1.0\r\n");
    put(&out, "o the floor\nf 1/1/1 4//1 3 2\n\tusemtl rust\ng\tlid \nusemtl rust\n"
              "f -4 -3 \\\n -2 -1 # remark\nl 1 2\n");
    put(&out, "g sides\ns off\nf 1 2 6\nf 1 6 5\nf 2 3 7 6\nusemtl other\nf 3 4 8 7\ng lid\n"
              "f 4 1 5 8");
    check_box("box.obj", &out);
    clod_mesh *mesh = parse("box.obj", &out, &METRES);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->part_count, 3);
    assert_string_equal(view->parts[0].name, "the floor");
    assert_string_equal(view->parts[1].name, "lid");
    assert_string_equal(view->parts[2].name, "sides");
    assert_int_equal(view->parts[0].facets, 2);
    assert_int_equal(view->parts[1].facets, 4);
    assert_int_equal(view->parts[2].facets, 6);
    assert_int_equal(view->part[11], 1);
    clod_mesh_destroy(&mesh);
}

static void ply_text(void **state)
{
    (void)state;
    static text out;
    out.length = 0;
    put(&out, "ply\nformat ascii 1.0\ncomment element face 99\nobj_info x\n"
              "element vertex 8\nproperty uchar red\nproperty float z\nproperty double y\n"
              "property float32 x\nelement face 6\nproperty int flags\n"
              "property list uchar int vertex_indices\nend_header\n");
    for (int p = 0; p < 8; p++) {
        put(&out, "255 %g %g %g\n", (double)POINTS[p][2], (double)POINTS[p][1],
            (double)POINTS[p][0]);
    }
    for (int s = 0; s < 6; s++) {
        put(&out, "7 4 %d %d %d %d\n", SIDES[s][0], SIDES[s][1], SIDES[s][2], SIDES[s][3]);
    }
    check_box("box.ply", &out);
}

/** Bytes of a number in either order. */
static void put_number(text *out, const void *value, size_t size, bool big)
{
    char bytes[8];
    memcpy(bytes, value, size);
    for (size_t b = 0; b < size; b++) {
        put_bytes(out, &bytes[big ? size - 1 - b : b], 1);
    }
}

static void ply_binary(void **state)
{
    (void)state;
    for (int big = 0; big < 2; big++) {
        static text out;
        out.length = 0;
        put(&out,
            "ply\nformat binary_%s_endian 1.0\nelement vertex 8\nproperty float x\n"
            "property double y\nproperty float z\nproperty uchar red\n"
            "element face 6\nproperty list ushort uint vertex_index\nend_header\n",
            big != 0 ? "big" : "little");
        for (int p = 0; p < 8; p++) {
            const double y = (double)POINTS[p][1];
            put_number(&out, &POINTS[p][0], 4, big);
            put_number(&out, &y, 8, big);
            put_number(&out, &POINTS[p][2], 4, big);
            put_bytes(&out, "\n", 1);
        }
        for (int s = 0; s < 6; s++) {
            const uint16_t four = 4;
            put_number(&out, &four, 2, big);
            for (int c = 0; c < 4; c++) {
                const uint32_t corner = (uint32_t)SIDES[s][c];
                put_number(&out, &corner, 4, big);
            }
        }
        check_box("box.ply", &out);
    }
}

// In this order: unit, scale, rotate, move. The corner (2, 0, 0) mm, twice as large, is turned
// by 90 degrees about z through (1, 1, 0) m: (4e-3, 0) - (1, 1) = (-0.996, -1) -> (1, -0.996).
static void a_mesh_is_placed(void **state)
{
    (void)state;
    maker *made = maker_new();
    maker_box(made, (const float[3]){0, 0, 0}, (const float[3]){2, 3, 5});
    const clod_mesh_placing placing = {.unit = 1e-3,
                                       .scale = 2.0,
                                       .rotate = {.axis = {0.0, 0.0, 5.0},
                                                  .angle = 1.57079632679489661923,
                                                  .point = {1, 1, 0}},
                                       .move = {10.0, 20.0, 30.0}};
    clod_mesh *mesh = maker_read(made, &placing);
    const clod_mesh_report report = maker_report(mesh, 0.0);
    check_relative(report.volume, 8.0 * 30e-9, 1e-9);         // places are rounded to 4e-15 m
    const double *corner = clod_mesh_look(mesh)->vertices[2]; // third in the file
    check_close(corner[0], 1.0 + 1.0 + 10.0, 1e-14);
    check_close(corner[1], 1.0 - 0.996 + 20.0, 1e-14);
    check_close(corner[2], 30.0, 1e-14);
    check_relative(report.weld, 5.0 * 2e-3 * 0x1p-21, 1e-15);
    clod_mesh_destroy(&mesh);
}

static void placings_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    maker *made = maker_new();
    maker_box(made, (const float[3]){0, 0, 0}, (const float[3]){2, 3, 5});
    const struct {
        clod_mesh_placing placing;
        const char *said;
    } wrong[] = {
        {{.unit = 0.0, .scale = 1.0}, "a.stl: a unit of 0 m"},
        {{.unit = NAN, .scale = 1.0}, "a.stl: a unit of nan m"},
        {{.unit = 1.0, .scale = -1.0}, "a.stl: a scale of -1"},
        {{.unit = 1.0, .scale = 1.0, .rotate = {.angle = 1.0}},
         "the axis of rotate is (0, 0, 0)"},
        {{.unit = 1.0, .scale = 1.0, .rotate = {.axis = {1, 0, 0}, .angle = NAN}},
         "finite numbers"},
        {{.unit = 1e6, .scale = 1e6}, "a vertex is 5e+12 m from the origin"},
        {{.unit = 1.0, .scale = 1.0, .move = {NAN, 0.0, 0.0}}, "finite numbers"},
        {{.unit = 1e-12, .scale = 1e-6, .move = {1e6, 0.0, 0.0}}, "none of the 12 facets"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        clod_status status = {CLOD_OK, ""};
        assert_null(clod_mesh_parse("a.stl", made->bytes, maker_length(made), &wrong[k].placing,
                                    &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, wrong[k].said));
    }
}

// Numbers of any type; a line feed as the first byte of the data, which Assimp would swallow.
static void ply_binary_of_any_type(void **state)
{
    (void)state;
    static const char HEADER[] = "ply\r\nformat binary_little_endian 1.0\r\n"
                                 "element vertex 4\r\nproperty char x\r\nproperty ushort y\r\n"
                                 "property int z\r\nelement face 1\r\nproperty uint id\r\n"
                                 "property list char ushort vertex_indices\r\nend_header\r\n";
    static const char DATA[] = "\n\n\n\n\n\n\n"               // 10, 2570, 168430090
                               "\xFE\x00\x80\xFF\xFF\xFF\xFF" // -2, 32768, -1
                               "\x7F\xFF\xFF\x00\x00\x00\x80" // 127, 65535, -2^31
                               "\x80\x01\x00\x00\x01\x00\x00" // -128, 1, 256
                               "\r\n\r\n\x03\x00\x00\x01\x00\x02\x00";
    static const double PLACES[3][3] = {
        {10.0, 2570.0, 168430090.0}, {-2.0, 32768.0, -1.0}, {127.0, 65535.0, -2147483648.0}};
    static text out;
    out.length = 0;
    put_bytes(&out, HEADER, sizeof HEADER - 1);
    put_bytes(&out, DATA, sizeof DATA - 1);
    const clod_mesh_placing placing = {.unit = 1e-3, .scale = 1.0};
    clod_mesh *mesh = parse("a.ply", &out, &placing);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->vertex_count, 3);
    for (int v = 0; v < 3; v++) {
        for (int k = 0; k < 3; k++) {
            check_relative(view->vertices[v][k], 1e-3 * PLACES[v][k], 6e-8); // rounded to float
        }
    }
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stl_texts),
        cmocka_unit_test(stl_binary),
        cmocka_unit_test(obj_files),
        cmocka_unit_test(ply_text),
        cmocka_unit_test(ply_binary),
        cmocka_unit_test(ply_binary_of_any_type),
        cmocka_unit_test(a_mesh_is_placed),
        cmocka_unit_test(placings_that_make_no_sense_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
