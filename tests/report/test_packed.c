// Numbers packed for a page, and base64. Expected texts: RFC 4648, section 10; and by hand.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/packed.h"

static void base64_gives_the_texts_of_the_rfc(void **state)
{
    (void)state;
    static const char *const PAIRS[][2] = {{"", ""},
                                           {"f", "Zg=="},
                                           {"fo", "Zm8="},
                                           {"foo", "Zm9v"},
                                           {"foob", "Zm9vYg=="},
                                           {"fooba", "Zm9vYmE="},
                                           {"foobar", "Zm9vYmFy"}};
    for (size_t k = 0; k < sizeof PAIRS / sizeof *PAIRS; k++) {
        clod_text text;
        FILE *out = clod_text_open(&text);
        assert_non_null(out);
        clod_packed_base64(out, (const unsigned char *)PAIRS[k][0], strlen(PAIRS[k][0]));
        char *made = clod_text_close(&text);
        assert_string_equal(made, PAIRS[k][1]);
        clod_memory_free(made);
    }
}

static void check(const double *value, size_t count, size_t stride, const char *wanted)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    assert_true(clod_packed_numbers(out, value, count, stride));
    char *made = clod_text_close(&text);
    assert_string_equal(made, wanted);
    clod_memory_free(made);
}

/** 0, 65535/2 rounded = 32768 and 65535, the lower byte first: 00 00 00 80 ff ff. */
static void numbers_lie_between_the_least_and_the_greatest(void **state)
{
    (void)state;
    const double all[] = {2.0, 7.0, 3.0, -1.0, 4.0, 0.0};
    check(all, 3, 2, "{\"min\":2,\"max\":4,\"data\":\"AAAAgP//\"}");
    const double same[] = {1.5, 1.5};
    check(same, 2, 1, "{\"min\":1.5,\"max\":1.5}");
    const double gap[] = {(double)NAN, 1.0, 0.0};
    check(gap, 3, 1, "{\"min\":0,\"max\":1,\"data\":\"AAD//wAA\"}");
    check(gap, 0, 1, "{\"min\":null,\"max\":null}");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(base64_gives_the_texts_of_the_rfc),
        cmocka_unit_test(numbers_lie_between_the_least_and_the_greatest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
