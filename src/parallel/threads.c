#include "parallel/threads.h"

#include <omp.h>

int clod_threads_available(void)
{
    return omp_get_num_procs();
}

void clod_threads_run(int count, int workers, void (*job)(void *context, int number),
                      void *context)
{
    omp_set_max_active_levels(2); // a job may use threads of its own
#pragma omp parallel for schedule(dynamic, 1) num_threads(workers)
    for (int number = 0; number < count; number++) {
        job(context, number);
    }
}
