// A checkpoint that all ranks write: slab s of the final order goes to rank s modulo their number, which puts
// its columns at their places in the file; blocks are hashed likewise.
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include "base/assert.h"
#include "base/memory.h"
#include "output/checkpoint_rows.h"
#include "output/file.h"
#include "parallel/ranks_collect.h"
#include "step/crew_part.h"
#include "step/crew_shares.h"

/** Contacts that are packed at a time. */
#define SOME 16384

/** The writing of one rank. */
typedef struct writing {
    clod_crew *crew;
    const clod_bed_layout *layout;
    int descriptor;
    clod_contact *contacts;  ///< [SOME] owned, as the next two
    uint64_t (*partners)[2]; ///< [SOME]
    uint64_t *counts;        ///< [ranks]
    clod_bytes *packed;      ///< scratch; borrowed
} writing;

/** File systems whose nodes see each other's bytes at once, and those of one machine. Others, NFS for one, keep
 *  pages: a node may write what it has of a page over what another one has written there. */
static const uint64_t COHERENT[] = {
    0xEF53,     // ext4
    0x58465342, // XFS
    0x9123683E, // Btrfs
    0x2FC12FC1, // ZFS
    0xF2F52010, // F2FS
    0x01021994, // tmpfs
    0x794C7630, // overlay
    0x0BD00BD0, // Lustre
    0x47504653, // GPFS
    0x19830326, // BeeGFS
    0x00C36400, // CephFS
};

static bool is_coherent(int descriptor)
{
    struct statfs info;
    bool found = false;
    if (fstatfs(descriptor, &info) == 0) {
        for (size_t k = 0; k < sizeof COHERENT / sizeof *COHERENT; k++) {
            found = found || ((uint64_t)info.f_type & 0xFFFFFFFF) == COHERENT[k];
        }
    }
    return found;
}

/** Whether an open file is the one that rank 0 means. */
static bool is_same(int descriptor, const clod_bed_file *file)
{
    struct stat info;
    char head[CLOD_BED_HEAD];
    return fstat(descriptor, &info) == 0 && (uint64_t)info.st_ino == file->number &&
           (uint64_t)info.st_size == file->size &&
           clod_file_read_at(descriptor, 0, head, sizeof head) == 0 &&
           memcmp(head, file->head, sizeof head) == 0;
}

/** Open the file that rank 0 means; -1: it is not there, another one, or not to be written side by side. */
static int open_same(const clod_bed_file *file, int flags)
{
    const int descriptor = clod_file_open(AT_FDCWD, file->path, flags | O_NOFOLLOW);
    if (descriptor >= 0 && !(is_coherent(descriptor) && is_same(descriptor, file))) {
        clod_file_close(descriptor); // nothing was written
        return -1;
    }
    return descriptor;
}

static bool fail(const writing *self, int error, clod_status *status)
{
    char folder[CLOD_BED_PATH];
    memcpy(folder, self->layout->file.folder, sizeof folder);
    const clod_folder named = {.path = folder}; // as messages have it
    return clod_folder_fail(&named, "write", self->layout->file.name, error, status);
}

static bool writing_init(writing *self, clod_crew *crew, const clod_bed_layout *layout,
                         int descriptor, clod_bytes *packed, clod_status *status)
{
    *self = (writing){crew,
                      layout,
                      descriptor,
                      clod_memory_alloc(SOME, sizeof *self->contacts),
                      clod_memory_alloc(SOME, sizeof *self->partners),
                      clod_memory_alloc((size_t)crew->ranks->size, sizeof *self->counts),
                      packed};
    const bool good =
        (self->contacts != NULL && self->partners != NULL && self->counts != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "No memory to write a checkpoint.");
    return clod_ranks_agree(crew->ranks, good, status);
}

static void writing_fini(writing *self)
{
    clod_memory_free(self->contacts);
    clod_memory_free(self->partners);
    clod_memory_free(self->counts);
}

/** Grains of the group of slabs from number `first` on, or their contacts, to the ranks whose they are. */
static bool hand_over(const writing *self, uint64_t first, int64_t what, clod_status *status)
{
    clod_crew *crew = self->crew;
    clod_crew_slabs *slabs = &crew->slabs;
    const uint64_t group = (uint64_t)crew->ranks->size * CLOD_CREW_SLAB;
    const clod_crew_range range = {first, group, what};
    clod_crew_shares all;
    bool good = clod_crew_shares_init(&all, crew->ranks, status);
    if (good) {
        slabs->range = range;
        clod_crew_slabs_pack(crew, &range, all.out);
        good = clod_ranks_swap(crew->ranks, all.out, &slabs->in, all.begin, status);
    }
    clod_crew_shares_fini(&all, crew->ranks);
    return good;
}

// ---- grains

/** Write the slab of this rank from what has come. */
static bool write_slab(const writing *self, uint64_t first, clod_status *status)
{
    clod_crew *crew = self->crew;
    const uint64_t total = self->layout->all.grains;
    const uint64_t left = first < total ? total - first : 0;
    const size_t count = left < CLOD_CREW_SLAB ? (size_t)left : CLOD_CREW_SLAB;
    if (!clod_crew_slabs_room(crew, count, status)) {
        return false;
    }
    crew->slabs.rows.grains.count = count;
    if (!clod_crew_slabs_take(&crew->slabs, first)) {
        return clod_status_fail(status, CLOD_FAILED,
                                "the ranks sent other grains than those from number %llu on",
                                (unsigned long long)first);
    }
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_grains(&columns, &crew->slabs.rows);
    if (count > 0 && columns.count != self->layout->grain_columns) {
        return clod_status_fail(status, CLOD_FAILED, "a rank has other columns of grains");
    }
    const int error = count == 0
                          ? 0
                          : clod_checkpoint_rows_put(self->descriptor, &columns,
                                                     self->layout->grain, first, self->packed);
    return error == 0 || fail(self, error, status);
}

static bool write_grains(const writing *self, clod_status *status)
{
    clod_ranks *ranks = self->crew->ranks;
    const uint64_t size = (uint64_t)ranks->size, rank = (uint64_t)ranks->rank;
    bool good = true;
    for (uint64_t first = 0; good && first < self->layout->all.grains;
         first += size * CLOD_CREW_SLAB) {
        good = hand_over(self, first, 0, status);
        if (good) {
            const bool mine = write_slab(self, first + rank * CLOD_CREW_SLAB, status);
            good = clod_ranks_agree(ranks, mine, status);
        }
    }
    return good;
}

// ---- contacts

/** Write the contacts that have come as rows from `first` on. */
static bool write_rows(const writing *self, uint64_t first, clod_status *status)
{
    const clod_crew_slabs *slabs = &self->crew->slabs;
    clod_checkpoint_columns columns;
    int error = 0;
    for (size_t k = 0, count; error == 0 && k < slabs->items; k += count) {
        count = slabs->items - k < SOME ? slabs->items - k : SOME;
        for (size_t c = 0; c < count; c++) {
            clod_crew_slabs_contact(slabs, k + c, &self->contacts[c], self->partners[c]);
        }
        clod_checkpoint_columns_of_contacts(&columns, self->contacts,
                                            (const uint64_t(*)[2])self->partners, count);
        CLOD_ASSERT(columns.count == self->layout->contact_columns); // one table for all
        error = clod_checkpoint_rows_put(self->descriptor, &columns, self->layout->contact,
                                         first + k, self->packed);
    }
    return error == 0 || fail(self, error, status);
}

static uint64_t contacts_of(const clod_bed_layout *layout)
{
    return layout->all.pairs + layout->all.walls;
}

static bool fail_to_count(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "the ranks have other contacts than counted");
}

/** Contacts with grains (1) or walls (2), behind `*before` of them that are written. */
static bool write_contacts(const writing *self, int64_t what, uint64_t *before,
                           clod_status *status)
{
    clod_crew *crew = self->crew;
    clod_ranks *ranks = crew->ranks;
    bool good = true;
    for (uint64_t first = 0; good && first < self->layout->all.grains;
         first += (uint64_t)ranks->size * CLOD_CREW_SLAB) {
        good = hand_over(self, first, what, status);
        bool mine = good && clod_crew_slabs_sort(&crew->slabs, status);
        good = good && clod_ranks_agree(ranks, mine, status);
        if (good) {
            const uint64_t count = crew->slabs.items;
            uint64_t own = *before;
            clod_ranks_gather(ranks, &count, sizeof count, self->counts);
            for (int r = 0; r < ranks->size; r++) { // slabs lie in the order of ranks
                own += r < ranks->rank ? self->counts[r] : 0;
                *before += self->counts[r];
            }
            mine = (*before <= contacts_of(self->layout) || fail_to_count(status)) &&
                   write_rows(self, own, status);
            good = clod_ranks_agree(ranks, mine, status);
        }
    }
    crew->slabs.items = crew->slabs.next = 0; // nobody else takes them
    return good;
}

// ---- all

static bool write_all(writing *self, clod_status *status)
{
    uint64_t before = 0;
    bool good = write_grains(self, status) && write_contacts(self, 1, &before, status) &&
                write_contacts(self, 2, &before, status);
    if (good && before != contacts_of(self->layout)) { // all know both
        good = fail_to_count(status);
    }
    if (good) { // to the disk, where other ranks may read it
        const int error = clod_file_sync(self->descriptor);
        const bool mine = error == 0 || fail(self, error, status);
        good = clod_ranks_agree(self->crew->ranks, mine, status);
    }
    return good;
}

bool clod_crew_write(clod_crew *self, clod_bed_layout *layout, bool *done, clod_status *status)
{
    clod_status unused = {0};
    clod_ranks_tell(self->ranks, layout, sizeof *layout);
    const int descriptor = open_same(&layout->file, O_RDWR);
    const bool here = descriptor >= 0 ||
                      clod_status_fail(&unused, CLOD_FAILED, "a rank does not see the file");
    *done = clod_ranks_agree(self->ranks, here, &unused);
    bool good = true;
    if (*done) {
        writing all;
        clod_bytes packed = {0};
        good = writing_init(&all, self, layout, descriptor, &packed, status) &&
               write_all(&all, status);
        writing_fini(&all);
        clod_bytes_fini(&packed);
    }
    const int error = descriptor >= 0 ? clod_file_close(descriptor) : 0;
    if (*done && good) {
        writing named = {.layout = layout};
        const bool mine = error == 0 || fail(&named, error, status);
        good = clod_ranks_agree(self->ranks, mine, status);
    }
    return good;
}

/** Hashes of every block whose number is this rank's modulo their number. */
static bool hash_own(const clod_ranks *ranks, const clod_bed_file *file, int descriptor,
                     clod_bytes *mine)
{
    const uint64_t bytes = file->size - file->start;
    const uint64_t size = (uint64_t)ranks->size;
    bool good = descriptor >= 0;
    for (uint64_t k = (uint64_t)ranks->rank; good && k < clod_file_blocks(bytes); k += size) {
        uint64_t hash = 0;
        good = clod_file_hash_block(descriptor, file->start, bytes, k, &hash) == 0;
        clod_bytes_put(mine, &hash, sizeof hash);
    }
    return good && !mine->lacks_memory;
}

/** Every rank's hashes to their places. */
static void sort_hashes(const clod_ranks *ranks, const clod_bytes *all, const size_t *begin,
                        uint64_t *hash)
{
    const size_t size = (size_t)ranks->size;
    for (size_t r = 0; r < size; r++) {
        for (size_t k = 0; k < (begin[r + 1] - begin[r]) / sizeof *hash; k++) {
            memcpy(&hash[k * size + r], all->data + begin[r] + k * sizeof *hash, sizeof *hash);
        }
    }
}

bool clod_crew_hash(clod_crew *self, clod_bed_file *file, uint64_t *hash)
{
    clod_status unused = {0};
    clod_crew_shares all;
    clod_ranks_tell(self->ranks, file, sizeof *file);
    if (!clod_crew_shares_init(&all, self->ranks, &unused)) {
        clod_crew_shares_fini(&all, self->ranks);
        return false;
    }
    const int descriptor = open_same(file, O_RDONLY);
    const bool mine = hash_own(self->ranks, file, descriptor, &all.out[0]) ||
                      clod_status_fail(&unused, CLOD_FAILED, "a rank cannot read the file");
    const bool good = clod_ranks_agree(self->ranks, mine, &unused) &&
                      clod_crew_shares_collect(&all, self->ranks, &unused);
    if (good && hash != NULL) {
        sort_hashes(self->ranks, &all.in, all.begin, hash);
    }
    if (descriptor >= 0) {
        clod_file_close(descriptor); // nothing was written
    }
    clod_crew_shares_fini(&all, self->ranks);
    return good;
}
