#include "config/settings.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

/** Values that are the same with and without quotes, in lists too. */
static bool is_plain(const char *text)
{
    static const char LETTERS[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    const size_t length = strlen(text);
    char plain[sizeof LETTERS + 8];
    snprintf(plain, sizeof plain, "%s+._/^%% -", LETTERS);
    return length > 0 && strspn(text, plain) == length && strchr(" %", text[0]) == NULL &&
           text[length - 1] != ' ' && (text[0] != '-' || strchr(LETTERS, text[1]) != NULL);
}

static void put_quoted(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text != '\0'; text++) {
        const unsigned char byte = (unsigned char)*text;
        if (byte < ' ' || byte == 127) {
            fprintf(out, "\\x%02X", (unsigned)byte);
        } else {
            fprintf(out, "%s%c", byte == '"' || byte == '\\' ? "\\" : "", byte);
        }
    }
    fputc('"', out);
}

/** A value in one line; sections are there in lists only. */
static void put_node(FILE *out, const clod_node *node)
{
    if (node->kind == CLOD_NODE_SCALAR) {
        (is_plain(node->text) ? (void)fputs(node->text, out) : put_quoted(out, node->text));
        return;
    }
    const bool map = node->kind == CLOD_NODE_MAP;
    fputc(map ? '{' : '[', out);
    for (size_t i = 0; i < node->count; i++) {
        fputs(i == 0 ? "" : ", ", out);
        if (map) {
            put_quoted(out, node->items[i]->key);
            fputs(": ", out);
        }
        put_node(out, node->items[i]);
    }
    fputc(map ? '}' : ']', out);
}

bool clod_settings_add(clod_setting **items, size_t *count, const char *key, char *value)
{
    clod_setting *grown = clod_memory_grow(*items, *count, *count + 1, sizeof *grown);
    if (grown == NULL) {
        clod_memory_free(value);
        return false;
    }
    *items = grown;
    clod_setting *one = &grown[(*count)++];
    *one = (clod_setting){clod_memory_text(key), value};
    return one->key != NULL && value != NULL;
}

/** The settings of a section, appended to those that are there. */
typedef struct collection {
    clod_loader *loader;
    clod_setting *items;
    size_t count;
} collection;

static void add(collection *self, const char *key, const clod_node *node)
{
    clod_report *report = self->loader->report;
    if (node->kind == CLOD_NODE_SCALAR && node->text[0] == '\0') {
        clod_report_add(report, clod_load_place(node), self->loader->path, "has no value");
        return;
    }
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out != NULL) {
        put_node(out, node);
    }
    const bool good = out != NULL && clod_settings_add(&self->items, &self->count, key,
                                                       clod_text_close(&text));
    report->lost = report->lost || !good;
}

/** All keys below a section whose own path in the other file is `above`. */
static void collect(collection *self, const char *above, const clod_node *node)
{
    for (size_t i = 0; i < node->count && !self->loader->report->lost; i++) {
        const clod_node *item = node->items[i];
        char key[CLOD_LOAD_PATH];
        snprintf(key, sizeof key, "%s%s%s", above, above[0] == '\0' ? "" : ".", item->key);
        const size_t length = clod_load_enter(self->loader, item->key);
        if (item->kind == CLOD_NODE_MAP) {
            collect(self, key, item);
        } else {
            add(self, key, item);
        }
        clod_load_leave(self->loader, length);
    }
}

void clod_settings_load(clod_loader *self, const clod_param *param, const clod_node *node,
                        void *target)
{
    if (node->kind != CLOD_NODE_MAP || node->count == 0) {
        clod_report_add(self->report, clod_load_place(node), self->path,
                        "must be keys with values, for instance %s: %s", param->key,
                        param->example);
        return;
    }
    collection all = {.loader = self};
    collect(&all, "", node);
    *(void **)(void *)((char *)target + param->offset) = all.items;
    *(size_t *)(void *)((char *)target + param->count) = all.count;
}

void clod_settings_free(clod_setting *self, size_t count)
{
    for (size_t k = 0; self != NULL && k < count; k++) {
        clod_memory_free(self[k].key);
        clod_memory_free(self[k].value);
    }
    clod_memory_free(self);
}
