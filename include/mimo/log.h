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

/* What physics warns of; also the ids of MIMO_WARNING_COUNT. */
#define MIMO_WARNING_CONTACTS_DROPPED 1    /**< More contacts than the model's nconmax: some are missing. */
#define MIMO_WARNING_CONSTRAINTS_DROPPED 2 /**< More constraints than the model's njmax: some are missing. */
#define MIMO_WARNING_BAD_POSITION 3        /**< A position that is no number, or huge: the world has failed. */
#define MIMO_WARNING_BAD_VELOCITY 4        /**< The same of a velocity. */
#define MIMO_WARNING_BAD_ACCELERATION 5    /**< The same of an acceleration. */
#define MIMO_WARNING_BAD_CONTROL 6         /**< A control that is no number, or huge: the step took all as 0. */
#define MIMO_WARNING_INERTIA 7             /**< The inertia matrix is nearly singular. */
#define MIMO_WARNING_NOT_CONVERGED 8       /**< The solver stopped at its last iteration; counted, not told. */

/** A message. It lasts until the function that receives it returns. */
typedef struct mimo_log_record {
  uint32_t struct_size; /**< Of the library's struct. 256 bytes are there, zero beyond it. */
  int32_t level;        /**< MIMO_LOG_WARNING or MIMO_LOG_INFO. */
  int32_t code;         /**< What it is about: a MIMO_WARNING_ constant where physics warns, else 0. */
  uint32_t in_world;    /**< 1: a world's physics warns; 0: a scene, a model or a renderer has something to say. */
  const char *text;     /**< One line, UTF-8. */
  size_t world;         /**< Number of the world in its batch; 0 for a single one. */
  double time;          /**< Simulated seconds since the world's reset; 0 where in_world is 0. */
} mimo_log_record;

/**
 * Receives messages; NULL in a config means silence. Called on the thread that called the library, before
 * that call returns. The handle of that call can only be read meanwhile, the rest answers MIMO_E_BUSY; any other handle
 * may be used. Must not throw or longjmp.
 */
typedef void (*mimo_log_fn)(void *user, const mimo_log_record *record);

#ifdef __cplusplus
}
#endif

#endif
