#pragma once
/**
 * @file contacts_law.h
 * What the law of a pair of materials demands of the keys of its section.
 */

#include "config/load.h"

#define CLOD_CONTACTS_PATH 300

/** One pair while it is made. */
typedef struct clod_contacts_pair {
    int a, b;
    const clod_node *own;          ///< its section, or NULL
    const clod_node *common;       ///< `default`, or NULL
    char path[CLOD_CONTACTS_PATH]; ///< of the section to complain about
    clod_place place;
} clod_contacts_pair;

/** Complain about a key of the section. */
void clod_contacts_fail(clod_loader *loader, const clod_contacts_pair *self, const char *key,
                        const char *message);

/** Complain about a key of the section that is written but has no effect. */
void clod_contacts_fail_unused(clod_loader *loader, const clod_contacts_pair *self,
                               const clod_param *row);

/** Values that do not go with the law or with each other. */
void clod_contacts_check_law(clod_loader *loader, const clod_contacts_pair *self,
                             const clod_case_contact *contact);

/** What the law of a pair that will be used must have. */
void clod_contacts_check_needs(clod_loader *loader, const clod_case *whole,
                               const clod_contacts_pair *self,
                               const clod_case_contact *contact);

/** Fill what follows from the law; what has no effect does not hold what was inherited. */
void clod_contacts_complete(clod_case_contact *contact);
