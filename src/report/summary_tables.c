#include "report/summary_tables.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/text.h"
#include "base/unit_endings.h"
#include "report/figure_json.h"
#include "report/html.h"

#define MOST 64 ///< objects, and rows, of a table

#define ROW(ending, si, shown, factor) {ending, shown},

/** Endings of keys and the units that they mean. */
static const clod_unit_ending UNITS[] = {CLOD_UNIT_ENDINGS(ROW)};

/** The beginning of a key with blanks for underscores. */
static void put_words(const char *key, size_t length, char name[CLOD_FIGURE_NAME])
{
    clod_text_fit(name, CLOD_FIGURE_NAME, CLOD_FIGURE_NAME, key, length);
    for (char *at = strchr(name, '_'); at != NULL; at = strchr(at, '_')) {
        *at = ' ';
    }
}

void clod_summary_tables_name(const char *key, char name[CLOD_FIGURE_NAME], char unit[16])
{
    size_t length = strlen(key);
    unit[0] = '\0';
    for (size_t k = 0; unit[0] == '\0' && k < sizeof UNITS / sizeof *UNITS; k++) {
        const size_t end = strlen(UNITS[k].ending);
        if (length > end && strcmp(key + length - end, UNITS[k].ending) == 0) {
            length -= end;
            snprintf(unit, 16, "%s", UNITS[k].unit);
        }
    }
    put_words(key, length, name);
}

/** Objects side by side, and the keys of their numbers. */
typedef struct layout {
    const json_t *item[MOST];
    char head[MOST][CLOD_FIGURE_NAME];
    const char *key[MOST];
    size_t items, keys;
    size_t more_items, more_keys; ///< that have no room
} layout;

static bool is_spread(const json_t *value)
{
    return json_is_number(json_object_get(value, "mean")) &&
           json_object_get(value, "deviation") != NULL;
}

static bool is_vector(const json_t *value)
{
    return json_array_size(value) == 3 && json_is_number(json_array_get(value, 0));
}

static bool is_shown(const json_t *value)
{
    return json_is_number(value) || json_is_boolean(value) || json_is_string(value) ||
           is_spread(value) || is_vector(value);
}

/** Whether it is an object with something that is shown. */
static bool has_shown(json_t *item)
{
    const char *key;
    json_t *value;
    json_object_foreach(item, key, value)
    {
        if (is_shown(value)) {
            return true;
        }
    }
    return false;
}

static void add_keys(layout *self, json_t *item)
{
    const char *key;
    json_t *value;
    json_object_foreach(item, key, value)
    {
        bool known = !is_shown(value) || strcmp(key, "name") == 0 || strcmp(key, "part") == 0 ||
                     strcmp(key, "errors_note") == 0;
        for (size_t k = 0; k < self->keys && !known; k++) {
            known = strcmp(self->key[k], key) == 0;
        }
        if (!known && self->keys < MOST) {
            self->key[self->keys++] = key;
        } else if (!known) {
            self->more_keys++;
        }
    }
}

static void add_item(layout *self, json_t *item, const char *name)
{
    if (!has_shown(item)) {
        return;
    }
    if (self->items < MOST) {
        const size_t k = self->items++;
        self->item[k] = item;
        clod_text_fit(self->head[k], CLOD_FIGURE_NAME, CLOD_FIGURE_NAME, name, strlen(name));
        add_keys(self, item);
    } else {
        self->more_items++;
    }
}

static void lay_out(layout *self, json_t *from)
{
    size_t k;
    json_t *item;
    json_array_foreach(from, k, item)
    {
        const char *name = json_string_value(json_object_get(item, "name"));
        const char *part = json_string_value(json_object_get(item, "part"));
        char number[32];
        snprintf(number, sizeof number, "%zu", k + 1);
        add_item(self, item, name != NULL ? name : part != NULL ? part : number);
    }
    const char *key;
    json_t *value;
    json_object_foreach(from, key, value)
    {
        char name[CLOD_FIGURE_NAME];
        put_words(key, strlen(key), name);
        add_item(self, value, name);
    }
}

/** Whether any number differs from zero. */
static bool says_something(const layout *self)
{
    for (size_t i = 0; i < self->items; i++) {
        for (size_t k = 0; k < self->keys; k++) {
            const json_t *value = json_object_get(self->item[i], self->key[k]);
            const json_t *number = is_spread(value) ? json_object_get(value, "mean") : value;
            if (json_is_string(value) || is_vector(value) || json_number_value(number) != 0.0) {
                return true;
            }
        }
    }
    return false;
}

static void put_number(FILE *out, const json_t *value)
{
    const double number = json_number_value(value);
    fprintf(out, number == round(number) && fabs(number) < 1e15 ? "%.0f" : "%.5g", number);
}

static void put_cell(FILE *out, const json_t *value)
{
    if (is_spread(value)) {
        fputs("<td title=\"", out);
        clod_figure_json_number(out, json_number_value(json_object_get(value, "mean")));
        fputs("\">", out);
        put_number(out, json_object_get(value, "mean"));
        fprintf(out, " <small>&plusmn; %.2g</small></td>",
                json_number_value(json_object_get(value, "deviation")));
    } else if (is_vector(value)) {
        fputs("<td>", out);
        for (size_t axis = 0; axis < 3; axis++) {
            fprintf(out, "%s%.4g", axis > 0 ? ", " : "(",
                    json_number_value(json_array_get(value, axis)));
        }
        fputs(")</td>", out);
    } else if (json_is_number(value)) {
        fputs("<td title=\"", out);
        clod_figure_json_number(out, json_number_value(value));
        fputs("\">", out);
        put_number(out, value);
        fputs("</td>", out);
    } else if (json_is_boolean(value)) {
        clod_html_cell(out, "td", json_is_true(value) ? "yes" : "no");
    } else {
        clod_html_cell(out, "td", json_is_string(value) ? json_string_value(value) : "");
    }
}

static void put_rows(FILE *out, const layout *self)
{
    for (size_t k = 0; k < self->keys; k++) {
        char name[CLOD_FIGURE_NAME], unit[16];
        clod_summary_tables_name(self->key[k], name, unit);
        fputs("<tr>", out);
        clod_html_cell(out, "th", name);
        for (size_t i = 0; i < self->items; i++) {
            put_cell(out, json_object_get(self->item[i], self->key[k]));
        }
        clod_html_cell(out, "td", unit);
        fputs("</tr>\n", out);
    }
}

void clod_summary_tables_put(FILE *out, const char *title, json_t *from)
{
    layout self = {.items = 0};
    lay_out(&self, from);
    if (!says_something(&self)) {
        return;
    }
    if (title != NULL) {
        clod_html_cell(out, "h3", title);
    }
    fputs("<div class=\"scroll\"><table class=\"copied\"><thead><tr><th></th>", out);
    for (size_t i = 0; i < self.items; i++) {
        clod_html_cell(out, "th", self.head[i]);
    }
    fputs("<th>unit</th></tr></thead>\n<tbody>", out);
    put_rows(out, &self);
    fputs("</tbody></table></div>\n", out);
    if (self.more_items > 0 || self.more_keys > 0) {
        fprintf(out,
                "<p class=\"note\">%zu columns more, and %zu rows of these, are in "
                "summary.json.</p>\n",
                self.more_items, self.more_keys);
    }
}
