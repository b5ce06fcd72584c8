#include "config/contacts.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "config/check.h"
#include "config/contacts_law.h"
#include "config/law_keys.h"
#include "config/suggest.h"

#define PAIR_NAME 256 ///< keys of YAML are at most 255 long

typedef clod_contacts_pair pair;

static const char *text_of(const clod_node *section, const char *key)
{
    const clod_node *node = clod_tree_find(section, key);
    return node != NULL && node->kind == CLOD_NODE_SCALAR ? node->text : NULL;
}

/** Whether a section gives a key another value than `default`, or than the table's default. */
static bool differs(const clod_node *own, const clod_node *common, const char *key)
{
    const char *mine = text_of(own, key);
    const char *theirs = text_of(common, key);
    const char *fallback = clod_param_find(&CLOD_TABLE_CONTACT, key)->fallback;
    return mine != NULL && strcmp(mine, theirs != NULL ? theirs : fallback) != 0;
}

/** Whether a key of `default` goes on to a section with its own law or exponent. */
static bool inherits(const clod_node *own, const clod_node *common, const char *key)
{
    const bool other_law = differs(own, common, "law");
    if (strcmp(key, "exponent") == 0) {
        return !other_law;
    }
    const bool stiffness = key[0] == 'k';
    return !stiffness || (!other_law && !differs(own, common, "exponent"));
}

static bool add(clod_loader *loader, clod_node *to, clod_node *item)
{
    if (item == NULL || !clod_tree_append(loader->arena, to, item)) {
        loader->report->lost = true;
        return false;
    }
    return true;
}

/** Own keys, then those of `default` that are inherited; NULL without memory. */
static clod_node *merge(clod_loader *loader, const clod_node *own, const clod_node *common,
                        clod_place place)
{
    clod_node *whole = clod_tree_node(loader->arena, CLOD_NODE_MAP, place);
    if (whole == NULL) {
        loader->report->lost = true;
        return NULL;
    }
    for (size_t i = 0; own != NULL && i < own->count; i++) {
        if (!add(loader, whole, own->items[i])) {
            return NULL;
        }
    }
    for (size_t i = 0; common != NULL && i < common->count; i++) {
        clod_node *item = common->items[i];
        const bool mine = own != NULL && clod_tree_find(own, item->key) != NULL;
        if (!mine && inherits(own, common, item->key) && !add(loader, whole, item)) {
            return NULL;
        }
    }
    const char *law = text_of(whole, "law");
    const double fixed = law != NULL ? clod_law_keys_exponent(law) : 0.0;
    if (fixed != 0.0 && clod_tree_find(whole, "exponent") == NULL) {
        char text[32];
        snprintf(text, sizeof text, "%.10g", fixed);
        const char *kept = clod_arena_text(loader->arena, text, strlen(text));
        clod_node *exponent = kept != NULL ? clod_tree_scalar(loader->arena, kept) : NULL;
        if (exponent != NULL) {
            exponent->key = "exponent";
        }
        if (!add(loader, whole, exponent)) {
            return NULL;
        }
    }
    return whole;
}

/** Read one merged section; false after errors in it. */
static bool load_merged(clod_loader *loader, const pair *self, clod_case_contact *contact)
{
    const clod_node *whole = merge(loader, self->own, self->common, self->place);
    if (whole == NULL) {
        return false;
    }
    const size_t before = loader->report->count;
    const size_t length = clod_load_enter(loader, self->path);
    clod_load_section(loader, &CLOD_TABLE_CONTACT, whole, self->place, contact);
    clod_load_leave(loader, length);
    return loader->report->count == before && clod_report_clean(loader->report, self->path);
}

/** Keys that stand in a pair's own section although its law has no use for them. */
static void check_own_unused(clod_loader *loader, const clod_case *whole, const pair *self,
                             const clod_case_contact *contact)
{
    for (size_t i = 0; i < CLOD_TABLE_CONTACT.count; i++) {
        const clod_param *row = &CLOD_TABLE_CONTACT.params[i];
        if (row->unused != NULL && clod_tree_find(self->own, row->key) != NULL &&
            !row->used(whole, contact)) {
            clod_contacts_fail_unused(loader, self, row);
        }
    }
}

/** Find the section of a pair under either of its two names. */
static const clod_node *find_pair(const clod_node *contacts, const clod_case *self, int a,
                                  int b, char name[PAIR_NAME])
{
    const char *first = self->materials[a].name;
    const char *second = self->materials[b].name;
    snprintf(name, PAIR_NAME, "%s-%s", first, second);
    const clod_node *node = clod_tree_find(contacts, name);
    if (node == NULL) {
        snprintf(name, PAIR_NAME, "%s-%s", second, first);
        node = clod_tree_find(contacts, name);
    }
    return node;
}

static void load_pair(clod_loader *loader, clod_case *self, const clod_node *contacts, int a,
                      int b)
{
    pair made = {.a = a, .b = b, .place = clod_load_place(contacts)};
    char name[PAIR_NAME];
    made.own = find_pair(contacts, self, a, b, name);
    made.common = clod_tree_find(contacts, "default");
    const bool needed = clod_check_pair_needed(self, a, b);
    if (made.own == NULL && made.common == NULL) {
        if (needed) {
            clod_report_add(loader->report, made.place, "contacts",
                            "no law for the pair %s-%s; add a section of this name, or default",
                            self->materials[a].name, self->materials[b].name);
        }
        return;
    }
    snprintf(made.path, sizeof made.path, "contacts.%s", made.own != NULL ? name : "default");
    made.place = clod_load_place(made.own != NULL ? made.own : made.common);
    clod_case_contact contact = {0};
    if (load_merged(loader, &made, &contact)) {
        clod_contacts_check_law(loader, &made, &contact);
        check_own_unused(loader, self, &made, &contact);
        if (needed) {
            clod_contacts_check_needs(loader, self, &made, &contact);
        }
        clod_contacts_complete(&contact);
    }
    contact.soften = self->soften;
    const size_t n = self->material_count;
    self->pairs[(size_t)a * n + (size_t)b] = contact;
    self->pairs[(size_t)b * n + (size_t)a] = contact;
}

/** Complain about half of a pair's name that is no material. */
static bool check_half(clod_loader *loader, const clod_case *self, const clod_node *section,
                       const char *half)
{
    if (clod_case_material_index(self, half) >= 0) {
        return true;
    }
    char hint[64];
    clod_suggest near = clod_suggest_start(half);
    for (size_t i = 0; i < self->material_count; i++) {
        clod_suggest_offer(&near, self->materials[i].name);
    }
    clod_report_add(loader->report, section->key_place, "contacts",
                    "\"%s\": there is no material %s%s", section->key, half,
                    clod_suggest_text(&near, hint, sizeof hint));
    return false;
}

static bool is_before(clod_place a, clod_place b)
{
    return a.line < b.line || (a.line == b.line && a.column < b.column);
}

static bool check_name(clod_loader *loader, const clod_case *self, const clod_node *contacts,
                       const clod_node *section)
{
    if (strcmp(section->key, "default") == 0) {
        return true;
    }
    char name[PAIR_NAME];
    snprintf(name, sizeof name, "%s", section->key);
    char *second = strchr(name, '-');
    if (second == NULL) {
        char hint[64];
        clod_suggest near = clod_suggest_start(section->key);
        clod_suggest_offer(&near, "default");
        for (size_t i = 0; i < CLOD_TABLE_CONTACTS.count; i++) {
            clod_suggest_offer(&near, CLOD_TABLE_CONTACTS.params[i].key);
        }
        clod_report_add(loader->report, section->key_place, "contacts",
                        "\"%s\" is not a pair; write two materials as a-b, or default%s",
                        section->key, clod_suggest_text(&near, hint, sizeof hint));
        return false;
    }
    *second++ = '\0';
    if (!check_half(loader, self, section, name) ||
        !check_half(loader, self, section, second)) {
        return false;
    }
    char turned[2 * PAIR_NAME];
    snprintf(turned, sizeof turned, "%s-%s", second, name);
    const clod_node *twin = clod_tree_find(contacts, turned);
    if (twin != NULL && twin != section && is_before(twin->key_place, section->key_place)) {
        clod_report_add(loader->report, section->key_place, "contacts",
                        "\"%s\" is the same pair as \"%s\" in line %d", section->key, twin->key,
                        twin->key_place.line);
        return false;
    }
    return true;
}

/** Names and kinds of all sections; with a wrong one, pairs would seem to have no law. */
static bool check_sections(clod_loader *loader, const clod_case *self,
                           const clod_node *contacts)
{
    bool good = true;
    for (size_t i = 0; i < contacts->count; i++) {
        const clod_node *section = contacts->items[i];
        if (clod_param_find(&CLOD_TABLE_CONTACTS, section->key) != NULL) {
            continue;
        }
        const bool named = check_name(loader, self, contacts, section);
        good = named && good;
        const bool empty = section->kind == CLOD_NODE_SCALAR && section->text[0] == '\0';
        if (named && section->kind != CLOD_NODE_MAP && !empty) {
            clod_report_add(loader->report, section->place, "contacts",
                            "\"%s\" must be a section with keys, not %s", section->key,
                            clod_tree_kind_name(section->kind));
            good = false;
        }
    }
    return good;
}

/** Keys for all pairs that stand in the section of one. */
static bool check_beside(clod_loader *loader, const clod_node *contacts)
{
    bool good = true;
    for (size_t i = 0; i < contacts->count; i++) {
        for (size_t k = 0; k < CLOD_TABLE_CONTACTS.count; k++) {
            const char *key = CLOD_TABLE_CONTACTS.params[k].key;
            const clod_node *node = clod_tree_find(contacts->items[i], key);
            if (node != NULL) {
                clod_report_add(loader->report, clod_load_place(node), "contacts",
                                "%s holds for all pairs: it stands beside them, as "
                                "contacts.%s, and not in %s",
                                key, key, contacts->items[i]->key);
                good = false;
            }
        }
    }
    return good;
}

/** Whether a pair that inherits a key of `default` has a use for it. */
static bool is_inherited(const clod_case *self, const clod_node *contacts,
                         const clod_param *row)
{
    const clod_node *common = clod_tree_find(contacts, "default");
    const size_t n = self->material_count;
    for (size_t a = 0; a < n; a++) {
        for (size_t b = a; b < n; b++) {
            char name[PAIR_NAME];
            const clod_node *own = find_pair(contacts, self, (int)a, (int)b, name);
            if (clod_tree_find(own, row->key) == NULL && inherits(own, common, row->key) &&
                row->used(self, &self->pairs[a * n + b])) {
                return true;
            }
        }
    }
    return false;
}

/** Keys of `default` that neither its own law nor that of any pair has a use for. */
static void check_default_unused(clod_loader *loader, const clod_case *self,
                                 const clod_node *contacts, const clod_case_contact *contact)
{
    const clod_node *common = clod_tree_find(contacts, "default");
    const pair alone = {.path = "contacts.default"};
    for (size_t i = 0; i < CLOD_TABLE_CONTACT.count; i++) {
        const clod_param *row = &CLOD_TABLE_CONTACT.params[i];
        if (row->unused != NULL && clod_tree_find(common, row->key) != NULL &&
            !row->used(self, contact) && !is_inherited(self, contacts, row)) {
            clod_contacts_fail_unused(loader, &alone, row);
        }
    }
}

/** Errors of `default` itself, before pairs repeat them under their own names. */
static void check_default(clod_loader *loader, const clod_node *contacts,
                          clod_case_contact *contact)
{
    const clod_node *common = clod_tree_find(contacts, "default");
    if (common == NULL || common->kind != CLOD_NODE_MAP) {
        return;
    }
    pair alone = {
        .common = common, .path = "contacts.default", .place = clod_load_place(common)};
    if (load_merged(loader, &alone, contact)) {
        clod_contacts_check_law(loader, &alone, contact);
    }
}

void clod_contacts_load(clod_loader *loader, clod_case *self)
{
    const clod_node *contacts = clod_tree_find(loader->root, "contacts");
    if (contacts == NULL || self->material_count == 0) {
        return;
    }
    if (contacts->kind != CLOD_NODE_MAP) {
        clod_report_add(loader->report, clod_load_place(contacts), "contacts",
                        "must be sections by pair of materials (a-b), and default");
        return;
    }
    if (self->material_count > CLOD_CONTACTS_MATERIALS) {
        clod_check_fail(loader, "materials", "has %zu materials, at most %d are allowed",
                        self->material_count, CLOD_CONTACTS_MATERIALS);
        return;
    }
    self->pairs =
        clod_memory_alloc(self->material_count * self->material_count, sizeof *self->pairs);
    if (self->pairs == NULL) {
        loader->report->lost = true;
        return;
    }
    if (!check_beside(loader, contacts)) {
        return;
    }
    clod_case_contact common = {0};
    check_default(loader, contacts, &common);
    if (!check_sections(loader, self, contacts)) {
        return;
    }
    for (int a = 0; a < (int)self->material_count; a++) {
        for (int b = a; b < (int)self->material_count; b++) {
            load_pair(loader, self, contacts, a, b);
        }
    }
    if (clod_report_clean(loader->report, "contacts")) {
        check_default_unused(loader, self, contacts, &common);
    }
}
