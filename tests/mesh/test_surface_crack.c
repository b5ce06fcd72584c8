// Sheets that should meet and do not: a crack that is narrow beside the grain pushes once.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"

#define RADIUS 0.01

/** Half a profile: facets on a ray from (x, z), endless along y beside a grain. */
typedef struct half {
    float x, z;
    double angle; ///< of the ray
} half;

/** Add the sheet of half a profile, 10 grain radii long. */
static void sheet(maker *made, const half *self)
{
    const float x = self->x + (float)(0.1 * cos(self->angle));
    const float z = self->z + (float)(0.1 * sin(self->angle));
    const float a[3] = {self->x, -0.1f, self->z}, b[3] = {x, -0.1f, z};
    const float c[3] = {x, 0.1f, z}, d[3] = {self->x, 0.1f, self->z};
    maker_add(made, a, b, c);
    maker_add(made, a, c, d);
}

static clod_surface *surface_of(const maker *made)
{
    return maker_surface(made, M_PI / 9.0);
}

/** Contacts with surfaces of one wall; `first` and `second`: their distances. */
static int touch(clod_surface *const *surfaces, int count, clod_vec3 p, double distance[2])
{
    static touching found;
    found.count = 0;
    for (int s = 0; s < count; s++) {
        touching_add(&found, surfaces[s], p, RADIUS);
    }
    const int contacts = touching_find(&found, p, RADIUS);
    for (int k = 0; k < contacts; k++) {
        distance[k < 2 ? k : 1] = found.contact[k]->at.distance;
    }
    return contacts;
}

/** Distance of a place from half a profile, by hand. */
static double distance_from(const half *self, double x, double z)
{
    const double dx = x - (double)self->x, dz = z - (double)self->z;
    const double along = fmax(dx * cos(self->angle) + dz * sin(self->angle), 0.0);
    return hypot(dx - along * cos(self->angle), dz - along * sin(self->angle));
}

/** Over both halves there is one contact, as far away as the nearer one. */
static void expect_once(clod_surface *const *surfaces, int count, const half side[2],
                        double overlap)
{
    for (int k = -400; k <= 400; k++) {
        const double x = 1e-5 * k;
        double z = RADIUS - overlap; // brought to the overlap by a few steps of Newton
        for (int n = 0; n < 50; n++) {
            z += RADIUS - overlap -
                 fmin(distance_from(&side[0], x, z), distance_from(&side[1], x, z));
        }
        double distance[2];
        const int contacts = touch(surfaces, count, (clod_vec3){x, 0.003, z}, distance);
        if (contacts != 1) {
            fail_msg("%d contacts at x = %g, halves from %g and %g at %g and %g rad", contacts,
                     x, (double)side[0].z, (double)side[1].z, side[0].angle, side[1].angle);
        }
        check_close(distance[0], RADIUS - overlap, 1e-8);
    }
}

/** Both halves as one file, and as two. */
static void expect_profile(const half side[2])
{
    maker *made = maker_new();
    sheet(made, &side[0]);
    clod_surface *first = surface_of(made);
    sheet(made, &side[1]);
    clod_surface *both = surface_of(made);
    made = maker_new();
    sheet(made, &side[1]);
    clod_surface *second = surface_of(made);
    for (int k = 0; k < 2; k++) {
        const double overlap = k == 0 ? 1e-6 : 5e-4;
        expect_once(&both, 1, side, overlap);
        expect_once((clod_surface *[]){first, second}, 2, side, overlap);
        expect_once((clod_surface *[]){second, first}, 2, side, overlap);
    }
    clod_surface_release(first);
    clod_surface_release(second);
    clod_surface_release(both);
}

// The distance over a crack of width g is that of the nearer rim: at most g^2 / (8 r) more.
static void flush_sheets(void **state)
{
    (void)state;
    static const float CRACKS[] = {0.0f, 1e-8f, 1e-7f, 1e-6f, 1e-5f, 1e-4f};
    for (size_t c = 0; c < sizeof CRACKS / sizeof CRACKS[0]; c++) {
        const float g = CRACKS[c];
        expect_profile((half[2]){{-0.5f * g, 0, M_PI}, {0.5f * g, 0, 0}});
    }
}

static void sheets_with_steps_and_bends(void **state)
{
    (void)state;
    static const float STEPS[] = {1e-6f, 1e-5f, 1e-4f};
    static const double BENDS[] = {-0.3, -0.1, -0.01, -1e-4, 1e-4, 0.01, 0.1, 0.3};
    for (size_t s = 0; s < sizeof STEPS / sizeof STEPS[0]; s++) {
        expect_profile((half[2]){{-5e-6f, 0, M_PI}, {5e-6f, STEPS[s], 0}});
        expect_profile((half[2]){{-5e-6f, STEPS[s], M_PI}, {5e-6f, 0, 0}});
    }
    for (size_t b = 0; b < sizeof BENDS / sizeof BENDS[0]; b++) {
        expect_profile((half[2]){{-5e-6f, 0, M_PI}, {5e-6f, 0, BENDS[b]}});
    }
}

/** Two closed boxes whose tops are flush. */
static void closed_boxes(void **state)
{
    (void)state;
    static const float CRACKS[] = {1e-7f, 1e-6f, 1e-5f, 1e-4f};
    for (size_t c = 0; c < sizeof CRACKS / sizeof CRACKS[0]; c++) {
        const float g = 0.5f * CRACKS[c];
        maker *made = maker_new();
        maker_box(made, (const float[3]){-0.1f, -0.1f, -0.02f},
                  (const float[3]){0.1f - g, 0.2f, 0.02f});
        maker_box(made, (const float[3]){g, -0.1f, -0.03f},
                  (const float[3]){0.1f, 0.2f, 0.03f});
        clod_surface *surface = surface_of(made);
        // the rim at -0.1 + (0.1 - g) has the rounding of 0.1 in single precision
        const float rim = -0.1f + (0.1f - g);
        expect_once(&surface, 1, (half[2]){{rim, 0, M_PI}, {g, 0, 0}}, 1e-6);
        expect_once(&surface, 1, (half[2]){{rim, 0, M_PI}, {g, 0, 0}}, 5e-4);
        clod_surface_release(surface);
    }
}

// Each side of a groove pushes with all its overlap, whether its sides meet, or leave a crack, or
// are two files.
static void grooves_push_from_each_side(void **state)
{
    (void)state;
    static const double BENDS[] = {M_PI / 2.0, M_PI / 4.0, M_PI / 6.0};
    static const float CRACKS[] = {0.0f, 1e-6f, 1e-4f};
    for (size_t k = 0; k < 9; k++) {
        const double tilt = 0.5 * BENDS[k / 3];
        const float g = 0.5f * CRACKS[k % 3];
        const half side[2] = {{-g, 0, M_PI - tilt}, {g, 0, tilt}};
        maker *made = maker_new();
        sheet(made, &side[0]);
        clod_surface *files[2] = {surface_of(made), NULL};
        sheet(made, &side[1]);
        clod_surface *both = surface_of(made);
        made = maker_new();
        sheet(made, &side[1]);
        files[1] = surface_of(made);
        // in the middle, 1 % of the radius into each side
        const double z = (0.99 * RADIUS - (double)g * sin(tilt)) / cos(tilt);
        double distance[2];
        assert_int_equal(touch(&both, 1, (clod_vec3){0, 0.003, z}, distance), 2);
        check_close(distance[0], 0.99 * RADIUS, 1e-7);
        check_close(distance[1], 0.99 * RADIUS, 1e-7);
        assert_int_equal(touch(files, 2, (clod_vec3){0, 0.003, z}, distance), 2);
        check_close(distance[1], 0.99 * RADIUS, 1e-7);
        clod_surface_release(both);
        clod_surface_release(files[0]);
        clod_surface_release(files[1]);
    }
}

// A slit that is wider than 1/50 of the radius holds the grain on both rims.
static void a_slit_has_two_rims(void **state)
{
    (void)state;
    maker *made = maker_new();
    sheet(made, &(half){-2e-4f, 0, M_PI});
    sheet(made, &(half){2e-4f, 0, 0});
    clod_surface *surface = surface_of(made);
    double distance[2];
    assert_int_equal(touch(&surface, 1, (clod_vec3){0, 0.003, 0.0099}, distance), 2);
    check_close(distance[0], hypot(0.0099, 2e-4), 1e-9);
    check_close(distance[1], hypot(0.0099, 2e-4), 1e-9);
    clod_surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flush_sheets),        cmocka_unit_test(sheets_with_steps_and_bends),
        cmocka_unit_test(closed_boxes),        cmocka_unit_test(grooves_push_from_each_side),
        cmocka_unit_test(a_slit_has_two_rims),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
