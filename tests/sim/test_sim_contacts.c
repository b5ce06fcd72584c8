// Contacts of the library's object: what one is made of, and one found by its identity.

#include <math.h>
#include <string.h>

#include "support/sim_made.h"

/** A bed between sides on a floor that moves as a belt: springs of sliding and of rolling. */
static const char BED[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: mepa, exponent: 1, k1: 2e4 N/m, k2: 6e4 N/m, k_adh: 1e4 N/m,\n"
    "  restitution: 0.4, friction: 0.5, rolling: epsd, rolling_friction: 0.1}}\n"
    "time: {step: 1e-5 s}\n"
    "domain: {min: [-20 mm, -20 mm, -5 mm], max: [20 mm, 20 mm, 90 mm]}\n"
    "stages: [{name: shear, duration: 1 s}]\n"
    "walls:\n"
    "  floor: {material: ore, surface_velocity: [0.05 m/s, 0 m/s, 0 m/s],\n"
    "    shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n"
    "  sides: {material: ore, shapes: [\n"
    "    {plane: {point: [-10 mm, 0 mm, 0 mm], normal: [1, 0, 0]}},\n"
    "    {plane: {point: [10 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}},\n"
    "    {plane: {point: [0 mm, -10 mm, 0 mm], normal: [0, 1, 0]}},\n"
    "    {plane: {point: [0 mm, 10 mm, 0 mm], normal: [0, -1, 0]}}]}\n"
    "grains:\n"
    "  - {material: ore, count: 80, radius: {distribution: uniform, min: 1.6 mm, max: 2 mm},\n"
    "     region: {box: {min: [-8 mm, -8 mm, 2 mm], max: [8 mm, 8 mm, 60 mm]}}}\n";
#define STEPS 20000

static clod_sim *make(int threads)
{
    clod_sim *sim = sim_made(BED, threads);
    CHECK(clod_sim_advance(sim, STEPS, &status));
    return sim;
}

/** Found in the order of the list it is the listed one; in the other, springs are turned. */
static void check_pair(clod_sim *sim, const clod_sim_contact *there)
{
    clod_sim_contact same, turned;
    bool found = false;
    CHECK(clod_sim_contact_of(sim, there->id_1, there->id_2, &same, &found, &status));
    assert_true(found);
    assert_memory_equal(&same, there, sizeof same);
    found = false;
    CHECK(clod_sim_contact_of(sim, there->id_2, there->id_1, &turned, &found, &status));
    assert_true(found);
    assert_true(turned.id_1 == there->id_2 && turned.id_2 == there->id_1);
    assert_true(turned.row_1 == there->row_2 && turned.row_2 == there->row_1);
    assert_true(turned.wall == -1 && turned.shape == -1);
    assert_true(turned.plastic == there->plastic && turned.tangent == there->tangent);
    for (int k = 0; k < 3; k++) {
        assert_true(turned.spring[k] == -there->spring[k]);
        assert_true(turned.roll[k] == -there->roll[k]);
    }
}

static void check_wall(clod_sim *sim, const clod_sim_contact *there)
{
    clod_sim_contact same;
    bool found = false;
    CHECK(clod_sim_wall_contact_of(sim, there->id_1, there->wall, there->shape, &same, &found,
                                   &status));
    assert_true(found);
    assert_memory_equal(&same, there, sizeof same);
}

/** All that clod_sim_contacts lists is found; copies, as the list is lent. */
static size_t check_all(clod_sim *sim, size_t *pairs)
{
    const clod_sim_contact *listed;
    size_t count;
    CHECK(clod_sim_contacts(sim, &listed, &count, &status));
    *pairs = 0;
    double spring = 0.0, roll = 0.0;
    for (size_t k = 0; k < count; k++) {
        if (listed[k].wall < 0) {
            (*pairs)++;
            spring += fabs(listed[k].spring[0]);
            roll += fabs(listed[k].roll[0]);
            check_pair(sim, &listed[k]);
        } else {
            check_wall(sim, &listed[k]);
        }
    }
    assert_true(spring > 0.0 && roll > 0.0);
    return count;
}

/** Every pair of ids and every id with every shape: as many are found as are listed. */
static size_t ask_for_all(clod_sim *sim, uint64_t ids, size_t *pairs)
{
    size_t all = 0;
    clod_sim_contact ignored;
    bool found;
    *pairs = 0;
    for (uint64_t a = 0; a < ids; a++) {
        for (uint64_t b = 0; b < a; b++) {
            CHECK(clod_sim_contact_of(sim, a, b, &ignored, &found, &status));
            *pairs += found;
        }
        for (int32_t w = 0; w < 2; w++) {
            for (int32_t s = 0; s < (w == 0 ? 1 : 4); s++) {
                CHECK(clod_sim_wall_contact_of(sim, a, w, s, &ignored, &found, &status));
                all += found;
            }
        }
    }
    return all + *pairs;
}

static void every_contact_is_found(void **unused)
{
    (void)unused;
    for (int threads = 1; threads <= 2; threads++) {
        clod_sim *sim = make(threads);
        size_t pairs, asked;
        const size_t count = check_all(sim, &pairs);
        assert_in_range(pairs, 60, 300);
        assert_in_range(count - pairs, 10, 100);
        assert_int_equal(ask_for_all(sim, 100, &asked), count);
        assert_int_equal(asked, pairs);
        clod_sim_destroy(&sim);
    }
}

/** Removed grains have no contacts, from the moment they were asked to go; the others do. */
static void what_went_has_no_contact(void **unused)
{
    (void)unused;
    for (int threads = 1; threads <= 2; threads++) {
        clod_sim *sim = make(threads);
        const clod_sim_contact *listed;
        size_t count, pairs, asked;
        CHECK(clod_sim_contacts(sim, &listed, &count, &status));
        assert_true(listed[0].wall < 0);
        const clod_sim_contact first = listed[0];
        CHECK(clod_sim_remove_grain(sim, first.id_1, &status));
        for (uint64_t id = 10; id < 20; id++) {
            if (id != first.id_1) {
                CHECK(clod_sim_remove_grain(sim, id, &status));
            }
        }
        clod_sim_contact contact = first;
        bool found = true;
        CHECK(clod_sim_contact_of(sim, first.id_1, first.id_2, &contact, &found, &status));
        assert_false(found);
        assert_memory_equal(&contact, &first, sizeof first); // unchanged
        const size_t left = check_all(sim, &pairs);
        assert_true(left < count);
        assert_int_equal(ask_for_all(sim, 100, &asked), left);
        CHECK(clod_sim_advance(sim, 500, &status));
        check_all(sim, &pairs);
        clod_sim_destroy(&sim);
    }
}

static void what_is_not_there_is_not_found(void **unused)
{
    (void)unused;
    clod_sim *sim = make(1);
    clod_sim_contact contact;
    bool found = true;
    const uint64_t ids[][2] = {{1, 1}, {1, 900}, {900, 1}, {900, 901}};
    for (size_t k = 0; k < sizeof ids / sizeof *ids; k++) {
        found = true;
        CHECK(clod_sim_contact_of(sim, ids[k][0], ids[k][1], &contact, &found, &status));
        assert_false(found);
    }
    found = true;
    CHECK(clod_sim_wall_contact_of(sim, 900, 0, 0, &contact, &found, &status));
    assert_false(found);
    const struct {
        int32_t wall, shape;
        const char *words;
    } wrong[] = {{-1, 0, "no wall -1; there are 2"},
                 {2, 0, "no wall 2"},
                 {0, 1, "the wall 'floor' has no shape 1; it has 1"},
                 {1, -1, "no shape -1; it has 4"}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        assert_false(clod_sim_wall_contact_of(sim, 1, wrong[k].wall, wrong[k].shape, &contact,
                                              &found, &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, wrong[k].words));
    }
    assert_false(clod_sim_contact_of(NULL, 1, 2, &contact, &found, &status));
    assert_non_null(strstr(status.text, "self is NULL"));
    assert_false(clod_sim_contact_of(sim, 1, 2, NULL, &found, &status));
    assert_non_null(strstr(status.text, "contact is NULL"));
    assert_false(clod_sim_wall_contact_of(sim, 1, 0, 0, &contact, NULL, &status));
    assert_non_null(strstr(status.text, "found is NULL"));
    CHECK(clod_sim_remove_grain(sim, 900, &status)); // a wrong request is told here too
    assert_false(clod_sim_contact_of(sim, 1, 2, &contact, &found, &status));
    assert_non_null(strstr(status.text, "there is none with this id"));
    clod_sim_destroy(&sim);
}

#define MEMBER(name, type, components)                                                         \
    {                                                                                          \
#name, type, components, offsetof(clod_sim_contact, name),                             \
            sizeof((clod_sim_contact *)NULL)->name                                             \
    }

/** The list of members is the struct, written out here by hand. */
static void every_member_is_in_the_list(void **unused)
{
    (void)unused;
    static const struct {
        const char *name;
        clod_sim_type type;
        size_t components, offset, size;
    } MEMBERS[] = {
        MEMBER(id_1, CLOD_SIM_U64, 1),    MEMBER(id_2, CLOD_SIM_U64, 1),
        MEMBER(row_1, CLOD_SIM_U64, 1),   MEMBER(row_2, CLOD_SIM_U64, 1),
        MEMBER(wall, CLOD_SIM_I32, 1),    MEMBER(shape, CLOD_SIM_I32, 1),
        MEMBER(plastic, CLOD_SIM_F64, 1), MEMBER(tangent, CLOD_SIM_F64, 1),
        MEMBER(spring, CLOD_SIM_F64, 3),  MEMBER(roll, CLOD_SIM_F64, 3),
    };
    const size_t count = sizeof MEMBERS / sizeof *MEMBERS;
    size_t end = 0;
    assert_int_equal(clod_sim_contact_field_count(), count);
    for (size_t k = 0; k < count; k++) {
        clod_sim_contact_field field;
        assert_true(clod_sim_contact_field_look(k, &field, &status));
        assert_string_equal(field.name, MEMBERS[k].name);
        assert_int_equal(field.type, MEMBERS[k].type);
        assert_int_equal(field.components, MEMBERS[k].components);
        assert_int_equal(field.offset, MEMBERS[k].offset);
        assert_int_equal(field.offset, end); // nothing between
        const bool spring = strcmp(field.name, "spring") == 0;
        const bool roll = strcmp(field.name, "roll") == 0;
        assert_int_equal(field.turns, spring || roll); // docs/theory: i against j
        assert_string_equal(field.unit, spring                               ? "m"
                                        : roll                               ? "rad"
                                        : strcmp(field.name, "plastic") == 0 ? "m^n"
                                        : strcmp(field.name, "tangent") == 0 ? "N m-1"
                                                                             : "1");
        end += MEMBERS[k].size;
    }
    assert_int_equal(end, sizeof(clod_sim_contact));
    clod_sim_contact_field field;
    assert_false(clod_sim_contact_field_look(count, &field, &status));
    assert_non_null(strstr(status.text, "no field 10; there are 10"));
    assert_false(clod_sim_contact_field_look(0, NULL, &status));
    assert_non_null(strstr(status.text, "field is NULL"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_contact_is_found),
        cmocka_unit_test(what_went_has_no_contact),
        cmocka_unit_test(what_is_not_there_is_not_found),
        cmocka_unit_test(every_member_is_in_the_list),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
