#include "mesh/mesh_import.h"

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

/** A file that Assimp has opened: the content in memory. */
typedef struct stream {
    struct aiFile file; ///< first, so that its address is that of the stream
    const char *bytes;
    size_t length, at;
} stream;

/** What Assimp may open. */
typedef struct library {
    const clod_mesh_source *source;
    bool lost; ///< there was no memory for a stream
} library;

/** Assimp's last error is one for the whole program. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static size_t stream_read(struct aiFile *file, char *buffer, size_t size, size_t count)
{
    stream *self = (stream *)file;
    const size_t left = self->length - self->at;
    const size_t items = size == 0 ? 0 : (left / size < count ? left / size : count);
    memcpy(buffer, self->bytes + self->at, items * size);
    self->at += items * size;
    return items;
}

static size_t stream_write(struct aiFile *file, const char *buffer, size_t size, size_t count)
{
    (void)file, (void)buffer, (void)size, (void)count;
    return 0;
}

static size_t stream_tell(struct aiFile *file)
{
    return ((stream *)file)->at;
}

static size_t stream_size(struct aiFile *file)
{
    return ((stream *)file)->length;
}

static enum aiReturn stream_seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    stream *self = (stream *)file;
    const size_t base = origin == aiOrigin_SET   ? 0
                        : origin == aiOrigin_CUR ? self->at
                                                 : self->length;
    if (offset > self->length - base) {
        return aiReturn_FAILURE;
    }
    self->at = base + offset;
    return aiReturn_SUCCESS;
}

static void stream_flush(struct aiFile *file)
{
    (void)file;
}

/** Name under which Assimp finds the content, and nothing else. */
#define NAME "mesh"

static struct aiFile *open_stream(struct aiFileIO *io, const char *name, const char *mode)
{
    library *self = (library *)(void *)io->UserData;
    const clod_mesh_source *source = self->source;
    const bool ours = strncmp(name, NAME ".", sizeof NAME) == 0 &&
                      strcmp(name + sizeof NAME, source->extension) == 0 && mode[0] == 'r';
    if (!ours) {
        return NULL;
    }
    stream *opened = clod_memory_alloc(1, sizeof *opened);
    if (opened == NULL) {
        self->lost = true;
        return NULL;
    }
    *opened = (stream){.file = {.ReadProc = stream_read,
                                .WriteProc = stream_write,
                                .TellProc = stream_tell,
                                .FileSizeProc = stream_size,
                                .SeekProc = stream_seek,
                                .FlushProc = stream_flush},
                       .bytes = source->bytes + source->begin,
                       .length = source->length - source->begin};
    return &opened->file;
}

static void close_stream(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    clod_memory_free(file);
}

static bool fail_vertices(const clod_mesh_source *source, clod_status *status)
{
    return clod_status_fail(status, CLOD_USAGE,
                            "%s: Assimp counts other vertices in this file than clod does, so "
                            "its facets would be wrong: export the mesh as a binary STL",
                            source->path);
}

/** Triangles of a scene, whatever they are; the number of faces with other than three corners. */
static size_t count_triangles(const struct aiScene *scene, size_t *others)
{
    size_t count = 0;
    *others = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh *mesh = scene->mMeshes[m];
        for (unsigned f = 0; f < mesh->mNumFaces; f++) {
            *others += mesh->mFaces[f].mNumIndices != 3;
        }
        count += mesh->mNumFaces;
    }
    return count;
}

/** Whether Assimp counted the vertices as clod did: the last facet has the last vertex. */
static bool check_end(const struct aiScene *scene, const clod_mesh_source *source,
                      clod_status *status)
{
    const struct aiMesh *mesh = scene->mMeshes[scene->mNumMeshes - 1];
    const struct aiVector3D *at =
        &mesh->mVertices[mesh->mFaces[mesh->mNumFaces - 1].mIndices[0]];
    return source->extra == 0 ||
           (at->x == (ai_real)CLOD_MESH_END[0] && at->y == (ai_real)CLOD_MESH_END[1] &&
            at->z == (ai_real)CLOD_MESH_END[2]) ||
           fail_vertices(source, status);
}

static bool check_corner(const clod_mesh_source *source, size_t facet, int corner,
                         const float place[3], clod_status *status)
{
    return (isfinite(place[0]) && isfinite(place[1]) && isfinite(place[2])) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: facet %zu: corner %d is (%g, %g, %g); a coordinate must be "
                            "finite and below 3e38: export the mesh again",
                            source->path, facet + 1, corner + 1, (double)place[0],
                            (double)place[1], (double)place[2]);
}

static bool copy(const struct aiScene *scene, const clod_mesh_source *source,
                 float (*corners)[3][3], clod_status *status)
{
    size_t facet = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh *mesh = scene->mMeshes[m];
        for (unsigned f = 0; f < mesh->mNumFaces && facet < source->facets; f++, facet++) {
            for (int c = 0; c < 3; c++) {
                const struct aiVector3D *at = &mesh->mVertices[mesh->mFaces[f].mIndices[c]];
                float *to = corners[facet][c];
                to[0] = (float)at->x;
                to[1] = (float)at->y;
                to[2] = (float)at->z;
                if (!check_corner(source, facet, c, to, status)) {
                    return false;
                }
            }
        }
    }
    return true;
}

static bool take(const struct aiScene *scene, const clod_mesh_source *source,
                 float (**corners)[3][3], clod_status *status)
{
    size_t others = 0;
    const size_t all = count_triangles(scene, &others);
    const size_t found = all - (all < source->extra ? all : source->extra);
    if (found != source->facets || others > 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the polygons of the file should make %zu triangles, but "
                                "%zu came out of them; one has no area or crosses itself: "
                                "export triangles",
                                source->path, source->facets, found - others);
    }
    if (!check_end(scene, source, status)) {
        return false;
    }
    *corners = clod_memory_alloc(found, sizeof **corners);
    if (*corners == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s: no memory for %zu facets",
                                source->path, found);
    }
    if (!copy(scene, source, *corners, status)) {
        clod_memory_free(*corners);
        *corners = NULL;
        return false;
    }
    return true;
}

/** Why Assimp gave nothing. */
static void fail(const library *from, const char *reason, clod_status *status)
{
    const bool memory = from->lost || reason == NULL || reason[0] == '\0' ||
                        strstr(reason, "bad_alloc") != NULL;
    if (memory) {
        clod_status_fail(status, CLOD_FAILED, "%s: no memory to read it", from->source->path);
    } else if (strstr(reason, "vertex index out of range") != NULL) {
        fail_vertices(from->source, status);
    } else {
        clod_status_fail(status, CLOD_USAGE,
                         "%s: Assimp cannot read it: %s; export the mesh as a binary STL",
                         from->source->path, reason);
    }
}

bool clod_mesh_import(const clod_mesh_source *source, float (**corners)[3][3],
                      clod_status *status)
{
    library from = {.source = source};
    struct aiFileIO io = {open_stream, close_stream, (aiUserData)(void *)&from};
    char name[16];
    *corners = NULL;
    snprintf(name, sizeof name, NAME ".%s", source->extension);
    pthread_mutex_lock(&lock);
    const struct aiScene *scene = aiImportFileEx(name, aiProcess_Triangulate, &io);
    if (scene == NULL) {
        fail(&from, aiGetErrorString(), status);
    }
    pthread_mutex_unlock(&lock);
    if (scene == NULL) {
        return false;
    }
    const bool done = take(scene, source, corners, status);
    aiReleaseImport(scene);
    return done;
}
