// Tables of a page as text: what a reader of a terminal sees of them.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/plain.h"

static void assert_plain(const char *html, const char *wanted)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    assert_true(clod_plain_put(out, html));
    char *told = clod_text_close(&text);
    assert_string_equal(told, wanted);
    clod_memory_free(told);
}

/** By hand: names begin a line, numbers end below each other; a plus or minus is one character of two bytes. */
static void columns_are_aligned(void **state)
{
    (void)state;
    assert_plain(
        "<div class=\"scroll\"><table class=\"results\"><thead><tr><th>quantity</th><th>a</th>"
        "<th>long name</th></tr></thead>\n<tbody><tr><th>flow [kg/s]</th>"
        "<td title=\"0.5 &plusmn; 0.1 kg/s\">0.50 <small>&plusmn; 0.10</small></td><td>12</td>"
        "</tr>\n<tr><th>&sigma;<sub>1</sub></th><td>3</td><td></td></tr></tbody></table></div>\n",
        "  quantity               a  long name\n"
        "  flow [kg/s]  0.50 ± 0.10         12\n"
        "  sigma_1                3           \n");
}

/** Headings and notes are lines; texts that were escaped are themselves. */
static void headings_and_notes_are_lines(void **state)
{
    (void)state;
    assert_plain("<h3>Gauges</h3>\n<table><tr><th title=\"t\">a &lt;b&gt; &amp;amp;</th></tr>"
                 "</table>\n<p class=\"note\"><strong>one</strong>: &plusmn; error</p>\n",
                 "\nGauges\n  a <b> &amp;\none: ± error\n");
    assert_plain("", "");
}

/** What would spoil a terminal is no part of it. */
static void control_characters_are_replaced(void **state)
{
    (void)state;
    assert_plain("<table><tr><td>a\033[31m</td></tr></table>", "  a?[31m\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_aligned),
        cmocka_unit_test(headings_and_notes_are_lines),
        cmocka_unit_test(control_characters_are_replaced),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
