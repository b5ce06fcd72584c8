// Contacts of the library's object: what one is made of, and one found by its identity.

#include <string.h>

#include "clod/sim.h"
#include "support/check.h"

static clod_status status;

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
        cmocka_unit_test(every_member_is_in_the_list),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
