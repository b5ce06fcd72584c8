// Forces of grains on meshes, told again: on faces, in grooves, on edges and corners, while the mesh
// moves.

#include "output/temp_folder.h"
#include "sim/sim.h"
#include "support/contact_forces.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define STEPS 30000
#define LOOKS 60

/** Four faces like a folded sheet: a groove at x = 0 between two ridges, with open rims. */
static clod_sim *folded(const char *folder, const char *motion)
{
    char text[3 * PATH_MAX];
    mesh_file file = mesh_file_open(folder, "folded");
    for (int k = 0; k < 4; k++) {
        const double x = 0.02 * (k - 2), low = k % 2 == 0 ? -0.012 : 0.012;
        mesh_file_sheet(&file, (double[3]){x, -0.03, k % 2 == 0 ? 0.012 : 0.0},
                        (double[3]){0.02, 0.0, low}, (double[3]){0.0, 0.06, 0.0}, 2, 3);
    }
    mesh_file_close(&file);
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.4}}\n"
             "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m], open: delete}\n"
             "grains:\n"
             "  - material: ore\n"
             "    count: 150\n"
             "    radius: {distribution: uniform, min: 2 mm, max: 4 mm}\n"
             "    region: {box: {min: [-36 mm, -26 mm, 16 mm], max: [36 mm, 26 mm, 60 mm]}}\n"
             "walls:\n"
             "  sheet: {material: ore, shapes: [{mesh: {file: %s, unit: 1 m}}]%s}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 5e-6 s, design_stress: 10 kPa}\n",
             file.path, motion);
    return sim_made(text, 2);
}

static void on_a_folded_sheet(void **temporary)
{
    static const char *const MOTION[] = {
        "", ", spin: 2 rad/s, spin_axis: [1, 2, 3], velocity: [0.1 m/s, 0 m/s, 0.05 m/s]"};
    for (int k = 0; k < 2; k++) {
        clod_sim *sim = folded(*temporary, MOTION[k]);
        size_t slots = 0;
        for (int look = 0; look < LOOKS; look++) { // while they come, roll and rest
            CHECK(clod_sim_advance(sim, STEPS / LOOKS, &status));
            const clod_sim_contact *contact;
            size_t count;
            CHECK(clod_sim_contacts(sim, &contact, &count, &status));
            for (size_t c = 0; c < count; c++) {
                slots += contact[c].wall == 0 && contact[c].shape % CLOD_SURFACE_SLOTS != 0;
            }
            contact_forces_undo_kick(&sim->state);
            contact_forces_compare(&sim->step, false);
        }
        assert_true(slots > 3); // some were on rims, beyond the first slot of a patch
        clod_sim_destroy(&sim);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(on_a_folded_sheet, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
