/**
 * @file mimo/log.h
 * Logging. The library never writes to stdout, stderr or files by itself.
 */
#ifndef MIMO_LOG_H
#define MIMO_LOG_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_LOG_WARNING 1 /**< Something is not as the user probably meant it. */
#define MIMO_LOG_INFO 2    /**< Worth knowing, once. */

/**
 * Receives messages; NULL in a config means silence. Called on the thread that called the library, before
 * that call returns; the message is valid during the callback only. Must not call back into the library with
 * the same handle, nor throw or longjmp.
 */
typedef void (*mimo_log_fn)(void *user, int32_t level, const char *message);

#ifdef __cplusplus
}
#endif

#endif
