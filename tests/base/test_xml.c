// Texts in XML: the entities of its specification, and no character that it forbids.
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "base/xml.h"
#include "support/check.h"

static void expect(const char *text, const char *expected)
{
    clod_text made;
    FILE *out = clod_text_open(&made);
    assert_non_null(out);
    clod_xml_text(out, text);
    char *found = clod_text_close(&made);
    assert_string_equal(found, expected);
    clod_memory_free(found);
}

static void what_has_a_meaning_is_escaped(void **state)
{
    (void)state;
    expect("", "");
    expect("a < b && c > \"d\"", "a &lt; b &amp;&amp; c &gt; &quot;d&quot;");
    expect("&lt;", "&amp;lt;");
}

static void control_characters_are_left_out(void **state)
{
    (void)state;
    expect("a\tb\nc\x1b[31m\x01\r", "a\tb\nc[31m");
    expect("\xc3\xa4 \xe2\x89\xa5", "\xc3\xa4 \xe2\x89\xa5"); // UTF-8
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_a_meaning_is_escaped),
        cmocka_unit_test(control_characters_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
