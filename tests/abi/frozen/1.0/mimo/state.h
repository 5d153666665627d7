/**
 * @file mimo/state.h
 * State: everything that the future of a world depends on, as bytes. A world that loads a state continues
 * exactly as the one that saved it, to the last bit, for as long as it is given the same actions.
 *
 * A state is made of sections with names and versions: "physics", "overrides", "random", "episode", one for each
 * agent's task and actuation ("agent/anna/task"), and one for everything that is remembered: senses and motors with a
 * delay ("delay/anna/touch/force", "agent/anna/motor delay"). What is remembered may be missing, as in a state of a
 * world that senses differently: it then starts fresh. A state that a library of version 1.x saved is read by all later
 * 1.y.
 */
#ifndef MIMO_STATE_H
#define MIMO_STATE_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Size of the world's state in bytes. It changes only where a reset brings another age. */
MIMO_API mimo_status mimo_env_state_size(const mimo_env *env, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves physics, actuation, task, random numbers, elapsed steps, all that mimo_env_set can write, and what is late.
 * The bytes may be kept in a file: machines that store numbers alike read them, and so do later versions.
 * @param state receives mimo_env_state_size bytes; needs no alignment.
 * Errors: MIMO_E_SIMULATION for a world that has failed.
 */
MIMO_API mimo_status mimo_env_state_save(const mimo_env *env, void *state, size_t state_bytes) MIMO_NOEXCEPT;

/** What a state did not hold of the world that loaded it, and the other way round. */
typedef struct mimo_load_report {
  uint32_t struct_size;      /**< sizeof(mimo_load_report), set by the caller. */
  uint32_t reserved;         /**< 0. */
  size_t fresh;              /**< How many memories the state did not hold, or held of another length or delay: they
                                  start fresh, with the first that is sensed in a step, or no action on its way. */
  size_t ignored;            /**< How many memories of the state this world does not have. */
  const char *fresh_names;   /**< Their sections' names, ", " between them, "" for none. Both strings are owned by the
                                  handle and valid until its next load. */
  const char *ignored_names; /**< Likewise. */
} mimo_load_report;

/**
 * Loads a state that was saved from a world of the same model, agents, actuation and task; its senses may have been
 * others, and others may have been late. Poses and velocities of bodies are then those of the state; contacts, sensors
 * and forces are zero until the next step or mimo_env_observe. Makes a failed world usable again.
 * @param state_bytes the state's own size, no more and no less: mimo_env_state_size of the world that saved it.
 * @param report      receives what started fresh; may be NULL.
 * Errors: MIMO_E_INVALID_ARGUMENT for a state of something else, a damaged one, or one that was cut short,
 *         MIMO_E_UNSUPPORTED for one of a newer library; the world then stays as it is.
 */
MIMO_API mimo_status mimo_env_state_load(mimo_env *env, const void *state, size_t state_bytes,
                                         mimo_load_report *report) MIMO_NOEXCEPT;

/**
 * Makes another world of the same scene and config, in the same state. The model is shared.
 * @param clone receives the handle; destroy it with mimo_env_destroy.
 */
MIMO_API mimo_status mimo_env_clone(const mimo_env *env, mimo_env **clone) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
