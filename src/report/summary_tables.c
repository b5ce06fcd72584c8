#include "report/summary_tables.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/text.h"
#include "base/unit_endings.h"
#include "report/figure_json.h"
#include "report/html.h"
#include "report/rounded.h"

#define MOST 64 ///< objects, and rows, of a table
#define WIDE 5  ///< objects that stand in columns

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

/** What a row, or a column, has of each object. */
typedef struct quantity {
    const char *key;
    size_t at;    ///< of a vector or tensor: number of the component
    char axes[3]; ///< of a vector "x", of a tensor "xy"; "": a plain number
} quantity;

/** Objects side by side, and their numbers. */
typedef struct layout {
    const json_t *item[MOST];
    char head[MOST][CLOD_FIGURE_NAME];
    quantity key[MOST];
    size_t items, keys;
    size_t more_items, more_keys; ///< that have no room
} layout;

static bool is_spread(const json_t *value)
{
    return json_is_number(json_object_get(value, "mean")) &&
           json_object_get(value, "deviation") != NULL;
}

/** Components of a mean with its deviation that is a vector, 3, or a tensor, 9; 0: it is none. */
static size_t components_of(const json_t *value)
{
    const size_t count = json_array_size(json_object_get(value, "mean"));
    return (count == 3 || count == 9) &&
                   json_array_size(json_object_get(value, "deviation")) == count
               ? count
               : 0;
}

/** Component `at` of `count` along the axes of an object: of x, y, z, or r, t, z. */
static quantity component_of(const json_t *item, const char *key, size_t count, size_t at)
{
    const char *along = json_string_value(json_object_get(item, "components"));
    const char *axis = along != NULL && strcmp(along, "cylindrical") == 0 ? "rtz" : "xyz";
    quantity self = {.key = key, .at = at, .axes = {axis[at % 3]}};
    if (count == 9) {
        self.axes[0] = axis[at / 3 % 3];
        self.axes[1] = axis[at % 3];
    }
    return self;
}

static bool is_vector(const json_t *value)
{
    return json_array_size(value) == 3 && json_is_number(json_array_get(value, 0));
}

static bool is_shown(const json_t *value)
{
    return json_is_number(value) || json_is_boolean(value) || json_is_string(value) ||
           is_spread(value) || is_vector(value) || components_of(value) > 0;
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

/** The key of the error of a number, if the object has one: angle_deg and error_deg, mean and deviation,
 *  sigma_c_Pa and sigma_c_error_Pa. */
static const json_t *error_of(const json_t *item, const char *key)
{
    static const char *const PAIRS[][2] = {{"angle", "error"}, {"mean", "deviation"}};
    char name[CLOD_FIGURE_NAME], unit[16], wanted[CLOD_FIGURE_NAME + 16];
    clod_summary_tables_name(key, name, unit);
    const size_t length =
        strlen(name); // of the key before its unit: they differ in blanks alone
    const char *ending = length < strlen(key) ? key + length : "";
    for (size_t k = 0; k < sizeof PAIRS / sizeof *PAIRS; k++) {
        if (strcmp(name, PAIRS[k][0]) == 0) {
            snprintf(wanted, sizeof wanted, "%s%s", PAIRS[k][1], ending);
            return json_object_get(item, wanted);
        }
    }
    snprintf(wanted, sizeof wanted, "%.*s_error%s", (int)length, key, ending);
    return json_object_get(item, wanted);
}

/** Whether a number is the error of another one of the object. */
static bool is_error(json_t *item, const json_t *value)
{
    const char *key;
    json_t *of;
    json_object_foreach(item, key, of)
    {
        if (of != value && json_is_number(of) && json_is_number(value) &&
            error_of(item, key) == value) {
            return true;
        }
    }
    return false;
}

static bool is_same(const quantity *a, const quantity *b)
{
    return strcmp(a->key, b->key) == 0 && strcmp(a->axes, b->axes) == 0;
}

/** Add what is not there yet. */
static void add_key(layout *self, quantity one)
{
    bool known = false;
    for (size_t k = 0; k < self->keys && !known; k++) {
        known = is_same(&self->key[k], &one);
    }
    if (!known && self->keys < MOST) {
        self->key[self->keys++] = one;
    } else if (!known) {
        self->more_keys++;
    }
}

/** Whether a key tells something about the object that has no row of its own. */
static bool is_about(const char *key)
{
    static const char *const ABOUT[] = {"name", "part", "components", "errors_note"};
    for (size_t k = 0; k < sizeof ABOUT / sizeof *ABOUT; k++) {
        if (strcmp(key, ABOUT[k]) == 0) {
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
        const size_t components = components_of(value);
        for (size_t c = 0; c < components; c++) {
            add_key(self, component_of(item, key, components, c));
        }
        if (components == 0 && is_shown(value) && !is_about(key) && !is_error(item, value)) {
            add_key(self, (quantity){.key = key});
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
            const json_t *value = json_object_get(self->item[i], self->key[k].key);
            const json_t *mean = is_spread(value) ? json_object_get(value, "mean") : value;
            if (json_is_string(value) || is_vector(value) || components_of(value) > 0 ||
                json_number_value(mean) != 0.0) {
                return true;
            }
        }
    }
    return false;
}

static void put_number(FILE *out, double value, double error, const char *unit)
{
    const bool whole = value == round(value) && fabs(value) < 1e15;
    clod_rounded_begin(out, "td", value, error, unit);
    if (error > 0.0) {
        clod_rounded_put(clod_writer_page(out), value, error, (double)NAN, CLOD_ROUNDED_SHORT,
                         "");
    } else {
        fprintf(out, whole ? "%.0f" : "%.4g", value);
    }
    fputs("</td>", out);
}

/** Whether an object has this component of a value, along the same axes. */
static bool has_component(const json_t *item, const quantity *which)
{
    const size_t count = components_of(json_object_get(item, which->key));
    const quantity own = component_of(item, which->key, count, which->at);
    return which->at < count && is_same(&own, which);
}

static double number_of(const json_t *value)
{
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

/** A number and its error, or words, that an object has of a quantity; vectors are none. */
static clod_summary_cell cell_of(const layout *self, size_t i, const quantity *which)
{
    const json_t *item = self->item[i];
    const json_t *value = json_object_get(item, which->key);
    const json_t *mean = json_object_get(value, "mean");
    const json_t *deviation = json_object_get(value, "deviation");
    clod_summary_cell cell = {self->head[i], which->key,  which->axes,
                              (double)NAN,   (double)NAN, NULL};
    if (which->axes[0] != '\0') {
        const bool has = has_component(item, which);
        cell.value = number_of(has ? json_array_get(mean, which->at) : NULL);
        cell.error = number_of(has ? json_array_get(deviation, which->at) : NULL);
    } else if (is_spread(value)) {
        cell.value = number_of(mean);
        cell.error = number_of(deviation);
    } else if (json_is_boolean(value)) {
        cell.words = json_is_true(value) ? "yes" : "no";
    } else if (json_is_string(value)) {
        cell.words = json_string_value(value);
    } else {
        cell.value = number_of(value);
        cell.error = number_of(error_of(item, which->key));
    }
    return cell;
}

static void put_cell(FILE *out, const layout *self, size_t i, const quantity *which)
{
    const json_t *value = json_object_get(self->item[i], which->key);
    const clod_summary_cell cell = cell_of(self, i, which);
    char name[CLOD_FIGURE_NAME], unit[16];
    clod_summary_tables_name(which->key, name, unit);
    if (which->axes[0] == '\0' && is_vector(value)) {
        fputs("<td>", out);
        for (size_t axis = 0; axis < 3; axis++) {
            fprintf(out, "%s%.4g", axis > 0 ? ", " : "(",
                    json_number_value(json_array_get(value, axis)));
        }
        fputs(")</td>", out);
    } else if (isfinite(cell.value)) {
        put_number(out, cell.value, cell.error, unit);
    } else {
        clod_html_cell(out, "td", cell.words != NULL ? cell.words : "");
    }
}

/** Whether any cell has an error. */
static bool has_errors(const layout *self)
{
    for (size_t i = 0; i < self->items; i++) {
        for (size_t k = 0; k < self->keys; k++) {
            if (cell_of(self, i, &self->key[k]).error > 0.0) {
                return true;
            }
        }
    }
    return false;
}

/** Name, axes and unit, as a head: "contact stress xy [Pa]". */
static void put_key(FILE *out, const quantity *which)
{
    char name[CLOD_FIGURE_NAME], unit[16], text[CLOD_FIGURE_NAME + 24];
    clod_summary_tables_name(which->key, name, unit);
    const int used = snprintf(text, sizeof text, which->axes[0] != '\0' ? "%s %s" : "%s%s",
                              name, which->axes);
    if (unit[0] != '\0' && used > 0) {
        snprintf(text + used, sizeof text - (size_t)used, " [%s]", unit);
    }
    clod_html_cell(out, "th", text);
}

/** A column for each object, a row for each number. */
static void put_columns(FILE *out, const layout *self)
{
    for (size_t i = 0; i < self->items; i++) {
        clod_html_cell(out, "th", self->head[i]);
    }
    fputs("</tr></thead>\n<tbody>", out);
    for (size_t k = 0; k < self->keys; k++) {
        fputs("<tr>", out);
        put_key(out, &self->key[k]);
        for (size_t i = 0; i < self->items; i++) {
            put_cell(out, self, i, &self->key[k]);
        }
        fputs("</tr>\n", out);
    }
}

/** A row for each object, where they are more than a page is wide. */
static void put_rows(FILE *out, const layout *self)
{
    for (size_t k = 0; k < self->keys; k++) {
        put_key(out, &self->key[k]);
    }
    fputs("</tr></thead>\n<tbody>", out);
    for (size_t i = 0; i < self->items; i++) {
        fputs("<tr>", out);
        clod_html_cell(out, "th", self->head[i]);
        for (size_t k = 0; k < self->keys; k++) {
            put_cell(out, self, i, &self->key[k]);
        }
        fputs("</tr>\n", out);
    }
}

void clod_summary_tables_put(FILE *out, const char *title, const char *note, json_t *from)
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
    (self.items > WIDE && self.items > self.keys ? put_rows : put_columns)(out, &self);
    fputs("</tbody></table></div>\n", out);
    if (note != NULL && has_errors(&self)) {
        fprintf(out, "<p class=\"note\">%s</p>\n", note);
    }
    if (self.more_items > 0 || self.more_keys > 0) {
        fprintf(out,
                "<p class=\"note\">%zu more of them, and %zu more numbers of these, are in "
                "summary.json.</p>\n",
                self.more_items, self.more_keys);
    }
}

/** The three components of a vector. */
static void take_vector(const json_t *value, clod_summary_cell cell, void *context,
                        void (*take)(void *, const clod_summary_cell *))
{
    static const char *const AXES[] = {"x", "y", "z"};
    for (size_t axis = 0; axis < 3; axis++) {
        cell.axes = AXES[axis];
        cell.value = number_of(json_array_get(value, axis));
        take(context, &cell);
    }
}

bool clod_summary_tables_each(json_t *from, void *context,
                              void (*take)(void *context, const clod_summary_cell *cell))
{
    layout self = {.items = 0};
    lay_out(&self, from);
    for (size_t i = 0; i < self.items; i++) {
        for (size_t k = 0; k < self.keys; k++) {
            const json_t *value = json_object_get(self.item[i], self.key[k].key);
            const clod_summary_cell cell = cell_of(&self, i, &self.key[k]);
            if (self.key[k].axes[0] == '\0' && is_vector(value)) {
                take_vector(value, cell, context, take);
            } else if (isfinite(cell.value) || cell.words != NULL) {
                take(context, &cell);
            }
        }
    }
    return self.more_items + self.more_keys == 0;
}
