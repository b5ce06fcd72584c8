#pragma once
/**
 * @file contacts.h
 * Contact laws of material pairs: inheritance from `default`, and what each law needs.
 */

#include "config/load.h"

#define CLOD_CONTACTS_MATERIALS 64

/**
 * Read the section `contacts` into self->pairs.
 *
 * A pair takes every key from its own section, else from `default`, else the default of the
 * table. Stiffnesses and the exponent are taken from `default` only when law and exponent are
 * the same there.
 *
 * @param loader  errors go to its report
 * @param self    [in,out] case whose other parts are loaded
 */
void clod_contacts_load(clod_loader *loader, clod_case *self);
