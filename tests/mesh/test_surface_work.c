// The elastic force of contacts with a mesh is that of a potential: it never jumps, and its work
// along a closed way is nothing, over ridges and corners, and in grooves and pits.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"
#include "support/dice.h"

#define RADIUS 0.3
#define POINTS 4000

/** The cube [-1, 1]^3, each side in its own number of pieces. */
static clod_surface *cube(void)
{
    maker *made = maker_new();
    for (int a = 0; a < 3; a++) {
        for (int side = -1; side <= 1; side += 2) {
            const int n = 3 + a, m = side > 0 ? 4 : 5;
            for (int k = 0; k < n * m; k++) {
                float p[4][3];
                for (int c = 0; c < 4; c++) {
                    const int i = k % n + (c == 1 || c == 2), j = k / n + (c >= 2);
                    p[c][a] = (float)side;
                    p[c][(a + 1) % 3] = -1.0f + 2.0f * (float)i / (float)n;
                    p[c][(a + 2) % 3] = -1.0f + 2.0f * (float)j / (float)m;
                }
                maker_add(made, p[0], p[1], p[2]);
                maker_add(made, p[0], p[2], p[3]);
            }
        }
    }
    return maker_surface(made, 0.35);
}

/** Sum of the overlaps along their directions, the force for a stiffness of 1; how many contacts. */
static clod_vec3 force_at(const clod_surface *surface, clod_vec3 p, int *contacts)
{
    static touching found;
    clod_vec3 force = {0.0, 0.0, 0.0};
    touching_near(&found, surface, p, RADIUS);
    *contacts = touching_find(&found, p, RADIUS);
    for (int k = 0; k < *contacts; k++) {
        const clod_surface_closest *at = &found.contact[k]->at;
        force = clod_vec3_axpy(force, RADIUS - at->distance, at->direction);
    }
    return force;
}

/** A circle. */
typedef struct round_way {
    clod_vec3 middle, u, v; ///< u, v: of the radius, across each other
} round_way;

static clod_vec3 point_of(const round_way *self, int k)
{
    const double a = 2.0 * M_PI * k / POINTS;
    return clod_vec3_axpy(clod_vec3_axpy(self->middle, cos(a), self->u), sin(a), self->v);
}

/**
 * Work of the force along a circle, by trapezoids; whether it jumps. Each contact's force
 * changes by at most the way times 1 + overlap/distance along faces, edges and corners.
 * Returns the largest number of contacts at a time.
 */
static int check_way(const clod_surface *surface, const round_way *way)
{
    double work = 0.0;
    int most = 0, contacts, before;
    clod_vec3 p = point_of(way, 0), f = force_at(surface, p, &before);
    for (int k = 1; k <= POINTS; k++) {
        const clod_vec3 q = point_of(way, k % POINTS), g = force_at(surface, q, &contacts);
        const clod_vec3 step = clod_vec3_sub(q, p);
        const int larger = contacts > before ? contacts : before;
        work += 0.5 * clod_vec3_dot(clod_vec3_add(f, g), step);
        // the nearest that a way comes is 0.02: overlap/distance is 14
        check_at_most(clod_vec3_length(clod_vec3_sub(g, f)),
                      15.0 * larger * clod_vec3_length(step) + 1e-12);
        most = larger > most ? larger : most;
        before = contacts;
        p = q;
        f = g;
    }
    // trapezoids: a kink costs (step)^2 times the change of slope, a few of them
    const double step = 2.0 * M_PI * clod_vec3_length(way->u) / POINTS;
    check_close(work, 0.0, 100.0 * step * step);
    return most;
}

/** Circles of a size about a place, in all directions. */
static int check_ways(const clod_surface *surface, clod_vec3 middle, double size)
{
    dice roll = {11};
    int most = 0;
    for (int k = 0; k < 40; k++) {
        double u[3], other[3];
        dice_direction(&roll, u);
        dice_direction(&roll, other);
        const clod_vec3 x = clod_vec3_of(u);
        const clod_vec3 y = clod_vec3_unit(clod_vec3_cross(x, clod_vec3_of(other)));
        const round_way way = {middle, clod_vec3_scale(x, size), clod_vec3_scale(y, size)};
        const int contacts = check_way(surface, &way);
        most = contacts > most ? contacts : most;
    }
    return most;
}

static void no_work_over_ridges_and_corners(void **state)
{
    (void)state;
    clod_surface *surface = cube();
    assert_int_equal(check_ways(surface, (clod_vec3){1.17, 0.1, 1.17}, 0.15), 1);
    assert_int_equal(check_ways(surface, (clod_vec3){1.17, 1.17, 1.17}, 0.15), 1);
    clod_surface_release(surface);
}

static void no_work_in_grooves_and_pits(void **state)
{
    (void)state;
    clod_surface *surface = cube();
    assert_int_equal(check_ways(surface, (clod_vec3){0.8, 0.1, 0.8}, 0.17), 2);
    assert_int_equal(check_ways(surface, (clod_vec3){-0.8, 0.8, -0.8}, 0.17), 3);
    clod_surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_work_over_ridges_and_corners),
        cmocka_unit_test(no_work_in_grooves_and_pits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
