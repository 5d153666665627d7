/**
 * @file mimo/access.h
 * Named access, for rewards and experiments of one's own. Look ids up once, then read and write many at a time.
 */
#ifndef MIMO_ACCESS_H
#define MIMO_ACCESS_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_BODY 1     /**< Rigid bodies; 0 is the world. */
#define MIMO_JOINT 2    /**< Joints: hinges, slides, balls, free joints. */
#define MIMO_GEOM 3     /**< Shapes of bodies. */
#define MIMO_SITE 4     /**< Marked places on bodies. */
#define MIMO_CAMERA 5   /**< Cameras. */
#define MIMO_ACTUATOR 6 /**< Motors. */
#define MIMO_SENSOR 7   /**< MuJoCo's sensors. */

#define MIMO_JOINT_POSITION 1       /**< Joint: 1 (hinge rad, slide m), 4 (ball, quaternion) or 7 (free). Writable. */
#define MIMO_JOINT_VELOCITY 2       /**< Joint: 1, 3 or 6. Writable. */
#define MIMO_JOINT_FORCE 3          /**< Joint: 1, 3 or 6; generalised force applied by you until changed. Writable. */
#define MIMO_JOINT_ACCELERATION 4   /**< Joint: 1, 3 or 6. */
#define MIMO_JOINT_RANGE 5          /**< Joint: 2, low and high; -inf and inf when not limited. */
#define MIMO_BODY_POSITION 6        /**< Body: 3, of its frame's origin, world, m. Writable with a free joint. */
#define MIMO_BODY_ORIENTATION 7     /**< Body: 4, w x y z. Writable with a free joint. */
#define MIMO_BODY_VELOCITY 8        /**< Body: 6, linear (m/s) of its origin and angular (rad/s), world frame. */
#define MIMO_BODY_FORCE 9           /**< Body: 6, force, torque at its centre of mass, world; as MIMO_JOINT_FORCE. */
#define MIMO_BODY_MASS 10           /**< Body: 1, kg. */
#define MIMO_BODY_CENTER_OF_MASS 11 /**< Body: 3, of the body alone, world, m. */
#define MIMO_GEOM_POSITION 12       /**< Geom: 3, world, m. */
#define MIMO_GEOM_ORIENTATION 13    /**< Geom: 4, w x y z. */
#define MIMO_GEOM_SIZE 14           /**< Geom: 3, by shape. */
#define MIMO_SITE_POSITION 15       /**< Site: 3, world, m. */
#define MIMO_SITE_ORIENTATION 16    /**< Site: 4, w x y z. */
#define MIMO_CAMERA_POSITION 17     /**< Camera: 3, world, m. */
#define MIMO_CAMERA_ORIENTATION 18  /**< Camera: 4, w x y z; a camera looks along its -z, +y is up in the picture. */
#define MIMO_ACTUATOR_CONTROL 19    /**< Actuator: 1, control input. Writable. */
#define MIMO_ACTUATOR_FORCE 20      /**< Actuator: 1, N or Nm. */
#define MIMO_SENSOR_VALUE 21        /**< Sensor: its dimension. */
#define MIMO_ACTUATOR_GEAR 22       /**< Actuator: 1, Nm at control 1; of this world, outlives resets. Writable. */

/** How many of a kind (MIMO_BODY ...) the world has. */
MIMO_API mimo_status mimo_env_count(const mimo_env *env, int32_t kind, size_t *count) MIMO_NOEXCEPT;

/**
 * Finds something by its name in the model.
 * Errors: MIMO_E_NOT_FOUND; the message lists names that are there.
 */
MIMO_API mimo_status mimo_env_find(const mimo_env *env, int32_t kind, const char *name, int32_t *id) MIMO_NOEXCEPT;

/** Name of something; "" where the model gives none. The string is owned by the environment. */
MIMO_API mimo_status mimo_env_name(const mimo_env *env, int32_t kind, int32_t id, const char **name) MIMO_NOEXCEPT;

/** The body that a joint, geom, site or camera belongs to, or the parent of a body. */
MIMO_API mimo_status mimo_env_body_of(const mimo_env *env, int32_t kind, int32_t id, int32_t *body) MIMO_NOEXCEPT;

/** How many values a quantity (MIMO_JOINT_POSITION ...) has for a list of ids together. */
MIMO_API mimo_status mimo_env_width(const mimo_env *env, int32_t quantity, const int32_t *ids, size_t id_count,
                                    size_t *value_count) MIMO_NOEXCEPT;

/**
 * Reads a quantity of many at once, one after the other.
 * Positions and velocities of joints, controls and forces set by you are current. Everything else was computed by
 * the last physics step from its start (MIMO_AT_LAST_START), or by reset, set and mimo_env_update, whichever came last.
 * @param value_count length of values, as mimo_env_width gives it.
 */
MIMO_API mimo_status mimo_env_get(const mimo_env *env, int32_t quantity, const int32_t *ids, size_t id_count,
                                  double *values, size_t value_count) MIMO_NOEXCEPT;

/**
 * Writes a quantity of many at once. Quaternions are normalised. When joints or bodies were moved, the poses of
 * everything are recomputed (as by mimo_env_update); a moved body keeps its velocity.
 * Errors: MIMO_E_INVALID_ARGUMENT for a quantity that cannot be written, or values that are not finite.
 */
MIMO_API mimo_status mimo_env_set(mimo_env *env, int32_t quantity, const int32_t *ids, size_t id_count,
                                  const double *values, size_t value_count) MIMO_NOEXCEPT;

/** Recomputes poses (bodies, geoms, sites, cameras) from the joints' positions. The trajectory stays as it was. */
MIMO_API mimo_status mimo_env_update(mimo_env *env) MIMO_NOEXCEPT;

#define MIMO_CONTACT_IDS 4 /**< Per contact: geom 1, geom 2, body of geom 1, body of geom 2. */
/**
 * Per contact: position 3; frame 9 (rows: normal from geom 1 to geom 2, two tangents; world); distance 1 (negative:
 * overlap); force on body 2 in that frame 3, torque 3.
 */
#define MIMO_CONTACT_VALUES 19

/**
 * The contacts that the last physics step computed (or reset), with their forces.
 * @param ids      n x MIMO_CONTACT_IDS, C order; may be NULL.
 * @param values   n x MIMO_CONTACT_VALUES, C order; SI units; may be NULL.
 * @param capacity how many contacts the arrays have room for.
 * @param count    receives how many there are.
 * Errors: MIMO_E_BUFFER_TOO_SMALL when there are more than capacity and an array is given; count is set all the same.
 */
MIMO_API mimo_status mimo_env_contacts(const mimo_env *env, int32_t *ids, double *values, size_t capacity,
                                       size_t *count) MIMO_NOEXCEPT;

#define MIMO_TOUCH_FRAME_VALUES 9 /**< Per sensor: outward normal 3, first tangent 3, second tangent 3; body frame. */

/**
 * The touch sensors of an agent, in the order of its touch fields. A sensor that stands for a whole small geom sits in
 * its middle and counts as looking along the body's x axis. The first tangent is the body's x axis projected on the
 * skin, or its y axis where x is within 10 degrees of the normal; the second is the normal x the first.
 * @param agent     index of the agent.
 * @param bodies    n ids; may be NULL.
 * @param geoms     n ids; may be NULL.
 * @param positions n x 3, metres, in the frame of the sensor's body, C order; may be NULL.
 * @param frames    n x MIMO_TOUCH_FRAME_VALUES; may be NULL.
 * @param capacity  how many sensors the arrays have room for.
 * @param count     receives how many there are, 0 where touch is off; may be NULL.
 * Errors: MIMO_E_BUFFER_TOO_SMALL when there are more than capacity and an array is given; count is set all the same.
 */
MIMO_API mimo_status mimo_env_touch_sensors(const mimo_env *env, size_t agent, int32_t *bodies, int32_t *geoms,
                                            double *positions, double *frames, size_t capacity,
                                            size_t *count) MIMO_NOEXCEPT;

/* What differs from world to world, though all share one model. It outlives resets. */

/**
 * Gives an agent another face, in this world only. Pictures show it from the next one on.
 * @param name see mimo_face_name.
 * Errors: MIMO_E_NOT_FOUND; the message lists the faces that there are.
 */
MIMO_API mimo_status mimo_env_set_face(mimo_env *env, size_t agent, const char *name) MIMO_NOEXCEPT;

/** The face that an agent shows. @param name receives a string owned by the environment; "" where it has no faces. */
MIMO_API mimo_status mimo_env_face(const mimo_env *env, size_t agent, const char **name) MIMO_NOEXCEPT;

/**
 * Holds a joint at an angle, softly, from the next step on. Locking it again moves the angle.
 * @param joint a hinge of an infant.
 * @param angle within the joint's range, rad.
 * Errors: MIMO_E_UNSUPPORTED when the model has no equality for that joint, or the joint is under position control.
 */
MIMO_API mimo_status mimo_env_lock(mimo_env *env, int32_t joint, double angle) MIMO_NOEXCEPT;

/** Lets a joint go, also one that the scene has locked. */
MIMO_API mimo_status mimo_env_unlock(mimo_env *env, int32_t joint) MIMO_NOEXCEPT;

/** Whether a joint is held, and at which angle (rad; also that of a lock that is off). Either may be NULL. */
MIMO_API mimo_status mimo_env_lock_state(const mimo_env *env, int32_t joint, uint8_t *locked,
                                         double *angle) MIMO_NOEXCEPT;

/** Sets gravity, m/s^2, world frame. */
MIMO_API mimo_status mimo_env_set_gravity(mimo_env *env, double x, double y, double z) MIMO_NOEXCEPT;

/** Reads gravity. @param xyz receives three numbers. */
MIMO_API mimo_status mimo_env_gravity(const mimo_env *env, double *xyz, size_t count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
