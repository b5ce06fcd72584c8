// The table of stages: barriers stand where one thread needs what another has written.
#include "step/stages.h"

#include "support/check.h"

/** What two stages must not touch at the same time, as the table has them. */
static int clash(const clod_stage *a, const clod_stage *b)
{
    const int touched =
        (a->writes & (b->reads | (b->writes & ~CLOD_STAGE_EACH))) | (a->reads & b->writes);
    return touched & ~(CLOD_STAGE_GATED | CLOD_STAGE_OWN) & ~(a->by_first & b->by_first);
}

/** The first pair of stages, of one step or of one and the next, without a barrier that they
 *  need; its first stage, or -1. */
static int unguarded(const clod_stage table[CLOD_STAGES])
{
    for (int a = 0; a < CLOD_STAGES; a++) {
        bool together = table[a].barrier == CLOD_BARRIER_NONE;
        for (int k = 1; together && k < CLOD_STAGES; k++) {
            const clod_stage *b = &table[(a + k) % CLOD_STAGES];
            if (b->barrier == CLOD_BARRIER_WITHIN) {
                // it writes behind its barrier only: what it reads before must stand
                clod_stage before = *b;
                before.writes = 0;
                if (clash(&table[a], &before) != 0) {
                    return a;
                }
                // where it makes no list there is no barrier either: on
                continue;
            }
            if (clash(&table[a], b) != 0) {
                return a;
            }
            together = b->barrier == CLOD_BARRIER_NONE;
        }
    }
    return -1;
}

/** The table as it is for one rank, which does nothing where ranks meet, or for several. */
static void table_for(clod_stage table[CLOD_STAGES], bool several)
{
    memcpy(table, CLOD_STAGE, sizeof *table * CLOD_STAGES);
    for (int k = 0; k < CLOD_STAGES; k++) {
        if (table[k].barrier == CLOD_BARRIER_RANKS && several) {
            table[k].barrier = CLOD_BARRIER_AFTER;
        } else if (table[k].barrier == CLOD_BARRIER_RANKS) {
            table[k].barrier = CLOD_BARRIER_NONE;
            table[k].reads = table[k].writes = table[k].by_first = 0;
        }
    }
}

static void barriers_stand_where_they_are_needed(void **state)
{
    (void)state;
    for (int several = 0; several < 2; several++) {
        clod_stage table[CLOD_STAGES];
        table_for(table, several != 0);
        const int found = unguarded(table);
        if (found >= 0) {
            fail_msg("a barrier is missing behind stage %s", CLOD_STAGE[found].name);
        }
    }
}

static void no_barrier_is_there_in_vain(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * CLOD_STAGES; k++) {
        clod_stage table[CLOD_STAGES];
        table_for(table, k < CLOD_STAGES);
        clod_stage *stage = &table[k % CLOD_STAGES];
        if (stage->barrier == CLOD_BARRIER_AFTER) {
            stage->barrier = CLOD_BARRIER_NONE;
            assert_true(unguarded(table) >= 0);
        }
    }
}

/** The first stage that needs a barrier before a last one; -1: none. */
static int unguarded_end(const clod_stage table[CLOD_STAGES],
                         const clod_stage last[CLOD_LAST_STAGES])
{
    clod_stage end[CLOD_STAGES + CLOD_LAST_STAGES];
    memcpy(end, table, sizeof *table * CLOD_STAGES);
    memcpy(end + CLOD_STAGES, last, sizeof *last * CLOD_LAST_STAGES);
    for (int b = CLOD_STAGES; b < CLOD_STAGES + CLOD_LAST_STAGES; b++) {
        for (int a = b - 1; a >= 0 && end[a].barrier == CLOD_BARRIER_NONE; a--) {
            if (clash(&end[a], &end[b]) != 0) {
                return a;
            }
        }
    }
    return -1;
}

static void the_last_stages_are_guarded(void **state)
{
    (void)state;
    for (int several = 0; several < 2; several++) {
        clod_stage table[CLOD_STAGES], last[CLOD_LAST_STAGES];
        table_for(table, several != 0);
        memcpy(last, CLOD_LAST_STAGE, sizeof last);
        if (several == 0) { // one rank has nothing to merge
            assert_int_equal(last[0].barrier, CLOD_BARRIER_RANKS);
            last[0].barrier = CLOD_BARRIER_NONE;
            last[1].reads = last[1].writes = last[1].by_first = 0;
        }
        assert_int_equal(unguarded_end(table, last), -1);
        if (several != 0) { // and the barrier is not there in vain
            last[0].barrier = CLOD_BARRIER_NONE;
            assert_int_not_equal(unguarded_end(table, last), -1);
        }
    }
}

/** Nothing is read that no stage writes, nothing written in vain; the ledger is for the caller.
 */
static void what_is_written_is_read(void **state)
{
    (void)state;
    int reads = 0, writes = 0;
    for (int k = 0; k < CLOD_STAGES; k++) {
        const clod_stage *stage = &CLOD_STAGE[k];
        assert_int_equal(stage->by_first & ~(stage->reads | stage->writes), 0);
        reads |= stage->reads;
        writes |= stage->writes;
    }
    for (int k = 0; k < CLOD_LAST_STAGES; k++) { // what planes have seen is read here alone
        reads |= CLOD_LAST_STAGE[k].reads;
        writes |= CLOD_LAST_STAGE[k].writes;
    }
    assert_int_equal(reads | CLOD_STAGE_SHARE | CLOD_STAGE_HISTORY, writes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(barriers_stand_where_they_are_needed),
        cmocka_unit_test(no_barrier_is_there_in_vain),
        cmocka_unit_test(the_last_stages_are_guarded),
        cmocka_unit_test(what_is_written_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
