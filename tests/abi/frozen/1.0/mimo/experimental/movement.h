/**
 * @file mimo/experimental/movement.h
 * Steps of movements that are known, from video or motion capture.
 */
#ifndef MIMO_EXPERIMENTAL_MOVEMENT_H
#define MIMO_EXPERIMENTAL_MOVEMENT_H

#include "../env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The joint positions of one step of a known movement. */
typedef struct mimo_movement {
  uint32_t struct_size;    /**< sizeof(mimo_movement), set by the caller. */
  uint32_t reserved;       /**< 0. */
  const double *positions; /**< frame_skip x the positions of all joints, in the order of MIMO_JOINT_POSITION, at the
                                end of each physics step. Quaternions are normalised. */
  size_t position_count;   /**< Length of positions. */
  double *forces;          /**< Receives frame_skip x one force per degree of freedom, N or Nm; or NULL. */
  size_t force_count;      /**< Length of forces. */
} mimo_movement;

/**
 * Simulates one step of a known movement, from video or motion capture: joints take the given positions, whatever is in
 * their way, and all senses respond as if they had moved there. Velocities and accelerations follow from the positions
 * as in a step of physics: the velocity at the end is the difference over a physics step. So set MIMO_JOINT_POSITION
 * and MIMO_JOINT_VELOCITY before the first step of a movement. Contacts yield and are felt according to these
 * accelerations. Motors keep their controls, without effect on the movement; no task is evaluated, no reflex acts, and
 * no delayed action arrives.
 *
 * The forces are the result of inverse dynamics at the start of each physics step: the forces needed in addition to
 * gravity, contacts, and the joints' limits, locks, springs and dampers. For a lying infant they are its muscles'
 * forces; on the first six degrees of freedom, its free joint, they are the residual that contacts do not explain.
 * @param block receives the observation; NULL with block_bytes 0 skips the senses.
 * Errors: MIMO_E_INVALID_ARGUMENT for numbers that are not finite and quaternions of length 0: nothing happens;
 *         MIMO_E_UNSUPPORTED for models with an integrator other than Euler; MIMO_E_SIMULATION as mimo_env_step, also
 *         if positions or the resulting velocities or accelerations exceed 1e10: the block is not written.
 */
MIMO_API mimo_status mimo_env_follow(mimo_env *env, const mimo_movement *movement, void *block,
                                     size_t block_bytes) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
