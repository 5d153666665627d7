/**
 * @file mimo/access.h
 * Named access, for custom rewards and experiments. Look ids up once, then read and write many values at a time.
 */
#ifndef MIMO_ACCESS_H
#define MIMO_ACCESS_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_BODY 1          /**< Rigid bodies; 0 is the world. */
#define MIMO_JOINT 2         /**< Joints: hinges, slides, balls, free joints. */
#define MIMO_GEOM 3          /**< Shapes of bodies. */
#define MIMO_SITE 4          /**< Marked places on bodies. */
#define MIMO_CAMERA 5        /**< Cameras. */
#define MIMO_ACTUATOR 6      /**< Motors. */
#define MIMO_SENSOR 7        /**< MuJoCo's sensors. */
#define MIMO_LIGHT 8         /**< Lights, without the headlight. */
#define MIMO_CONTACT 9       /**< Contacts that the last physics step computed, or the reset. No names. */
#define MIMO_STEP_CONTACT 10 /**< Pairs of geoms that touched during the last environment step; see below. No names. */
#define MIMO_AGENT 11        /**< Agents, by their index. */
#define MIMO_FACE 12         /**< Faces that the model has; in built-in bodies in the order of mimo_face_name. */
#define MIMO_WORLD 13        /**< The world itself: id 0, without a name. */

/*
 * Quantities: kind, how many values each element has, what they are. "Writable" ones can be set. Those marked W differ
 * from world to world: what is set there outlives resets. Everything that can be set is part of the saved state, except
 * MIMO_WARNING_STEPS. A quantity's number is its kind * 256 + 1, 2, ..., so that no quantity can be taken for a kind.
 */

/**
 * Body: 3, of its frame's origin, world, m. Writable with a free joint; W for one that stands on the world without
 * joints.
 */
#define MIMO_BODY_POSITION 0x0101
#define MIMO_BODY_ORIENTATION 0x0102 /**< Body: 4, w x y z. Writable as MIMO_BODY_POSITION. */
#define MIMO_BODY_VELOCITY 0x0103    /**< Body: 6, linear (m/s) of its origin and angular (rad/s), world frame. */
/**
 * Body: 6, force and torque at its centre of mass, world. Writable as MIMO_JOINT_FORCE.
 */
#define MIMO_BODY_FORCE 0x0104
#define MIMO_BODY_MASS 0x0105           /**< Body: 1, kg, > 0. Writable, W: its inertia grows along. */
#define MIMO_BODY_CENTER_OF_MASS 0x0106 /**< Body: 3, of the body alone, world, m. */
#define MIMO_BODY_POSE 0x0107           /**< Body: 7, position and orientation. Writable as MIMO_BODY_POSITION. */

#define MIMO_JOINT_POSITION 0x0201 /**< Joint: 1 (hinge rad, slide m), 4 (ball, quaternion) or 7 (free). Writable. */
#define MIMO_JOINT_VELOCITY 0x0202 /**< Joint: 1, 3 or 6. Writable. */
/**
 * Joint: 1, 3 or 6; generalised force that you apply, until you change it or the world is reset. Writable.
 */
#define MIMO_JOINT_FORCE 0x0203
#define MIMO_JOINT_ACCELERATION 0x0204 /**< Joint: 1, 3 or 6. */
#define MIMO_JOINT_RANGE 0x0205        /**< Joint: 2, low and high; -inf and inf when not limited. */
#define MIMO_JOINT_DAMPING 0x0206      /**< Joint: 1, for all its axes, Nms/rad or Ns/m, >= 0. Writable, W. */
/**
 * Joint: 2, 1 where it is held, else 0; and at which angle, rad. Writable, W, for hinges of infants; see mimo_env_set.
 * 0 and 0 where nothing could hold it.
 */
#define MIMO_JOINT_LOCK 0x0207

#define MIMO_GEOM_POSITION 0x0301    /**< Geom: 3, world, m. */
#define MIMO_GEOM_ORIENTATION 0x0302 /**< Geom: 4, w x y z. */
/**
 * Geom: 3, by shape, m, > 0; those that its shape does not use are left alone. Writable, W, but for planes, meshes and
 * height fields: what touches and what is seen; mass, inertia and touch sensors stay.
 */
#define MIMO_GEOM_SIZE 0x0303
#define MIMO_GEOM_POSE 0x0304 /**< Geom: 7, position and orientation. */
/**
 * Geom: 3, sliding, torsional (m), rolling (m), >= 0; two geoms meet with the larger one, or as their pair in the
 * model says. Writable, W.
 */
#define MIMO_GEOM_FRICTION 0x0305
/**
 * Geom: 4, red, green, blue, opacity, 0 to 1. (0.5, 0.5, 0.5, 1) shows the material's colour, where there is a
 * material. Writable, W.
 */
#define MIMO_GEOM_COLOR 0x0306

#define MIMO_SITE_POSITION 0x0401    /**< Site: 3, world, m. */
#define MIMO_SITE_ORIENTATION 0x0402 /**< Site: 4, w x y z. */
#define MIMO_SITE_POSE 0x0403        /**< Site: 7, position and orientation. */
#define MIMO_SITE_VELOCITY 0x0404    /**< Site: 6, linear (m/s) of its position and angular (rad/s), world frame. */

#define MIMO_CAMERA_POSITION 0x0501    /**< Camera: 3, world, m. */
#define MIMO_CAMERA_ORIENTATION 0x0502 /**< Camera: 4, w x y z; a camera looks along its -z, +y is up in the picture. */
#define MIMO_CAMERA_POSE 0x0503        /**< Camera: 7, position and orientation. */

#define MIMO_ACTUATOR_CONTROL 0x0601 /**< Actuator: 1, control input. Writable. */
#define MIMO_ACTUATOR_FORCE 0x0602   /**< Actuator: 1, N or Nm. */
#define MIMO_ACTUATOR_GEAR 0x0603    /**< Actuator: 1, Nm at control 1. Writable, W. */

#define MIMO_SENSOR_VALUE 0x0701 /**< Sensor: its dimension. */

#define MIMO_LIGHT_POSITION 0x0801  /**< Light: 3, m, in the frame of its body, mostly the world. Writable, W. */
#define MIMO_LIGHT_DIRECTION 0x0802 /**< Light: 3, unit vector in that frame. Writable (any length), W. */
#define MIMO_LIGHT_COLOR 0x0803     /**< Light: 3, red, green, blue of its diffuse part, 0 to 100. Writable, W. */

#define MIMO_CONTACT_GEOMS 0x0901    /**< Contact: 2, ids of geom 1 and geom 2; -1 for a flex (MuJoCo 4). */
#define MIMO_CONTACT_BODIES 0x0902   /**< Contact: 2, ids of their bodies; of a flex that of the nearest vertex. */
#define MIMO_CONTACT_POSITION 0x0903 /**< Contact: 3, world, m. */
#define MIMO_CONTACT_FRAME 0x0904    /**< Contact: 9, rows: normal from geom 1 to geom 2, two tangents; world. */
#define MIMO_CONTACT_DISTANCE 0x0905 /**< Contact: 1, m; negative: how deep the geoms overlap, of boxes too. */
#define MIMO_CONTACT_FORCE 0x0906    /**< Contact: 3, on the second body, in the contact's frame, N. */
#define MIMO_CONTACT_TORQUE 0x0907   /**< Contact: 3, on the second body, in the contact's frame, Nm. */

#define MIMO_STEP_CONTACT_GEOMS 0x0a01   /**< Step contact: 2, ids of geom 1 and geom 2; -1 for a flex (MuJoCo 4). */
#define MIMO_STEP_CONTACT_BODIES 0x0a02  /**< Step contact: 2, ids of their bodies. */
#define MIMO_STEP_CONTACT_START 0x0a03   /**< Step contact: 1, when they first touched, s since the step's start. */
#define MIMO_STEP_CONTACT_END 0x0a04     /**< Step contact: 1, when they last touched, s since the step's start. */
#define MIMO_STEP_CONTACT_IMPULSE 0x0a05 /**< Step contact: 3, on the second body over the step, world, N s. */
/**
 * Step contact: 3, the largest of the physics steps' forces, on the second body, world, N.
 */
#define MIMO_STEP_CONTACT_PEAK_FORCE 0x0a06
#define MIMO_STEP_CONTACT_PEAK_POSITION 0x0a07 /**< Step contact: 3, of the strongest contact at that time, world, m. */

/**
 * Agent: 1, id of the MIMO_FACE that it shows; -1 for none of them. Writable, W, for agents that have a face.
 */
#define MIMO_AGENT_FACE 0x0b01
/**
 * Agent: the numbers that its task wants to be reached; how many they are and what they mean depends on the task, see
 * docs/tasks.md. No numbers for a task without a goal and for a custom task, which has fields instead.
 */
#define MIMO_AGENT_GOAL 0x0b02
#define MIMO_AGENT_ACHIEVED 0x0b03 /**< Agent: the same numbers as they are so far; see MIMO_AGENT_GOAL. */
/**
 * Agent: 1, its age in months, for size and mass (mimo_growth). No number for an agent that is not an infant.
 */
#define MIMO_AGENT_AGE 0x0b04

#define MIMO_WORLD_GRAVITY 0x0d01 /**< World: 3, m/s^2, world frame. Writable, W. */

/**
 * Or-ed to a quantity: its value of now, which follows from the current positions and velocities; nothing is changed by
 * asking. For poses, positions, orientations, centres of mass and velocities, and for what is always current.
 */
#define MIMO_NOW 0x40000000

/*
 * Contacts within a step: physics goes in steps of mimo_env_timestep, several to an environment step, and MIMO_CONTACT
 * are those of the last one. A world with step_contacts in its config also keeps one MIMO_STEP_CONTACT for each pair of
 * geoms that touched in any of them (or in mimo_env_physics_step), in the order in which they met. A reset or a loaded
 * state takes them away. Without the switch, functions that are asked for them return MIMO_E_UNSUPPORTED.
 *
 * A flex of MuJoCo 4 (cloth, ropes) is no geom: contacts give -1 in its place. Its body is the body of the vertex that
 * the contact is next to, or of the node where nodes move the vertices; a step contact keeps the first such body. Both
 * are -1 only if a host's mjData holds a contact without any geom or flex.
 */

/** Number of elements of a kind (MIMO_BODY ...) in the world. */
MIMO_API mimo_status mimo_env_count(const mimo_env *env, mimo_kind kind, size_t *count) MIMO_NOEXCEPT;

/**
 * Finds an element by its name.
 * Errors: MIMO_E_NOT_FOUND; the message lists existing names.
 */
MIMO_API mimo_status mimo_env_find(const mimo_env *env, mimo_kind kind, const char *name, int32_t *id) MIMO_NOEXCEPT;

/** Name of an element; "" if it has none. The environment owns the string, until a reset to another age. */
MIMO_API mimo_status mimo_env_name(const mimo_env *env, mimo_kind kind, int32_t id, const char **name) MIMO_NOEXCEPT;

/** The body that a joint, geom, site, camera or light belongs to, or the parent of a body. */
MIMO_API mimo_status mimo_env_body_of(const mimo_env *env, mimo_kind kind, int32_t id, int32_t *body) MIMO_NOEXCEPT;

/**
 * Number of values of a quantity (MIMO_JOINT_POSITION ...) for a list of ids together.
 * @param ids NULL with id_count 0: all of the quantity's kind.
 */
MIMO_API mimo_status mimo_env_width(const mimo_env *env, mimo_quantity quantity, const int32_t *ids, size_t id_count,
                                    size_t *value_count) MIMO_NOEXCEPT;

/**
 * Reads a quantity of many elements at once, one after the other.
 * Values that are not computed (positions and velocities of joints, controls, applied forces, and all marked W) are
 * current. Poses, positions, orientations, centres of mass and velocities of bodies belong to the start of the last
 * physics step, or to the last reset, mimo_env_observe, mimo_env_update, loaded state or set position if that came
 * later; with MIMO_NOW they are current. Accelerations, actuator forces, sensors and contacts are computed by physics
 * steps, resets and mimo_env_observe. mimo_env_render, mimo_env_project and mimo_env_look_angles use the current
 * positions and change none of these values.
 * @param quantity    may have MIMO_NOW.
 * @param ids         NULL with id_count 0: all of the quantity's kind.
 * @param value_count length of values, as mimo_env_width gives it.
 * Errors: MIMO_E_INVALID_ARGUMENT for MIMO_NOW with a quantity that only physics steps compute.
 */
MIMO_API mimo_status mimo_env_get(const mimo_env *env, mimo_quantity quantity, const int32_t *ids, size_t id_count,
                                  double *values, size_t value_count) MIMO_NOEXCEPT;

/** The same in single precision, for engines. */
MIMO_API mimo_status mimo_env_get_float(const mimo_env *env, mimo_quantity quantity, const int32_t *ids,
                                        size_t id_count, float *values, size_t value_count) MIMO_NOEXCEPT;

/**
 * Writes a quantity of many elements at once; of an id that occurs twice the last value applies. Quaternions and
 * directions are normalised. Moving joints, bodies or lights recomputes all poses (as mimo_env_update does); a moved
 * body keeps its velocity. A lock holds its joint by a soft constraint from the next step on; the angle must lie within
 * the joint's range. Setting masses costs about as much as several physics steps, independent of their number.
 * @param ids NULL with id_count 0: all of the quantity's kind.
 * Errors: MIMO_E_INVALID_ARGUMENT for a quantity that cannot be written, and for values that are not finite or out of
 *         range; MIMO_E_UNSUPPORTED for a lock of a joint without an equality for it, or under position control; for a
 *         light that follows a body; for the face of an agent without faces. Nothing is written then.
 */
MIMO_API mimo_status mimo_env_set(mimo_env *env, mimo_quantity quantity, const int32_t *ids, size_t id_count,
                                  const double *values, size_t value_count) MIMO_NOEXCEPT;

/**
 * Recomputes poses (bodies, geoms, sites, cameras) from the joints' positions, so that mimo_env_get returns current
 * poses until the next step. The trajectory does not change.
 */
MIMO_API mimo_status mimo_env_update(mimo_env *env) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
