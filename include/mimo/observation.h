/**
 * @file mimo/observation.h
 * What observations, actions and rewards consist of: the layout. An observation is one block of bytes that holds all
 * fields.
 */
#ifndef MIMO_OBSERVATION_H
#define MIMO_OBSERVATION_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * What something observes, acts with and is rewarded for: see mimo_env_layout, mimo_batch_layout, mimo_senses_layout.
 * It never changes, but for bounds, receptors and times where a reset brings another age. It belongs to the world, the
 * batch or the senses that it describes, and is refused (MIMO_E_BAD_HANDLE) when they are gone. Worlds of a batch have
 * its layout.
 * Any number of threads may ask it, also while its owner steps or becomes of another age: each answer is of one age.
 * Its strings and shapes last as long as it does.
 */
typedef struct mimo_layout mimo_layout;

/** The sizes of everything, for one world. */
typedef struct mimo_layout_info {
  uint32_t struct_size; /**< sizeof(mimo_layout_info), set by the caller. */
  uint32_t reserved;    /**< 0. */
  size_t block_bytes;   /**< Size of an observation block, a multiple of 64. It should be 64-byte aligned. */
  size_t fields;        /**< Number of fields. */
  size_t actions;       /**< Number of actions of all agents together. */
  size_t agents;        /**< Number of agents: of rewards, flags and outcomes. */
  size_t terms;         /**< Number of reward terms of all agents together. */
} mimo_layout_info;

/** Tells the sizes. Set info->struct_size first. */
MIMO_API mimo_status mimo_layout_describe(const mimo_layout *layout, mimo_layout_info *info) MIMO_NOEXCEPT;

#define MIMO_U8 1  /**< uint8_t */
#define MIMO_I32 2 /**< int32_t */
#define MIMO_F32 3 /**< float */
#define MIMO_F64 4 /**< double */

/**
 * One field of the observation block.
 *
 * When it is true: what a step gives belongs to the time from start to end, in seconds after the step's end; both are 0
 * for what is true then, both are negative for what is late or belongs to the start of the last physics step, and start
 * is before end for what was gathered meanwhile. After a reset, and from mimo_env_observe, it belongs to now, but for
 * what is late.
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
  double low;           /**< Smallest possible value; -infinity where there is none. */
  double high;          /**< Largest possible value; infinity where there is none. */
  double start;         /**< Seconds after the step's end, <= 0. */
  double end;           /**< Seconds after the step's end, start <= end <= 0. */
  double period;        /**< Seconds from one new value to the next: those of a step. */
  size_t receptors;     /**< On how many receptors it reports, in the order of its first axis; 0: it is not of skin. */
  double sample_rate;   /**< Of sound, samples a second, the oldest first, up to `end`; 0: it is no sound. */
} mimo_field;

/** Describes the index-th field. Set field->struct_size first. */
MIMO_API mimo_status mimo_layout_field(const mimo_layout *layout, size_t index, mimo_field *field) MIMO_NOEXCEPT;

/** Finds a field by its name. Errors: MIMO_E_NOT_FOUND; the message lists names that are there. */
MIMO_API mimo_status mimo_layout_find(const mimo_layout *layout, const char *name, size_t *index) MIMO_NOEXCEPT;

/**
 * What one element of a field is: the joint, sensor or actuator it belongs to, "robot:left_elbow".
 * @param field   index of the field.
 * @param element position in the flattened field.
 * @param label   receives a string; "" for pictures and touch, which have no labels.
 */
MIMO_API mimo_status mimo_layout_label(const mimo_layout *layout, size_t field, size_t element,
                                       const char **label) MIMO_NOEXCEPT;

/**
 * How late the elements of a field come, in seconds: whole numbers of the model's time steps, 0 for what is sensed at
 * once. A field's start and end are those of all its elements. A batch tells those of its first world, which others of
 * another age do not share.
 * @param field   index of the field.
 * @param seconds receives one number for each element of the flattened field.
 * @param count   length of seconds: the product of the field's shape.
 */
MIMO_API mimo_status mimo_layout_delays(const mimo_layout *layout, size_t field, double *seconds,
                                        size_t count) MIMO_NOEXCEPT;

/**
 * Where the pixels of a picture lie, foveated or not: unit vectors from the eye or camera to the middle of each, in its
 * own frame: x to the right, y up, z backwards.
 * @param field      index of a picture: of colour, depth or segmentation.
 * @param directions receives height x width x 3 numbers.
 * @param count      length of directions.
 * Errors: MIMO_E_INVALID_ARGUMENT for a field that is no picture.
 */
MIMO_API mimo_status mimo_layout_directions(const mimo_layout *layout, size_t field, float *directions,
                                            size_t count) MIMO_NOEXCEPT;

#define MIMO_RECEPTOR_BODY 1     /**< 1, id of the body that it sits on. */
#define MIMO_RECEPTOR_GEOM 2     /**< 1, id of the geom whose surface it lies on. */
#define MIMO_RECEPTOR_POSITION 3 /**< 3, m, in the frame of its body. */
/**
 * 9, in the frame of its body: outward normal, first tangent, second tangent. The first tangent is the body's x axis
 * projected on the skin, or its y axis where x is within 10 degrees of the normal; the second is the normal x the
 * first. A receptor that stands for a whole small geom sits in its middle and counts as looking along the body's x
 * axis.
 */
#define MIMO_RECEPTOR_FRAME 4

/** How many values a quantity (MIMO_RECEPTOR_POSITION ...) has for all receptors of a field together. */
MIMO_API mimo_status mimo_layout_receptor_width(const mimo_layout *layout, size_t field, int32_t quantity,
                                                size_t *value_count) MIMO_NOEXCEPT;

/**
 * Where a field's receptors are: a quantity of all of them, one after the other.
 * @param value_count length of values, as mimo_layout_receptor_width gives it.
 */
MIMO_API mimo_status mimo_layout_receptors(const mimo_layout *layout, size_t field, int32_t quantity, double *values,
                                           size_t value_count) MIMO_NOEXCEPT;

/** One action: the control input of one motor, as a share of its largest torque, or what agent.h says. */
typedef struct mimo_action {
  uint32_t struct_size; /**< sizeof(mimo_action), set by the caller. */
  uint32_t reserved;    /**< 0. */
  const char *name;     /**< Its actuator's, "act:left_elbow", or its muscle's. */
  const char *unit;     /**< "rad" under position control without normalize_actions; "" for none. */
  size_t agent;         /**< Whose it is. */
  double low;           /**< Smallest value, a number of a float; -infinity where there is none. */
  double high;          /**< Largest value. */
} mimo_action;

/** Describes the index-th action. Set action->struct_size first. */
MIMO_API mimo_status mimo_layout_action(const mimo_layout *layout, size_t index, mimo_action *action) MIMO_NOEXCEPT;

/** A part of an agent's reward; the reward is their sum. */
typedef struct mimo_term {
  uint32_t struct_size; /**< sizeof(mimo_term), set by the caller. */
  uint32_t reserved;    /**< 0. */
  const char *name;     /**< "distance". */
  size_t agent;         /**< Whose reward. */
} mimo_term;

/** Describes the index-th term of mimo_env_results. Set term->struct_size first. */
MIMO_API mimo_status mimo_layout_term(const mimo_layout *layout, size_t index, mimo_term *term) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
