// What the contacts of a step remember, as forces: against the closed forms of the pair's law,
// in beds of three materials and six laws, with walls.

#include "state/contact_walk.h"
#include "support/bed.h"

/** Pull-off force of the clamp, k_adh x at the overlap where P meets the upper bound. */
static void check_contact(const scene *s, const clod_contact *contact,
                          clod_contact_strength strength, int *adhesive)
{
    const clod_grains *grains = &s->state.grains;
    const int a = grains->material[contact->i];
    const clod_wall *walls = s->state.walls.wall;
    const int b = contact->shape < 0 ? grains->material[contact->j]
                                     : clod_wall_material(&walls[contact->j], contact->shape);
    // row of an upper triangle, written out
    static const int ROW[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    const clod_law *law = &s->law[ROW[a][b]];
    const double memory = contact->history[0];
    const double x = memory / (1.0 + law->k_adh / law->k2);
    check_close(strength.pull_off, law->k_adh * x, 1e-12 * (1.0 + law->k_adh * x));
    const double pressed =
        memory > 0.0 ? law->k1 * memory * law->k2 / (law->k2 - law->k1) : 0.0;
    check_close(strength.pressed, pressed, 1e-12 * (1.0 + pressed));
    *adhesive += strength.pull_off > 0.0;
}

static void strength_is_that_of_the_law(void **state)
{
    (void)state;
    int pairs = 0, walls = 0;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        clod_step_reader reader;
        bed_init(&s, (bed_kind)kind, 3);
        scene_start(&s);
        scene_run(&s, 3000);
        const clod_contact_source from = clod_step_contacts(&s.step, &reader);
        const clod_contact *contact;
        clod_contact_walk walk;
        clod_contact_walk_begin(&walk, &from);
        while ((contact = clod_contact_walk_next(&walk)) != NULL) {
            check_contact(&s, contact, from.strength(from.laws, contact),
                          contact->shape < 0 ? &pairs : &walls);
        }
        scene_end(&s);
    }
    assert_true(pairs > 50 && walls > 10); // that pull
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strength_is_that_of_the_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
