// Broken mesh files: each is refused with file, line or facet, value and what to do.

#include "mesh/mesh_maker.h"

static void refuse(const char *name, const char *bytes, size_t length, const char *said)
{
    clod_status status = {CLOD_OK, ""};
    clod_mesh *mesh = clod_mesh_parse(name, bytes, length, &METRES, &status);
    if (mesh != NULL || strstr(status.text, said) == NULL) {
        print_error("%s\nexpected: %s\nsaid: %s\n", bytes, said, status.text);
    }
    assert_null(mesh);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, said));
}

typedef struct wrong {
    const char *text, *said;
} wrong;

static void refuse_all(const char *name, const wrong *files, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        refuse(name, files[k].text, strlen(files[k].text), files[k].said);
    }
}

#define REFUSE_ALL(name, files) refuse_all(name, files, sizeof(files) / sizeof(files)[0])

#define FACET "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"

static void stl_texts(void **state)
{
    (void)state;
    static const wrong FILES[] = {
        {"", "a.stl: the file is empty"},
        {"solid a\nendsolid a\n", "a.stl: there is no facet"},
        {"solid a\n" FACET "endloop\n",
         "a.stl:8: the file ends in facet 1, where \"endfacet\""},
        {"solid a\n" FACET "endloop\nendfacet\n", "a.stl:9: the file ends in facet 2, where "
                                                  "\"facet or endsolid\" is expected"},
        {"solid a\n" FACET "vertex 1 1 0\nendloop\n", "a.stl:7: facet 1: \"vertex\" where "
                                                      "\"endloop\" is expected"},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
         "a.stl:6: facet 1: \"endloop\" where \"vertex\" is expected"},
        {"solid a\nfacet normal 0 0 1 outer loop\nvertex 0 nan 0\n",
         "a.stl:3: facet 1: coordinate y is \"nan\", which is no finite number"},
        {"solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 1,5\n", "coordinate z is \"1,5\""},
        {"solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0 12345678901234567890\n",
         "coordinate z is \"12345678901234567890\""},
        {"solid a\nfacet normal 0 0 1 outer loop\nvertex 0 0\n1\n",
         "a.stl:3: facet 1: the line ends where \"coordinate\" is expected"},
        {"solid a\n" FACET "endloop\nendfacet\nendsolid a\nrubbish", "a.stl:10: facet 2: "
                                                                     "\"rubbish\""},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1e39 0 0\n"
         "vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
         "a.stl: facet 1: corner 2 is (inf, 0, 0)"},
        {"<html>not found</html>", "a.stl: this is no STL file: it has 22 bytes"},
    };
    REFUSE_ALL("a.stl", FILES);
}

static void stl_binary(void **state)
{
    (void)state;
    maker *made = maker_new();
    maker_box(made, (const float[3]){0, 0, 0}, (const float[3]){1, 1, 1});
    const size_t length = maker_length(made);
    refuse("a.stl", made->bytes, length - 1,
           "a.stl: the header announces 12 facets, which take 684 bytes, but the file has 683, "
           "enough for 11 facets; it was cut off");
    refuse("a.stl", made->bytes, length - 50, "enough for 11 facets");
    refuse("a.stl", made->bytes, length + 7, "12 facets and then some; something follows");
    memset(made->bytes + 80, 0xFF, 4);
    refuse("a.stl", made->bytes, length, "announces 4294967295 facets");
    memset(made->bytes + 80, 0, 4);
    refuse("a.stl", made->bytes, 84, "there is no facet in the file");
    memcpy(made->bytes + 80, &made->count, 4);
    memset(made->bytes + 84 + 50 * 7 + 12, 0xFF, 4); // NaN
    refuse("a.stl", made->bytes, length, "a.stl: facet 8: corner 1 is (-nan");
}

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

static void obj_files(void **state)
{
    (void)state;
    static const wrong FILES[] = {
        {"v 0 0 0\n", "a.obj: there is no facet"},
        {SQUARE "f 1 2 5\n", "a.obj:5: facet 1: there is no vertex 5; 4 stand above this line"},
        {SQUARE "f 1 2 0\n", "a.obj:5: facet 1: there is no vertex 0"},
        {SQUARE "f 1 2 3\nf 1 2 -5\n", "a.obj:6: facet 2: there is no vertex -5"},
        {SQUARE "f 1 2\n", "a.obj:5: facet 1 has 2 corners"},
        {SQUARE "f 1 2 x/1\n", "a.obj:5: \"x/1\": a corner"},
        {SQUARE "f 1 2 3.5\n", "a.obj:5: \"3.5\": a corner"},
        {"v 0 0\nf 1 1 1\n", "a.obj:1: vertex 1 has 2 coordinates"},
        {"v 0 0 inf\n", "a.obj:1: \"inf\": a coordinate must be a finite number"},
        {"v 0 0 0 0.5\n", "a.obj:1: \"0.5\": a vertex with a weight"},
        {"v 4 1 0\nv 2 1 0\nv 0 2 0\nv 0 3 0\nv 3 4 0\nv 1 4 0\nv 3 3 0\nv 4 3 0\n"
         "f 1 2 3 4 5 6 7 8\n", // its fourth and sixth side cross
         "a.obj: the polygons of the file should make 6 triangles, but 4 came out of them"},
        {SQUARE "surf 0 1 0 1 1 2 3 4\n", "a.obj:5: \"surf\": curved surfaces"},
    };
    REFUSE_ALL("a.obj", FILES);
    refuse("a.obj", SQUARE "f 1 2 3\n\0", sizeof SQUARE + 8, "a.obj: byte 41 is zero");
    static char many[2000] = SQUARE "f";
    for (int k = 0; k < 257; k++) {
        strcat(many, " 1 2 3");
    }
    refuse("a.obj", many, strlen(many), "a.obj:5: facet 1 has 771 corners; from 3 to 255");
}

#define VERTICES "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
#define HEADER                                                                                 \
    "ply\nformat ascii 1.0\n" VERTICES                                                         \
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"

static void ply_files(void **state)
{
    (void)state;
    static const wrong FILES[] = {
        {"plyx\n", "a.ply: this is no PLY file"},
        {"ply\nformat ascii 1.0\n", "a.ply:3: the file ends before end_header"},
        {"ply\n" VERTICES "end_header\n",
         "a.ply:6: \"end_header\": there is no line that begins "
         "with format"},
        {"ply\nformat ascii 1.0\n" VERTICES "end_header\n", "faces one list vertex_indices"},
        {"ply\nformat ebcdic 1.0\n", "a.ply:2: \"ebcdic\": the format must be"},
        {"ply\nformat ascii 1.0\nelement vertex 4000000000\n", "a.ply:3: \"4000000000\": this "
                                                               "cannot be how many"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float x\n"
         "property float y\nelement face 1\nproperty list uchar int vertex_indices\n"
         "end_header\n",
         "vertices x, y and z, once each"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float x\n"
         "property float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n",
         "vertices x, y and z, once each"},
        {"ply\nformat ascii 1.0 z\n", "a.ply:2: \"z\": there is one word too many"},
        {"ply\nformat ascii 1.0\nelement edge 1\n", "a.ply:3: \"edge\": only vertices"},
        {"ply\nformat ascii 1.0\nelement face 1\n",
         "a.ply:3: \"face\": only vertices, and then"},
        {"ply\nformat ascii 1.0\nproperty float x\n", "a property belongs below an element"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", "a.ply:4: \"half\": "
                                                                       "unknown type"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float texcoord\n",
         "a.ply:4: \"texcoord\": the only list"},
        {HEADER "0 0 0\n1 0 0\n", "a.ply: the file ends in vertex 3 of 3"},
        {HEADER "0 0 0\n1 0 0\n0 1 0\n", "a.ply: the file ends in face 1 of 1"},
        {HEADER "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n", "a.ply:11: \"0\": there are more values"},
        {HEADER "0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
         "a.ply:11: the line ends too early: a finite number"},
        {HEADER "0 0 0\n\n1 0 0\n0 1 0\n3 0 1 2\n",
         "a.ply:11: the line ends too early: a finite number"},
        {HEADER "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "a.ply:11: \"nan\": a finite number"},
        {HEADER "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.ply: face 1: there is no vertex 3"},
        {HEADER "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.ply:13: \"-1\": a whole number"},
        {HEADER "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "a.ply: face 1 has 2 corners"},
        {HEADER "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "a.ply:14: \"3\": this follows"},
    };
    REFUSE_ALL("a.ply", FILES);
    static const char BINARY[] = "ply\nformat binary_little_endian 1.0\n" VERTICES
                                 "element face 1\nproperty list uchar int vertex_indices\n"
                                 "end_header\n";
    static char bytes[sizeof BINARY + 64];
    const size_t header = sizeof BINARY - 1;
    memcpy(bytes, BINARY, header);
    bytes[header + 36] = 3;
    bytes[header + 45] = 1;
    refuse("a.ply", bytes, header + 35, "a.ply: the file ends in vertex 3 of 3");
    refuse("a.ply", bytes, header + 36, "a.ply: the file ends in face 1 of 1");
    refuse("a.ply", bytes, header + 48, "a.ply: the file ends in face 1 of 1");
    refuse("a.ply", bytes, header + 50, "a.ply: 1 bytes follow the last face");
    bytes[header + 42] = 1; // the corner 256
    refuse("a.ply", bytes, header + 49, "a.ply: face 1: there is no vertex 256");
    bytes[header + 36] = 0;
    refuse("a.ply", bytes, header + 49, "a.ply: face 1 has 0 corners");
    bytes[header + 36] = 3;
    bytes[header + 42] = 0;
    memset(bytes + header + 16, 0xFF, 4); // NaN
    refuse("a.ply", bytes, header + 49, "a.ply: vertex 2: coordinate y is -nan");
}

static void names_tell_the_format(void **state)
{
    (void)state;
    refuse("a.step", "x", 1, "a.step: the name must end in .stl, .obj or .ply");
    refuse("stl", "x", 1, "must end in");
    refuse("a.stl.gz", "x", 1, "must end in");
}

// 4096 names are read, one more is not.
static void too_many_parts(void **state)
{
    (void)state;
    static char many[200000] = SQUARE;
    size_t length = strlen(many);
    for (int k = 0; k <= CLOD_MESH_PARTS_MOST; k++) {
        if (k == CLOD_MESH_PARTS_MOST) {
            clod_status status = {CLOD_OK, ""};
            clod_mesh *mesh = clod_mesh_parse("a.obj", many, length, &METRES, &status);
            assert_non_null(mesh);
            assert_int_equal(clod_mesh_look(mesh)->part_count, CLOD_MESH_PARTS_MOST);
            clod_mesh_destroy(&mesh);
        }
        length +=
            (size_t)snprintf(many + length, sizeof many - length, "g part-%d\nf 1 2 3\n", k);
        assert_true(length < sizeof many - 1);
    }
    refuse("a.obj", many, length, "a.obj: the file has more than 4096 named parts");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stl_texts),
        cmocka_unit_test(stl_binary),
        cmocka_unit_test(obj_files),
        cmocka_unit_test(ply_files),
        cmocka_unit_test(names_tell_the_format),
        cmocka_unit_test(too_many_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
