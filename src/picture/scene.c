#include "picture/scene.h"

#include "base/memory.h"

void clod_scene_fini(clod_scene *self)
{
    clod_memory_free(self->center);
    clod_memory_free(self->radius);
    clod_memory_free(self->shade);
    clod_memory_free(self->corner);
    clod_memory_free(self->normal);
    clod_memory_free(self->paint);
    clod_memory_free(self->wall);
    clod_memory_free(self->part);
    clod_memory_free(self->veiled);
    clod_memory_free(self->end);
    clod_memory_free(self->mark);
    clod_memory_free(self->ink);
    *self = (clod_scene){0};
}
