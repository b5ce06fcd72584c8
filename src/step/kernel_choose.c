#include <string.h>

#include "step/kernel.h"

extern const clod_kernel clod_kernel_scalar;

#if defined(__x86_64__)
extern const clod_kernel clod_kernel_avx2;
extern const clod_kernel clod_kernel_avx512;

static bool machine_has(const clod_kernel *kernel)
{
    __builtin_cpu_init();
    if (kernel == &clod_kernel_avx512) {
        return machine_has(&clod_kernel_avx2) && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    }
    if (kernel == &clod_kernel_avx2) {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    }
    return true;
}

static const clod_kernel *const KERNELS[] = {&clod_kernel_avx512, &clod_kernel_avx2,
                                             &clod_kernel_scalar};
#else
static bool machine_has(const clod_kernel *kernel)
{
    return kernel != NULL;
}

#if defined(__aarch64__)
extern const clod_kernel clod_kernel_neon;

static const clod_kernel *const KERNELS[] = {&clod_kernel_neon, &clod_kernel_scalar};
#else
static const clod_kernel *const KERNELS[] = {&clod_kernel_scalar};
#endif
#endif

const clod_kernel *clod_kernel_choose(const char *name)
{
    for (size_t k = 0; k < sizeof KERNELS / sizeof *KERNELS; k++) {
        const bool wanted = name == NULL || strcmp(name, KERNELS[k]->name) == 0;
        if (wanted && machine_has(KERNELS[k])) {
            return KERNELS[k];
        }
    }
    return NULL;
}
