/**
 * include: FILE in a case. Expected: what the files say, and messages with the file and line where the
 * mistake stands.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "clod/case.h"
#include "clod/schema.h"
#include "support/check.h"

static char folder[] = "/tmp/clod-include-XXXXXX";
static clod_status status;

static const char CASE[] = "materials:\n"
                           "  ore: {density: 2500 kg/m3}\n"
                           "contacts:\n"
                           "  default: {law: hooke, k1: 1e5 N/m, friction: 0.3}\n"
                           "domain: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}\n"
                           "grains:\n"
                           "  - material: ore\n"
                           "    count: 3\n"
                           "    radius: {distribution: uniform, min: 5 mm, max: 6 mm}\n"
                           "    region: {box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 1 m]}}\n"
                           "stages: [{name: run, duration: 1 ms}]\n";

/** The case with a line more, beside a card. */
static clod_case *load(const char *line, const char *card, const char *const *overrides,
                       size_t count)
{
    char path[64];
    char text[2048];
    snprintf(path, sizeof path, "%s/card.yaml", folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(card, out);
    fclose(out);
    snprintf(path, sizeof path, "%s/case.yaml", folder);
    snprintf(text, sizeof text, "%s%s", CASE, line);
    status = (clod_status){CLOD_OK, ""};
    return clod_case_parse(path, text, strlen(text), overrides, count, &status);
}

static void refuse(const char *line, const char *card, const char *words)
{
    clod_case *self = load(line, card, NULL, 0);
    assert_null(self);
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, words) == NULL) {
        print_error("%s\nlacks: %s\n", status.text, words);
    }
    assert_non_null(strstr(status.text, words));
}

static const char CARD[] = "# a card\n"
                           "contacts:\n"
                           "  default:\n"
                           "    restitution: 0.41\n"
                           "grains:\n"
                           "  0: {velocity: [0 m/s, 0 m/s, -2 m/s]}\n"
                           "gravity: [0 m/s2, 0 m/s2, -5 m/s2]\n";

static void sections_are_joined(void **state)
{
    (void)state;
    clod_case *self = load("include: card.yaml\n", CARD, NULL, 0);
    assert_non_null(self);
    const clod_case_contact *pair = clod_case_pair(self, 0, 0);
    assert_true(pair->restitution == 0.41 && pair->friction == 0.3);
    assert_true(self->grains[0].velocity[2] == -2.0 && self->grains[0].count == 3);
    assert_true(self->gravity[2] == -5.0);
    // the complete case has the keys, and needs no card
    char *echo = clod_case_echo(self);
    assert_non_null(strstr(echo, "restitution: 0.41"));
    assert_null(strstr(echo, "include"));
    clod_schema_free(echo);
    clod_case_destroy(&self);
}

static void an_override_comes_after(void **state)
{
    (void)state;
    const char *overrides[] = {"contacts.default.restitution=0.7"};
    clod_case *self = load("include: card.yaml\n", CARD, overrides, 1);
    assert_non_null(self);
    assert_true(clod_case_pair(self, 0, 0)->restitution == 0.7);
    clod_case_destroy(&self);
}

// As if it stood in the case, whatever the order; before, the file was not read, and nothing said so.
static void an_override_may_name_the_file(void **state)
{
    (void)state;
    const char *overrides[] = {"contacts.default.restitution=0.7", "include=card.yaml"};
    clod_case *self = load("", CARD, overrides, 2);
    assert_non_null(self);
    assert_true(clod_case_pair(self, 0, 0)->restitution == 0.7 && self->gravity[2] == -5.0);
    clod_case_destroy(&self);
    self = load("include: nothing.yaml\n", CARD, overrides, 2);
    assert_non_null(self);
    assert_true(self->gravity[2] == -5.0);
    clod_case_destroy(&self);
    const char *wrong[] = {"include=nothing.yaml"};
    assert_null(load("", CARD, wrong, 1));
    assert_non_null(strstr(status.text, "nothing.yaml: cannot be opened"));
}

// As all --set: 0.4 of the card in place of 0.3, a vector whole, the radius within its section; the rest stays.
static void a_file_that_an_override_names_replaces_keys(void **state)
{
    (void)state;
    static const char BOTH[] = "contacts:\n  default: {friction: 0.4}\n"
                               "domain: {max: [1 m, 1 m, 2 m]}\n"
                               "grains:\n  0: {radius: {min: 4 mm}}\n";
    const char *overrides[] = {"include=card.yaml", "grains.0.count=5"};
    clod_case *self = load("include: nothing.yaml\n", BOTH, overrides, 2);
    assert_non_null(self);
    assert_true(clod_case_pair(self, 0, 0)->friction == 0.4 &&
                clod_case_pair(self, 0, 0)->k1 == 1e5);
    assert_true(self->domain_max[2] == 2.0 && self->domain_min[2] == 0.0);
    assert_true(fabs(self->grains[0].radius_min - 4e-3) < 1e-15 && self->grains[0].count == 5);
    clod_case_destroy(&self);
    // --set after the card, whatever the order
    const char *more[] = {"contacts.default.friction=0.6", "include=card.yaml"};
    self = load("", BOTH, more, 2);
    assert_non_null(self);
    assert_true(clod_case_pair(self, 0, 0)->friction == 0.6);
    clod_case_destroy(&self);
    // mistakes of the card are still shown there
    assert_null(load("", "contacts:\n  default: {friction: -1}\n", more + 1, 1));
    assert_non_null(
        strstr(status.text, "card.yaml:2:23: contacts.default.friction: -1 is out of range"));
}

static void a_key_in_both_is_refused_with_both_places(void **state)
{
    (void)state;
    char words[256];
    snprintf(
        words, sizeof words,
        "%s/case.yaml:4:38: contacts.default.friction: is given in %s/card.yaml too, in line 3; keep "
        "one of them, or name that file by --set include=FILE",
        folder, folder);
    refuse("include: card.yaml\n", "contacts:\n  default:\n    friction: 0.4\n", words);
}

static void mistakes_in_the_card_are_shown_there(void **state)
{
    (void)state;
    refuse("include: card.yaml\n", "contacts:\n  default:\n    restitutio: 0.4\n",
           "card.yaml:3:5: contacts.default.restitutio: this key is not known; did you mean "
           "restitution?\n      restitutio: 0.4\n      ^");
    refuse("include: card.yaml\n", "contacts:\n  default: {restitution: 1.4}\n",
           "card.yaml:2:26: contacts.default.restitution: 1.4 is out of range");
    refuse("include: card.yaml\n", "contacts: [\n", "card.yaml:");
    refuse("include: card.yaml\n", "grains:\n  1: {count: 4}\n",
           "card.yaml:2:3: grains.1: the list of the case has no such element; it has 1");
}

/** One mistake, one message. */
static void a_key_that_is_twice_in_the_card_is_told_once(void **state)
{
    (void)state;
    static const char *const CARDS[] = {
        "gravity: 0\ngravity: 0\n",
        "contacts:\n  default: {restitution: 0.4, restitution: 0.5}\n",
        "output: {interval: 1 ms}\noutput: {interval: 1 ms}\n"};
    static const char *const KEYS[] = {"gravity", "restitution", "output"};
    for (int k = 0; k < 3; k++) {
        char words[64];
        snprintf(words, sizeof words, "key %s stands here a second time", KEYS[k]);
        refuse("include: card.yaml\n", CARDS[k], words);
        assert_null(strstr(status.text, "keep one of them"));
    }
}

static void what_cannot_be_included(void **state)
{
    (void)state;
    refuse("include: none.yaml\n", "", "none.yaml: cannot be opened");
    refuse("include: card.yaml\n", "# nothing\n", "has no keys of a case");
    refuse("include: card.yaml\n", "[1, 2]\n", "has no keys of a case");
    refuse("include: card.yaml\n", "include: other.yaml\n",
           "card.yaml:1:1: include: an included file cannot include another");
    refuse("include: [card.yaml]\n", CARD, "include: must be a single value");
}

static int begin(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}

static int end(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "%s/card.yaml", folder);
    return unlink(path) != 0 || rmdir(folder) != 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sections_are_joined),
        cmocka_unit_test(an_override_comes_after),
        cmocka_unit_test(an_override_may_name_the_file),
        cmocka_unit_test(a_file_that_an_override_names_replaces_keys),
        cmocka_unit_test(a_key_in_both_is_refused_with_both_places),
        cmocka_unit_test(mistakes_in_the_card_are_shown_there),
        cmocka_unit_test(a_key_that_is_twice_in_the_card_is_told_once),
        cmocka_unit_test(what_cannot_be_included),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
