/**
 * @file mimo/task.h
 * Tasks: the built-in ones, their parameters, and custom ones, whose functions run inside reset and step.
 */
#ifndef MIMO_TASK_H
#define MIMO_TASK_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Name of the index-th task ("none", "reach", ...), or NULL past the last. Static string. */
MIMO_API const char *mimo_task_name(size_t index) MIMO_NOEXCEPT;

/** A parameter of a task. */
typedef struct mimo_parameter {
  uint32_t struct_size;    /**< sizeof(mimo_parameter), set by the caller. */
  uint32_t reserved;       /**< 0. */
  const char *name;        /**< "reach/success_reward". Static. */
  const char *description; /**< One line, with the unit. Static. */
  double standard;         /**< Default value. */
  double low;              /**< Smallest allowed value. */
  double high;             /**< Largest allowed value. A range from 0 to 1 may be a switch; the description says so. */
} mimo_parameter;

/** Number of parameters of all tasks together. */
MIMO_API mimo_status mimo_parameter_count(size_t *count) MIMO_NOEXCEPT;

/** Describes the index-th parameter. Set parameter->struct_size first. */
MIMO_API mimo_status mimo_parameter_describe(size_t index, mimo_parameter *parameter) MIMO_NOEXCEPT;

/**
 * Sets a parameter of a task, or of a sense of your own, for environments made from now on.
 * Errors: MIMO_E_NOT_FOUND; MIMO_E_INVALID_ARGUMENT out of range.
 */
MIMO_API mimo_status mimo_scene_set_parameter(mimo_scene *scene, const char *name, double value) MIMO_NOEXCEPT;

/** Returns the value of a parameter in this scene. */
MIMO_API mimo_status mimo_scene_get_parameter(const mimo_scene *scene, const char *name, double *value) MIMO_NOEXCEPT;

/** The context of a call of a task's function. Valid until the function returns. */
typedef struct mimo_task_moment {
  uint32_t struct_size; /**< Size in the library. 256 bytes are readable, zero beyond it. */
  uint32_t reserved;    /**< 0. */
  size_t world;         /**< Number of the world in its batch; 0 for a single environment. */
  size_t agent;         /**< Number of the agent. */
  uint64_t step;        /**< Steps since the reset, including this one: 1 after the first; 0 in reset. */
  void *memory;         /**< memory_bytes bytes for this world and agent, 8-byte aligned, zero at the start of an
                             episode; part of the world's state. NULL if memory_bytes is 0. */
  float *fields;        /**< Values of the declared fields, one field after the other, in the order of declaration; part
                             of the world's state. Zero at the start of an episode, then as last left. The values at
                             the function's return are observed. NULL if no fields are declared. */
  const float *action;  /**< The agent's actions of this step, clipped to their bounds. NULL if the step had none, and
                             in reset. */
  size_t action_count;  /**< Length of action; 0 if it is NULL. */
  const void *block;    /**< The observation of this step of all agents, as the caller of the step receives it, except
                             that fields of custom tasks have the values of the step before. NULL if the caller passed
                             no block, and in reset. */
  size_t block_bytes;   /**< Length of block; 0 if it is NULL. */
} mimo_task_moment;

/** A task's evaluation of a step of one agent. All members start as zero. */
typedef struct mimo_task_verdict {
  uint32_t struct_size; /**< Size in the library. 256 bytes are there, zero beyond it; a value set beyond it is
                             MIMO_E_TASK. */
  int32_t outcome;      /**< MIMO_OUTCOME_NONE, _SUCCESS or _FAILURE; the latter two end the episode. */
  double reward;        /**< For a task without terms. With terms it must stay 0: the reward is their sum. */
  double *terms;        /**< One for each of the task's terms. NULL if it declares none. */
  uint32_t goes_on;     /**< 1: success or failure does not end the episode. */
  uint32_t truncated;   /**< 1: the episode is cut off here. */
} mimo_task_verdict;

/**
 * Prepares an episode of one agent in a world at its stored state: named access moves things, mimo_env_random gives the
 * random numbers.
 * @param user as in mimo_task.
 * @param env  the world; all its functions work, except resets, steps and loading a state (MIMO_E_BUSY) and
 *             destruction.
 * @return MIMO_OK, or any MIMO_E_ constant: the reset then returns MIMO_E_TASK, and its message quotes the constant and
 *         the message of mimo_fail or of the failed call.
 *         The function must not end its thread and must not longjmp out. On Linux and macOS, where program and library
 *         share an unwinder, an exception that leaves it fails the reset with MIMO_E_TASK (in a batch, of that world
 *         alone). On other systems no exception may leave it; mimo.hpp catches all on every system.
 */
typedef mimo_status (*mimo_task_reset_fn)(void *user, mimo_env *env, const mimo_task_moment *moment);

/**
 * Evaluates a step of one agent, after the senses. Positions of bodies belong to the start of the last physics step.
 * The function may draw random numbers and write values, for example to place the next goal; this takes effect in the
 * next step. It is called for the agents in their order. If it moves bodies, or calls mimo_env_update or _observe, the
 * next agent's call finds all bodies at their current places. The step fails with MIMO_E_TASK, which names the value,
 * for numbers that are not finite, fields outside their bounds, a reward besides terms, and an unknown outcome. A step
 * that fails by its task has happened.
 * @param env as in mimo_task_reset_fn.
 * @return    as in mimo_task_reset_fn, for the step.
 */
typedef mimo_status (*mimo_task_evaluate_fn)(void *user, mimo_env *env, const mimo_task_moment *moment,
                                             mimo_task_verdict *verdict);

/**
 * A field of the observation that a custom task fills, of type MIMO_F32: for example a goal and the progress towards
 * it. Each agent has its own, with its prefix ("anna/goal"). Limits of senses do not apply to it.
 */
typedef struct mimo_task_field {
  uint32_t struct_size; /**< sizeof(mimo_task_field), set by mimo_task_field_init. */
  uint32_t ndim;        /**< Length of shape, up to 4. 0: the field is one number. */
  const char *name;     /**< "goal", "task/goal"; unique among the agent's fields. */
  const char *unit;     /**< "m"; NULL: none. */
  const char *frame;    /**< Frame of reference: "world"; NULL: none. */
  const size_t *shape;  /**< ndim sizes, each at least 1, the last one changes fastest. */
  double low;           /**< Smallest allowed value. Default -infinity. */
  double high;          /**< Largest allowed value. Default infinity. */
} mimo_task_field;

/**
 * Fills a field with defaults: one number without bounds and without a name.
 * @param size sizeof(mimo_task_field) as the caller knows it.
 */
MIMO_API mimo_status mimo_task_field_init(mimo_task_field *field, size_t size) MIMO_NOEXCEPT;

/** A custom task. The worlds of a batch call its functions at the same time on several threads and share `user`. */
typedef struct mimo_task {
  uint32_t struct_size;           /**< sizeof(mimo_task), set by mimo_task_init. */
  uint32_t reserved;              /**< 0. */
  void *user;                     /**< Passed to the functions; must outlive all worlds with this task. */
  size_t memory_bytes;            /**< Memory per world and agent, up to 1048576; all fields together have the same
                                       limit. */
  mimo_task_reset_fn reset;       /**< May be NULL. */
  mimo_task_evaluate_fn evaluate; /**< Required. */
  const char *const *terms;       /**< Names of the terms whose sum is the reward (mimo_layout_term).
                                       NULL: a single term "reward". */
  size_t term_count;              /**< Length of terms, up to 1000. */
  const mimo_task_field *fields;  /**< Further fields of the observation, each of the size that it says. NULL: none. */
  size_t field_count;             /**< Length of fields, up to 1000. */
} mimo_task;

/**
 * Fills a task with defaults: no functions, no memory, no terms, no fields.
 * @param size sizeof(mimo_task) as the caller knows it.
 */
MIMO_API mimo_status mimo_task_init(mimo_task *task, size_t size) MIMO_NOEXCEPT;

/**
 * Sets a custom task, named "custom", for all worlds made from now on, in place of the scene's. NULL removes it. A task
 * named by mimo_env_config has priority. Terms and fields are copied.
 * Errors: MIMO_E_INVALID_ARGUMENT for an invalid term or field; a field with the name of another field of the agent is
 * refused when worlds are made.
 */
MIMO_API mimo_status mimo_scene_set_task(mimo_scene *scene, const mimo_task *task) MIMO_NOEXCEPT;

/** Draws numbers from 0 (inclusive) to 1 (exclusive) from the world's random stream. */
MIMO_API mimo_status mimo_env_random(mimo_env *env, double *values, size_t count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
