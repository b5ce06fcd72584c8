#include "report/figure_files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder_names.h"

#define PATH 4096
#define MARK 192                      ///< bytes of a mark
#define FIGURE_MOST ((off_t)64 << 20) ///< bytes: a larger file is none of clod's figures

/** Where the figures of a page are. */
typedef struct place {
    char folder[PATH];
    char stem[PATH]; ///< of their names: that of the page, without its ending
} place;

static place place_of(const char *page)
{
    place self;
    const char *slash = strrchr(page, '/');
    const char *name = slash != NULL ? slash + 1 : page;
    const char *dot = strrchr(name, '.');
    const size_t length = dot != NULL ? (size_t)(dot - name) : strlen(name);
    snprintf(self.folder, sizeof self.folder, "%.*s",
             slash != NULL ? (int)(slash + 1 - page) : 2, slash != NULL ? page : "./");
    snprintf(self.stem, sizeof self.stem, "%.*s", (int)length, name);
    return self;
}

/** The line behind a figure: no comment, in which XML allows no "--" as names of figures have. */
static void write_mark(const char *name, const char *svg, size_t size, char mark[MARK])
{
    snprintf(mark, MARK, "<?clod figure %s, crc32 %08" PRIx64 "?>\n", name,
             clod_file_crc32(0, svg, size));
}

/** Whether a whole file is a figure and the mark that it has from clod; `size` bytes from `start` on. */
static bool is_marked(int file, const char *name, size_t size, size_t start)
{
    char mark[MARK];
    char *text = clod_memory_alloc(size + 1, 1);
    bool clods = false;
    if (text != NULL && clod_file_read_at(file, 0, text, size) == 0) {
        write_mark(name, text, start, mark);
        clods = strlen(mark) == size - start && memcmp(text + start, mark, size - start) == 0;
    }
    clod_memory_free(text);
    return clods;
}

/** Whether an open file is a figure of clod's: read whole only when its last line looks like the mark. */
static bool is_figure(int file, const char *name)
{
    struct stat info;
    char end[MARK];
    if (fstat(file, &info) != 0 || !S_ISREG(info.st_mode) || info.st_size < 1 ||
        info.st_size > FIGURE_MOST) {
        return false;
    }
    const size_t size = (size_t)info.st_size, length = size < MARK ? size : MARK;
    if (clod_file_read_at(file, size - length, end, length) != 0) {
        return false;
    }
    size_t start = length - 1;
    while (start > 0 && end[start - 1] != '\n') {
        start--;
    }
    static const char BEGIN[] = "<?clod figure ";
    const bool looks =
        length - start > sizeof BEGIN - 1 && memcmp(end + start, BEGIN, sizeof BEGIN - 1) == 0;
    return looks && is_marked(file, name, size, size - length + start);
}

/**
 * Whether a file is one that clod wrote, and nobody has changed.
 *
 * @param path   of the file
 * @param name   of the figure that it would be
 * @param there  [out] whether there is something of that name, a pipe too
 */
static bool is_clods(const char *path, const char *name, bool *there)
{
    const int file = clod_file_open(AT_FDCWD, path, O_RDONLY | O_NONBLOCK); // no pipe waits
    *there = file >= 0 || errno != ENOENT;
    const bool clods = file >= 0 && is_figure(file, name);
    if (file >= 0) {
        clod_file_close(file); // nothing was written
    }
    return clods;
}

/** Find whether the page is that of a results folder, whose figures have names of their own. */
static bool find_names(const place *self, bool *names, clod_status *status)
{
    char lock[PATH + sizeof CLOD_FOLDER_LOCK];
    snprintf(lock, sizeof lock, "%s%s", self->folder, CLOD_FOLDER_LOCK);
    *names = false;
    return strcmp(self->stem, "report") != 0 || clod_file_is_there(lock, names, status);
}

static void name_file(const place *self, const char *figure, char path[2 * PATH + 192])
{
    snprintf(path, 2 * PATH + 192, "%s%s-%s.svg", self->folder, self->stem, figure);
}

bool clod_figure_files_check(const char *page, const clod_figure_file *files, size_t count,
                             clod_status *status)
{
    const place self = place_of(page);
    bool names;
    if (!find_names(&self, &names, status)) {
        return false;
    }
    for (size_t k = 0; k < count && !names; k++) {
        char path[2 * PATH + 192];
        bool there;
        name_file(&self, files[k].name, path);
        if (!is_clods(path, files[k].name, &there) && there) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s is in the way of a figure of %s, and it is not as clod wrote one; move it, "
                "or give the page another name. Nothing was written",
                path, page);
        }
    }
    return true;
}

static bool write_one(const char *path, const clod_figure_file *file, clod_status *status)
{
    char mark[MARK];
    const size_t size = strlen(file->svg);
    write_mark(file->name, file->svg, size, mark);
    return clod_file_replace(path, file->svg, size, mark, strlen(mark), status);
}

static bool is_among(const clod_figure_file *files, size_t count, const char *name)
{
    bool found = false;
    for (size_t k = 0; k < count; k++) {
        found = found || strcmp(files[k].name, name) == 0;
    }
    return found;
}

/** The figure that a file of the folder would be, by its name alone. */
static bool figure_of(const place *self, const char *file, char name[256])
{
    const size_t stem = strlen(self->stem), length = strlen(file);
    const bool fits = length > stem + sizeof "-.svg" - 1 && length < stem + 256 &&
                      strncmp(file, self->stem, stem) == 0 && file[stem] == '-' &&
                      strcmp(file + length - 4, ".svg") == 0;
    if (fits) {
        snprintf(name, 256, "%.*s", (int)(length - stem - 5), file + stem + 1);
    }
    return fits;
}

/** Remove what an earlier page had and this one has not. */
static bool clear(const char *page, const place *self, const clod_figure_file *files,
                  size_t count, clod_status *status)
{
    DIR *folder = opendir(self->folder);
    if (folder == NULL) {
        return clod_file_fail(status, "open the folder of", page, errno);
    }
    bool good = true;
    for (struct dirent *entry = readdir(folder); good && entry != NULL;
         entry = readdir(folder)) {
        char name[256], path[2 * PATH + 192];
        bool there;
        if (!figure_of(self, entry->d_name, name) || is_among(files, count, name)) {
            continue;
        }
        name_file(self, name, path);
        if (is_clods(path, name, &there) && unlink(path) != 0 && errno != ENOENT) {
            good = clod_file_fail(status, "remove", path, errno);
        }
    }
    closedir(folder);
    return good;
}

bool clod_figure_files_write(const char *page, const clod_figure_file *files, size_t count,
                             clod_status *status)
{
    const place self = place_of(page);
    bool good = true;
    for (size_t k = 0; good && k < count; k++) {
        char path[2 * PATH + 192];
        name_file(&self, files[k].name, path);
        good = write_one(path, &files[k], status);
    }
    return good && clear(page, &self, files, count, status);
}
