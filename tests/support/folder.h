/* A folder of its own for what a test in C writes. Define _POSIX_C_SOURCE as 200809L before all headers. */
#ifndef MIMO_TESTS_SUPPORT_FOLDER_H
#define MIMO_TESTS_SUPPORT_FOLDER_H

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/* Makes a folder and goes there. The name ends with XXXXXX, which is replaced. Returns whether it did. */
#ifdef _WIN32
static inline int enter_folder(char* name) { return mktemp(name) != NULL && mkdir(name) == 0 && chdir(name) == 0; }
#else
static inline int enter_folder(char* name) { return mkdtemp(name) != NULL && chdir(name) == 0; }
#endif

#endif
