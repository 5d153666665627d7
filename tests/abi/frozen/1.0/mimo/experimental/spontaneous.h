/**
 * @file mimo/experimental/spontaneous.h
 * Spontaneous movements: how infants move before they want anything. Commands for the motors that a program may send in
 * place of random numbers, or add to its own.
 */
#ifndef MIMO_EXPERIMENTAL_SPONTANEOUS_H
#define MIMO_EXPERIMENTAL_SPONTANEOUS_H

#include "../batch.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Kinds of spontaneous movements. How strong and how frequent each is follows from the infant's physiological age.
 */
#define MIMO_MOVEMENT_GENERAL 1u      /**< General movements: all limbs and the trunk, in turns; slow, they wax and wane. */
#define MIMO_MOVEMENT_FIDGETS 2u      /**< Small movements of all joints all the time, between 6 weeks and 5 1/2 months. */
#define MIMO_MOVEMENT_KICKS 4u        /**< Kicks: hip, knee and ankle bend and stretch together. */
#define MIMO_MOVEMENT_STARTLES 8u     /**< Startles: arms and legs fly apart, up to the fourth month. */
#define MIMO_MOVEMENT_TWITCHES 16u    /**< Short twitches of single joints. */
#define MIMO_MOVEMENT_ALL 0x80000000u /**< All kinds of the loaded library. */

/**
 * What the motors of an agent do by themselves at this moment of its episode: actions for the next step. They depend on
 * the seed of the episode, its time, the agent's age and the names of its motors only: the same episode has the same
 * movements, whatever a program does with them. Eyes rest.
 * @param which   MIMO_MOVEMENT_ bits; 0: nothing moves.
 * @param actions receives as many numbers as the agent has actions (mimo_agent_info.action_count), within their bounds.
 * @param count   length of actions.
 * Errors: MIMO_E_UNSUPPORTED for an agent that is no infant, or is not moved by torques; MIMO_E_BUFFER_TOO_SMALL.
 */
MIMO_API mimo_status mimo_env_spontaneous(const mimo_env *env, size_t agent, uint32_t which, float *actions,
                                          size_t count) MIMO_NOEXCEPT;

/**
 * The same for all agents of all worlds: actions as mimo_batch_step takes them.
 * @param which   MIMO_MOVEMENT_ bits; 0: nothing moves.
 * @param actions receives the actions of each world, one world after the other.
 * @param count length of actions: worlds times actions of a world.
 */
MIMO_API mimo_status mimo_batch_spontaneous(const mimo_batch *batch, uint32_t which, float *actions,
                                            size_t count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
