#pragma once
/**
 * @file mesh_words.h
 * Words of a text, as the checks of the mesh formats read them.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

/** A word; its length is 0 at the end. */
typedef struct clod_mesh_word {
    char *text;
    size_t length;
} clod_mesh_word;

/** A place in a text. */
typedef struct clod_mesh_cursor {
    char *at, *end;
    size_t line; ///< from 1
} clod_mesh_cursor;

#define CLOD_MESH_WORD_MOST 60 ///< bytes of a word that a message repeats, and of a number

/** Precision with which a message repeats a word. */
static inline int clod_mesh_words_shown(clod_mesh_word word)
{
    return word.length < CLOD_MESH_WORD_MOST ? (int)word.length : CLOD_MESH_WORD_MOST;
}

static inline bool clod_mesh_words_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/** The next word of this line. What separates words becomes blanks, as Assimp knows them. */
static inline clod_mesh_word clod_mesh_words_in_line(clod_mesh_cursor *self)
{
    while (self->at < self->end && clod_mesh_words_blank(*self->at)) {
        *self->at++ = ' ';
    }
    clod_mesh_word word = {self->at, 0};
    while (self->at < self->end && *self->at != '\n' && !clod_mesh_words_blank(*self->at)) {
        self->at++;
    }
    word.length = (size_t)(self->at - word.text);
    return word;
}

/** The next word of this line or one below. */
static inline clod_mesh_word clod_mesh_words_next(clod_mesh_cursor *self)
{
    clod_mesh_word word = clod_mesh_words_in_line(self);
    while (word.length == 0 && self->at < self->end) {
        self->at++; // a line's end
        self->line++;
        word = clod_mesh_words_in_line(self);
    }
    return word;
}

/** What is left of this line, without blanks around it. */
static inline clod_mesh_word clod_mesh_words_rest(clod_mesh_cursor *self)
{
    while (self->at < self->end && clod_mesh_words_blank(*self->at)) {
        self->at++;
    }
    char *stop = memchr(self->at, '\n', (size_t)(self->end - self->at));
    stop = stop != NULL ? stop : self->end;
    clod_mesh_word rest = {self->at, (size_t)(stop - self->at)};
    self->at = stop;
    while (rest.length > 0 && clod_mesh_words_blank(rest.text[rest.length - 1])) {
        rest.length--;
    }
    return rest;
}

/** Whether a word is a keyword, in small letters or large ones. */
static inline bool clod_mesh_words_is(clod_mesh_word word, const char *keyword)
{
    return strlen(keyword) == word.length && strncasecmp(word.text, keyword, word.length) == 0;
}

/** Whether a word is a keyword of a format that knows small letters only. */
static inline bool clod_mesh_words_same(clod_mesh_word word, const char *keyword)
{
    return strlen(keyword) == word.length && memcmp(word.text, keyword, word.length) == 0;
}

/** Digits from `at` on; how many. */
static inline size_t clod_mesh_words_digits(clod_mesh_word word, size_t at)
{
    size_t count = 0;
    while (at + count < word.length && word.text[at + count] >= '0' &&
           word.text[at + count] <= '9') {
        count++;
    }
    return count;
}

/**
 * Whether a word is a decimal number: no nan, no inf, nothing behind it. Assimp reads one with
 * more than 19 digits before its point as 0, so such a one is none.
 */
static inline bool clod_mesh_words_number(clod_mesh_word word)
{
    size_t at = word.length > 0 && (word.text[0] == '-' || word.text[0] == '+') ? 1 : 0;
    const size_t whole = clod_mesh_words_digits(word, at);
    at += whole;
    size_t part = 0;
    if (at < word.length && word.text[at] == '.') {
        part = clod_mesh_words_digits(word, at + 1);
        at += 1 + part;
    }
    if (at < word.length && (word.text[at] == 'e' || word.text[at] == 'E')) {
        at++;
        at += at < word.length && (word.text[at] == '-' || word.text[at] == '+') ? 1 : 0;
        const size_t power = clod_mesh_words_digits(word, at);
        at += power;
        if (power == 0) {
            return false;
        }
    }
    return at == word.length && whole + part > 0 && whole <= 18 &&
           word.length <= CLOD_MESH_WORD_MOST;
}

/** The whole number that a word is; false when it is none, or has more than 18 digits. */
static inline bool clod_mesh_words_whole(clod_mesh_word word, int64_t *value)
{
    const bool negative = word.length > 0 && word.text[0] == '-';
    const size_t sign = negative ? 1 : 0;
    const size_t digits = clod_mesh_words_digits(word, sign);
    if (digits == 0 || digits > 18 || sign + digits != word.length) {
        return false;
    }
    *value = 0;
    for (size_t i = sign; i < word.length; i++) {
        *value = 10 * *value + (word.text[i] - '0');
    }
    *value = negative ? -*value : *value;
    return true;
}
