#pragma once
/**
 * @file course.h
 * One grain of 5 mm on one wall, looked at on its way: a point of mass if it does not roll
 * (docs/theory/belts-and-chutes.md).
 */

#include "base/vec3.h"
#include "verify/bench.h"

#define CLOD_VERIFY_COURSE_RADIUS 0.005 ///< m
#define CLOD_VERIFY_COURSE_GRAVITY 9.81 ///< m/s2

/** Keys of a contact: its rolling resistance bears what friction 1 can turn; it rolls freely. */
#define CLOD_VERIFY_COURSE_HELD "rolling: epsd2, rolling_friction: 1"
#define CLOD_VERIFY_COURSE_FREE "rolling: none"

/** What the case of a course has beside the material. */
typedef struct clod_verify_course {
    const char *name;
    const char *law;     ///< with its stiffnesses of 1e5 N/m; NULL: hooke
    const char *rolling; ///< keys of the contact
    double friction;
    const char *shape;  ///< of the wall
    double tilt;        ///< rad, of gravity about y: it points along x and -z
    double place[3];    ///< m, of the centre at the start
    double velocity[3]; ///< m/s
    double spin;        ///< rad/s about y
    double duration;    ///< s
} clod_verify_course;

/** Where the grain is. */
typedef struct clod_verify_sight {
    double time;
    clod_vec3 place, velocity;
    double spin; ///< rad/s about y
} clod_verify_sight;

/** Look at a grain; false: it has been seen for long enough. */
typedef bool (*clod_verify_course_look)(void *context, const clod_verify_sight *now);

/** Run a course from its case file on, with a look every 0.1 ms. Errors: those of a case. */
bool clod_verify_course_run(const clod_verify_bench *bench, const clod_verify_course *self,
                            clod_verify_course_look look, void *context, clod_status *status);

/** How far the grain sinks into the wall under a force [m]. Threads: pure. */
double clod_verify_course_overlap(double force);

/** Mass of the grain [kg]. Threads: pure. */
double clod_verify_course_mass(void);
