#pragma once
/**
 * @file law_forms.h
 * What the kernels ask of a law's kind, each question once. The rest of the program asks its
 * row (law_kinds.h). A kernel that is compiled for one kind knows the answers (kernel_batch.h):
 * they are comparisons, since a table costs the other kernels up to 0.9 % more instructions.
 */

#include "law/law.h"

/** k1 and k2 are times sqrt(R*); n is 3/2. Threads: pure. Test tests/law/test_law_kinds.c */
static inline bool clod_law_root_radius(const clod_law *law)
{
    return law->kind == CLOD_LAW_HERTZ;
}

/** k2 rises with the largest overlap [m], and that is what a contact remembers, in place of
 *  plastic overlap^n [m^n]. Threads: pure. Test tests/law/test_law_kinds.c */
static inline bool clod_law_rises(const clod_law *law)
{
    return law->kind == CLOD_LAW_LUDING;
}

/** It pulls beside k_adh: at any contact, or by its patch. Threads: pure.
 *  Test tests/law/test_law_kinds.c */
static inline bool clod_law_pulls(const clod_law *law)
{
    return law->kind == CLOD_LAW_EEPA;
}
