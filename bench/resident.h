#pragma once
/**
 * @file resident.h
 * The most memory that this process has had in the machine.
 */

/** So far, or since it was forgotten [kB]; -1: the system does not tell. getrusage would count the
 *  caller's before exec. */
long bench_resident_most(void);

/** Let the most be that of now; where the system cannot, it stays that so far. */
void bench_resident_forget(void);
