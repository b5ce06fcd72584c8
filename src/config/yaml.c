#include "config/yaml.h"

#include <libfyaml.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "clod/mesh.h"

#define LONGEST_KEY CLOD_MESH_NAME_MOST ///< bytes: a name of a part fits

typedef struct builder {
    clod_arena *arena;
    clod_report *report;
    int source;
    clod_node *root;
    clod_node *open[CLOD_YAML_DEPTH]; ///< maps and lists that are not closed yet
    size_t depth;
    const char *key; ///< of the map on top, waiting for its value
    clod_place key_place;
} builder;

/** Length of the character at `text`, 0 when it is none that a case file may have. */
static size_t character_length(const char *text, size_t left)
{
    const unsigned char c = (unsigned char)text[0];
    const bool control = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F;
    return control ? 0 : clod_text_utf8(text, left);
}

/** Refuse what libfyaml 0.7.12 should not be handed: too much text, bytes that are no text. */
static bool guard(const char *text, size_t length, int source, clod_report *report)
{
    clod_place place = {.source = source, .line = 1, .column = 1, .width = 1};
    if (length > CLOD_YAML_BYTES) {
        clod_report_add(report, place, "",
                        "%zu bytes are too long for a case file; at most %zu (1 MiB)", length,
                        CLOD_YAML_BYTES);
        return false;
    }
    const unsigned char *bytes = (const unsigned char *)text;
    for (size_t i = 0; i < length;) {
        const size_t step = character_length(text + i, length - i);
        if (step == 0) {
            clod_report_add(report, place, "",
                            "byte 0x%02X is not text; save the file as plain UTF-8", bytes[i]);
            return false;
        }
        place.column++;
        if (bytes[i] == '\n') {
            place.line++;
            place.column = 1;
        }
        i += step;
    }
    return true;
}

static clod_place place_of(const builder *self, struct fy_event *event)
{
    clod_place place = {.source = self->source, .line = 1, .column = 1, .width = 1};
    const struct fy_mark *start = fy_event_start_mark(event);
    const struct fy_mark *end = fy_event_end_mark(event);
    if (start != NULL) {
        place.line = start->line + 1;
        place.column = start->column + 1;
        if (event->type == FYET_SCALAR && end != NULL && end->line == start->line &&
            end->column > start->column) {
            place.width = end->column - start->column;
        }
    }
    return place;
}

static bool fail(const builder *self, clod_place place, const char *message)
{
    clod_report_add(self->report, place, "", "%s", message);
    return false;
}

static bool no_memory(const builder *self)
{
    self->report->lost = true;
    return false;
}

/** Hang a finished value under the map or list on top. */
static bool attach(builder *self, clod_node *node)
{
    if (self->depth == 0) {
        if (self->root != NULL) {
            return fail(self, node->place, "a second document; a case file holds one");
        }
        self->root = node;
        return true;
    }
    clod_node *above = self->open[self->depth - 1];
    if (above->kind == CLOD_NODE_MAP) {
        node->key = self->key;
        node->key_place = self->key_place;
        self->key = NULL;
    }
    return clod_tree_append(self->arena, above, node) || no_memory(self);
}

static bool waits_for_key(const builder *self)
{
    return self->depth > 0 && self->open[self->depth - 1]->kind == CLOD_NODE_MAP &&
           self->key == NULL;
}

/** Whether a key is what stands behind the comma of a number: {from: 0,2} has the keys from and 2 in YAML. */
static bool check_comma(const builder *self, const clod_node *above, const char *key,
                        clod_place place)
{
    const clod_node *before = above->count > 0 ? above->items[above->count - 1] : NULL;
    if (before == NULL || before->kind != CLOD_NODE_SCALAR || key[0] < '0' || key[0] > '9') {
        return true;
    }
    clod_place all = before->place;
    const size_t sign = strspn(before->text, "+-"),
                 digits = strspn(before->text + sign, "0123456789");
    if (digits == 0 || before->text[sign + digits] != '\0' || all.line != place.line ||
        all.column + all.width + 1 != place.column) {
        return true;
    }
    all.width += 1 + place.width;
    clod_report_add(self->report, all, "",
                    "write the decimal point as a point, not a comma: %s: %s.%s", before->key,
                    before->text, key);
    return false;
}

static bool take_key(builder *self, const char *text, clod_place place)
{
    if (text[0] == '\0' || strlen(text) > LONGEST_KEY) {
        return fail(self, place, "a key is a short word, followed by a colon and a space");
    }
    const clod_node *above = self->open[self->depth - 1];
    if (!check_comma(self, above, text, place)) {
        return false;
    }
    const clod_node *twin = clod_tree_find(above, text);
    if (twin != NULL) {
        clod_report_add(self->report, place, "",
                        "key %s stands here a second time; the first is in line %d", text,
                        twin->key_place.line);
    }
    self->key = text;
    self->key_place = place;
    return true;
}

static bool take_scalar(builder *self, struct fy_event *event)
{
    const clod_place place = place_of(self, event);
    size_t length = 0;
    const char *text = fy_token_get_text(event->scalar.value, &length);
    char *copy =
        clod_arena_text(self->arena, text == NULL ? "" : text, text == NULL ? 0 : length);
    if (copy == NULL) {
        return no_memory(self);
    }
    if (strlen(copy) != (text == NULL ? 0 : length)) {
        return fail(self, place, "a zero byte is not text");
    }
    if (waits_for_key(self)) {
        return take_key(self, copy, place);
    }
    clod_node *node = clod_tree_node(self->arena, CLOD_NODE_SCALAR, place);
    if (node == NULL) {
        return no_memory(self);
    }
    node->text = copy;
    return attach(self, node);
}

static bool open_group(builder *self, struct fy_event *event, clod_node_kind kind)
{
    const clod_place place = place_of(self, event);
    if (waits_for_key(self)) {
        return fail(self, place, "a key is a short word, not a list or a section");
    }
    if (self->depth == CLOD_YAML_DEPTH) {
        return fail(self, place, "sections and lists are nested too deeply");
    }
    clod_node *node = clod_tree_node(self->arena, kind, place);
    if (node == NULL) {
        return no_memory(self);
    }
    if (!attach(self, node)) {
        return false;
    }
    self->open[self->depth++] = node;
    return true;
}

static bool plain(const builder *self, struct fy_event *event)
{
    if (event->type == FYET_ALIAS || fy_event_get_anchor_token(event) != NULL) {
        return fail(self, place_of(self, event),
                    "anchors (&) and aliases (*) are not used in case files; write it out");
    }
    if (fy_event_get_tag_token(event) != NULL) {
        return fail(self, place_of(self, event), "tags (!) are not used in case files");
    }
    return true;
}

static bool take_event(builder *self, struct fy_event *event)
{
    switch (event->type) {
    case FYET_SCALAR:
        return plain(self, event) && take_scalar(self, event);
    case FYET_MAPPING_START:
        return plain(self, event) && open_group(self, event, CLOD_NODE_MAP);
    case FYET_SEQUENCE_START:
        return plain(self, event) && open_group(self, event, CLOD_NODE_LIST);
    case FYET_MAPPING_END:
    case FYET_SEQUENCE_END:
        self->depth--;
        return true;
    case FYET_ALIAS:
        return plain(self, event);
    default:
        return true;
    }
}

/** The diagnostics object prints nothing: what it collects goes into the report. */
static void drop_output(struct fy_diag *diag, void *user, const char *text, size_t length)
{
    (void)diag;
    (void)user;
    (void)text;
    (void)length;
}

/** Whether a line is a key whose colon has no space behind it: the commonest slip. */
static bool lacks_space(const clod_report *report, int line)
{
    const char *at = report->text;
    const char *end = at + report->length;
    for (int i = 1; i < line && at < end; at++) {
        i += *at == '\n';
    }
    while (at < end && (*at == ' ' || *at == '-')) {
        at++;
    }
    while (at < end && *at != ':' && *at != '\n' && *at != '#' && *at != '"') {
        at++;
    }
    return end - at > 1 && at[0] == ':' && at[1] != ' ' && at[1] != '\n' && at[1] != '\r';
}

static void report_syntax(const builder *self, struct fy_diag *diag)
{
    void *position = NULL;
    const struct fy_diag_error *error = fy_diag_errors_iterate(diag, &position);
    clod_place place = {.source = self->source, .line = 1, .column = 1, .width = 1};
    if (error == NULL || error->msg == NULL) {
        clod_report_add(self->report, place, "", "this is not YAML");
        return;
    }
    place.line = error->line > 0 ? error->line : 1;
    place.column = error->column > 0 ? error->column : 1;
    const bool space = self->source == 0 && lacks_space(self->report, place.line);
    clod_report_add(self->report, place, "", "not YAML: %s%s", error->msg,
                    space ? "; a colon needs a space behind it" : "");
}

static void parse(builder *self, struct fy_parser *parser, struct fy_diag *diag)
{
    bool good = true;
    for (;;) {
        struct fy_event *event = fy_parser_parse(parser);
        if (event == NULL) {
            break;
        }
        good = take_event(self, event);
        const bool end = event->type == FYET_STREAM_END;
        fy_parser_event_free(parser, event);
        if (!good || end) {
            break;
        }
    }
    if (good && (fy_parser_get_stream_error(parser) || fy_diag_got_error(diag))) {
        report_syntax(self, diag);
        good = false;
    }
    if (!good) {
        self->root = NULL;
    }
}

clod_node *clod_yaml_read(clod_arena *arena, const char *text, size_t length, int source,
                          clod_report *report)
{
    if (!guard(text, length, source, report)) {
        return NULL;
    }
    builder self = {.arena = arena, .report = report, .source = source};
    struct fy_diag_cfg config;
    fy_diag_cfg_default(&config);
    config.fp = NULL;
    config.output_fn = drop_output;
    config.colorize = false;
    struct fy_diag *diag = fy_diag_create(&config);
    const struct fy_parse_cfg parse_config = {
        .search_path = "",
        .flags = FYPCF_QUIET | FYPCF_COLLECT_DIAG | FYPCF_DEFAULT_VERSION_1_2 | FYPCF_JSON_NONE,
        .diag = diag,
    };
    struct fy_parser *parser = diag == NULL ? NULL : fy_parser_create(&parse_config);
    if (diag != NULL) {
        fy_diag_set_collect_errors(diag, true);
    }
    if (parser == NULL || fy_parser_set_string(parser, text, length) != 0) {
        no_memory(&self);
    } else {
        parse(&self, parser, diag);
    }
    fy_parser_destroy(parser);
    fy_diag_destroy(diag);
    return self.root;
}
