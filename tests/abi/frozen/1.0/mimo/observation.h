/**
 * @file mimo/observation.h
 * The layout of observations, actions and rewards. An observation is one block of bytes that holds all fields.
 */
#ifndef MIMO_OBSERVATION_H
#define MIMO_OBSERVATION_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Describes the observations, actions and rewards of a world, a batch or attached senses: see mimo_env_layout,
 * mimo_batch_layout, mimo_senses_layout. It never changes, except that a reset to another age changes bounds, receptors
 * and times. It belongs to the object that it describes and is refused (MIMO_E_BAD_HANDLE) when that is destroyed.
 * Worlds of a batch share the batch's layout.
 * Any number of threads may read it, also while its owner steps or changes age: each answer belongs to one age. Its
 * strings and shapes are valid as long as the layout.
 */
typedef struct mimo_layout mimo_layout;

/** The sizes of one world, and the length of its steps. */
typedef struct mimo_layout_info {
  uint32_t struct_size; /**< sizeof(mimo_layout_info), set by the caller. */
  uint32_t reserved;    /**< 0. */
  size_t block_bytes;   /**< Size of an observation block, a multiple of 64. Need not be aligned. */
  size_t fields;        /**< Number of fields. */
  size_t actions;       /**< Number of actions of all agents together. */
  size_t agents;        /**< Number of agents, so of rewards, flags and outcomes. */
  size_t terms;         /**< Number of reward terms of all agents together. */
  double step_seconds;  /**< Simulated seconds from one step to the next: of a world frame_skip physics steps, of
                             attached senses `step` of mimo_senses_config. */
} mimo_layout_info;

/** Returns the sizes. Set info->struct_size first. */
MIMO_API mimo_status mimo_layout_describe(const mimo_layout *layout, mimo_layout_info *info) MIMO_NOEXCEPT;

#define MIMO_U8 1  /**< uint8_t */
#define MIMO_I32 2 /**< int32_t */
#define MIMO_F32 3 /**< float */
#define MIMO_F64 4 /**< double */

/**
 * One field of the observation block.
 *
 * Its time: the value that a step gives belongs to the interval from start to end, in seconds relative to the step's
 * end. Both are 0 for a value at the step's end. Both are negative for a delayed value, or one at the start of the last
 * physics step. Start is before end for a value collected over an interval. After a reset, and from mimo_env_observe,
 * values belong to the current time, except delayed ones.
 */
typedef struct mimo_field {
  uint32_t struct_size; /**< sizeof(mimo_field), set by the caller. */
  int32_t dtype;        /**< MIMO_U8, MIMO_I32, MIMO_F32 or MIMO_F64. */
  const char *name;     /**< Path, "proprioception/position", "vision/eye_left". */
  const char *unit;     /**< "rad", "m/s^2", "" for none. */
  const char *frame;    /**< Frame of reference: "joint", "site", "camera", "" for none. */
  size_t offset;        /**< Bytes from the start of the block, a multiple of 64. */
  size_t bytes;         /**< Length. */
  const size_t *shape;  /**< ndim sizes; the last one changes fastest. */
  size_t ndim;          /**< At least 1. */
  double low;           /**< Smallest possible value; -infinity if there is none. */
  double high;          /**< Largest possible value; infinity if there is none. */
  double start;         /**< Seconds after the step's end, <= 0. */
  double end;           /**< Seconds after the step's end, start <= end <= 0. */
  double period;        /**< Seconds between new values: the length of a step. */
  size_t receptors;     /**< Number of skin receptors along its first axis; 0: not a skin field. */
  double sample_rate;   /**< For sound: samples per second, the oldest first, up to `end`; 0: not a sound. */
} mimo_field;

/** Describes the index-th field. Set field->struct_size first. */
MIMO_API mimo_status mimo_layout_field(const mimo_layout *layout, size_t index, mimo_field *field) MIMO_NOEXCEPT;

/** Finds a field by its name. Errors: MIMO_E_NOT_FOUND; the message lists existing names. */
MIMO_API mimo_status mimo_layout_find(const mimo_layout *layout, const char *name, size_t *index) MIMO_NOEXCEPT;

/**
 * Name of one element of a field: its joint, sensor or actuator, "robot:left_elbow".
 * @param field   index of the field.
 * @param element position in the flattened field.
 * @param label   receives a string; "" for pictures and touch.
 */
MIMO_API mimo_status mimo_layout_label(const mimo_layout *layout, size_t field, size_t element,
                                       const char **label) MIMO_NOEXCEPT;

/**
 * Delays of a field's elements in seconds: multiples of the model's time step, 0 for elements sensed at once. A field's
 * start and end cover all its elements. A batch gives the delays of its first world; worlds of another age have other
 * ones.
 * @param field   index of the field.
 * @param seconds receives one number for each element of the flattened field.
 * @param count   length of seconds: the product of the field's shape.
 */
MIMO_API mimo_status mimo_layout_delays(const mimo_layout *layout, size_t field, double *seconds,
                                        size_t count) MIMO_NOEXCEPT;

/**
 * Directions of a picture's pixels, foveated or not: unit vectors from the eye or camera to the middle of each pixel,
 * in the camera's frame: x to the right, y up, z backwards.
 * @param field      index of a picture field: colour, depth or segmentation.
 * @param directions receives height x width x 3 numbers.
 * @param count      length of directions.
 * Errors: MIMO_E_INVALID_ARGUMENT for a field that is not a picture.
 */
MIMO_API mimo_status mimo_layout_directions(const mimo_layout *layout, size_t field, float *directions,
                                            size_t count) MIMO_NOEXCEPT;

#define MIMO_RECEPTOR_BODY 0x2001     /**< 1, id of its body. */
#define MIMO_RECEPTOR_GEOM 0x2002     /**< 1, id of the geom whose surface it is on. */
#define MIMO_RECEPTOR_POSITION 0x2003 /**< 3, m, in the frame of its body. */
/**
 * 9, in the frame of its body: outward normal, first tangent, second tangent. The first tangent is the body's x axis
 * projected on the skin, or its y axis if x is within 10 degrees of the normal; the second is the normal x the first.
 * A receptor that represents a whole small geom lies in its middle, and its normal is the body's x axis.
 */
#define MIMO_RECEPTOR_FRAME 0x2004

/** Number of values of a quantity (MIMO_RECEPTOR_POSITION ...) for all receptors of a field together. */
MIMO_API mimo_status mimo_layout_receptor_width(const mimo_layout *layout, size_t field, mimo_quantity quantity,
                                                size_t *value_count) MIMO_NOEXCEPT;

/**
 * Reads a quantity of all receptors of a field, one after the other.
 * @param value_count length of values, as mimo_layout_receptor_width gives it.
 */
MIMO_API mimo_status mimo_layout_receptors(const mimo_layout *layout, size_t field, mimo_quantity quantity,
                                           double *values, size_t value_count) MIMO_NOEXCEPT;

/** One action: by default a motor's control input as a share of its largest torque; agent.h has the alternatives. */
typedef struct mimo_action {
  uint32_t struct_size; /**< sizeof(mimo_action), set by the caller. */
  uint32_t reserved;    /**< 0. */
  const char *name;     /**< Name of its actuator, "act:left_elbow", or muscle. */
  const char *unit;     /**< "rad" under position control without normalize_actions; "" for none. */
  size_t agent;         /**< Index of its agent. */
  double low;           /**< Smallest value, representable as a float; -infinity if there is none. */
  double high;          /**< Largest value. */
} mimo_action;

/** Describes the index-th action. Set action->struct_size first. */
MIMO_API mimo_status mimo_layout_action(const mimo_layout *layout, size_t index, mimo_action *action) MIMO_NOEXCEPT;

/** A part of an agent's reward; the reward is their sum. */
typedef struct mimo_term {
  uint32_t struct_size; /**< sizeof(mimo_term), set by the caller. */
  uint32_t reserved;    /**< 0. */
  const char *name;     /**< "distance". */
  size_t agent;         /**< Index of the agent whose reward it is part of. */
} mimo_term;

/** Describes the index-th term of mimo_env_results. Set term->struct_size first. */
MIMO_API mimo_status mimo_layout_term(const mimo_layout *layout, size_t index, mimo_term *term) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
