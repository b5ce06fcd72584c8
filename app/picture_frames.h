#pragma once
/**
 * @file picture_frames.h
 * Pictures drawn by several processes, and ffmpeg that makes a movie of them.
 */

#include "picture/picture.h"

#define CLOD_APP_FRAMES_JOBS 1024

typedef struct clod_app_frames_job {
    const clod_picture_options *options;
    const char *output; ///< file, or folder of frames; NULL: named after the run
    const char *movie;  ///< file; NULL: none
    int jobs;           ///< processes that draw frames, at most CLOD_APP_FRAMES_JOBS
} clod_app_frames_job;

/**
 * Draw the picture or all of them, and the movie.
 *
 * Errors  those of clod_picture_open and clod_picture_draw; CLOD_USAGE: no ffmpeg, which is told
 *         before anything is drawn; CLOD_FAILED: a process or ffmpeg fails.
 * Test    tests/cli/test_picture.py
 */
bool clod_app_frames(const clod_app_frames_job *self, clod_status *status);
