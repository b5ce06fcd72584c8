// The surfaces of the walls as triangles: area, place and velocity of every shape.

#include <math.h>
#include <string.h>

#include "output/wall_mesh.h"
#include "support/check.h"

static double triangle_area(double corner[3][3])
{
    clod_vec3 p[3];
    memcpy(p, corner, sizeof p);
    return 0.5 * clod_vec3_length(
                     clod_vec3_cross(clod_vec3_sub(p[1], p[0]), clod_vec3_sub(p[2], p[0])));
}

/** The mesh of one shape that stands on x = 1 and has turned by 90 degrees about z. */
static clod_wall_mesh mesh_of(clod_shape shape)
{
    clod_status status;
    clod_wall_mesh mesh;
    shape.center = (clod_vec3){1.0, 0.0, 0.0};
    shape.axis[0] = (clod_vec3){1.0, 0.0, 0.0};
    shape.axis[1] = (clod_vec3){0.0, 1.0, 0.0};
    shape.axis[2] = (clod_vec3){0.0, 0.0, 1.0};
    clod_wall wall = {.shape_count = 1,
                      .shapes = &shape,
                      .spin = 2.0,
                      .spin_axis = {0.0, 0.0, 1.0},
                      .shift = {0.0, 0.0, 5.0},
                      .angle = M_PI / 2};
    const clod_state state = {.walls = {1, &wall}};
    assert_true(clod_wall_mesh_make(&mesh, &state, &status));
    return mesh;
}

/** Area of the mesh, and the middle of its box: where it is. */
static double mesh_area(clod_wall_mesh *mesh, double middle[3])
{
    double area = 0.0;
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (size_t t = 0; t < mesh->count; t++) {
        area += triangle_area(mesh->corner[t]);
        for (int v = 0; v < 9; v++) {
            low[v % 3] = fmin(low[v % 3], mesh->corner[t][v / 3][v % 3]);
            high[v % 3] = fmax(high[v % 3], mesh->corner[t][v / 3][v % 3]);
        }
    }
    for (int d = 0; d < 3; d++) {
        middle[d] = 0.5 * (low[d] + high[d]);
    }
    return area;
}

static void every_shape_has_its_area_and_place(void **context)
{
    (void)context;
    // areas of polygons with n corners on the circle: n/2 sin(2 pi/n) r^2; side 2 sin(pi/n) r
    const double n = CLOD_WALL_MESH_SEGMENTS;
    const double circle = 0.5 * n * sin(2.0 * M_PI / n);
    const struct {
        clod_shape shape;
        double area, height;
    } cases[] = {
        {{.kind = CLOD_SHAPE_DISC, .outer = 0.3}, circle * 0.09, 5.0},
        {{.kind = CLOD_SHAPE_ANNULUS, .outer = 0.3, .inner = 0.1}, circle * 0.08, 5.0},
        {{.kind = CLOD_SHAPE_CYLINDER, .outer = 0.3, .half = {0, 0, 0.2}},
         n * 2.0 * sin(M_PI / n) * 0.3 * 0.4,
         5.2},
        // trapezia and triangles: mean edge times slant height, 0.4 high and 0.2 or 0.3 less
        // wide
        {{.kind = CLOD_SHAPE_CONE, .outer = 0.1, .inner = 0.3, .half = {0, 0, 0.2}},
         n * 2.0 * sin(M_PI / n) * 0.2 * hypot(0.4, 0.2 * cos(M_PI / n)),
         5.2},
        {{.kind = CLOD_SHAPE_CONE, .outer = 0.3, .half = {0, 0, 0.2}},
         n * sin(M_PI / n) * 0.3 * hypot(0.4, 0.3 * cos(M_PI / n)),
         5.2},
        {{.kind = CLOD_SHAPE_CONE, .inner = 0.3, .half = {0, 0, 0.2}},
         n * sin(M_PI / n) * 0.3 * hypot(0.4, 0.3 * cos(M_PI / n)),
         5.2},
        {{.kind = CLOD_SHAPE_BOX, .half = {0.1, 0.2, 0.3}}, 2 * (0.08 + 0.12 + 0.24), 5.0},
        {{.kind = CLOD_SHAPE_BAR, .half = {0.4, 0.2, 0.1}}, 2 * (0.32 + 0.16 + 0.08), 5.0},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        clod_wall_mesh mesh = mesh_of(cases[c].shape);
        double middle[3];
        check_close(mesh_area(&mesh, middle), cases[c].area, 1e-12);
        // the centre (1, 0, 0), turned by 90 degrees about z through the origin, and shifted
        check_close(middle[0], 0.0, 1e-12);
        check_close(middle[1], 1.0, 1e-12);
        check_close(middle[2], cases[c].height, 1e-12);
        for (size_t t = 0; t < mesh.count; t++) { // velocity of turning: w x r, w = 2 about z
            double x = 0.0, y = 0.0;
            for (int v = 0; v < 3; v++) {
                x += mesh.corner[t][v][0] / 3.0;
                y += mesh.corner[t][v][1] / 3.0;
            }
            check_close(mesh.velocity[t][0], -2.0 * y, 1e-12);
            check_close(mesh.velocity[t][1], 2.0 * x, 1e-12);
            assert_int_equal(mesh.shape[t], (int)cases[c].shape.kind);
        }
        clod_wall_mesh_fini(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shape_has_its_area_and_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
