/**
 * @file mimo/log.h
 * Logging. The library never writes to stdout or stderr; it writes only the files that a call names.
 */
#ifndef MIMO_LOG_H
#define MIMO_LOG_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_LOG_WARNING 1 /**< Something is probably not as the user intended. */
#define MIMO_LOG_INFO 2    /**< Useful to know, told once. */

/** A message, valid until the function that receives it returns. */
typedef struct mimo_log_record {
  uint32_t struct_size; /**< Size in the library. 256 bytes are readable, zero beyond it. */
  int32_t level;        /**< MIMO_LOG_WARNING or MIMO_LOG_INFO. */
  int32_t code;         /**< A MIMO_WARNING_ constant for a warning of the physics, else 0. */
  uint32_t in_world;    /**< 1: a world's physics warns; 0: the message comes from a scene, a model or a renderer. */
  const char *text;     /**< One line, UTF-8. */
  size_t world;         /**< Number of the world in its batch; 0 for a single one. */
  double time;          /**< Simulated seconds since the world's reset; 0 where in_world is 0. */
} mimo_log_record;

/**
 * Receives messages; NULL in a config turns them off. The library calls it on the thread of the caller, before the
 * call returns. Meanwhile the handle of that call can only be read (everything else returns MIMO_E_BUSY); any other
 * handle may be used. It must not throw or longjmp.
 */
typedef void (*mimo_log_fn)(void *user, const mimo_log_record *record);

#ifdef __cplusplus
}
#endif

#endif
