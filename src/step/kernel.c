// Compiled once per instruction set: CLOD_SIMD_SUFFIX names it, CLOD_SIMD_<SET> selects it.
#include "step/kernel.h"

#include "step/kernel_contact.h"
#include "step/kernel_ledger.h"
#include "step/kernel_motion.h"
#include "step/kernel_search.h"
#include "step/kernel_wall.h"

#define KERNEL_NAME_OF(suffix) clod_kernel_##suffix
#define KERNEL_NAME(suffix) KERNEL_NAME_OF(suffix)
#define KERNEL_TEXT_OF(suffix) #suffix
#define KERNEL_TEXT(suffix) KERNEL_TEXT_OF(suffix)

extern const clod_kernel KERNEL_NAME(CLOD_SIMD_SUFFIX);
const clod_kernel KERNEL_NAME(CLOD_SIMD_SUFFIX) = {
    .name = KERNEL_TEXT(CLOD_SIMD_SUFFIX),
    .width = CLOD_WIDTH,
    .contact = kernel_contact,
    .wall = kernel_wall,
    .contact_dissipate = kernel_contact_dissipate,
    .wall_dissipate = kernel_wall_dissipate,
    .contact_stored = kernel_contact_stored,
    .wall_stored = kernel_wall_stored,
    .drift = kernel_drift,
    .within = kernel_within,
    .can_touch = kernel_can_touch,
    .kick = kernel_kick,
};
