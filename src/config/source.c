#include "config/source.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"

struct clod_case_source {
    clod_report report; ///< names and texts of the files, for messages
    clod_arena arena;   ///< owned: tree and texts
    clod_node *root;
};

/** The texts of --set, in the arena; NULL without memory. */
static const char **copy_overrides(clod_loader *loader, size_t count)
{
    const char **copies = clod_arena_alloc(loader->arena, (count + 1) * sizeof *copies);
    for (size_t k = 0; copies != NULL && k < count; k++) {
        const char *text = loader->report->overrides[k];
        copies[k] = clod_arena_text(loader->arena, text, strlen(text));
        copies = copies[k] != NULL ? copies : NULL;
    }
    return copies;
}

void clod_source_keep(clod_case *self, clod_loader *loader, size_t overrides)
{
    const clod_report *from = loader->report;
    const char **copies = copy_overrides(loader, overrides);
    self->source = clod_memory_alloc(1, sizeof *self->source);
    if (copies == NULL || self->source == NULL) {
        loader->report->lost = true;
        return;
    }
    self->source->report = (clod_report){.name = self->path,
                                         .text = self->text,
                                         .length = from->length,
                                         .included_name = from->included_name,
                                         .included_text = from->included_text,
                                         .included_length = from->included_length,
                                         .overrides = copies};
    self->source->root = loader->root;
    self->source->arena = *loader->arena;
    *loader->arena = (clod_arena){0};
}

void clod_source_destroy(clod_case_source **self)
{
    if (*self != NULL) {
        clod_arena_fini(&(*self)->arena);
        clod_memory_free(*self);
        *self = NULL;
    }
}

/** Length of the path with which a text begins, ended by ": "; 0: there is none. The longest that the case
 *  has, where there is one: a name of a part may have any characters. */
static size_t path_length(clod_node *root, const char *text)
{
    size_t found = 0;
    for (const char *end = strstr(text, ": "); end != NULL; end = strstr(end + 1, ": ")) {
        char path[CLOD_LOAD_PATH];
        const size_t there = (size_t)(end - text);
        if (there < sizeof path) {
            memcpy(path, text, there);
            path[there] = '\0';
            found = clod_tree_at(root, path) != NULL ? there : found;
        }
    }
    if (found > 0) {
        return found;
    }
    const size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789_.-");
    return length < CLOD_LOAD_PATH && strncmp(text + length, ": ", 2) == 0 ? length : 0;
}

/** The value where the whole path was written, else the key of the section that was. */
static clod_place place_of(clod_node *root, const char *path)
{
    const clod_node *node = clod_tree_at(root, path);
    return node != NULL && node->kind == CLOD_NODE_SCALAR
               ? node->place
               : clod_load_place(clod_tree_nearest(root, path));
}

bool clod_source_tell(const clod_case *self, clod_status *status)
{
    const clod_case_source *source = self->source;
    const size_t length = source != NULL ? path_length(source->root, status->text) : 0;
    if (length == 0 || strlen(status->text) > CLOD_STATUS_TEXT / 2 ||
        clod_tree_step(source->root, status->text, strcspn(status->text, ".:")) == NULL) {
        return false;
    }
    const clod_status said = *status;
    char path[CLOD_LOAD_PATH] = "";
    memcpy(path, said.text, length);
    return clod_report_one(&source->report, place_of(source->root, path), path,
                           said.text + length + 2, said.code, status);
}

const char *clod_source_where(const clod_case *self, const char *path, char *where)
{
    where[0] = '\0';
    if (self->source == NULL) {
        return where;
    }
    const clod_report *files = &self->source->report;
    const clod_place place = place_of(self->source->root, path);
    const char *name = place.source == CLOD_PLACE_INCLUDED ? files->included_name : files->name;
    const int length = place.source > 0 ? 0
                                        : snprintf(where, CLOD_SOURCE_WHERE, "%s:%d:%d: ", name,
                                                   place.line, place.column);
    if (length >= CLOD_SOURCE_WHERE) {
        where[0] = '\0';
    }
    return where;
}
