/**
 * @file mimo/agent.h
 * Agents of a scene: their position, their senses, and the joints they control.
 */
#ifndef MIMO_AGENT_H
#define MIMO_AGENT_H

#include "growth.h"
#include "scene.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_PROPRIOCEPTION_VELOCITY 0x01u     /**< Joint velocities, rad/s. */
#define MIMO_PROPRIOCEPTION_TORQUE 0x02u       /**< Three-axis torque sensors at the joints, Nm. */
#define MIMO_PROPRIOCEPTION_LIMIT 0x04u        /**< Limit sensors, 1 at a joint's limit. */
#define MIMO_PROPRIOCEPTION_ACTUATION 0x08u    /**< Controls and torques of motors, targets, or the state of muscles. */
#define MIMO_PROPRIOCEPTION_JOINT_TORQUE 0x10u /**< Torque about each joint's own axis, Nm. */
#define MIMO_PROPRIOCEPTION_POSITION 0x20u     /**< Joint angles, rad. */
#define MIMO_PROPRIOCEPTION_EFFORT 0x40u       /**< proprioception/effort, 0 to 1: see docs/guide/muscles.md. */
#define MIMO_PROPRIOCEPTION_ALL 0x80000000u    /**< All bits of the loaded library. */

#define MIMO_VISION_RGB 0x01u          /**< Colour, uint8 H x W x 3, row 0 is the top. */
#define MIMO_VISION_DEPTH 0x02u        /**< Depth along the camera's axis, float32 H x W, metres. */
#define MIMO_VISION_SEGMENTATION 0x04u /**< Geom id of each pixel, int32 H x W, -1 is background. */

#define MIMO_VESTIBULAR_ACCELERATION 0x1u     /**< vestibular/acceleration, 3, m/s^2, gravity included. */
#define MIMO_VESTIBULAR_ANGULAR_VELOCITY 0x2u /**< vestibular/angular_velocity, 3, rad/s. */

#define MIMO_PLACE_SCENE 0  /**< The scene's own place for an infant. */
#define MIMO_PLACE_ROOT 1   /**< The origin of its root body mimo_location; standing soles are 0.33 m below. */
#define MIMO_PLACE_SOLES 2  /**< The point between its feet, at the height of their lowest point. */
#define MIMO_PLACE_LOWEST 3 /**< Below its root body, at the height of its lowest point: it lies on that height. */

#define MIMO_ACTUATION_TORQUE 0   /**< An action is the share of a motor's largest torque. */
#define MIMO_ACTUATION_POSITION 1 /**< An action is the angle to which a soft lock moves a joint, rad. */
/**
 * Two muscles per motor, by the original MIMo's model. Actions are the muscles' target activations, 0 to 1: first all
 * muscles that pull to the negative side, "act:.../negative", then all that pull to the positive side. Joints lose
 * their springs and 19/20 of their dampers, motors their limits. Before every physics step the muscles move their
 * activation towards the action and pull. The motor's control input is then torque over gear; a world's own gear makes
 * the muscles stronger or weaker. While a task prepares an episode, muscles do not pull. The motors need user numbers,
 * see models/README.md.
 *
 * Fields, one number per muscle, at the end of the step: proprioception/activation, and proprioception/muscle_force,
 * the force with which it would pull now.
 */
#define MIMO_ACTUATION_MUSCLE 2
#define MIMO_ACTUATION_MUJOCO_MUSCLE 3 /**< MuJoCo's muscle model: activation rises in 0.01 s, falls in 0.04 s. */

#define MIMO_ACT_TRUNK 0x01u       /**< Three motors. */
#define MIMO_ACT_HEAD 0x02u        /**< Three motors. */
#define MIMO_ACT_EYES 0x04u        /**< Three motors per eye. */
#define MIMO_ACT_RIGHT_ARM 0x08u   /**< Shoulder (three) and elbow. */
#define MIMO_ACT_LEFT_ARM 0x10u    /**< The same on the left. */
#define MIMO_ACT_RIGHT_HAND 0x20u  /**< Wrist (three) and fingers: one motor of a mitten, 22 of five fingers. */
#define MIMO_ACT_LEFT_HAND 0x40u   /**< The same on the left. */
#define MIMO_ACT_RIGHT_LEG 0x80u   /**< Hip (three) and knee. */
#define MIMO_ACT_LEFT_LEG 0x100u   /**< The same on the left. */
#define MIMO_ACT_RIGHT_FOOT 0x200u /**< Ankle (three) and toes; a big toe has its own motor. */
#define MIMO_ACT_LEFT_FOOT 0x400u  /**< The same on the left. */
#define MIMO_ACT_ALL 0x80000000u   /**< All bits of the loaded library. */
#define MIMO_ACT_NONE 0x40000000u  /**< No motor; excludes the other bits. */

#define MIMO_TOUCH_FORCE 0x1u        /**< touch/force, N x 3: normal force and friction, N. */
#define MIMO_TOUCH_NORMAL_FORCE 0x2u /**< touch/force, N x 1: only the normal force, N; instead of MIMO_TOUCH_FORCE. */
#define MIMO_TOUCH_SLIP 0x4u         /**< touch/slip, N x 2: sliding over the skin, along its tangents, m/s. */
#define MIMO_TOUCH_FRICTION_USE 0x8u /**< touch/friction_use, N x 1: share of the possible friction in use, 0 to 1. */

#define MIMO_RESPONSE_NEAREST 1  /**< The nearest sensor feels the whole touch. */
#define MIMO_RESPONSE_LINEAR 2   /**< Weights fall linearly with the distance along the skin, to 0 at 2 spacings. */
#define MIMO_RESPONSE_GAUSSIAN 3 /**< Gaussian weights with a deviation of 2/3 spacing, cut off at 2 spacings. */

#define MIMO_FRAME_BODY 1  /**< The frame of the sensor's body. */
#define MIMO_FRAME_WORLD 2 /**< The world frame. */
#define MIMO_FRAME_SKIN 3  /**< The skin's frame at the sensor: normal and two tangents; see MIMO_RECEPTOR_FRAME. */

/**
 * Name of the index-th face of the built-in bodies, or NULL past the last: "neutral", "enjoyment", "sadness",
 * "surprise", "disgust", "anger", "fear". Static string. Materials named "mimo_face_<name>" in your own MJCF add faces.
 */
MIMO_API const char *mimo_face_name(size_t index) MIMO_NOEXCEPT;

/**
 * One agent: its position, its senses, and the joints it controls. Usually an infant; with `root` any part of any
 * model. Such an agent
 *   - reads the positions of its hinges and slides, its motors, and the torque sensors on it;
 *   - acts with its actuators, within their ctrlrange (no bounds where they have none);
 *   - has skin where mimo_scene_set_touch says so, and nowhere else;
 *   - sees with all cameras that it carries, "vision/NAME";
 *   - has a vestibular organ at vestibular_at;
 *   - has no face, no gaze and no reflexes; its task is "none" or a custom one.
 */
typedef struct mimo_agent_config {
  uint32_t struct_size;        /**< sizeof(mimo_agent_config), set by mimo_agent_config_init. */
  int32_t place;               /**< A MIMO_PLACE_ constant: its point that lies at position. Default: the scene's. */
  const char *name;            /**< Prefix of its fields and model names, "anna/...": letters, digits, '_', '-', '.';
                                    NULL or "" (default): none, for a single agent. */
  const char *body;            /**< "mitten" (default) or "fingers" (five fingers, a big toe); with "-mirrored" appended
                                    the left side mirrors the right one. "scene": the body is in the scene's MJCF. */
  double position[3];          /**< Of the point selected by place, m, world frame; unused with _PLACE_SCENE. */
  double orientation[4];       /**< Of the root body, w x y z; need not be normalised; unused with _PLACE_SCENE. */
  uint32_t proprioception;     /**< MIMO_PROPRIOCEPTION_ bits; 0: no proprioception. Default, as the original: VELOCITY,
                                    TORQUE, LIMIT, ACTUATION and POSITION. */
  uint32_t vestibular;         /**< MIMO_VESTIBULAR_ bits; 0: no sense of balance. Default: ACCELERATION and
                                    ANGULAR_VELOCITY. */
  double limit_threshold;      /**< Distance from a joint's limit at which limit sensors start, radians, > 0. Default
                                    0.035. */
  uint32_t vision;             /**< MIMO_VISION_ bits of both eyes; 0: no vision. Default MIMO_VISION_RGB. */
  uint32_t vision_width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t vision_height;      /**< Pixels, 1 to 4096. Default 256. */
  int32_t actuation;           /**< A MIMO_ACTUATION_ constant. Default torque. */
  double vision_fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own (60). */
  double vision_foveation;     /**< L, 0.01 to 100: colour pictures show their middle L / ln(1 + L) times as large and
                                    their rim smaller; 0 (default): as drawn. See mimo_layout_directions. */
  uint32_t acts;               /**< MIMO_ACT_ bits: the parts whose motors it controls; 0: the scene's choice. */
  uint32_t normalize_actions;  /**< 1: actions go from -1 to 1, mapped linearly to their range; 0: they have their own
                                    range. */
  uint32_t touch;              /**< MIMO_TOUCH_ output bits; 0: no touch. Default MIMO_TOUCH_FORCE. */
  int32_t touch_response;      /**< A MIMO_RESPONSE_ constant: how a touch spreads over sensors. Default _LINEAR. */
  int32_t touch_frame;         /**< A MIMO_FRAME_ constant: of touch/force with three components. Default _BODY. */
  uint32_t reflexes;           /**< MIMO_REFLEX_ bits; adds the field reflex/activation; 0 (default): none. */
  double touch_scale;          /**< Divides the distances between sensors, 0.001 to 1000: 2 gives 4 times as many.
                                    Default 1. */
  double touch_slip_threshold; /**< Slip below this is 0, since MuJoCo's friction creeps; m/s, >= 0. Default 0.005. */
  const char *face;            /**< The face that it starts with, see mimo_face_name; NULL: neutral. */
  const char *root;            /**< With body "scene": the body of the model that, with its children, is the agent;
                                    "world": the whole model. NULL: an infant. */
  const char *vestibular_at;   /**< Site or body whose motion the vestibular sense feels; NULL: the infant's head. */
  const mimo_growth *growth;   /**< Its age and size; NULL: 18 months. */
  uint32_t hearing;            /**< MIMO_HEARING_ bits; 0 (default): no hearing. */
  uint32_t voice;              /**< 1: an infant's voice, with four actions after the motors' actions: "voice:loudness",
                                    0 (silent) to 1 (a cry); "voice:pitch", -0.5 to 0.5 octaves; "voice:opening" and
                                    "voice:front", 0.7 to 1.3 times the first and second formant of its age. Every agent
                                    with hearing hears it, see docs/guide/hearing.md. 0 (default): no voice. */
  double strength;             /**< Factor of what an infant's motors and muscles can do, 0.01 to 100, at any age on top
                                    of its growth's; 0 (default): 1. It is in MIMO_ACTUATOR_GEAR of worlds, not in the
                                    MJCF of scenes. Not with MIMO_ACTUATION_POSITION, which uses no motors. */
} mimo_agent_config;

/**
 * Fills a config with defaults: the mitten body at the scene's place, with proprioception, balance, touch and colour
 * vision.
 * @param size sizeof(mimo_agent_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_agent_config_init(mimo_agent_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Fills a config with the scene's defaults for its next infant: its body (static string), its position and orientation
 * (they apply if you set place to MIMO_PLACE_ROOT; 0 0 0 if all places are taken), and, in scenes made for a task, the
 * senses of that task; in catch muscles; everything else as mimo_agent_config_init.
 * @param size sizeof(mimo_agent_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_scene_default_agent(const mimo_scene *scene, mimo_agent_config *config,
                                              size_t size) MIMO_NOEXCEPT;

/**
 * Adds an infant.
 *
 * If neither the scene nor the config gives a place to the first infant, it stands at the origin on a fixed surface
 * (the one nearest to height 0 with room for it) or, if something is in its way, up to 4 m beside it. The place is
 * computed when a world is made, with everything that the scene then has. A warning goes to the scene's log if an
 * infant starts more than 5 mm inside something, at a given place or because there is no free one.
 * @param config NULL means the scene's defaults, see mimo_scene_default_agent.
 * @param agent  receives its number, 0 for the first; may be NULL.
 * Errors: MIMO_E_NOT_FOUND for an unknown body; MIMO_E_INVALID_ARGUMENT for a body that the scene does not support
 * (five fingers in standup), for a name that an agent or a part of the scene has, for a missing name where there are
 * several agents, and when no place is given and the scene has none left; MIMO_E_MODEL for a scene that does not
 * compile where its compiler settings weigh all bodies (settotalmass, ...); MIMO_E_UNSUPPORTED for such settings in a
 * scene with a composite, and for global coordinates.
 */
MIMO_API mimo_status mimo_scene_add_agent(mimo_scene *scene, const mimo_agent_config *config,
                                          size_t *agent) MIMO_NOEXCEPT;

/**
 * Adds all infants that the scene names (the custom text "mimo:infants" of its MJCF, "anna ben"), each at its own
 * place; in a scene that names none, a single one.
 * @param config their common settings; with a name only if the scene gives none, with a place only for a single infant.
 *               NULL: the scene's defaults, see mimo_scene_default_agent.
 * @param count  receives how many were added; may be NULL.
 * Errors: as mimo_scene_add_agent. All of them are added, or none.
 */
MIMO_API mimo_status mimo_scene_add_agents(mimo_scene *scene, const mimo_agent_config *config,
                                           size_t *count) MIMO_NOEXCEPT;

/**
 * Sets the distance between the touch sensors of one part of an infant's body, in place of the standard one.
 * @param body    name of a body without its agent's name, "left_hand"; NULL: every body, which replaces what was set
 *                for single ones before.
 * @param spacing metres, at most 10; touch_scale does not change it; 0: no skin there.
 * Errors: MIMO_E_NOT_FOUND for an unknown body; the message lists the infant's bodies. For an agent with a root the
 *         error comes when an environment is made or senses are attached.
 */
MIMO_API mimo_status mimo_scene_set_touch(mimo_scene *scene, size_t agent, const char *body,
                                          double spacing) MIMO_NOEXCEPT;

/**
 * Chooses the joints that an agent's proprioception reads: the first call replaces the default list, each call adds one
 * joint. Position, velocity, limits and torque about the joint's axis then have one element per call, in that order.
 * @param joint a hinge or slide of the agent, by its name in the model, "anna/robot:left_elbow".
 * Errors: MIMO_E_INVALID_ARGUMENT for a joint that was already chosen. An unknown joint is MIMO_E_NOT_FOUND when an
 *         environment is made or senses are attached; the message lists the agent's joints.
 */
MIMO_API mimo_status mimo_scene_read_joint(mimo_scene *scene, size_t agent, const char *joint) MIMO_NOEXCEPT;

/** Imperfections of a sense or motor. A sense or motor without limits costs nothing. */
typedef struct mimo_limits {
  uint32_t struct_size; /**< sizeof(mimo_limits), set by mimo_limits_init. */
  uint32_t reserved;    /**< 0. */
  double delay;         /**< Delay in seconds, 0 to 2, rounded to time steps of the model (at most 2000; independent of
                             frame_skip) or, with attached senses, to steps. Default 0. */
  double gain;          /**< Factor of all values, 0 to 3.4e38 (the largest float). Default 1. */
  double noise;         /**< Standard deviation of the Gaussian noise that is added, 0 to 3.4e38, in the field's
                             or action's unit (colours: levels of 255). Default 0. */
  double blur;          /**< For colour pictures only: lines of this many cycles per degree keep half their contrast,
                             0.05 to 1000; 0 (default): sharp. */
  double signal_noise;  /**< Standard deviation of further noise as a share of the value, 0 to 1000. Default 0. */
} mimo_limits;

/**
 * Fills limits with defaults: a perfect sense or motor.
 * @param size sizeof(mimo_limits) as the caller knows it.
 */
MIMO_API mimo_status mimo_limits_init(mimo_limits *limits, size_t size) MIMO_NOEXCEPT;

/**
 * Limits a sense of an agent, or a part of one, for environments made and senses attached from now on. The order is
 * blur, gain, delay, noise. Until the delay has passed, the agent senses the first values of the episode. The result is
 * clipped to the bounds of its field, or to the largest float. The noise is determined by the world's seed, the time
 * step and the field's name: it is the same in every run and for every observation of a step. Delayed values are part
 * of the world's state; an episode senses nothing of the one before.
 * @param path   a field without its agent's name, "vision/eye_left", or all fields below a path, "touch". If several
 *               calls set a field, the last one applies. Gain and noise of "vision" do not apply to depth and
 *               segmentation unless the path names them.
 * @param limits NULL: a perfect sense.
 * Errors, from mimo_env_create and mimo_senses_attach: MIMO_E_NOT_FOUND for a path without a field, with a list of all
 *         fields; MIMO_E_INVALID_ARGUMENT for a delay of more than 2000 time steps.
 */
MIMO_API mimo_status mimo_scene_limit_sense(mimo_scene *scene, size_t agent, const char *path,
                                            const mimo_limits *limits) MIMO_NOEXCEPT;

/**
 * Limits the path from an agent's actions to its motors, for environments made from now on. Actions are clipped to
 * their bounds, multiplied by the gain, given noise, clipped again, and delayed. Until the first action arrives, motors
 * are as at the start of the episode. Each step with actions draws new noise, determined by the world's seed, the step
 * and the action's name. Commands in transit are part of the world's state; an episode receives nothing of the one
 * before. Tasks see the controls that arrive.
 * @param path   a motor's name, "act:left_elbow"; one of its muscles, "act:left_elbow/negative"; a part of the body, as
 *               the MIMO_ACT_ constants name it: "trunk", "head", "eyes", "right_arm", "left_arm", "right_hand",
 *               "left_hand", "right_leg", "left_leg", "right_foot", "left_foot"; or "" for all. If several calls set an
 *               action, the last one applies.
 * @param limits NULL: a perfect motor. Noise is in the action's unit, as mimo_action gives it; blur must be 0.
 * Errors, from mimo_env_create: MIMO_E_NOT_FOUND for a path without a motor, with a list of the agent's motors;
 *         MIMO_E_INVALID_ARGUMENT for a delay of more than 2000 time steps. mimo_senses_attach refuses limits of motors
 *         with MIMO_E_UNSUPPORTED, because the host commands them.
 */
MIMO_API mimo_status mimo_scene_limit_motor(mimo_scene *scene, size_t agent, const char *path,
                                            const mimo_limits *limits) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
