/**
 * @file mimo/task.h
 * Tasks: those of the library, their parameters, and your own as functions that run inside reset and step.
 */
#ifndef MIMO_TASK_H
#define MIMO_TASK_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Name of the index-th task ("none", "reach", ...), or NULL past the last. Static string. */
MIMO_API const char *mimo_task_name(size_t index) MIMO_NOEXCEPT;

/** A number by which a task can be changed. */
typedef struct mimo_parameter {
  uint32_t struct_size;    /**< sizeof(mimo_parameter), set by the caller. */
  uint32_t reserved;       /**< 0. */
  const char *name;        /**< "reach/success_reward". Static. */
  const char *description; /**< One line; with unit. Static. */
  double standard;         /**< Value unless set. */
  double low;              /**< Smallest allowed value. */
  double high;             /**< Largest allowed value. From 0 to 1 it may be a switch; the description says so. */
} mimo_parameter;

/** Number of parameters of all tasks together. */
MIMO_API mimo_status mimo_parameter_count(size_t *count) MIMO_NOEXCEPT;

/** Describes the index-th parameter. Set parameter->struct_size first. */
MIMO_API mimo_status mimo_parameter_describe(size_t index, mimo_parameter *parameter) MIMO_NOEXCEPT;

/**
 * Sets a parameter for environments made from now on.
 * Errors: MIMO_E_NOT_FOUND; MIMO_E_INVALID_ARGUMENT out of range.
 */
MIMO_API mimo_status mimo_scene_set_parameter(mimo_scene *scene, const char *name, double value) MIMO_NOEXCEPT;

/** The value that a parameter has in this scene. */
MIMO_API mimo_status mimo_scene_get_parameter(const mimo_scene *scene, const char *name, double *value) MIMO_NOEXCEPT;

#define MIMO_OUTCOME_NONE 0     /**< The episode goes on. */
#define MIMO_OUTCOME_SUCCESS 1  /**< The agent's episode has ended well. */
#define MIMO_OUTCOME_FAILURE -1 /**< The agent's episode has ended badly. */

#define MIMO_TASK_MEMORY_LIMIT 1048576 /**< Largest memory_bytes of a task. */

/**
 * Prepares an episode of one agent, in a world that is at its start: named access moves things, mimo_env_random
 * gives the random numbers.
 * @param user   as in mimo_task.
 * @param env    the world; it takes everything but resets, steps, loading a state and destruction.
 * @param world  its number in the batch; 0 for a single environment.
 * @param agent  number of the agent.
 * @param memory memory_bytes of the task's own for this world and agent, 8-byte aligned, zero at first; part of the
 *               world's state.
 * @return MIMO_OK, or a MIMO_E_ constant that the reset then returns; mimo_fail says why. An exception of a C++ program
 *         fails it too, and in a batch only that world. The function must not end its thread nor jump out.
 */
typedef mimo_status (*mimo_task_reset_fn)(void *user, mimo_env *env, size_t world, size_t agent, void *memory);

/**
 * Judges a step of one agent. Positions of bodies are those of the start of the last physics step.
 * @param reward  0 unless set; finite, else the step fails with MIMO_E_INVALID_ARGUMENT.
 * @param outcome MIMO_OUTCOME_NONE unless set.
 */
typedef mimo_status (*mimo_task_evaluate_fn)(void *user, const mimo_env *env, size_t world, size_t agent, void *memory,
                                             double *reward, int32_t *outcome);

/** A task. Worlds of a batch call its functions at the same time, on several threads: `user` is shared. */
typedef struct mimo_task {
  uint32_t struct_size;           /**< sizeof(mimo_task), set by mimo_task_init. */
  uint32_t reserved;              /**< 0. */
  void *user;                     /**< Passed to the functions; outlives all worlds with this task. */
  size_t memory_bytes;            /**< Memory for each world and agent, up to MIMO_TASK_MEMORY_LIMIT. */
  mimo_task_reset_fn reset;       /**< May be NULL. */
  mimo_task_evaluate_fn evaluate; /**< Needed. */
} mimo_task;

/**
 * Fills a task with defaults: no functions, no memory.
 * @param size sizeof(mimo_task) as the caller knows it.
 */
MIMO_API mimo_status mimo_task_init(mimo_task *task, size_t size) MIMO_NOEXCEPT;

/**
 * Gives all worlds made from now on a task of your own, named "custom", in place of the scene's. NULL takes it away.
 * A task that mimo_env_config names comes first.
 */
MIMO_API mimo_status mimo_scene_set_task(mimo_scene *scene, const mimo_task *task) MIMO_NOEXCEPT;

/** Numbers from 0 (inclusive) to 1 (exclusive) from the world's own random stream. */
MIMO_API mimo_status mimo_env_random(mimo_env *env, double *values, size_t count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
