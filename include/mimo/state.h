/**
 * @file mimo/state.h
 * State: everything that the future of a world depends on, as bytes. A world that loads a state continues
 * exactly as the one that saved it, to the last bit, for as long as it is given the same actions.
 */
#ifndef MIMO_STATE_H
#define MIMO_STATE_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Size of the world's state in bytes; it does not change. */
MIMO_API mimo_status mimo_env_state_size(const mimo_env *env, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves physics, actuation, task, random numbers, elapsed steps, and all that mimo_env_set can write.
 * The bytes may be kept in a file and are good for this version of the library on this kind of machine.
 * @param state receives mimo_env_state_size bytes; needs no alignment.
 * Errors: MIMO_E_SIMULATION for a world that has failed.
 */
MIMO_API mimo_status mimo_env_state_save(const mimo_env *env, void *state, size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads a state that was saved from a world of the same model, agents, actuation and task; its senses may have been
 * others. Poses and velocities of bodies are then those of the state; contacts, sensors and forces are zero until the
 * next step or mimo_env_observe. Makes a failed world usable again.
 * @param state_bytes the state's own size, no more and no less.
 * Errors: MIMO_E_INVALID_ARGUMENT for a state of something else, a damaged one, or one that was cut short; the world
 *         then stays as it is.
 */
MIMO_API mimo_status mimo_env_state_load(mimo_env *env, const void *state, size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Makes another world of the same scene and config, in the same state. The model is shared.
 * @param clone receives the handle; destroy it with mimo_env_destroy.
 */
MIMO_API mimo_status mimo_env_clone(const mimo_env *env, mimo_env **clone) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
