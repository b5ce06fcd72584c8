// The contacts of a step, read one slab after the other, are those that it exports.
#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define STEPS 3000

/** Read all contacts, `room` at a time, and compare them with the exported ones. */
static void compare(const scene *s, const clod_contact_source *from, size_t room)
{
    const clod_state *state = &s->state;
    clod_contact *some = clod_memory_alloc(room, sizeof *some);
    clod_contact *all = clod_memory_alloc(state->contact_count + room, sizeof *all);
    size_t pairs, walls, count = 0, got = room;
    from->begin(from->context, &pairs, &walls);
    assert_int_equal(walls, state->wall_contact_count);
    assert_int_equal(pairs + walls, state->contact_count);
    while (got == room) {
        got = from->next(from->context, some, room);
        memcpy(all + count, some, got * sizeof *some);
        count += got;
        assert_true(count <= state->contact_count);
    }
    assert_int_equal(from->next(from->context, some, room), 0); // and so it stays
    const clod_state read = {
        .contacts = all, .contact_count = count, .wall_contact_count = walls};
    assert_true(bits_same_contacts(&read, state));
    clod_memory_free(some);
    clod_memory_free(all);
}

static void what_is_read_is_what_is_exported(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        for (int threads = looks_for_races() ? 3 : 1; threads <= (looks_for_races() ? 3 : 4);
             threads++) {
            scene s;
            bed_init(&s, (bed_kind)kind, 7);
            scene_start_with(&s, (clod_step_options){.threads = threads});
            scene_run(&s, STEPS);
            clod_step_reader reader;
            const clod_contact_source from = clod_step_contacts(&s.step, &reader);
            assert_true(clod_step_export(&s.step, &s.step.status));
            assert_true(s.state.contact_count > 50);
            for (size_t room = 1; room < 1000; room = 3 * room + 1) {
                compare(&s, &from, room);
            }
            compare(&s, &from, s.state.contact_count); // which is not seen to be the end
            scene_end(&s);
        }
    }
}

/** Contacts in the list of a state: those of a step whose list could not be made, or of none.
 */
static void a_state_without_lists_is_read_too(void **state)
{
    (void)state;
    scene s;
    bed_init(&s, BED_DRUM, 7);
    scene_start(&s);
    scene_run(&s, STEPS);
    assert_true(clod_step_export(&s.step, &s.step.status));
    clod_contact_list list;
    clod_contact_source from = clod_contact_source_of(&list, &s.state);
    compare(&s, &from, 7);
    s.step.near.made = false;
    clod_step_reader reader;
    from = clod_step_contacts(&s.step, &reader);
    assert_true(from.next != NULL && from.context == &reader.list);
    compare(&s, &from, 7);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_read_is_what_is_exported),
        cmocka_unit_test(a_state_without_lists_is_read_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
