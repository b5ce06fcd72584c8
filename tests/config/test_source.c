/**
 * Errors that are found after a case was read get the place of their key. Expected: lines, columns and carets
 * counted by hand in the text below.
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "clod/case.h"
#include "config/source.h"
#include "support/case_of.h"

static char folder[] = "/tmp/clod-source-XXXXXX";

static const char CASE[] = "materials: {ore: {density: 2500 kg/m3}}\n"
                           "contacts: {default: {law: hooke, k1: 1e5 N/m, friction: 0.3}}\n"
                           "domain: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}\n"
                           "grains:\n"
                           "  - material: ore\n"
                           "    count: 3\n"
                           "    radius: {distribution: uniform, min: 5 mm, max: 6 mm}\n"
                           "    region: {box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}}\n"
                           "walls:\n"
                           "  floor:\n"
                           "    material: ore\n"
                           "    shapes:\n"
                           "      - plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}\n"
                           "stages: [{name: run, duration: 1 ms}]\n";

static clod_case *load(const char *more, const char *const *overrides, size_t count)
{
    char text[2048];
    snprintf(text, sizeof text, "%s%s", CASE, more);
    char path[64];
    snprintf(path, sizeof path, "%s/case.yaml", folder);
    return case_at(path, text, overrides, count);
}

/** What an error becomes; %s of the expected text is the folder. */
static void tells(const clod_case *self, const char *said, const char *expected)
{
    char whole[1024];
    clod_status status = {CLOD_OK, ""};
    snprintf(whole, sizeof whole, expected, folder);
    clod_status_fail(&status, CLOD_FAILED, "%s", said);
    assert_false(clod_source_tell(self, &status));
    assert_string_equal(status.text, whole);
    assert_int_equal(status.code, CLOD_FAILED);
}

static void a_key_has_its_line_and_a_caret(void **state)
{
    (void)state;
    clod_case *self = load("", NULL, 0);
    tells(self, "grains.0.count: too many",
          "%s/case.yaml:6:12: grains.0.count: too many\n      count: 3\n             ^");
    tells(self, "walls.floor: is lost",
          "%s/case.yaml:10:3: walls.floor: is lost\n    floor:\n    ^~~~~");
    tells(self, "walls.floor.shapes.0: cannot turn",
          "%s/case.yaml:13:9: walls.floor.shapes.0: cannot turn\n"
          "        - plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}\n          ^");
    clod_case_destroy(&self);
}

/** Of a key with its default only the section was written, or what is above that. */
static void a_default_has_the_place_of_its_section(void **state)
{
    (void)state;
    clod_case *self = load("", NULL, 0);
    tells(
        self, "walls.floor.oscillation.frequency: too fast",
        "%s/case.yaml:10:3: walls.floor.oscillation.frequency: too fast\n    floor:\n    ^~~~~");
    tells(self, "contacts.ore-ore: none",
          "%s/case.yaml:2:1: contacts.ore-ore: none\n"
          "  contacts: {default: {law: hooke, k1: 1e5 N/m, friction: 0.3}}\n  ^~~~~~~~");
    clod_case_destroy(&self);
}

/** A text without a key, of a section that was not written, with a place already, or of a case that was not
 *  read from a text. */
static void other_texts_stay(void **state)
{
    (void)state;
    clod_case *self = load("", NULL, 0);
    const char *const stay[] = {"",
                                "no memory for the walls",
                                "walls",
                                "time.step: is too long",
                                "walls.yaml:3:1: walls.floor: is lost",
                                "step 3: grains: none",
                                "walls floor: is lost"};
    for (size_t k = 0; k < sizeof stay / sizeof stay[0]; k++) {
        tells(self, stay[k], stay[k]);
        clod_status status = {CLOD_OK, ""};
        clod_status_fail(&status, CLOD_USAGE, "%s", stay[k]);
        clod_source_tell(self, &status);
        assert_string_equal(status.text, stay[k]);
    }
    const clod_case bare = {.path = self->path, .text = self->text};
    tells(&bare, "grains.0.count: too many", "grains.0.count: too many");
    clod_case_destroy(&self);
}

static void an_override_is_named_itself(void **state)
{
    (void)state;
    char setting[] = "grains.0.count=7";
    const char *const overrides[] = {"seed=2", setting};
    clod_case *self = load("", overrides, 2);
    memset(setting, 'x', strlen(setting)); // the case has its own copy
    tells(self, "grains.0.count: too many", "--set grains.0.count=7: grains.0.count: too many");
    tells(self, "grains.0.mass: too much",
          "%s/case.yaml:5:5: grains.0.mass: too much\n    - material: ore\n      ^");
    clod_case_destroy(&self);
}

static void an_included_file_is_named_itself(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "%s/card.yaml", folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs("# a card\ncontacts:\n  default:\n    restitution: 0.5\n", out);
    fclose(out);
    clod_case *self = load("include: card.yaml\n", NULL, 0);
    remove(path); // the case has its own copy
    tells(self, "contacts.default.restitution: too low",
          "%s/card.yaml:4:18: contacts.default.restitution: too low\n"
          "      restitution: 0.5\n                   ^~~");
    clod_case_destroy(&self);
}

/** Warnings have the place only. */
static void where_a_key_stands(void **state)
{
    (void)state;
    const char *const overrides[] = {"grains.0.count=7"};
    char where[CLOD_SOURCE_WHERE], expected[CLOD_SOURCE_WHERE];
    clod_case *self = load("", overrides, 1);
    snprintf(expected, sizeof expected, "%s/case.yaml:10:3: ", folder);
    assert_string_equal(clod_source_where(self, "walls.floor", where), expected);
    assert_string_equal(clod_source_where(self, "grains.0.count", where), "");
    const clod_case bare = {.path = self->path, .text = self->text};
    assert_string_equal(clod_source_where(&bare, "walls.floor", where), "");
    clod_case_destroy(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_key_has_its_line_and_a_caret),
        cmocka_unit_test(a_default_has_the_place_of_its_section),
        cmocka_unit_test(other_texts_stay),
        cmocka_unit_test(an_override_is_named_itself),
        cmocka_unit_test(an_included_file_is_named_itself),
        cmocka_unit_test(where_a_key_stands),
    };
    if (mkdtemp(folder) == NULL) {
        return EXIT_FAILURE;
    }
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
