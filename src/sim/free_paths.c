#include "sim/free_paths.h"

#include <stdio.h>
#include <string.h>

bool clod_free_paths_pick(const char *list, const char *before, size_t *k, clod_free_path *path)
{
    for (const char *word = list; *word != '\0'; (*k)--) {
        const size_t length = strcspn(word, " ");
        if (*k == 0) {
            snprintf(path->text, sizeof path->text, "%s%s%.*s", before != NULL ? before : "",
                     before != NULL ? "." : "", (int)length, word);
            return true;
        }
        word += length + (word[length] == ' ' ? 1 : 0);
    }
    return false;
}
