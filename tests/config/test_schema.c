/**
 * Explanations and JSON Schema: complete and valid. The manual: tests/calibrate/test_explain.py.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <jansson.h>
#include <stdbool.h>
#include <string.h>

#include "clod/schema.h"
#include "config/walk.h"

typedef struct tally {
    size_t rows;
} tally;

/** Every row says what it is, where it comes from, and how an example looks. */
static void check_row(void *context, const char *path, const clod_param *param)
{
    tally *self = context;
    self->rows++;
    const bool group = param->table != NULL;
    if (param->help == NULL || param->source == NULL ||
        param->help[strlen(param->help) - 1] != '.') {
        fail_msg("%s: no help that ends in a full stop, or no source", path);
    }
    const bool exemplary =
        param->kind == CLOD_PARAM_CHOICE || param->fallback != NULL || param->example != NULL;
    if (!group && !exemplary) {
        fail_msg("%s: neither default nor example", path);
    }
    if ((param->kind == CLOD_PARAM_REAL || param->kind == CLOD_PARAM_VECTOR ||
         param->kind == CLOD_PARAM_REALS || param->kind == CLOD_PARAM_INTEGER) &&
        (param->unit == NULL || !(param->min < param->max))) {
        fail_msg("%s: no unit or no range", path);
    }
    // the key must be found by its own path
    static clod_status status;
    char *text = clod_schema_explain(NULL, path, &status);
    if (text == NULL || strncmp(text, path, strlen(path)) != 0 ||
        strstr(text, param->help) == NULL) {
        fail_msg("%s: explained as %s", path, text == NULL ? status.text : text);
    }
    clod_schema_free(text);
}

static void every_row_is_complete(void **state)
{
    (void)state;
    tally self = {0};
    clod_walk(&CLOD_TABLE_CASE, check_row, &self);
    assert_true(self.rows > 100);
}

static void explain_finds_paths_elements_and_last_parts(void **state)
{
    (void)state;
    static const char *const FOUND[][2] = {
        {"k_adh", "contacts.PAIR.k_adh\n"},
        {"contacts.ore-side.k_adh", "contacts.PAIR.k_adh\n"},
        {"grains.0.count", "grains.N.count\n"},
        {"grains.count", "grains.N.count\n"},
        {"stages.1.walls.lid.stress", "stages.N.walls.NAME.stress\n"},
        {"ring_shear.preshear_stress", "at least 10 Pa"},
        {"time.step", "default  auto"},
        {"coulomb", "one of adhesive, force, paper"},
    };
    static clod_status status;
    for (size_t i = 0; i < sizeof FOUND / sizeof FOUND[0]; i++) {
        char *text = clod_schema_explain(NULL, FOUND[i][0], &status);
        if (text == NULL || strstr(text, FOUND[i][1]) == NULL) {
            fail_msg("%s: %s", FOUND[i][0], text == NULL ? status.text : text);
        }
        clod_schema_free(text);
    }
    char *all = clod_schema_explain(NULL, NULL, &status);
    assert_non_null(strstr(all, "ring_shear.preshear_stress"));
    clod_schema_free(all);
}

static void explain_suggests_the_nearest_key(void **state)
{
    (void)state;
    static clod_status status;
    assert_null(clod_schema_explain(NULL, "kadh", &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(
        status.text, "there is no key kadh; did you mean k_adh?\nclod explain lists all keys");
    assert_null(clod_schema_explain(NULL, "ring_shear.dept", &status));
    assert_non_null(strstr(status.text, "did you mean ring_shear.depth?"));
}

static void schema_is_json_with_every_key(void **state)
{
    (void)state;
    char *text = clod_schema_json();
    assert_non_null(text);
    json_t *schema = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    assert_non_null(schema);
    assert_string_equal(json_string_value(json_object_get(schema, "$schema")),
                        "https://json-schema.org/draft/2020-12/schema");
    const json_t *keys = json_object_get(schema, "properties");
    for (size_t i = 0; i < CLOD_TABLE_CASE.count; i++) {
        assert_non_null(json_object_get(keys, CLOD_TABLE_CASE.params[i].key));
    }
    const json_t *ring = json_object_get(json_object_get(keys, "ring_shear"), "properties");
    assert_int_equal(json_object_size(ring), CLOD_TABLE_RING_SHEAR.count);
    json_decref(schema);
    clod_schema_free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_complete),
        cmocka_unit_test(explain_finds_paths_elements_and_last_parts),
        cmocka_unit_test(explain_suggests_the_nearest_key),
        cmocka_unit_test(schema_is_json_with_every_key),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
