/**
 * @file mimo/observation.h
 * What observations and actions consist of. An observation is one block of bytes that holds all fields.
 */
#ifndef MIMO_OBSERVATION_H
#define MIMO_OBSERVATION_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_U8 1  /**< uint8_t */
#define MIMO_I32 2 /**< int32_t */
#define MIMO_F32 3 /**< float */
#define MIMO_F64 4 /**< double */

#define MIMO_AT_END 1        /**< Belongs to the end of the step. */
#define MIMO_AT_LAST_START 2 /**< Belongs to the start of the last physics step, one time step before the end. */

/** One field of the observation block. */
typedef struct mimo_field {
  uint32_t struct_size; /**< sizeof(mimo_field), set by the caller. */
  int32_t dtype;        /**< MIMO_U8, MIMO_I32, MIMO_F32 or MIMO_F64. */
  const char *name;     /**< Path, "proprioception/position", "vision/eye_left". Owned by the environment. */
  const char *unit;     /**< "rad", "m/s^2", "" for none. Owned by the environment. */
  const char *frame;    /**< Frame of reference: "joint", "site", "camera", "" for none. Owned by the environment. */
  size_t offset;        /**< Bytes from the start of the block, a multiple of 64. */
  size_t bytes;         /**< Length. */
  size_t shape[4];      /**< C order; the first ndim entries count, the others are 0. */
  uint32_t ndim;        /**< 1 to 4. */
  int32_t time;         /**< MIMO_AT_END or MIMO_AT_LAST_START. */
  double low;           /**< Smallest possible value; -infinity where there is none. */
  double high;          /**< Largest possible value; infinity where there is none. */
} mimo_field;

/**
 * Size of an observation block.
 * @param bytes  receives the block's size, a multiple of 64; may be NULL. The block should be 64-byte aligned.
 * @param fields receives the number of fields; may be NULL.
 */
MIMO_API mimo_status mimo_env_observation_size(const mimo_env *env, size_t *bytes, size_t *fields) MIMO_NOEXCEPT;

/** Describes the index-th field. Set field->struct_size first. */
MIMO_API mimo_status mimo_env_observation_field(const mimo_env *env, size_t index, mimo_field *field) MIMO_NOEXCEPT;

/**
 * What one element of a field is: the joint, sensor or actuator it belongs to, "robot:left_elbow".
 * @param element position in the flattened field; pictures and touch have no labels.
 * @param label   receives a string owned by the environment.
 */
MIMO_API mimo_status mimo_env_observation_label(const mimo_env *env, size_t index, size_t element,
                                                const char **label) MIMO_NOEXCEPT;

/** Number of actions of all agents together. */
MIMO_API mimo_status mimo_env_action_size(const mimo_env *env, size_t *count) MIMO_NOEXCEPT;

/**
 * Bounds of the actions. An action is the control input of one motor, as a share of its largest torque; under position
 * control it is an angle; with normalize_actions all bounds are -1 and 1.
 * @param low, high arrays of count elements; either may be NULL.
 */
MIMO_API mimo_status mimo_env_action_bounds(const mimo_env *env, float *low, float *high,
                                            size_t count) MIMO_NOEXCEPT;

/** Name of the index-th action, its actuator's: "act:left_elbow". The string is owned by the environment. */
MIMO_API mimo_status mimo_env_action_name(const mimo_env *env, size_t index, const char **name) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
