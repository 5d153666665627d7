/**
 * @file mimo/mimo.h
 * libmimo: MIMo, the multimodal infant model, as a C library.  MIT licence, see LICENSE.
 *
 * In the order of use:
 *
 *     1. versions and status       6. named access: joints, bodies, contacts by name; gaze
 *     2. logging                   7. pictures
 *     3. scenes, agents, tasks     8. timing
 *     4. environments              9. rewards and outcomes
 *     5. stepping, observations    10. what differs from world to world: faces, locks, gravity
 *                                  11. state: save, load, clone
 *                                  12. batches of worlds
 *                                  13. tasks of your own
 *                                  14. senses on your own simulation
 *
 * Rules that hold everywhere (docs/ has an article on each):
 *
 *     Errors    Functions that can fail return a mimo_status: 0 is success, negative is failure, and
 *               mimo_last_error() then holds one line that names the argument, its value and what was
 *               expected. When an argument is refused, nothing is written anywhere.
 *     Handles   mimo_scene, mimo_env, mimo_batch, mimo_senses are opaque. Destroy accepts NULL; a destroyed handle is
 *               refused by every function (MIMO_E_BAD_HANDLE), destroying it again does nothing. A handle made
 *               before fork() answers MIMO_E_FORKED in the child.
 *     Threads   Functions that take a const handle may run at the same time on one handle; functions that
 *               take a handle without const need it for themselves; different handles are independent.
 *               Any thread may call. A thread that is cancelled (pthread_cancel) within a call finishes the call first.
 *     Memory    Buffers belong to the caller and come with their length in elements (observation blocks:
 *               in bytes). One that is too short is refused and stays as it was (MIMO_E_BUFFER_TOO_SMALL); a
 *               length that no memory has, such as a negative number turned into size_t, is
 *               MIMO_E_INVALID_ARGUMENT. Strings passed in are UTF-8 and copied; who owns a string passed out
 *               is said where it is declared.
 *     Structs   Versioned structs start with struct_size and are filled by their _init function, called as
 *               mimo_X_init(&x, sizeof x); where there is none, set struct_size to their sizeof and the rest to
 *               0. They only ever grow at the end. Reserved fields are 0.
 *     Units     SI units and radians. Quaternions are w x y z. Frames: x forward, y left, z up. The velocity
 *               of a free joint is linear in the world frame, then angular in the body's own frame.
 */
#ifndef MIMO_H
#define MIMO_H

#include <stddef.h>
#include <stdint.h>

#include "mimo_export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------------------------
 * 1. Versions and status
 * ------------------------------------------------------------------------------------------------- */

#define MIMO_VERSION_MAJOR 0 /**< Version of this header; mimo_version() gives the library's. */
#define MIMO_VERSION_MINOR 1 /**< See MIMO_VERSION_MAJOR. */
#define MIMO_VERSION_PATCH 0 /**< See MIMO_VERSION_MAJOR. */
#define MIMO_ABI_VERSION 0   /**< Changes when old callers would break; equals the SONAME's number. */
#define MIMO_API_MAJOR 0     /**< Version of what is declared here, 0.9; docs/abi.md says what may change. */
#define MIMO_API_MINOR 9     /**< Grows when something is added: `#if MIMO_API_MAJOR > 0 || MIMO_API_MINOR >= 9`. */

/** Result of a call: MIMO_OK or one of the negative MIMO_E_ constants. */
typedef int32_t mimo_status;

#define MIMO_OK 0                  /**< The call did what it says. */
#define MIMO_E_INVALID_ARGUMENT -1 /**< An argument is NULL, out of range or not finite. */
#define MIMO_E_BAD_HANDLE -2       /**< Not a handle of that kind, or one already destroyed. */
#define MIMO_E_BUFFER_TOO_SMALL -3 /**< A caller's buffer is shorter than needed; nothing was written. */
#define MIMO_E_STRUCT_SIZE -4      /**< struct_size unknown, or an unknown tail of the struct is not zero. */
#define MIMO_E_NOT_FOUND -5        /**< No body, joint, scene, file... of that name. */
#define MIMO_E_MODEL -6            /**< A model does not compile, or asks for too much; see docs/guide/errors.md. */
#define MIMO_E_SIMULATION -7       /**< The simulation failed or diverged; reset makes the world usable again. */
#define MIMO_E_RENDER -8           /**< The renderer failed. */
#define MIMO_E_UNSUPPORTED -9      /**< Not possible here, for example no OSMesa on this machine. */
#define MIMO_E_OUT_OF_MEMORY -10   /**< An allocation failed. */
#define MIMO_E_FORKED -11          /**< The handle was made in the parent process, before fork(). */
#define MIMO_E_INTERNAL -12        /**< A defect in libmimo; please report the message. */

/** ABI version of the loaded library; compare with MIMO_ABI_VERSION. Never fails. */
MIMO_API uint32_t mimo_abi_version(void) MIMO_NOEXCEPT;

/** Version of the loaded library, "major.minor.patch". Static string. */
MIMO_API const char *mimo_version(void) MIMO_NOEXCEPT;

/** Version of the MuJoCo that the library runs on, "2.2.2". Static string. */
MIMO_API const char *mimo_mujoco_version(void) MIMO_NOEXCEPT;

/** Name of a status, "MIMO_E_NOT_FOUND"; "MIMO_E_UNKNOWN" for a number that is none. Static string. */
MIMO_API const char *mimo_status_name(mimo_status status) MIMO_NOEXCEPT;

/**
 * What the last failed call on this thread complained about, one line, never NULL, "" if nothing failed yet. The string
 * belongs to the library and is valid until the next failing call on the same thread. Calls that succeed, and the
 * destroy functions, leave it alone. Within a function of your own task it is "" at first, and what fails there is not
 * seen outside, unless the task fails with it. Messages are UTF-8.
 */
MIMO_API const char *mimo_last_error(void) MIMO_NOEXCEPT;

/**
 * What the last failed call that was given this handle first complained about: for runtimes that move work from thread
 * to thread (Go, Node), where mimo_last_error may be somebody else's. mimo_env_create and the like are given their
 * scene. mimo_scene_create and mimo_env_make are given none: such a runtime stays on one thread for them and
 * mimo_last_error.
 * @param handle   a mimo_scene, mimo_env, mimo_batch or mimo_senses.
 * @param text     receives the message, zero-terminated, "" if nothing failed yet; NULL with capacity 0 asks for its
 *                 length only.
 * @param capacity 1024 bytes are enough for any message.
 * @param length   receives the length without the terminating zero; may be NULL.
 * Errors: as everywhere, but they change no handle's message. Any thread may ask, also while others use the handle.
 */
MIMO_API mimo_status mimo_last_error_of(const void *handle, char *text, size_t capacity,
                                        size_t *length) MIMO_NOEXCEPT;

/**
 * Says what went wrong in a function of your own task: `return mimo_fail(MIMO_E_NOT_FOUND, "no ball in this scene");`.
 * The call that runs the task fails with that status and quotes the message.
 * @param status  a MIMO_E_ constant.
 * @param message one line, UTF-8; copied.
 * @return status, after mimo_last_error() was set to the message.
 */
MIMO_API mimo_status mimo_fail(mimo_status status, const char *message) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 2. Logging. The library never writes to stdout, stderr or files by itself.
 * ------------------------------------------------------------------------------------------------- */

#define MIMO_LOG_WARNING 1 /**< Something is not as the user probably meant it. */
#define MIMO_LOG_INFO 2    /**< Worth knowing, once. */

/**
 * Receives messages; NULL in a config means silence. Called on the thread that called the library, before
 * that call returns; the message is valid during the callback only. Must not call back into the library with
 * the same handle, nor throw or longjmp.
 */
typedef void (*mimo_log_fn)(void *user, int32_t level, const char *message);

/* ---------------------------------------------------------------------------------------------------
 * 3. Scenes and agents. A scene describes a room, objects and infants; environments are made from it.
 * ------------------------------------------------------------------------------------------------- */

/** A description of what is to be simulated. It may be changed or destroyed once environments exist. */
typedef struct mimo_scene mimo_scene;

/** How a scene starts. At most one of name, file and xml may be set; none of them gives an empty world. */
typedef struct mimo_scene_config {
  uint32_t struct_size;  /**< sizeof(mimo_scene_config), set by mimo_scene_config_init. */
  uint32_t reserved;     /**< 0. */
  const char *name;      /**< Built-in scene: "reach", "benchmark", ...; see mimo_scene_builtin. */
  const char *file;      /**< Path of an MJCF file. Its includes may name built-in files as "mimo/mitten.xml". */
  const char *xml;       /**< MJCF text; relative paths in it start from the working directory. */
  const char *model_dir; /**< Folder to take built-in models from instead of those inside the library, or NULL. */
  mimo_log_fn log;       /**< Messages about the scene's making, or NULL. */
  void *log_user;        /**< Passed to log. */
  /* What a document may ask for; 0 means the default. What asks for more is refused with MIMO_E_MODEL. */
  uint64_t max_file_bytes;  /**< Bytes of each file that is read. Default 268435456. */
  uint64_t max_pixels;      /**< Pixels of a texture or height field. Default 67108864. */
  uint64_t max_vertices;    /**< Vertices of a mesh or skin, and its faces. Default 1000000. */
  uint64_t max_elements;    /**< Elements of the document, and those that composites become. Default 40000. */
  uint64_t max_keyframes;   /**< Default 10000. */
  uint64_t max_iterations;  /**< Iterations of each solver in a physics step. Default 10000. */
  uint64_t max_world_bytes; /**< What the buffers of one world may need, as estimated. Default 4294967296. */
  uint32_t confined;        /**< 1: includes and assets must lie in the folder of the document that names them, or
                                 below; 0: anywhere. */
  uint32_t limits_reserved; /**< 0. */
} mimo_scene_config;

/**
 * Fills a config with defaults: an empty world, silent.
 * @param size sizeof(mimo_scene_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_scene_config_init(mimo_scene_config *config, size_t size) MIMO_NOEXCEPT;

/** Name of the index-th built-in scene, or NULL past the last. Static string. */
MIMO_API const char *mimo_scene_builtin(size_t index) MIMO_NOEXCEPT;

/**
 * Makes a scene. Parses the MJCF but compiles nothing yet. Elements may be nested 256 deep.
 * @param config NULL means defaults.
 * @param scene  receives the handle; destroy it with mimo_scene_destroy.
 */
MIMO_API mimo_status mimo_scene_create(const mimo_scene_config *config, mimo_scene **scene) MIMO_NOEXCEPT;

/** Destroys a scene. NULL and destroyed handles are ignored. Environments made from it live on. */
MIMO_API void mimo_scene_destroy(mimo_scene *scene) MIMO_NOEXCEPT;

/** Name of the index-th room ("playroom"), or NULL past the last. Static string. */
MIMO_API const char *mimo_scene_room(size_t index) MIMO_NOEXCEPT;

/**
 * Gives a scene that has none a room: floor, sky, light, and a place for an infant. What the scene says itself about
 * solver, statistics and pictures stays.
 * Errors: MIMO_E_NOT_FOUND for an unknown room; MIMO_E_INVALID_ARGUMENT for a scene that has a room or a floor already.
 */
MIMO_API mimo_status mimo_scene_set_room(mimo_scene *scene, const char *name) MIMO_NOEXCEPT;

#define MIMO_PROPRIOCEPTION_VELOCITY 0x01u     /**< Joint velocities, rad/s. */
#define MIMO_PROPRIOCEPTION_TORQUE 0x02u       /**< Three-axis torque sensors at the joints, Nm. */
#define MIMO_PROPRIOCEPTION_LIMIT 0x04u        /**< Limit sensors, 1 at a joint's limit. */
#define MIMO_PROPRIOCEPTION_ACTUATION 0x08u    /**< Controls and torques of motors, targets, or what muscles do. */
#define MIMO_PROPRIOCEPTION_JOINT_TORQUE 0x10u /**< Torque about each joint's own axis, Nm. */
#define MIMO_PROPRIOCEPTION_POSITION 0x20u     /**< Joint angles, rad. */
#define MIMO_PROPRIOCEPTION_EFFORT 0x40u       /**< proprioception/effort, 0 to 1: see docs/guide/muscles.md. */
#define MIMO_PROPRIOCEPTION_DEFAULT 0x2fu      /**< All but JOINT_TORQUE and EFFORT, as the original. */
#define MIMO_PROPRIOCEPTION_ALL 0x7fu          /**< Everything. */

#define MIMO_VISION_RGB 0x01u          /**< Colour, uint8 H x W x 3, row 0 is the top. */
#define MIMO_VISION_DEPTH 0x02u        /**< Depth along the camera's axis, float32 H x W, metres. */
#define MIMO_VISION_SEGMENTATION 0x04u /**< Geom id of each pixel, int32 H x W, -1 is background. */

#define MIMO_ACTUATION_TORQUE 0   /**< An action is a motor's share of its largest torque. */
#define MIMO_ACTUATION_POSITION 1 /**< An action is the angle to which a soft lock takes a joint, rad. */
/**
 * Two muscles a motor, of the original MIMo's model. Actions are the activations they are told to have, 0 to 1: first
 * all muscles that pull to the negative side, "act:.../negative", then all that pull to the positive side. Joints lose
 * their springs and 19/20 of their dampers, motors their limits. Before every physics step muscles turn their
 * activation towards the action and pull; the motor's control input then is torque over gear, and a world's own gear
 * makes them stronger or weaker. While a task prepares an episode muscles do nothing. Needs a motor's user numbers, see
 * models/README.md.
 *
 * Fields, one number a muscle, of the end of the step: proprioception/activation, and proprioception/muscle_force, with
 * which it would pull now.
 */
#define MIMO_ACTUATION_MUSCLE 2
#define MIMO_ACTUATION_MUJOCO_MUSCLE 3 /**< By MuJoCo's muscle model: activation rises in 0.01 s, falls in 0.04 s. */

#define MIMO_ACT_TRUNK 0x01u       /**< Three motors. */
#define MIMO_ACT_HEAD 0x02u        /**< Three. */
#define MIMO_ACT_EYES 0x04u        /**< Three an eye. */
#define MIMO_ACT_RIGHT_ARM 0x08u   /**< Shoulder (three) and elbow. */
#define MIMO_ACT_LEFT_ARM 0x10u    /**< The same on the left. */
#define MIMO_ACT_RIGHT_HAND 0x20u  /**< Wrist (three) and fingers: one motor of a mitten, 22 of five fingers. */
#define MIMO_ACT_LEFT_HAND 0x40u   /**< The same on the left. */
#define MIMO_ACT_RIGHT_LEG 0x80u   /**< Hip (three) and knee. */
#define MIMO_ACT_LEFT_LEG 0x100u   /**< The same on the left. */
#define MIMO_ACT_RIGHT_FOOT 0x200u /**< Ankle (three) and toes; a big toe has a motor of its own. */
#define MIMO_ACT_LEFT_FOOT 0x400u  /**< The same on the left. */
#define MIMO_ACT_ALL 0x7ffu        /**< Everything. */
#define MIMO_ACT_NONE 0x80000000u  /**< No motor at all; excludes the other bits. */

#define MIMO_TOUCH_FORCE 0x1u        /**< touch/force, N x 3: normal force and friction, N. */
#define MIMO_TOUCH_NORMAL_FORCE 0x2u /**< touch/force, N x 1: the normal force alone, N; instead of MIMO_TOUCH_FORCE. */
#define MIMO_TOUCH_SLIP 0x4u         /**< touch/slip, N x 2: how it slides over the skin, along its tangents, m/s. */
#define MIMO_TOUCH_FRICTION_USE 0x8u /**< touch/friction_use, N x 1: share of the possible friction in use; 1: all. */

#define MIMO_TOUCH_NEAREST 1  /**< The nearest sensor feels all of a touch. */
#define MIMO_TOUCH_LINEAR 2   /**< Weights fall linearly with the distance along the skin, to 0 at twice the spacing. */
#define MIMO_TOUCH_GAUSSIAN 3 /**< Weights fall as a bell of deviation 2/3 spacing, cut off at twice the spacing. */

#define MIMO_FRAME_BODY 1  /**< The frame of the body that the sensor sits on. */
#define MIMO_FRAME_WORLD 2 /**< The frame of the world. */
#define MIMO_FRAME_SKIN 3  /**< Of the skin at the sensor: outward normal, two tangents; see mimo_env_touch_sensors. */

/**
 * Name of the index-th face of the built-in bodies, or NULL past the last: "neutral", "enjoyment", "sadness",
 * "surprise", "disgust", "anger", "fear". Static string. Further ones are materials of your own MJCF named
 * "mimo_face_<name>".
 */
MIMO_API const char *mimo_face_name(size_t index) MIMO_NOEXCEPT;

/**
 * One agent: where it is, what it senses, what of it acts. Mostly an infant; with `root` any part of a model that
 * knows nothing of infants. Such an agent
 *   - reads the positions of its hinges and slides, its motors, and the torque sensors on it;
 *   - acts with its actuators, within their ctrlrange (no bounds where they have none);
 *   - has skin where mimo_scene_set_touch says so, and nowhere else;
 *   - sees with all cameras that it carries, "vision/NAME";
 *   - has a vestibular organ where vestibular_at says;
 *   - has no face, no gaze, and its only task is "none" or one of your own.
 */
typedef struct mimo_agent_config {
  uint32_t struct_size;        /**< sizeof(mimo_agent_config), set by mimo_agent_config_init. */
  uint32_t place_given;        /**< 1: position and orientation below count; 0: the scene's own place for an infant. */
  const char *name;            /**< "" for a sole agent; else the prefix of its fields and model names, "anna/...". */
  const char *body;            /**< "mitten", "fingers" (hands with five fingers, feet with a big toe); or "scene": the
                                    body is part of the scene's MJCF. */
  double position[3];          /**< Of the root body mimo_location, m, world frame; standing soles are 0.33 below. */
  double orientation[4];       /**< Of the root body, w x y z; need not be normalised. */
  uint32_t proprioception;     /**< MIMO_PROPRIOCEPTION_ bits; 0: no proprioception. */
  uint32_t vestibular;         /**< 1: accelerometer and gyroscope in the head; 0: none. */
  double limit_threshold;      /**< Limit sensors work this near to a limit; radians, > 0. Default 0.035. */
  uint32_t vision;             /**< MIMO_VISION_ bits of both eyes; 0: no vision. Default MIMO_VISION_RGB. */
  uint32_t vision_width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t vision_height;      /**< Pixels, 1 to 4096. Default 256. */
  uint32_t actuation;          /**< A MIMO_ACTUATION_ constant. Default torque. */
  double vision_fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own (60). */
  uint32_t acts;               /**< MIMO_ACT_ bits: parts that have motors; 0: the scene's own choice. */
  uint32_t normalize_actions;  /**< 1: actions go from -1 to 1, mapped linearly to their range; 0: their own range. */
  uint32_t touch;              /**< MIMO_TOUCH_ output bits; 0: no touch. Default MIMO_TOUCH_FORCE. */
  int32_t touch_response;      /**< MIMO_TOUCH_NEAREST, _LINEAR (default) or _GAUSSIAN: who feels how much. */
  int32_t touch_frame;         /**< MIMO_FRAME_BODY (default), _WORLD or _SKIN: of touch/force with three components. */
  uint32_t touch_reserved;     /**< 0. */
  double touch_scale;          /**< Divides the usual distances between sensors: 2 makes 4 times as many. Default 1. */
  double touch_slip_threshold; /**< Slip below counts as none: MuJoCo's friction creeps. m/s, >= 0. Default 0.005. */
  const char *face;            /**< The face that it shows at first, see mimo_face_name; NULL: neutral. */
  const char *root;            /**< With body "scene": the body of the model that the agent consists of, with all below
                                    it; "world": everything. NULL: an infant. */
  const char *vestibular_at;   /**< Site or body whose motion the vestibular sense feels; NULL: the infant's head. */
} mimo_agent_config;

/**
 * Fills a config with defaults: the mitten body at the scene's place, all senses on.
 * @param size sizeof(mimo_agent_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_agent_config_init(mimo_agent_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Fills a config with what the scene gives its next infant by itself: its body (static string), its place (position and
 * orientation, which count where place_given is set to 1; 0 0 0 where all places are taken), and in reach, standup,
 * selfbody and catch the senses of the experiments, and no eyes; in catch muscles; elsewhere the same as
 * mimo_agent_config_init.
 * @param size sizeof(mimo_agent_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_scene_default_agent(const mimo_scene *scene, mimo_agent_config *config,
                                              size_t size) MIMO_NOEXCEPT;

/**
 * Adds an infant.
 *
 * In a scene that names no place for its first infant and where none is given, it stands on what stands still at the
 * origin (the surface nearest to height 0 with room for it), or, where something is in its way there, beside it, up to
 * 4 m away. That is worked out when a world is made, with all that is in the scene by then. One that is given a place,
 * or finds none, and starts more than 5 mm inside of something is told of by a warning to the scene's log.
 * @param config NULL means the scene's own, see mimo_scene_default_agent.
 * @param agent  receives its number, 0 for the first; may be NULL.
 * Errors: MIMO_E_NOT_FOUND for an unknown body; MIMO_E_INVALID_ARGUMENT for a body that the scene is not made for (five
 * fingers in standup), for a name in use by an agent or a part of the scene, for no name where there are several
 * agents, and when the scene has no place left and none is given; MIMO_E_MODEL for a scene that does not compile where
 * its compiler settings weigh all bodies (settotalmass, ...); MIMO_E_UNSUPPORTED for such settings where it has a
 * composite, and for global coordinates.
 */
MIMO_API mimo_status mimo_scene_add_agent(mimo_scene *scene, const mimo_agent_config *config,
                                          int32_t *agent) MIMO_NOEXCEPT;

/**
 * Adds all infants that the scene names (its MJCF's custom text "mimo:infants", "anna ben"), each at a place of its
 * own; in a scene that names none a single one.
 * @param config what they have in common; a name only where the scene gives none, a place only where there is just one.
 *               NULL: the scene's own, see mimo_scene_default_agent.
 * @param count  receives how many were added; may be NULL.
 * Errors: as mimo_scene_add_agent. All of them are added, or none.
 */
MIMO_API mimo_status mimo_scene_add_agents(mimo_scene *scene, const mimo_agent_config *config,
                                           size_t *count) MIMO_NOEXCEPT;

/**
 * Sets the distance between the touch sensors of one part of an infant's body, in place of the usual one.
 * @param body    name of a body without its agent's name, "left_hand"; NULL: every body, and what was set before for
 *                single ones no longer counts.
 * @param spacing metres, at most 10, as it is (touch_scale does not change it); 0: no skin there.
 * Errors: MIMO_E_NOT_FOUND for a body that the infant does not have; the message lists those that it has. Where the
 *         scene does not know (an agent with a root), it comes when an environment is made or senses are attached.
 */
MIMO_API mimo_status mimo_scene_set_touch(mimo_scene *scene, int32_t agent, const char *body,
                                          double spacing) MIMO_NOEXCEPT;

/**
 * Has an agent's proprioception read this joint; the first call takes away all others. Position, velocity, limits and
 * torque about the joint's axis then have one element for each call, in that order.
 * @param joint a hinge or slide of the agent, by its name in the model, "anna/robot:left_elbow".
 * Errors: MIMO_E_INVALID_ARGUMENT for a joint that is read already. A joint that the agent does not have is
 *         MIMO_E_NOT_FOUND when an environment is made or senses are attached; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_read_joint(mimo_scene *scene, int32_t agent, const char *joint) MIMO_NOEXCEPT;

/** How much less an agent senses than there is to be sensed. What is not limited costs nothing. */
typedef struct mimo_limits {
  uint32_t struct_size; /**< sizeof(mimo_limits), set by mimo_limits_init. */
  uint32_t delay;       /**< Steps by which what is sensed comes late, up to 1000; before that, what the episode began
                             with. Default 0. */
  double gain;          /**< Factor of all values, 0 to 3.4e38 (the largest float). Default 1. */
  double noise;         /**< Standard deviation of the Gaussian noise that is added, 0 to 3.4e38, in the field's unit
                             (colours: levels of 255). Default 0. */
  double blur;          /**< Of pictures in colour: lines this fine, in cycles per degree, keep half their contrast; 0
                             (default): sharp. 0.05 to 1000. */
} mimo_limits;

/**
 * Fills limits with those of a perfect sense.
 * @param size sizeof(mimo_limits) as the caller knows it.
 */
MIMO_API mimo_status mimo_limits_init(mimo_limits *limits, size_t size) MIMO_NOEXCEPT;

/**
 * Limits a sense of an agent, or a part of one, for environments made from now on. First the picture is blurred, then
 * comes the gain, then the noise, then the delay. What comes out is cut to the bounds of its field, and to the largest
 * float where there are none. The noise follows from
 * the world's seed and step: it is the same in every run and for any number of looks at a step. What is late is part of
 * the world's state, and no episode senses anything of the one before.
 * @param path   a field without its agent's name, "vision/eye_left", or all fields below a path, "touch". Where several
 *               calls concern a field, the last one counts. Gain and noise of "vision" do not concern depth and
 *               segmentation, unless these are named.
 * @param limits NULL: a perfect sense.
 * Errors: MIMO_E_NOT_FOUND from mimo_env_create for a path that leads to no field; the message lists those that there
 *         are. Attached senses cannot be limited.
 */
MIMO_API mimo_status mimo_scene_limit_sense(mimo_scene *scene, int32_t agent, const char *path,
                                            const mimo_limits *limits) MIMO_NOEXCEPT;

#define MIMO_SHAPE_SPHERE 1    /**< size: radius. */
#define MIMO_SHAPE_CAPSULE 2   /**< size: radius, half length of the cylindrical part (along z). */
#define MIMO_SHAPE_ELLIPSOID 3 /**< size: three radii. */
#define MIMO_SHAPE_CYLINDER 4  /**< size: radius, half length (along z). */
#define MIMO_SHAPE_BOX 5       /**< size: three half lengths. */

/** A rigid object of one primitive shape. */
typedef struct mimo_object_config {
  uint32_t struct_size;  /**< sizeof(mimo_object_config), set by mimo_object_config_init. */
  int32_t shape;         /**< A MIMO_SHAPE_ constant. */
  const char *name;      /**< Of its body and its geom; needed, unique among bodies and geoms. */
  double size[3];        /**< Metres, by shape; unused entries are ignored. */
  double position[3];    /**< Metres, world frame. */
  double orientation[4]; /**< w x y z; need not be normalised. */
  double mass;           /**< Kilograms; 0: a density of 1000 kg/m^3. */
  double rgba[4];        /**< Colour, 0 to 1. */
  uint32_t fixed;        /**< 1: part of the world; 0: it moves freely. */
  uint32_t reserved;     /**< 0. */
} mimo_object_config;

/**
 * Fills a config with defaults: a red sphere of 4 cm radius and 0.1 kg at the origin, free to move, without name.
 * @param size sizeof(mimo_object_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_object_config_init(mimo_object_config *config, size_t size) MIMO_NOEXCEPT;

/** Adds an object. Errors: MIMO_E_INVALID_ARGUMENT for sizes, mass or colours out of range and for a name in use. */
MIMO_API mimo_status mimo_scene_add_object(mimo_scene *scene, const mimo_object_config *config) MIMO_NOEXCEPT;

/** An object that is described by an MJCF document of its own: a toy with parts, a piece of furniture, a robot. */
typedef struct mimo_model_config {
  uint32_t struct_size;  /**< sizeof(mimo_model_config), set by mimo_model_config_init. */
  uint32_t fixed;        /**< 1: it gets no free joint; 0: it moves freely, unless its body has joints of its own. */
  const char *name;      /**< Needed: letters, digits, '_', '-', '.'. Goes with '/' before all names in the document. */
  const char *file;      /**< Path of an MJCF file; what it includes and its meshes lie relative to its folder. */
  const char *xml;       /**< Or MJCF text; relative paths start from the working directory. */
  double position[3];    /**< Where its body is, metres, world frame; in place of what the document says. */
  double orientation[4]; /**< w x y z; need not be normalised. */
} mimo_model_config;

/**
 * Fills a config with defaults: at the origin, free to move, without name and document.
 * @param size sizeof(mimo_model_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_model_config_init(mimo_model_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Adds an MJCF document as an object. The one body in its worldbody becomes the object, with its assets, contacts,
 * equalities, tendons, actuators, sensors and custom elements. All their names get the object's name before them,
 * "cup/handle", so the same document may be added often; the free joint, and a body without a name, have the object's.
 * Its main defaults count for it alone, and it gets none of the scene's. Angles, euler angles and automatic limits are
 * converted to the scene's settings. What else stands in its worldbody (floor, lights) does not come along, nor do its
 * solver options, keyframes, sizes and visual settings: there the scene's count. Nor do keyframes of the scene stay:
 * they are positions of other joints.
 * Errors: MIMO_E_NOT_FOUND for a file that cannot be read; MIMO_E_MODEL for a document that is no MJCF or has not just
 * one body, or that does not compile where its compiler settings weigh all its bodies (settotalmass, ...);
 * MIMO_E_UNSUPPORTED for global coordinates, and for such settings where it has a composite; MIMO_E_INVALID_ARGUMENT
 * for a name in use, and for fixed = 1 where the body has a free joint.
 */
MIMO_API mimo_status mimo_scene_add_model(mimo_scene *scene, const mimo_model_config *config) MIMO_NOEXCEPT;

/**
 * Fastens a body to another one or to the world, softly, as the solver holds things.
 * @param body  name of a body in the scene, "anna/left_hand".
 * @param other name of the one to which it is fastened; NULL: the world.
 * @param pose  where the body is in the other's frame: position (m) and quaternion w x y z; NULL: as they are to each
 *              other where the scene starts, with all that is added and posed before an environment is made.
 * Errors: MIMO_E_NOT_FOUND for a body that the scene does not have; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_weld(mimo_scene *scene, const char *body, const char *other,
                                     const double *pose) MIMO_NOEXCEPT;

/**
 * Holds a hinge or slide, softly, and starts it there. mimo_env_unlock lets it go. Position control takes over the
 * locks of the joints that it moves.
 * @param joint name of a joint in the scene, "anna/robot:left_knee".
 * @param value rad or m, within the joint's range.
 * Errors: MIMO_E_NOT_FOUND for a joint that the scene does not have; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_lock(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/**
 * Sets where a hinge or slide starts; resets lead there, before a task changes it.
 * @param joint name of a joint in the scene, of an infant, an object or a model of your own.
 * @param value rad or m, within the joint's range.
 * Errors: as mimo_scene_lock.
 */
MIMO_API mimo_status mimo_scene_set_pose(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/** A camera whose pictures are fields: "vision/NAME", "vision/NAME_depth", "vision/NAME_segmentation". */
typedef struct mimo_camera_config {
  uint32_t struct_size; /**< sizeof(mimo_camera_config), set by mimo_camera_config_init. */
  uint32_t outputs;     /**< MIMO_VISION_ bits, at least one. Default MIMO_VISION_RGB. */
  const char *name;     /**< A camera of the scene's MJCF or of an infant, "anna/eye_left"; with placed = 1 the name of
                             a new one. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 256. */
  double fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own, 45 for a new one. */
  uint32_t placed;      /**< 1: make the camera, where the entries below say; 0: it is there already. */
  uint32_t reserved;    /**< 0. */
  const char *body;     /**< Body that carries it, by its name in the model; NULL: it stands still in the world. */
  double position[3];   /**< Where it is, metres, in the frame of the body. */
  double look_at[3];    /**< The point in the middle of its picture, metres, in the frame of the body, whose z axis
                             points up in the picture. */
} mimo_camera_config;

/**
 * Fills a config with defaults: a camera of the model, no name yet; a new one looks from (1.5, 0, 0.8) at (0, 0, 0.4).
 * @param size sizeof(mimo_camera_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_camera_config_init(mimo_camera_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Has a camera observed. Its fields come after those of all agents and belong to the scene.
 * Errors: MIMO_E_NOT_FOUND for a body that the scene does not have, and from mimo_env_create for a camera that the
 *         model does not have; MIMO_E_INVALID_ARGUMENT for a camera that is observed already, or a new one whose name
 *         is in use.
 */
MIMO_API mimo_status mimo_scene_add_camera(mimo_scene *scene, const mimo_camera_config *config) MIMO_NOEXCEPT;

/**
 * The scene as one MJCF document, as MuJoCo will compile it; for looking at it and for other tools. Files that it
 * names "mimo/..." are the built-in ones, installed as share/mimo/models.
 * Errors: MIMO_E_MODEL where bodies are fastened as they start (mimo_scene_weld) or an infant has no place, and the
 *         scene does not compile.
 * @param text   receives the document, zero-terminated; NULL with capacity 0 asks for the size only.
 * @param length receives the length without the terminating zero; may be NULL.
 */
MIMO_API mimo_status mimo_scene_xml(const mimo_scene *scene, char *text, size_t capacity,
                                    size_t *length) MIMO_NOEXCEPT;

/**
 * Writes the scene for tools that know nothing of libmimo: FOLDER/scene.xml, and in FOLDER/assets copies of all
 * textures, meshes and other files that it refers to. Any program with MuJoCo opens it, also elsewhere.
 * @param folder made where it is not there. A file that is there already must hold the same: nothing is overwritten.
 * Errors: MIMO_E_INVALID_ARGUMENT for a file that is there with other content or cannot be written; MIMO_E_NOT_FOUND
 *         for one that cannot be read; MIMO_E_MODEL as from mimo_scene_xml. Nothing has been written then.
 */
MIMO_API mimo_status mimo_scene_save(const mimo_scene *scene, const char *folder) MIMO_NOEXCEPT;

/** Name of the index-th task ("none", "reach", ...), or NULL past the last. Static string. */
MIMO_API const char *mimo_task_name(size_t index) MIMO_NOEXCEPT;

/** A number by which a task can be changed. */
typedef struct mimo_parameter {
  uint32_t struct_size;    /**< sizeof(mimo_parameter), set by the caller. */
  uint32_t reserved;       /**< 0. */
  const char *name;        /**< "reach/success_reward". Static. */
  const char *description; /**< One line; with unit. Static. */
  double standard;         /**< Value unless set. */
  double low;              /**< Smallest allowed value. */
  double high;             /**< Largest allowed value. From 0 to 1 it may be a switch; the description says so. */
} mimo_parameter;

/** Number of parameters of all tasks together. */
MIMO_API mimo_status mimo_parameter_count(size_t *count) MIMO_NOEXCEPT;

/** Describes the index-th parameter. Set parameter->struct_size first. */
MIMO_API mimo_status mimo_parameter_describe(size_t index, mimo_parameter *parameter) MIMO_NOEXCEPT;

/**
 * Sets a parameter for environments made from now on.
 * Errors: MIMO_E_NOT_FOUND; MIMO_E_INVALID_ARGUMENT out of range.
 */
MIMO_API mimo_status mimo_scene_set_parameter(mimo_scene *scene, const char *name, double value) MIMO_NOEXCEPT;

/** The value that a parameter has in this scene. */
MIMO_API mimo_status mimo_scene_get_parameter(const mimo_scene *scene, const char *name, double *value) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 4. Environments: one simulated world with its agents' senses.
 * ------------------------------------------------------------------------------------------------- */

/** A world: physics, agents, senses, observation layout. */
typedef struct mimo_env mimo_env;

#define MIMO_JACOBIAN_MODEL 0  /**< As the model says; built-in scenes say sparse. */
#define MIMO_JACOBIAN_DENSE 1  /**< As the original solves; for comparing trajectories to the last digit. */
#define MIMO_JACOBIAN_SPARSE 2 /**< The same solution to rounding, about twice as fast. */

#define MIMO_DISABLE_CONTACT 0x1u    /**< No contacts. */
#define MIMO_DISABLE_GRAVITY 0x2u    /**< No gravity. */
#define MIMO_DISABLE_OWN_SOLVER 0x4u /**< mj_step as it is, instead of libmimo's solver: same to rounding, slower. */

#define MIMO_RENDER_SHADOWS 0x01u     /**< Lights cast shadows. */
#define MIMO_RENDER_REFLECTIONS 0x02u /**< Floors and boxes may mirror what is before them. */
#define MIMO_RENDER_SKY 0x04u         /**< The scene's sky; without it the background is black. */
#define MIMO_RENDER_HAZE 0x08u        /**< Haze at the horizon of an endless floor. */
#define MIMO_RENDER_FOG 0x10u         /**< Fog, as the scene's MJCF describes it. */
#define MIMO_RENDER_DEFAULT 0x0fu     /**< Everything but fog. */

/** How a world is simulated. */
typedef struct mimo_env_config {
  uint32_t struct_size;    /**< sizeof(mimo_env_config), set by mimo_env_config_init. */
  uint32_t frame_skip;     /**< Physics steps per environment step, 1 to 1000; each is one time step of the model, 5 ms
                                in built-in scenes. Default 0: the scene's own, mostly 2. */
  int32_t jacobian;        /**< A MIMO_JACOBIAN_ constant. */
  uint32_t disable;        /**< MIMO_DISABLE_ bits. */
  const char *renderer;    /**< "ray" (our own, on the CPU), "osmesa" (MuJoCo's), "auto" (default): ray where the scene
                                allows, else osmesa; or "none": then eyes must be off. */
  uint32_t max_steps;      /**< Steps after which an episode is truncated; 0: the task's parameter episode_steps. */
  uint32_t timing;         /**< 1: mimo_env_timing counts; costs a few clock reads a step. */
  mimo_log_fn log;         /**< Messages during create, reset and step, or NULL. */
  void *log_user;          /**< Passed to log. */
  const char *task;        /**< See mimo_task_name; NULL: the scene's own. Every agent has the task for itself. */
  uint32_t render;         /**< MIMO_RENDER_ bits (_DEFAULT): what pictures show. What is left out costs nothing. */
  uint32_t samples;        /**< Samples a pixel for smooth edges: 1, 4, 16 or 64 (OSMesa may give fewer); 0: one ray, or
                                what the model tells OSMesa. */
  uint32_t render_threads; /**< Threads that draw one picture with the ray renderer, 1 to 64, the caller's among them.
                                Pictures do not differ. Default 1, which is best in batches. */
  uint32_t reserved;       /**< 0. */
} mimo_env_config;

/**
 * Fills a config with defaults.
 * @param size sizeof(mimo_env_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_env_config_init(mimo_env_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene and makes a world of it, in its initial state.
 * Note: MuJoCo's XML loader calls srand(123), the one piece of process state that is touched.
 * @param scene  is not needed any more afterwards.
 * @param config NULL means defaults.
 * Errors: MIMO_E_MODEL with file and line; MIMO_E_NOT_FOUND for an unknown task; MIMO_E_UNSUPPORTED when eyes are on
 *         and no renderer works here, when the program's C++ locale has a decimal comma, or when a MuJoCo of another
 *         version lies in the program's global scope.
 */
MIMO_API mimo_status mimo_env_create(const mimo_scene *scene, const mimo_env_config *config,
                                     mimo_env **env) MIMO_NOEXCEPT;

/** The usual case in one call: a built-in scene by name with its own infants (mimo_scene_add_agents) and task. */
MIMO_API mimo_status mimo_env_make(const char *scene_name, mimo_env **env) MIMO_NOEXCEPT;

/** Destroys a world. NULL and destroyed handles are ignored. */
MIMO_API void mimo_env_destroy(mimo_env *env) MIMO_NOEXCEPT;

/** What is to be known of one agent of a world. */
typedef struct mimo_agent_info {
  uint32_t struct_size;   /**< sizeof(mimo_agent_info), set by the caller. */
  uint32_t action_offset; /**< Where its actions start in the action array. */
  uint32_t action_count;  /**< How many they are. */
  uint32_t reserved;      /**< 0. */
  const char *name;       /**< Owned by the environment. */
  double mass;            /**< Of its whole body, kg. */
  double height;          /**< Vertical extent of its geoms in the initial pose qpos0, metres. */
} mimo_agent_info;

/** Name of the task. The string is owned by the environment. */
MIMO_API mimo_status mimo_env_task(const mimo_env *env, const char **name) MIMO_NOEXCEPT;

/** Physics steps per environment step. */
MIMO_API mimo_status mimo_env_frame_skip(const mimo_env *env, uint32_t *frame_skip) MIMO_NOEXCEPT;

/** Number of agents; also the length of the reward, terminated and truncated arrays of a step. */
MIMO_API mimo_status mimo_env_agent_count(const mimo_env *env, size_t *count) MIMO_NOEXCEPT;

/** Describes the index-th agent. Set info->struct_size first. */
MIMO_API mimo_status mimo_env_agent(const mimo_env *env, size_t index, mimo_agent_info *info) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 5. Stepping and observations. An observation is one block of bytes that holds all fields.
 * ------------------------------------------------------------------------------------------------- */

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

/**
 * Starts an episode: from the scene's stored state, as its task wants it.
 * @param seed  points to the seed of the world's random numbers; NULL goes on with its own stream.
 * @param block receives the observation, as mimo_env_observe gives it; may be NULL with block_bytes 0.
 */
MIMO_API mimo_status mimo_env_reset(mimo_env *env, const uint64_t *seed, void *block,
                                    size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Goes one step on: sets the motors, runs frame_skip physics steps, senses, rewards.
 * @param action       all agents' actions, clipped to their bounds; NULL with action_count 0 leaves the
 *                     controls as they are (0 after a reset, or as set by mimo_env_set).
 * @param block        receives the observation, every byte of it; NULL with block_bytes 0 skips the senses.
 * @param reward       one per agent; may be NULL.
 * @param terminated   one per agent, 1 when its episode has ended by success or failure; may be NULL.
 * @param truncated    one per agent, 1 when the episode has reached its step limit; may be NULL.
 * @param agents       length of the last three arrays, 0 if all are NULL.
 * Errors: MIMO_E_INVALID_ARGUMENT for a NaN in action, or an infinite one without bounds (nothing happens then);
 *         MIMO_E_SIMULATION when the physics fails or diverges: block and results are then unspecified. Until the
 *         world is reset or loads a state, it can be looked at (names, values, sizes), but whatever would simulate,
 *         sense, draw, write values, save or clone answers MIMO_E_SIMULATION.
 */
MIMO_API mimo_status mimo_env_step(mimo_env *env, const float *action, size_t action_count, void *block,
                                   size_t block_bytes, double *reward, uint8_t *terminated, uint8_t *truncated,
                                   size_t agents) MIMO_NOEXCEPT;

/**
 * The observation of the current state, without changing the trajectory. All its fields belong to the current
 * state, so after a step it differs from the step's block in the fields with time MIMO_AT_LAST_START.
 */
MIMO_API mimo_status mimo_env_observe(mimo_env *env, void *block, size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Bare physics: count physics steps with the controls as they are, without actuation, senses or task.
 * What MuJoCo alone costs; also for hosts that bring senses and control of their own.
 * @param count 0 to 1000000.
 * Errors: MIMO_E_SIMULATION as mimo_env_step; MIMO_E_INVALID_ARGUMENT from within a task of this world.
 */
MIMO_API mimo_status mimo_env_physics_step(mimo_env *env, size_t count) MIMO_NOEXCEPT;

/** Simulated seconds since reset. */
MIMO_API mimo_status mimo_env_time(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

/** Length of one physics step, seconds. */
MIMO_API mimo_status mimo_env_timestep(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 6. Named access, for rewards and experiments of one's own. Look ids up once, then read and write many at a time.
 * ------------------------------------------------------------------------------------------------- */

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

/** Where an infant looks. */
typedef struct mimo_gaze {
  uint32_t struct_size;      /**< sizeof(mimo_gaze), set by the caller. */
  uint32_t meets;            /**< 1: the lines of sight come closest before both eyes; 0: they lead apart. */
  double left_position[3];   /**< Of the left eye's camera, world, m. */
  double left_direction[3];  /**< Its line of sight, unit vector, world. */
  double right_position[3];  /**< Of the right eye's camera. */
  double right_direction[3]; /**< Its line of sight. */
  double vergence;           /**< Angle between the lines of sight, rad; negative where they lead apart. */
  double point[3];           /**< Where they meet: half-way where they are closest, world, m; zero if they do not. */
  double miss;               /**< How far they pass each other there, m. */
} mimo_gaze;

/** Where an agent looks, by its eyes' cameras as they are (see mimo_env_get). Set gaze->struct_size first. */
MIMO_API mimo_status mimo_env_gaze(const mimo_env *env, size_t agent, mimo_gaze *gaze) MIMO_NOEXCEPT;

#define MIMO_LOOK_EYES 0 /**< The eyes alone turn. They reach 45 degrees to the sides, 33 up and 47 down. */
#define MIMO_LOOK_HEAD 1 /**< The head turns first, so that the eyes have to turn little. */

#define MIMO_LOOK_JOINTS 8 /**< As many joints as looking takes at most. */

/**
 * Angles of the joints that make an agent look at a point, from where its chest is now; nothing moves. For position
 * control, for locks, or for mimo_env_set. Eyes do not roll: their torsion is 0.
 * @param point    three numbers, metres, world frame.
 * @param how      MIMO_LOOK_EYES or MIMO_LOOK_HEAD.
 * @param joints   receives ids: pan, tilt and torsion of the left eye, then of the right one; with MIMO_LOOK_HEAD
 *                 swivel and tilt of the head before them. May be NULL.
 * @param angles   receives their angles, rad, cut to the joints' ranges; may be NULL.
 * @param capacity how many joints the arrays have room for.
 * @param count    receives how many there are; may be NULL.
 * @param errors   receives two angles, by which the left and the right eye miss the point because of their range, rad;
 *                 may be NULL.
 * Errors: MIMO_E_NOT_FOUND or MIMO_E_UNSUPPORTED for a body without such eyes; MIMO_E_BUFFER_TOO_SMALL.
 */
MIMO_API mimo_status mimo_env_look_angles(mimo_env *env, size_t agent, const double *point, int32_t how,
                                          int32_t *joints, double *angles, size_t capacity, size_t *count,
                                          double *errors) MIMO_NOEXCEPT;

/**
 * Makes an agent look at a point at once: its joints are set, as by mimo_env_set, not driven. Springs and motors
 * go on moving them in the next step.
 * @param errors as in mimo_env_look_angles.
 */
MIMO_API mimo_status mimo_env_look_at(mimo_env *env, size_t agent, const double *point, int32_t how,
                                      double *errors) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 7. Pictures for people: any camera of the model, or a free one that looks at a point.
 * ------------------------------------------------------------------------------------------------- */

#define MIMO_PICTURE_RGBA 0x1u      /**< Four bytes a pixel, the last one 255. */
#define MIMO_PICTURE_BOTTOM_UP 0x2u /**< Row 0 is the bottom, as in OpenGL's textures; of depth, too. */

/** What to draw. */
typedef struct mimo_picture_config {
  uint32_t struct_size; /**< sizeof(mimo_picture_config), set by mimo_picture_config_init. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 640. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 480. */
  uint32_t format;      /**< MIMO_PICTURE_ bits. Default 0: RGB, row 0 is the top. */
  const char *camera;   /**< A camera of the model; NULL: the free camera below. */
  double look_at[3];    /**< Free camera: the point in the middle, world, m. */
  double distance;      /**< Free camera: from that point, m, > 0. */
  double azimuth;       /**< Free camera: degrees; 0 looks along +x, 90 along +y. */
  double elevation;     /**< Free camera: degrees; negative looks down. */
  double fovy;          /**< Vertical field of view, degrees; 0: the camera's own. */
} mimo_picture_config;

/**
 * Fills a config with defaults: a free camera that sees the infant from the front.
 * @param size sizeof(mimo_picture_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_picture_config_init(mimo_picture_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Draws the current state.
 * @param rgb          height x width x 3 bytes, or 4 with MIMO_PICTURE_RGBA; NULL with rgb_bytes 0: not wanted.
 * @param depth        height x width floats, metres along the camera's axis; NULL with depth_count 0: not wanted.
 * @param segmentation height x width geom ids, -1 is background; NULL with segmentation_count 0: not wanted.
 */
MIMO_API mimo_status mimo_env_render(mimo_env *env, const mimo_picture_config *config, uint8_t *rgb, size_t rgb_bytes,
                                     float *depth, size_t depth_count, int32_t *segmentation,
                                     size_t segmentation_count) MIMO_NOEXCEPT;

/**
 * Where points of the world lie in the picture that mimo_env_render draws of this state; for drawing over it.
 * @param config NULL means defaults, as in mimo_env_render.
 * @param points count x 3, metres, world frame, C order; finite.
 * @param pixels count x 3: pixels to the right of the left edge, pixels below the upper edge, and depth along the
 *               camera's axis in metres. A depth of 0 or less is behind the camera; the pixels then mean nothing.
 */
MIMO_API mimo_status mimo_env_project(const mimo_env *env, const mimo_picture_config *config, const double *points,
                                      size_t count, double *pixels) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 8. Timing: where a step's time goes.
 * ------------------------------------------------------------------------------------------------- */

/** Seconds spent in the parts of steps since the last call of mimo_env_timing_reset. */
typedef struct mimo_timing {
  uint32_t struct_size;  /**< sizeof(mimo_timing), set by the caller. */
  uint32_t reserved;     /**< 0. */
  uint64_t steps;        /**< Environment steps counted. */
  double total;          /**< Everything. */
  double physics;        /**< MuJoCo's steps. */
  double touch;          /**< Sense of touch. */
  double vision;         /**< Drawing the eyes' pictures. */
  double proprioception; /**< Joint senses. */
  double vestibular;     /**< Accelerometer and gyroscope. */
} mimo_timing;

/** Reads the timing; all zero unless the environment was made with timing = 1. Set timing->struct_size first. */
MIMO_API mimo_status mimo_env_timing(const mimo_env *env, mimo_timing *timing) MIMO_NOEXCEPT;

/** Starts counting anew. */
MIMO_API mimo_status mimo_env_timing_reset(mimo_env *env) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 9. Rewards and outcomes, more closely than mimo_env_step tells.
 * ------------------------------------------------------------------------------------------------- */

/** Number of terms of an agent's reward, which is their sum. */
MIMO_API mimo_status mimo_env_reward_term_count(const mimo_env *env, size_t agent, size_t *count) MIMO_NOEXCEPT;

/** Name of the index-th term, "distance". The string is owned by the environment. */
MIMO_API mimo_status mimo_env_reward_term_name(const mimo_env *env, size_t agent, size_t index,
                                               const char **name) MIMO_NOEXCEPT;

/** The terms of the last step's reward, 0 after a reset. @param count length of values. */
MIMO_API mimo_status mimo_env_reward_terms(const mimo_env *env, size_t agent, double *values,
                                           size_t count) MIMO_NOEXCEPT;

/** Whether an agent's last step was a success or a failure (0 or 1), also where that does not end the episode. */
MIMO_API mimo_status mimo_env_outcome(const mimo_env *env, size_t agent, uint8_t *success,
                                      uint8_t *failure) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 10. What differs from world to world, though all share one model. It outlives resets.
 * ------------------------------------------------------------------------------------------------- */

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

/* ---------------------------------------------------------------------------------------------------
 * 11. State: everything that the future of a world depends on, as bytes. A world that loads a state continues
 *     exactly as the one that saved it, to the last bit, for as long as it is given the same actions.
 * ------------------------------------------------------------------------------------------------- */

/** Size of the world's state in bytes; it does not change. */
MIMO_API mimo_status mimo_env_state_size(const mimo_env *env, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves physics, actuation, task, random numbers, elapsed steps, locks, gears, faces and gravity.
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

/* ---------------------------------------------------------------------------------------------------
 * 12. Batches: many worlds of one scene, stepped by a pool of threads. World i does exactly what a single
 *     environment does that is reset with the i-th seed and given the i-th actions, for any number of threads.
 *     Arrays stack the worlds along their first axis: blocks lie at i * mimo_env_observation_size.
 *
 *     What one world cannot do (its simulation failed, its actions are not numbers) stops none of the others. The
 *     call then returns the status of the first such world, mimo_last_error() names it, and
 *     mimo_batch_world_error tells of each. Masks have one byte a world: 0 leaves that world alone, and its
 *     rows as they are; a NULL mask means all.
 * ------------------------------------------------------------------------------------------------- */

/** Many worlds. Needs itself alone like an environment; its threads are its own business. */
typedef struct mimo_batch mimo_batch;

#define MIMO_AUTORESET_NONE 0 /**< Worlds go on when an episode has ended, until mimo_batch_reset. */
/**
 * The step after the end of an episode starts a new one instead of acting: its reward is 0, both flags are 0, its block
 * is that of the reset.
 */
#define MIMO_AUTORESET_NEXT_STEP 1
/**
 * The step that ends an episode also starts the next one: reward and flags are those of the old episode, the block is
 * the first of the new one; the last block of the old one goes to final_blocks.
 */
#define MIMO_AUTORESET_SAME_STEP 2

/** How many worlds, and what happens when one's episode ends. Modes are those of Gymnasium's vector environments. */
typedef struct mimo_batch_config {
  uint32_t struct_size;    /**< sizeof(mimo_batch_config), set by mimo_batch_config_init. */
  uint32_t worlds;         /**< At least 1. Default 1. */
  uint32_t threads;        /**< 0 (default): as many as the machine has cores; never more than worlds. */
  int32_t autoreset;       /**< A MIMO_AUTORESET_ constant. When one agent's episode ends, the others' are truncated. */
  uint32_t restart_failed; /**< 1: a world whose simulation fails starts a new episode, as after an end (with NONE: in
                                the same step). 0: it stays failed until mimo_batch_reset or a state is loaded. */
  uint32_t reserved;       /**< 0. */
} mimo_batch_config;

/**
 * Fills a config with defaults: one world, all cores, no automatic reset.
 * @param size sizeof(mimo_batch_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_batch_config_init(mimo_batch_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene once and makes worlds of it. Until seeded, world i's random numbers are those of seed i.
 * @param env_config   for all worlds; NULL means defaults. Messages of the worlds come on the thread that calls.
 * @param batch_config NULL means defaults.
 * Errors: as mimo_env_create.
 */
MIMO_API mimo_status mimo_batch_create(const mimo_scene *scene, const mimo_env_config *env_config,
                                       const mimo_batch_config *batch_config, mimo_batch **batch) MIMO_NOEXCEPT;

/**
 * Destroys a batch, its worlds and their handles; waits for what was sent, with all that its tasks do. NULL and
 * destroyed handles are ignored.
 */
MIMO_API void mimo_batch_destroy(mimo_batch *batch) MIMO_NOEXCEPT;

/** Number of worlds and of threads; either may be NULL. */
MIMO_API mimo_status mimo_batch_size(const mimo_batch *batch, size_t *worlds, size_t *threads) MIMO_NOEXCEPT;

/**
 * One world as an environment. All functions of environments work on it, between the batch's own calls: what its
 * observations and actions are (the same for all worlds), names, contacts, pictures, locks, state, single steps.
 * Different worlds may then be used by different threads, or by tasks of other batches.
 * @param env receives a handle that belongs to the batch; mimo_env_destroy leaves it alone. Between
 *            mimo_batch_send and mimo_batch_receive it is refused with MIMO_E_INVALID_ARGUMENT.
 */
MIMO_API mimo_status mimo_batch_world(mimo_batch *batch, size_t world, mimo_env **env) MIMO_NOEXCEPT;

/**
 * What became of one world in the last call that concerned it.
 * @param status  MIMO_OK, or why it did not do what was asked; may be NULL.
 * @param message one line, "" for none; valid until the next call with this batch; may be NULL.
 */
MIMO_API mimo_status mimo_batch_world_error(const mimo_batch *batch, size_t world, mimo_status *status,
                                            const char **message) MIMO_NOEXCEPT;

/**
 * Starts episodes.
 * @param seeds  one for each world; NULL: every world goes on with its own random numbers.
 * @param mask   which worlds; NULL: all.
 * @param worlds length of seeds and mask; 0 if both are NULL.
 * @param blocks receives the observations of the worlds that were reset; may be NULL with block_bytes 0.
 */
MIMO_API mimo_status mimo_batch_reset(mimo_batch *batch, const uint64_t *seeds, const uint8_t *mask, size_t worlds,
                                      void *blocks, size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Where the results of a step go, beside the observations. All are optional: NULL is not written.
 * A world whose simulation failed and that was not restarted in this step gets a block of zeros, reward 0,
 * terminated 0 and truncated 1; one whose actions are refused (see mimo_env_step) does not move, and only its status
 * is written.
 */
typedef struct mimo_batch_results {
  uint32_t struct_size;   /**< sizeof(mimo_batch_results), set by the caller. */
  uint32_t reserved;      /**< 0. */
  double *reward;         /**< worlds x agents. */
  uint8_t *terminated;    /**< worlds x agents. */
  uint8_t *truncated;     /**< worlds x agents. */
  size_t agents;          /**< Length of the three arrays above. */
  mimo_status *status;    /**< Per world: MIMO_OK, or why it failed (also when it was restarted). */
  uint8_t *was_reset;     /**< Per world: 1 when this step started a new episode: the block is its first. */
  uint8_t *final_written; /**< Per world: 1 when its final block was written. */
  size_t worlds;          /**< Length of the three arrays above. */
  void *final_blocks;     /**< With MIMO_AUTORESET_SAME_STEP: last observations of the episodes that ended; other rows
                               stay as they are. */
  size_t final_bytes;     /**< Length, as that of the blocks. */
} mimo_batch_results;

/**
 * Goes one step on in all worlds.
 * @param actions worlds x mimo_env_action_size; NULL with action_count 0 leaves all controls as they are.
 * @param blocks  receives the observations; NULL with block_bytes 0 skips the senses.
 * @param results NULL: not wanted.
 * Errors: those of the first world that did not do what was asked and was not restarted; all others have gone on.
 */
MIMO_API mimo_status mimo_batch_step(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/**
 * Starts a step and returns at once, so that the caller can do something else meanwhile. The arrays belong to the
 * batch until mimo_batch_receive; the results struct itself does not. Nothing but mimo_batch_receive and
 * mimo_batch_destroy can be called in between.
 */
MIMO_API mimo_status mimo_batch_send(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/** Waits for the step that was sent. Errors: as mimo_batch_step; MIMO_E_INVALID_ARGUMENT within a task of that step. */
MIMO_API mimo_status mimo_batch_receive(mimo_batch *batch) MIMO_NOEXCEPT;

/** The observations of the current states, as mimo_env_observe. */
MIMO_API mimo_status mimo_batch_observe(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *blocks,
                                        size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Reads a quantity of many ids in many worlds, as mimo_env_get; so that a reward needs one call and no loop.
 * @param values worlds x the width that mimo_env_width gives for the ids.
 */
MIMO_API mimo_status mimo_batch_get(const mimo_batch *batch, int32_t quantity, const int32_t *ids, size_t id_count,
                                    const uint8_t *mask, size_t worlds, double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/** Writes a quantity of many ids in many worlds, as mimo_env_set. All values are checked before any is written. */
MIMO_API mimo_status mimo_batch_set(mimo_batch *batch, int32_t quantity, const int32_t *ids, size_t id_count,
                                    const uint8_t *mask, size_t worlds, const double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/** Gives an agent another face in many worlds, as mimo_env_set_face. */
MIMO_API mimo_status mimo_batch_set_face(mimo_batch *batch, size_t agent, const char *name, const uint8_t *mask,
                                         size_t worlds) MIMO_NOEXCEPT;

/** Saves the states of many worlds. @param states worlds x mimo_env_state_size bytes. */
MIMO_API mimo_status mimo_batch_state_save(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *states,
                                           size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads states into many worlds, from this batch or from a single environment of the same scene.
 * @param states worlds x mimo_env_state_size bytes; or just one state, which all worlds load: futures of one present.
 */
MIMO_API mimo_status mimo_batch_state_load(mimo_batch *batch, const uint8_t *mask, size_t worlds, const void *states,
                                           size_t state_bytes) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 13. Tasks of your own, as functions that run inside reset and step; in a batch on all of its threads.
 * ------------------------------------------------------------------------------------------------- */

#define MIMO_OUTCOME_NONE 0     /**< The episode goes on. */
#define MIMO_OUTCOME_SUCCESS 1  /**< The agent's episode has ended well. */
#define MIMO_OUTCOME_FAILURE -1 /**< The agent's episode has ended badly. */

#define MIMO_TASK_MEMORY_LIMIT 1048576 /**< Largest memory_bytes of a task. */

/**
 * Prepares an episode of one agent, in a world that is at its start: named access moves things, mimo_env_random
 * gives the random numbers.
 * @param user   as in mimo_task.
 * @param env    the world; it takes everything but resets, steps, loading a state and destruction.
 * @param world  its number in the batch; 0 for a single environment.
 * @param agent  number of the agent.
 * @param memory memory_bytes of the task's own for this world and agent, 8-byte aligned, zero at first; part of the
 *               world's state.
 * @return MIMO_OK, or a MIMO_E_ constant that the reset then returns; mimo_fail says why. An exception of a C++ program
 *         fails it too, and in a batch only that world. The function must not end its thread nor jump out.
 */
typedef mimo_status (*mimo_task_reset_fn)(void *user, mimo_env *env, size_t world, size_t agent, void *memory);

/**
 * Judges a step of one agent. Positions of bodies are those of the start of the last physics step.
 * @param reward  0 unless set; finite, else the step fails with MIMO_E_INVALID_ARGUMENT.
 * @param outcome MIMO_OUTCOME_NONE unless set.
 */
typedef mimo_status (*mimo_task_evaluate_fn)(void *user, const mimo_env *env, size_t world, size_t agent, void *memory,
                                             double *reward, int32_t *outcome);

/** A task. Worlds of a batch call its functions at the same time, on several threads: `user` is shared. */
typedef struct mimo_task {
  uint32_t struct_size;           /**< sizeof(mimo_task), set by mimo_task_init. */
  uint32_t reserved;              /**< 0. */
  void *user;                     /**< Passed to the functions; outlives all worlds with this task. */
  size_t memory_bytes;            /**< Memory for each world and agent, up to MIMO_TASK_MEMORY_LIMIT. */
  mimo_task_reset_fn reset;       /**< May be NULL. */
  mimo_task_evaluate_fn evaluate; /**< Needed. */
} mimo_task;

/**
 * Fills a task with defaults: no functions, no memory.
 * @param size sizeof(mimo_task) as the caller knows it.
 */
MIMO_API mimo_status mimo_task_init(mimo_task *task, size_t size) MIMO_NOEXCEPT;

/**
 * Gives all worlds made from now on a task of your own, named "custom", in place of the scene's. NULL takes it away.
 * A task that mimo_env_config names comes first.
 */
MIMO_API mimo_status mimo_scene_set_task(mimo_scene *scene, const mimo_task *task) MIMO_NOEXCEPT;

/** Numbers from 0 (inclusive) to 1 (exclusive) from the world's own random stream. */
MIMO_API mimo_status mimo_env_random(mimo_env *env, double *values, size_t count) MIMO_NOEXCEPT;

/* ---------------------------------------------------------------------------------------------------
 * 14. Senses on your own simulation: a program that uses MuJoCo by itself gives them its mjModel and mjData.
 *     They only look; stepping, control and memory stay the host's. An environment is nothing but a world with such
 *     senses: of the same model in the same state they give the same bytes.
 * ------------------------------------------------------------------------------------------------- */

/** Senses that are attached to a host's model. Needs itself alone; others may read model and data meanwhile. */
typedef struct mimo_senses mimo_senses;

/**
 * Attaches senses to a model.
 * @param scene       describes the agents (mimo_scene_add_agent with body "scene", and a root where it is no infant),
 *                    their skin, joints and cameras. Its own MJCF does not count. Not needed any more afterwards.
 * @param config      renderer, render, samples, render_threads and log count; NULL means defaults.
 * @param model       the host's mjModel. It outlives the senses and keeps its sizes.
 * @param mujoco_version mj_version() of the host; has to be that of mimo_mujoco_version, 222 for "2.2.2".
 * @param model_size  sizeof(mjModel) as the host's compiler knows it; 0 where the host cannot know, as in Python.
 * @param data_size   sizeof(mjData), likewise.
 * @param senses      receives the handle; destroy it with mimo_senses_destroy.
 * Errors: MIMO_E_UNSUPPORTED for a MuJoCo of another version, and for effort, muscles and limits, which only worlds of
 *         the library know of; MIMO_E_INVALID_ARGUMENT for what is no mjModel;
 *         MIMO_E_NOT_FOUND for what the model lacks, with a list of what it has.
 */
MIMO_API mimo_status mimo_senses_attach(const mimo_scene *scene, const mimo_env_config *config, const void *model,
                                        int32_t mujoco_version, size_t model_size, size_t data_size,
                                        mimo_senses **senses) MIMO_NOEXCEPT;

/** Detaches senses. NULL and destroyed handles are ignored. */
MIMO_API void mimo_senses_destroy(mimo_senses *senses) MIMO_NOEXCEPT;

/** Size of an observation block, as mimo_env_observation_size. */
MIMO_API mimo_status mimo_senses_observation_size(const mimo_senses *senses, size_t *bytes,
                                                  size_t *fields) MIMO_NOEXCEPT;

/** Describes the index-th field, as mimo_env_observation_field. Its strings are owned by the senses. */
MIMO_API mimo_status mimo_senses_observation_field(const mimo_senses *senses, size_t index,
                                                   mimo_field *field) MIMO_NOEXCEPT;

/** What one element of a field is, as mimo_env_observation_label. The string is owned by the senses. */
MIMO_API mimo_status mimo_senses_observation_label(const mimo_senses *senses, size_t index, size_t element,
                                                   const char **label) MIMO_NOEXCEPT;

/** The touch sensors of an agent, as mimo_env_touch_sensors. */
MIMO_API mimo_status mimo_senses_touch_sensors(const mimo_senses *senses, size_t agent, int32_t *bodies, int32_t *geoms,
                                               double *positions, double *frames, size_t capacity,
                                               size_t *count) MIMO_NOEXCEPT;

/**
 * Senses what the data hold: after mj_step the fields belong to the times that mimo_field says, after mj_forward all of
 * them to now. MIMO_PROPRIOCEPTION_JOINT_TORQUE needs mj_rnePostConstraint, which MuJoCo only calls by itself for
 * models with force, torque or accelerometer sensors; with integrators other than Euler, accelerations and contacts are
 * those of the last stage.
 * @param data  an mjData of the model, any of them, unchanged by the call; not while it is being stepped.
 * @param block receives the observation, every byte of it.
 */
MIMO_API mimo_status mimo_senses_observe(mimo_senses *senses, const void *data, void *block,
                                         size_t block_bytes) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
