#pragma once
/**
 * @file news.h
 * Something that a run says as soon as it happens: to the user, and in log.jsonl.
 */

#include <jansson.h>

typedef struct clod_news {
    const char *event; ///< name in the log
    json_t *fields;    ///< owned by who is told; without the time on the clock
    char text[256];    ///< a sentence for the user
} clod_news;
