#pragma once
/**
 * @file app.h
 * The verbs of the command line, one file each. Each takes its own arguments, argv[0] being
 * "clod VERB", and returns the exit status: 0 done, 1 failed, 2 wrong use.
 */

int clod_app_calibrate(int argc, char **argv);
int clod_app_check(int argc, char **argv);
int clod_app_contact(int argc, char **argv);
int clod_app_explain(int argc, char **argv);
int clod_app_hopper(int argc, char **argv);
int clod_app_locus(int argc, char **argv);
int clod_app_mesh(int argc, char **argv);
int clod_app_new(int argc, char **argv);
int clod_app_picture(int argc, char **argv);
int clod_app_report(int argc, char **argv);
int clod_app_compare(int argc, char **argv);
int clod_app_run(int argc, char **argv);
int clod_app_schema(int argc, char **argv);
int clod_app_verify(int argc, char **argv);
