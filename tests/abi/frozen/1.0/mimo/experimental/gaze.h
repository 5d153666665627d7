/**
 * @file mimo/experimental/gaze.h
 * The gaze of infants.
 */
#ifndef MIMO_EXPERIMENTAL_GAZE_H
#define MIMO_EXPERIMENTAL_GAZE_H

#include "../env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The gaze of an infant. */
typedef struct mimo_gaze {
  uint32_t struct_size;      /**< sizeof(mimo_gaze), set by the caller. */
  uint32_t meets;            /**< 1: the lines of sight converge in front of the eyes; 0: they diverge. */
  double left_position[3];   /**< Position of the left eye's camera, world, m. */
  double left_direction[3];  /**< Its line of sight, unit vector, world. */
  double right_position[3];  /**< Position of the right eye's camera. */
  double right_direction[3]; /**< Its line of sight. */
  double vergence;           /**< Angle between the lines of sight, rad; negative if they diverge. */
  double point[3];           /**< Their meeting point: the middle of their closest approach, world, m; zero if they
                                  diverge. */
  double miss;               /**< Their distance there, m. */
} mimo_gaze;

/**
 * The gaze of an agent, from the poses of its eyes' cameras that mimo_env_get returns: after a step those at the start
 * of the last physics step, after mimo_env_update the current ones. Set gaze->struct_size first.
 */
MIMO_API mimo_status mimo_env_gaze(const mimo_env *env, size_t agent, mimo_gaze *gaze) MIMO_NOEXCEPT;

#define MIMO_LOOK_EYES 0 /**< Only the eyes turn. They reach 45 degrees to the sides, 33 up and 47 down. */
#define MIMO_LOOK_HEAD 1 /**< The head turns first, the eyes turn the rest. */

/**
 * Computes the joint angles with which an agent looks at a point from the current position of its chest, without moving
 * anything: for position control, for locks, or for mimo_env_set. The torsion of the eyes is 0.
 * @param point    three numbers, metres, world frame.
 * @param how      MIMO_LOOK_EYES or MIMO_LOOK_HEAD.
 * @param joints   receives ids: with MIMO_LOOK_HEAD swivel and tilt of the head; then pan, tilt and torsion of the
 *                 left eye and of the right one. May be NULL.
 * @param angles   receives their angles, rad, clipped to the joints' ranges; may be NULL.
 * @param capacity length of the arrays; 0 if both are NULL, to learn the count.
 * @param count    receives the number of joints; may be NULL.
 * @param errors   receives two angles, rad: by how much the left and the right eye miss the point because of their
 *                 range; may be NULL.
 * Errors: MIMO_E_NOT_FOUND or MIMO_E_UNSUPPORTED for a body without such eyes; MIMO_E_BUFFER_TOO_SMALL.
 */
MIMO_API mimo_status mimo_env_look_angles(mimo_env *env, size_t agent, const double *point, int32_t how,
                                          int32_t *joints, double *angles, size_t capacity, size_t *count,
                                          double *errors) MIMO_NOEXCEPT;

/**
 * Makes an agent look at a point at once: sets its joints as mimo_env_set does. In the next step springs and motors
 * move them again.
 * @param errors as in mimo_env_look_angles.
 */
MIMO_API mimo_status mimo_env_look_at(mimo_env *env, size_t agent, const double *point, int32_t how,
                                      double *errors) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
