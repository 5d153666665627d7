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

/** What a function of a task is told: of whom it is asked, and what happened. It lasts until the function returns. */
typedef struct mimo_task_moment {
  uint32_t struct_size; /**< Of the library's struct. 256 bytes are there, zero beyond it. */
  uint32_t reserved;    /**< 0. */
  size_t world;         /**< Number of the world in its batch; 0 for a single environment. */
  size_t agent;         /**< Number of the agent. */
  uint64_t step;        /**< Steps since the reset, with this one: 1 after the first. 0 in reset. */
  void *memory;         /**< memory_bytes of the task's own for this world and agent, 8-byte aligned, zero at the start
                             of an episode; part of the world's state. NULL where memory_bytes is 0. */
  float *fields;        /**< Values of the declared fields, one field after the other, in the order of declaration; part
                             of the world's state. Zero at the start of an episode, then as last left; what they are
                             when the function returns is observed. NULL where none are declared. */
  const float *action;  /**< The agent's own actions of this step, within their bounds. NULL where the step was given
                             none, and in reset. */
  size_t action_count;  /**< Length of action, 0 where it is NULL. */
  const void *block;    /**< The observation of this step, as the caller of the step gets it, of all agents; the fields
                             of tasks of one's own in it are still those of the step before. NULL where the caller asks
                             for none, and in reset. */
  size_t block_bytes;   /**< Length of block, 0 where it is NULL. */
} mimo_task_moment;

/** What a task says of a step of one agent. All is zero unless set. */
typedef struct mimo_task_verdict {
  uint32_t struct_size; /**< Of the library's struct. 256 bytes are there, zero beyond it: what is set there is
                             MIMO_E_TASK. */
  int32_t outcome;      /**< MIMO_OUTCOME_NONE, _SUCCESS or _FAILURE; the latter two end the episode. */
  double reward;        /**< Of a task without terms. Of one with terms it stays 0: the reward is their sum. */
  double *terms;        /**< One for each of the task's terms. NULL where it declares none. */
  uint32_t goes_on;     /**< 1: success or failure does not end the episode. */
  uint32_t truncated;   /**< 1: the episode is cut off here. */
} mimo_task_verdict;

/**
 * Prepares an episode of one agent, in a world that is at its start: named access moves things, mimo_env_random
 * gives the random numbers.
 * @param user as in mimo_task.
 * @param env  the world; it takes everything but resets, steps and loading a state (MIMO_E_BUSY), and destruction.
 * @return MIMO_OK, or any MIMO_E_ constant: the reset then returns MIMO_E_TASK, whichever it was, and its message
 *         quotes the constant and what mimo_fail or the failed call said.
 *         It must not end its thread nor jump out. An exception that leaves it fails the reset with MIMO_E_TASK, in a
 *         batch only that world's, where program and library share an unwinder: on Linux and macOS. Elsewhere none
 *         may leave it; mimo.hpp catches all on every system.
 */
typedef mimo_status (*mimo_task_reset_fn)(void *user, mimo_env *env, const mimo_task_moment *moment);

/**
 * Judges a step of one agent, after it was sensed. Positions of bodies are those of the start of the last physics step.
 * It may draw random numbers and write, to place the next goal, say: that counts from the next step on. Agents are
 * asked in their order: where one's task moves bodies, or calls mimo_env_update or _observe, the next one's finds all
 * bodies where they are now.
 * Numbers that are not finite, fields beyond their bounds, a reward beside terms: the step fails with MIMO_E_TASK and
 * names them. So does an outcome that is unknown here. A step that fails by its task has happened.
 * @param env as in mimo_task_reset_fn.
 * @return    as there, of the step.
 */
typedef mimo_status (*mimo_task_evaluate_fn)(void *user, mimo_env *env, const mimo_task_moment *moment,
                                             mimo_task_verdict *verdict);

/**
 * A field of the observation that a task of your own fills, of MIMO_F32: a goal, and what has been reached of it.
 * Each agent has one of its own, with its prefix ("anna/goal"). Limits of senses do not concern it.
 */
typedef struct mimo_task_field {
  uint32_t struct_size; /**< sizeof(mimo_task_field), set by mimo_task_field_init. */
  uint32_t ndim;        /**< Length of shape, up to 4. 0: the field is one number. */
  const char *name;     /**< "goal", "task/goal"; no other field of the agent has it. */
  const char *unit;     /**< "m"; NULL: none. */
  const char *frame;    /**< Frame of reference: "world"; NULL: none. */
  const size_t *shape;  /**< ndim sizes, each at least 1, the last one changes fastest. */
  double low;           /**< Smallest allowed value; -infinity unless set. */
  double high;          /**< Largest allowed value; infinity unless set. */
} mimo_task_field;

/**
 * Fills a field with defaults: one number without bounds and name.
 * @param size sizeof(mimo_task_field) as the caller knows it.
 */
MIMO_API mimo_status mimo_task_field_init(mimo_task_field *field, size_t size) MIMO_NOEXCEPT;

/** A task. Worlds of a batch call its functions at the same time, on several threads: `user` is shared. */
typedef struct mimo_task {
  uint32_t struct_size;           /**< sizeof(mimo_task), set by mimo_task_init. */
  uint32_t reserved;              /**< 0. */
  void *user;                     /**< Passed to the functions; outlives all worlds with this task. */
  size_t memory_bytes;            /**< Memory for each world and agent, up to 1048576; likewise all fields together. */
  mimo_task_reset_fn reset;       /**< May be NULL. */
  mimo_task_evaluate_fn evaluate; /**< Needed. */
  const char *const *terms;       /**< Names of the terms that the reward is the sum of (mimo_layout_term).
                                       NULL: it is one number, the term "reward". */
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
 * Gives all worlds made from now on a task of your own, named "custom", in place of the scene's. NULL takes it away.
 * A task that mimo_env_config names comes first. Terms and fields are copied.
 * Errors: MIMO_E_INVALID_ARGUMENT names what is wrong with a term or field; that a field has the name of another one of
 * the agent is found when worlds are made.
 */
MIMO_API mimo_status mimo_scene_set_task(mimo_scene *scene, const mimo_task *task) MIMO_NOEXCEPT;

/** Numbers from 0 (inclusive) to 1 (exclusive) from the world's own random stream. */
MIMO_API mimo_status mimo_env_random(mimo_env *env, double *values, size_t count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
