// What is written once for a page and a terminal: what a reader of each sees of it.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/plain.h"
#include "report/writer.h"

/** Whether a text is laid out so. */
static void assert_plain(char *text, const char *wanted)
{
    clod_text own;
    FILE *out = clod_text_open(&own);
    assert_non_null(out);
    clod_plain_put(out, text);
    char *told = clod_text_close(&own);
    assert_string_equal(told, wanted);
    clod_memory_free(told);
}

/** What the writer makes of it. */
static void put(clod_writer out, const char *foreign, const char *words)
{
    clod_writer_mark(out, "<p>", "");
    clod_writer_cell(out, "td", foreign);
    clod_writer_words(out, words);
    clod_writer_mark(out, "</p>\n", "\n");
}

static void assert_written(const char *foreign, const char *words, const char *page,
                           const char *text)
{
    clod_text texts[2];
    const clod_writer out = {clod_text_open(&texts[0]), clod_text_open(&texts[1])};
    assert_true(out.page != NULL && out.text != NULL);
    put(out, foreign, words);
    char *told[2];
    for (size_t k = 0; k < 2; k++) {
        told[k] = clod_text_close(&texts[k]);
        assert_string_equal(told[k], k == 0 ? page : text);
        clod_memory_free(told[k]);
    }
    const clod_writer alone = clod_writer_page(clod_text_open(&texts[0]));
    put(alone, foreign, words);
    told[0] = clod_text_close(&texts[0]);
    assert_string_equal(told[0], page);
    clod_memory_free(told[0]);
}

/** By hand: names begin a line, numbers end below each other; a plus or minus is one character of two bytes. */
static void columns_are_aligned(void **state)
{
    (void)state;
    char text[] =
        "quantity\ta\tlong name\t\nflow [kg/s]\t0.50 \u00b1 0.10\t12\t\nsigma_1\t3\t\t\n\f";
    assert_plain(text, "  quantity               a  long name\n"
                       "  flow [kg/s]  0.50 \u00b1 0.10         12\n"
                       "  sigma_1                3           \n");
}

/** Each table has widths of its own, whatever stands beside it; a name alone has no blanks behind it. */
static void tables_and_lines_come_in_order(void **state)
{
    (void)state;
    char text[] = "a line\n\nlong name\t1\t\n\fb\t22\t\n\t3\t\n\fname\t\nof two\t\n\flast";
    assert_plain(text, "a line\n\n  long name  1\n  b  22\n      3\n  name\n  of two\nlast");
    assert_plain(text + sizeof text - 1, "");
}

/** What would spoil a terminal is no part of it. */
static void control_characters_are_replaced(void **state)
{
    (void)state;
    char text[] = "a\033[31m\t\n\fb\177\xff\n";
    assert_plain(text, "  a?[31m\nb??\n");
}

/** More columns than are aligned are written all the same. */
static void no_column_is_lost(void **state)
{
    (void)state;
    char text[2 * 200 + 16] = "name\t", wanted[3 * 200 + 16] = "  name";
    for (size_t k = 0; k < 200; k++) {
        strcat(text, "x\t");
        strcat(wanted, "  x");
    }
    strcat(text, "\n\f");
    strcat(wanted, "\n");
    assert_plain(text, wanted);
}

/** Foreign text is escaped on a page, and has no mark of a table in a text; words have symbols. */
static void both_say_the_same(void **state)
{
    (void)state;
    assert_written("a <b>\t& $tau_1$\n", "flowability $sigma_1$/$sigma_c$: $ff_c$, $r\u00b2$",
                   "<p><td>a &lt;b&gt;\t&amp; $tau_1$\n</td>flowability &sigma;<sub>1</sub>/"
                   "&sigma;<sub>c</sub>: ff<sub>c</sub>, r\u00b2</p>\n",
                   "a <b>?& $tau_1$?\tflowability sigma_1/sigma_c: ff_c, r\u00b2\n");
    assert_written(NULL, "$rho_inside$ or a_b $phi$",
                   "<p><td>-</td>&rho;<sub>inside</sub> or a_b &phi;</p>\n",
                   "-\trho_inside or a_b phi\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_aligned),
        cmocka_unit_test(tables_and_lines_come_in_order),
        cmocka_unit_test(control_characters_are_replaced),
        cmocka_unit_test(no_column_is_lost),
        cmocka_unit_test(both_say_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
