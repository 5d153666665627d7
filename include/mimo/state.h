/**
 * @file mimo/state.h
 * States: everything that the future of a world depends on, as bytes. A world that loads a state continues exactly as
 * the world that saved it, to the last bit, as long as both receive the same actions.
 *
 * A state consists of sections with names and versions: "physics", "overrides", "random", "episode", one for each
 * agent's task and actuation ("agent/anna/task"), and one for each memory: senses and motors with a delay
 * ("delay/anna/touch/force", "agent/anna/motor delay"), receptors, sounds. Memories may be missing, for example in a
 * state of a world with other senses: they then start fresh. Every later version 1.y with the same MuJoCo reads the
 * states of version 1.x; docs/abi.md has the details, docs/state-format.md the bytes.
 */
#ifndef MIMO_STATE_H
#define MIMO_STATE_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Size of the world's state in bytes. Only a reset to another age changes it. */
MIMO_API mimo_status mimo_env_state_size(const mimo_env *env, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves physics, actuation, task, random numbers, elapsed steps, all values that mimo_env_set can write, and all
 * memories. The bytes may be kept in a file: little-endian machines and later versions read them.
 * @param state receives mimo_env_state_size bytes; needs no alignment.
 * Errors: MIMO_E_SIMULATION for a world that has failed.
 */
MIMO_API mimo_status mimo_env_state_save(const mimo_env *env, void *state, size_t state_bytes) MIMO_NOEXCEPT;

/** Differences between the memories of a state and of the world that loaded it. */
typedef struct mimo_load_report {
  uint32_t struct_size;      /**< sizeof(mimo_load_report), set by the caller. */
  uint32_t reserved;         /**< 0. */
  size_t fresh;              /**< Number of memories that the state lacked, or had with another length or delay: they
                                  start fresh, with the next sensed value, or without an action in transit. */
  size_t ignored;            /**< Number of memories in the state that this world does not have. */
  const char *fresh_names;   /**< Names of their sections, separated by ", "; "" for none. Both strings are owned by the
                                  handle and valid until its next load. */
  const char *ignored_names; /**< The same for the ignored ones. */
} mimo_load_report;

/**
 * Loads a state that was saved from a world of the same model, agents, actuation and task; its senses and delays may
 * differ. Poses and velocities of bodies are then those of the state; contacts, sensors and forces are 0 until the next
 * step or mimo_env_observe. A failed world becomes usable again.
 * @param state_bytes the exact size of the state: mimo_env_state_size of the world that saved it.
 * @param report      receives the memories that started fresh; may be NULL.
 * Errors: MIMO_E_MISMATCH for a state of another model, age, task, actuation or agents; MIMO_E_FILE for one that is
 *         damaged, was cut short, or is no state; MIMO_E_UNSUPPORTED for one of a newer library; the world then stays
 *         as it is.
 */
MIMO_API mimo_status mimo_env_state_load(mimo_env *env, const void *state, size_t state_bytes,
                                         mimo_load_report *report) MIMO_NOEXCEPT;

/**
 * Makes another world of the same scene and config, in the same state. Both share the model.
 * @param clone receives the handle; destroy it with mimo_env_destroy.
 */
MIMO_API mimo_status mimo_env_clone(const mimo_env *env, mimo_env **clone) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
