// The largest stable step of a cubic lattice: by hand, and as the eigenvalues of that bed have it.

#include "setup/lattice.h"
#include "setup/stability.h"

#include "support/scene.h"

#define R 3e-3                                     // m
#define MASS (2481.3 * 4.1887902047863905 * 27e-9) // kg
#define OVERLAP (2.0 * R * 1e-3)                   // m
#define GAP (2.0 * R - OVERLAP)                    // m between centres
#define SIDE 4                                     // grains along an edge

/** Largest stable step of the same lattice by its eigenvalues (setup/stability.h). */
static double measured(const clod_case_contact *contact)
{
    scene s;
    scene_init(&s, 1e-9, contact);
    for (int g = 0; g < SIDE * SIDE * SIDE; g++) {
        const int layer = g / (SIDE * SIDE), line = g / SIDE % SIDE;
        scene_grain(&s, GAP * (g % SIDE), GAP * line, GAP * layer, R);
    }
    for (int a = 0; a < 3; a++) {
        s.state.domain.min[a] = -0.5 * GAP;
        s.state.domain.max[a] = (SIDE - 0.5) * GAP;
        s.state.domain.periodic[a] = true;
    }
    scene_start(&s);
    clod_status status = {0};
    clod_stability found;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&s.step, &reader);
    if (!clod_stability_measure(&found, &s.state, &contacts, &s.laws, &status)) {
        fail_msg("%s", status.text);
    }
    assert_int_equal(found.contacts, 3 * SIDE * SIDE * SIDE);
    scene_end(&s);
    return found.step;
}

static double closed(const clod_case_contact *contact)
{
    const clod_law law = clod_law_make(contact, &ORE, &ORE);
    return clod_lattice_step(&law, MASS, R, OVERLAP);
}

/** hooke, k = k_t = 1e6 N/m without dash-pots: 8 k a^2/I = 20 k/m (a/R)^2 is above 12 k/m; without friction 4 k/m. */
static void without_dash_pots_by_hand(void **state)
{
    (void)state;
    clod_case_contact contact = contact_elastic(1.0, 1e6);
    contact.friction = 0.5;
    const double arm = 0.5 * GAP / R;
    check_relative(closed(&contact), 2.0 / sqrt(20.0 * 1e6 / MASS * arm * arm), 1e-12);
    contact.friction = 0.0;
    check_relative(closed(&contact), 2.0 / sqrt(4.0 * 1e6 / MASS), 1e-12);
}

/** Each of the three modes is the first to go: slips that are soft and stiff, rolling that is stiff; and those of ore. */
static void as_the_eigenvalues_have_it(void **state)
{
    (void)state;
    static const struct {
        double ratio, restitution, rolling_friction, rolling_damping;
    } ALL[] = {
        {0.1, 1.0, 0.0, 0.0},  {0.1, 0.3, 0.0, 0.0}, {1.0, 1.0, 0.0, 0.0}, {1.0, 0.3, 0.0, 0.0},
        {1.0, 0.05, 0.0, 0.0}, {0.1, 0.3, 2.0, 0.0}, {0.1, 0.3, 2.0, 0.4},
    };
    for (size_t k = 0; k < sizeof ALL / sizeof *ALL; k++) {
        clod_case_contact contact = contact_elastic(1.0, 1e6);
        contact.friction = 0.5;
        contact.tangential_ratio = ALL[k].ratio;
        contact.restitution = ALL[k].restitution;
        contact.rolling = CLOD_ROLLING_EPSD;
        contact.rolling_friction = ALL[k].rolling_friction;
        contact.rolling_damping = ALL[k].rolling_damping;
        check_relative(closed(&contact), measured(&contact), 3e-5);
    }
    clod_case_contact ore = contact_ore(); // unloads on k2, rolls by epsd2
    check_relative(closed(&ore), measured(&ore), 3e-5);
    ore.law = CLOD_LAW_HERTZ;
    ore.restitution = 0.5;
    check_relative(closed(&ore), measured(&ore), 3e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_dash_pots_by_hand),
        cmocka_unit_test(as_the_eigenvalues_have_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
