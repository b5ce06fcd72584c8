// A walk meets each contact of a source once, in order, however many there are.
#include "state/contact_walk.h"
#include "support/check.h"

/** Contacts that are numbered by their rows. */
typedef struct numbered {
    int count, at;
} numbered;

static void begin(void *context, size_t *pairs, size_t *walls)
{
    numbered *self = context;
    self->at = 0;
    *walls = self->count > 0;
    *pairs = (size_t)self->count - *walls;
}

static size_t next(void *context, clod_contact *to, size_t room)
{
    numbered *self = context;
    size_t count = 0;
    for (; count < room && self->at < self->count; self->at++) {
        to[count++] = (clod_contact){.i = self->at};
    }
    return count;
}

static void each_contact_is_met_once(void **state)
{
    (void)state;
    for (int count = 0; count <= 3 * CLOD_CONTACT_WALK_SOME; count++) {
        numbered given = {.count = count};
        const clod_contact_source source = {.context = &given, .begin = begin, .next = next};
        clod_contact_walk walk;
        for (int way = 0; way < 2; way++) { // the second one begins in the middle of the first
            clod_contact_walk_begin(&walk, &source);
            assert_int_equal(walk.walls, count > 0);
            assert_int_equal(walk.pairs, count > 0 ? count - 1 : 0);
            const int stop = way == 0 ? count / 2 : count;
            for (int k = 0; k < stop; k++) {
                const clod_contact *contact = clod_contact_walk_next(&walk);
                assert_non_null(contact);
                assert_int_equal(contact->i, k);
            }
        }
        assert_null(clod_contact_walk_next(&walk));
        assert_null(clod_contact_walk_next(&walk)); // and so it stays
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_contact_is_met_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
