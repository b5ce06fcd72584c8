#include "config/load.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "config/settings.h"
#include "config/suggest.h"
#include "config/value.h"

#define LONGEST_NAME 31

static void *at(void *target, size_t offset)
{
    return (char *)target + offset;
}

size_t clod_load_enter(clod_loader *self, const char *key)
{
    const size_t length = strlen(self->path);
    snprintf(self->path + length, sizeof self->path - length, "%s%s", length == 0 ? "" : ".",
             key);
    return length;
}

void clod_load_leave(clod_loader *self, size_t length)
{
    self->path[length] = '\0';
}

void clod_load_folder(const char *path, char folder[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    const int length = slash == NULL ? 1 : slash == path ? 1 : (int)(slash - path);
    snprintf(folder, PATH_MAX, "%.*s", length, slash == NULL ? "." : path);
}

clod_place clod_load_place(const clod_node *node)
{
    return node->key != NULL ? node->key_place : node->place;
}

/** "; did you mean cone.half_angle or wedge.half_angle?", the nearest key of the sections of a table; "" if none is near. */
static const char *hint_below(const clod_table *table, const char *key, char *buffer,
                              size_t size)
{
    clod_suggest near = clod_suggest_start(key);
    for (size_t k = 0; k < table->count; k++) {
        const clod_table *section =
            table->params[k].kind == CLOD_PARAM_SECTION ? table->params[k].table : NULL;
        for (size_t i = 0; section != NULL && i < section->count; i++) {
            clod_suggest_offer(&near, section->params[i].key);
        }
    }
    size_t used = 0;
    buffer[0] = '\0';
    for (size_t k = 0; k < table->count && clod_suggest_found(&near); k++) {
        const clod_param *param = &table->params[k];
        if (param->kind == CLOD_PARAM_SECTION && used < size &&
            clod_param_find(param->table, near.best) != NULL) {
            used +=
                (size_t)snprintf(buffer + used, size - used, "%s%s.%s",
                                 used == 0 ? "; did you mean " : " or ", param->key, near.best);
        }
    }
    if (used > 0 && used < size) {
        snprintf(buffer + used, size - used, "?");
    }
    return buffer;
}

static bool check_keys(clod_loader *self, const clod_table *table, const clod_node *node)
{
    bool good = true;
    for (size_t i = 0; i < node->count; i++) {
        const clod_node *item = node->items[i];
        if (clod_param_find(table, item->key) != NULL) {
            continue;
        }
        char hint[160];
        const char *now = NULL;
        clod_suggest near = clod_suggest_start(item->key);
        for (size_t k = 0; k < table->count; k++) {
            const char *formerly = table->params[k].formerly;
            now = formerly != NULL && strcmp(formerly, item->key) == 0 ? table->params[k].key
                                                                       : now;
            clod_suggest_offer(&near, table->params[k].key);
        }
        const bool beside =
            self->around != NULL && clod_param_find(self->around, item->key) != NULL;
        const size_t length = clod_load_enter(self, item->key);
        if (now == NULL && beside && node->key != NULL) {
            clod_report_add(self->report, item->key_place, self->path,
                            "this key is not known here: it belongs beside %s, not in it",
                            node->key);
        } else {
            clod_report_add(
                self->report, item->key_place, self->path, "this key is not known%s%s",
                now != NULL ? "; it is called now " : "",
                now != NULL                 ? now
                : clod_suggest_found(&near) ? clod_suggest_text(&near, hint, sizeof hint)
                                            : hint_below(table, item->key, hint, sizeof hint));
        }
        clod_load_leave(self, length);
        good = false;
    }
    return good;
}

static bool is_name(const char *text)
{
    const size_t length = strlen(text);
    const size_t good = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                     "0123456789_");
    const bool digit = text[0] >= '0' && text[0] <= '9';
    return length > 0 && good == length && !digit && length <= LONGEST_NAME;
}

/** Give an item of a map its name; every struct in a map starts with `char *name`. */
static void take_name(clod_loader *self, const clod_param *param, const clod_node *item,
                      char **name)
{
    if (!param->any_name && !is_name(item->key)) {
        clod_report_add(self->report, item->key_place, self->path,
                        "\"%s\" is not a name; use letters, digits and _, at most %d, with a "
                        "letter first",
                        item->key, LONGEST_NAME);
    }
    *name = clod_memory_text(item->key);
    self->report->lost = self->report->lost || *name == NULL;
}

static void fail_empty(clod_loader *self, const clod_param *param, const clod_node *node)
{
    clod_report_add(self->report, clod_load_place(node), self->path,
                    param->kind == CLOD_PARAM_LIST ? "has no elements; begin each with \"- \""
                                                   : "is empty");
}

static void load_items(clod_loader *self, const clod_param *param, const clod_node *node,
                       void *target)
{
    const clod_node_kind kind = param->kind == CLOD_PARAM_LIST ? CLOD_NODE_LIST : CLOD_NODE_MAP;
    const bool empty = node->kind == CLOD_NODE_SCALAR && node->text[0] == '\0';
    if (empty || (node->kind == kind && node->count == 0)) {
        fail_empty(self, param, node);
        return;
    }
    if (node->kind != kind) {
        clod_report_add(self->report, node->place, self->path, "must be %s, not %s",
                        kind == CLOD_NODE_LIST ? "a list of sections, each begun with \"- \""
                                               : "sections by name",
                        clod_tree_kind_name(node->kind));
        return;
    }
    char *items = clod_memory_alloc(node->count, param->table->size);
    if (items == NULL) {
        self->report->lost = true;
        return;
    }
    *(void **)at(target, param->offset) = items;
    *(size_t *)at(target, param->count) = node->count;
    for (size_t i = 0; i < node->count; i++) {
        const clod_node *item = node->items[i];
        char *element = items + i * param->table->size;
        char index[24];
        snprintf(index, sizeof index, "%zu", i);
        const size_t length = clod_load_enter(self, item->key == NULL ? index : item->key);
        if (kind == CLOD_NODE_MAP) {
            take_name(self, param, item, (char **)element);
        }
        clod_load_section(self, param->table, item, clod_load_place(item), element);
        clod_load_leave(self, length);
    }
}

static void load_rows(clod_loader *self, const clod_table *table, const clod_node *node,
                      clod_place place, void *target);

static void load_given(clod_loader *self, const clod_param *param, const clod_node *node,
                       void *target)
{
    if (param->given != 0) {
        *(bool *)at(target, param->given) = true;
    }
    switch (param->kind) {
    case CLOD_PARAM_SECTION:
        clod_load_section(self, param->table, node, clod_load_place(node),
                          at(target, param->offset));
        break;
    case CLOD_PARAM_LIST:
    case CLOD_PARAM_MAP:
        load_items(self, param, node, target);
        break;
    case CLOD_PARAM_PAIRS: // the pairs: contacts.c, when the materials are known
        load_rows(self, param->beside, node, clod_load_place(node), target);
        break;
    case CLOD_PARAM_SETTINGS:
        clod_settings_load(self, param, node, target);
        break;
    default:
        clod_value_load(self, param, node, target);
        break;
    }
}

static void load_missing(clod_loader *self, const clod_param *param, const char *section,
                         clod_place place, void *target)
{
    if (param->need == CLOD_PARAM_REQUIRED) {
        const char *colon = param->example == NULL ? "" : ", for instance ";
        const char *example = param->example == NULL ? "" : param->example;
        clod_report_add(self->report, place, section, "needs the key %s%s%s%s%s", param->key,
                        colon, param->example == NULL ? "" : param->key,
                        param->example == NULL ? "" : ": ", example);
    } else if (param->need == CLOD_PARAM_DEFAULTED) {
        clod_load_section(self, param->table, NULL, place, at(target, param->offset));
    } else if (param->fallback != NULL) {
        const clod_node *node = clod_tree_scalar(self->arena, param->fallback);
        if (node == NULL) {
            self->report->lost = true;
            return;
        }
        clod_value_load(self, param, node, target);
    }
}

/** A table of which exactly one key is given: the index of that key is the kind. */
static bool take_kind(clod_loader *self, const clod_table *table, const clod_node *node,
                      clod_place place, void *target)
{
    char all[128] = "";
    size_t given = 0;
    for (size_t i = 0; i < table->count; i++) {
        const size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", i == 0 ? "" : ", ",
                 table->params[i].key);
        if (clod_tree_find(node, table->params[i].key) != NULL) {
            *(int *)at(target, table->kind) = (int)i;
            given++;
        }
    }
    if (given != 1) {
        clod_report_add(self->report, place, self->path, "must have exactly one of %s", all);
    }
    return given == 1;
}

/** All rows of a table, from the section that holds their keys. */
static void load_rows(clod_loader *self, const clod_table *table, const clod_node *node,
                      clod_place place, void *target)
{
    for (size_t i = 0; i < table->count; i++) {
        const clod_param *param = &table->params[i];
        const clod_node *item = clod_tree_find(node, param->key);
        const size_t length = strlen(self->path);
        if (item != NULL) {
            clod_load_enter(self, param->key);
            self->around = param->kind == CLOD_PARAM_SECTION ? table : NULL;
            load_given(self, param, item, target);
            self->around = NULL;
        } else {
            char section[CLOD_LOAD_PATH];
            memcpy(section, self->path, sizeof section);
            clod_load_enter(self, param->key);
            load_missing(self, param, section, place, target);
        }
        clod_load_leave(self, length);
    }
}

void clod_load_section(clod_loader *self, const clod_table *table, const clod_node *node,
                       clod_place place, void *target)
{
    const bool empty = node != NULL && node->kind == CLOD_NODE_SCALAR && node->text[0] == '\0';
    if (node != NULL && !empty && node->kind != CLOD_NODE_MAP) {
        clod_report_add(self->report, node->place, self->path,
                        "must be a section with keys, not %s", clod_tree_kind_name(node->kind));
        return;
    }
    const bool known = node == NULL || empty || check_keys(self, table, node);
    self->around = NULL; // it is not around the sections below this one
    if (table->one_of && !(known && take_kind(self, table, node, place, target))) {
        return;
    }
    load_rows(self, table, node, place, target);
}

void clod_load_free(const clod_table *table, void *target)
{
    for (size_t i = 0; i < table->count; i++) {
        const clod_param *param = &table->params[i];
        void **value = at(target, param->offset);
        switch (param->kind) {
        case CLOD_PARAM_TEXT:
        case CLOD_PARAM_FILE:
        case CLOD_PARAM_REALS:
        case CLOD_PARAM_PAIRS:
            clod_memory_free(*value);
            *value = NULL;
            break;
        case CLOD_PARAM_SETTINGS:
            clod_settings_free(*value, *(size_t *)at(target, param->count));
            *value = NULL;
            break;
        case CLOD_PARAM_SECTION:
            clod_load_free(param->table, value);
            break;
        case CLOD_PARAM_LIST:
        case CLOD_PARAM_MAP:
            for (size_t k = 0; *value != NULL && k < *(size_t *)at(target, param->count); k++) {
                char *element = (char *)*value + k * param->table->size;
                clod_load_free(param->table, element);
                if (param->kind == CLOD_PARAM_MAP) {
                    clod_memory_free(*(char **)(void *)element);
                }
            }
            clod_memory_free(*value);
            *value = NULL;
            break;
        default:
            break;
        }
    }
}
