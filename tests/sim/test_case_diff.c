// Which keys of two complete cases differ: text against text, both written by hand.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "sim/case_diff.h"

static char seen[1024];

static void note(void *context, const char *key, const char *there, const char *here)
{
    (void)context;
    const size_t used = strlen(seen);
    snprintf(seen + used, sizeof seen - used, "%s: %s | %s\n", key, there != NULL ? there : "-",
             here != NULL ? here : "-");
}

static void expect(const char *there, const char *here, const char *differences)
{
    clod_status status;
    seen[0] = '\0';
    assert_true(clod_case_differences(there, here, note, NULL, &status));
    assert_string_equal(seen, differences);
}

#define HEAD "# a comment: 1\ntitle: \"a: b\"\nmaterials:\n  ore:\n    density: 2500 kg/m3\n"
#define STAGES                                                                                 \
    "stages:\n  - name: \"a\"\n    duration: 1 s\n    walls:\n      lid:\n        spin: 1 "    \
    "rad/s\n"                                                                                  \
    "  - name: \"b\"\n    duration: 2 s\n"

static void keys_are_told_with_their_path(void **state)
{
    (void)state;
    expect(HEAD STAGES, HEAD STAGES, "");
    expect(HEAD "contacts:\n  ore-ore:\n    friction: 0.3\n    k1: 1 N/m\n",
           HEAD "contacts:\n  ore-ore:\n    friction: 0.2\n    k1: 1 N/m\n",
           "contacts.ore-ore.friction: 0.3 | 0.2\n");
    expect("# one\ntitle: \"a\"\n", "# two\ntitle: \"b\"\n", "title: \"a\" | \"b\"\n");
}

static void list_items_are_numbered(void **state)
{
    (void)state;
    expect(STAGES,
           "stages:\n  - name: \"a\"\n    duration: 1 s\n    walls:\n      lid:\n"
           "        spin: 2 rad/s\n  - name: \"c\"\n    duration: 2 s\n",
           "stages.0.walls.lid.spin: 1 rad/s | 2 rad/s\nstages.1.name: \"b\" | \"c\"\n");
    expect("walls:\n  box:\n    shapes:\n      - plane:\n          point: 1\n"
           "      - plane:\n          point: 2\n    spin: 0\n",
           "walls:\n  box:\n    shapes:\n      - plane:\n          point: 1\n"
           "      - plane:\n          point: 3\n    spin: 0\n",
           "walls.box.shapes.1.plane.point: 2 | 3\n");
}

static void what_is_only_in_one_is_told(void **state)
{
    (void)state;
    expect("a:\n  b: 1\nc: 2\n", "a:\n  b: 1\n  d: 3\n", "c: 2 | -\na.d: - | 3\n");
}

#define ONE(a, b)                                                                              \
    "parts:\n  \"Hood: left\":\n    speed: " a "\n  \"Hood: right\":\n    speed: " b "\n"
#define TWO(a, b)                                                                              \
    "parts:\n  \"a \\\"b\\\": c\\\\\":\n    speed: " a                                         \
    "\n  \"a \\\"b\\\": d\":\n    speed: " b "\n"

static void names_in_quotes_are_whole(void **state)
{
    (void)state;
    expect(ONE("1", "5"), ONE("2", "6"),
           "parts.\"Hood: left\".speed: 1 | 2\nparts.\"Hood: right\".speed: 5 | 6\n");
    expect(ONE("1", "5"), ONE("1", "6"), "parts.\"Hood: right\".speed: 5 | 6\n");
    expect(TWO("1", "5"), TWO("2", "5"), "parts.\"a \\\"b\\\": c\\\\\".speed: 1 | 2\n");
    expect("\"a: 1\n\"b\\", "\"a: 2\n\"c\\", ""); // a quote that does not end: no key
}

/** A name of 255 bytes, of which each takes two in quotes, and two that differ at the end. */
static void names_are_not_cut(void **state)
{
    (void)state;
    char name[511], texts[2][2400], differences[700];
    for (size_t k = 0; k < sizeof name - 1; k++) {
        name[k] = k % 2 == 0 ? '\\' : '"';
    }
    name[sizeof name - 1] = '\0';
    for (int t = 0; t < 2; t++) {
        snprintf(texts[t], sizeof texts[t],
                 "parts:\n  \"%s1\":\n    speed: 1\n  \"%s2\":\n    speed: %d\n", name, name,
                 5 + t);
    }
    snprintf(differences, sizeof differences, "parts.\"%s2\".speed: 5 | 6\n", name);
    expect(texts[0], texts[1], differences);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_are_told_with_their_path),
        cmocka_unit_test(list_items_are_numbered),
        cmocka_unit_test(what_is_only_in_one_is_told),
        cmocka_unit_test(names_in_quotes_are_whole),
        cmocka_unit_test(names_are_not_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
