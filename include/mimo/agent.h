/**
 * @file mimo/agent.h
 * Agents of a scene: where they are, what they sense, what of them acts.
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
#define MIMO_PROPRIOCEPTION_ACTUATION 0x08u    /**< Controls and torques of motors, targets, or what muscles do. */
#define MIMO_PROPRIOCEPTION_JOINT_TORQUE 0x10u /**< Torque about each joint's own axis, Nm. */
#define MIMO_PROPRIOCEPTION_POSITION 0x20u     /**< Joint angles, rad. */
#define MIMO_PROPRIOCEPTION_EFFORT 0x40u       /**< proprioception/effort, 0 to 1: see docs/guide/muscles.md. */
/** What nerves of muscles and joints tell, Hz: see docs/guide/proprioception.md. None by default. */
#define MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY 0x80u    /**< proprioception/spindle_primary, two muscles a motor: Ia. */
#define MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY 0x100u /**< proprioception/spindle_secondary, likewise: II. */
#define MIMO_PROPRIOCEPTION_TENDON_ORGAN 0x200u      /**< proprioception/tendon_organ, likewise: Ib. */
#define MIMO_PROPRIOCEPTION_JOINT_RECEPTOR 0x400u    /**< proprioception/joint_receptor, joints x 2: near its ends. */
#define MIMO_PROPRIOCEPTION_ALL 0x80000000u          /**< All that the loaded library has. */

#define MIMO_VISION_RGB 0x01u          /**< Colour, uint8 H x W x 3, row 0 is the top. */
#define MIMO_VISION_DEPTH 0x02u        /**< Depth along the camera's axis, float32 H x W, metres. */
#define MIMO_VISION_SEGMENTATION 0x04u /**< Geom id of each pixel, int32 H x W, -1 is background. */

#define MIMO_VESTIBULAR_ACCELERATION 0x1u     /**< vestibular/acceleration, 3, m/s^2, gravity included. */
#define MIMO_VESTIBULAR_ANGULAR_VELOCITY 0x2u /**< vestibular/angular_velocity, 3, rad/s. */
#define MIMO_VESTIBULAR_CANALS 0x4u           /**< vestibular/canals, 6 x 2, Hz: see docs/guide/balance.md. */
#define MIMO_VESTIBULAR_OTOLITHS 0x8u         /**< vestibular/otoliths, 2 x 2 x 2 x 2, Hz: likewise. */
#define MIMO_VESTIBULAR_GRAVITY 0x10u         /**< vestibular/gravity, 3, m/s^2: where up is, as it is estimated. */

#define MIMO_HEARING_EARS 0x1u  /**< hearing/ear_left, hearing/ear_right: sound of the step at both ears, Pa. */
#define MIMO_HEARING_BANDS 0x2u /**< hearing/bands, 2 x 24, dB above threshold; hearing/time_difference, s. */

#define MIMO_PLACE_SCENE 0  /**< The scene's own place for an infant. */
#define MIMO_PLACE_ROOT 1   /**< The origin of its root body mimo_location; standing soles are 0.33 m below. */
#define MIMO_PLACE_SOLES 2  /**< The middle between its feet from above, at the height of the lowest point of them. */
#define MIMO_PLACE_LOWEST 3 /**< Its root body from above, at the height of its lowest point: it lies on that height. */

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
#define MIMO_ACT_ALL 0x80000000u   /**< All that the loaded library has. */
#define MIMO_ACT_NONE 0x40000000u  /**< No motor at all; excludes the other bits. */

/** Reflexes of newborns, which add to the agent's commands by its age: see docs/guide/reflexes.md. */
#define MIMO_REFLEX_PALMAR_GRASP 0x1u           /**< Fingers close on what presses on the palm; needs five fingers. */
#define MIMO_REFLEX_PLANTAR_GRASP 0x2u          /**< Toes curl under what presses on the ball of the foot. */
#define MIMO_REFLEX_ROOTING 0x4u                /**< The head turns to what touches a corner of the mouth. */
#define MIMO_REFLEX_MORO 0x8u                   /**< A head that drops: arms open, then close. */
#define MIMO_REFLEX_ASYMMETRIC_TONIC_NECK 0x10u /**< The head turned aside: limbs stretch there, bend opposite. */
#define MIMO_REFLEX_STEPPING 0x20u              /**< Upright on its feet, leaning forward: legs step in turn. */
#define MIMO_REFLEX_WITHDRAWAL 0x40u            /**< Legs draw back from what touches or pricks one. */
#define MIMO_REFLEX_FELT 0x40000000u            /**< reflex/activation has all that this body can do. */
#define MIMO_REFLEX_ALL 0x80000000u             /**< All that this body can do, of those of the loaded library. */

#define MIMO_TOUCH_FORCE 0x1u        /**< touch/force, N x 3: normal force and friction, N. */
#define MIMO_TOUCH_NORMAL_FORCE 0x2u /**< touch/force, N x 1: the normal force alone, N; instead of MIMO_TOUCH_FORCE. */
#define MIMO_TOUCH_SLIP 0x4u         /**< touch/slip, N x 2: how it slides over the skin, along its tangents, m/s. */
#define MIMO_TOUCH_FRICTION_USE 0x8u /**< touch/friction_use, N x 1: share of the possible friction in use; 1: all. */

/** What nerves of the skin tell, N a field: see docs/guide/skin.md. Hz but where it says otherwise; none by default. */
#define MIMO_TOUCH_SA1 0x10u                /**< touch/sa1: how deep the skin is pressed. */
#define MIMO_TOUCH_RA 0x20u                 /**< touch/ra: how fast that changes, and sliding. */
#define MIMO_TOUCH_PC 0x40u                 /**< touch/pc: jolts and vibration, as an envelope. */
#define MIMO_TOUCH_SA2 0x80u                /**< touch/sa2, N x 2: stretch along the sensor's two tangents. */
#define MIMO_TOUCH_TEMPERATURE 0x100u       /**< touch/temperature: of the skin's surface, degrees Celsius. */
#define MIMO_TOUCH_COLD 0x200u              /**< touch/cold. */
#define MIMO_TOUCH_WARM 0x400u              /**< touch/warm. */
#define MIMO_TOUCH_NOCICEPTION_FAST 0x800u  /**< touch/nociception_fast: pricks and heat, at once. */
#define MIMO_TOUCH_NOCICEPTION_SLOW 0x1000u /**< touch/nociception_slow: the same and cold, late and lasting. */
#define MIMO_TOUCH_UNITS 0x2000u            /**< touch/units, N x 4: SA1, RA, PC, SA2 that a sensor stands for. */

#define MIMO_RESPONSE_NEAREST 1  /**< The nearest sensor feels all of a touch. */
#define MIMO_RESPONSE_LINEAR 2   /**< Weights fall linearly with the distance along the skin, to 0 at 2 spacings. */
#define MIMO_RESPONSE_GAUSSIAN 3 /**< Weights fall as a bell of deviation 2/3 spacing, cut off at 2 spacings. */

#define MIMO_FRAME_BODY 1  /**< The frame of the body that the sensor sits on. */
#define MIMO_FRAME_WORLD 2 /**< The frame of the world. */
#define MIMO_FRAME_SKIN 3  /**< Of the skin at the sensor: outward normal, two tangents; see MIMO_RECEPTOR_FRAME. */

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
 *   - has no face, no gaze, no reflexes, and its only task is "none" or one of your own.
 */
typedef struct mimo_agent_config {
  uint32_t struct_size;        /**< sizeof(mimo_agent_config), set by mimo_agent_config_init. */
  int32_t place;               /**< A MIMO_PLACE_ constant: which point of it lies at position. Default: the scene's. */
  const char *name;            /**< "" for a sole agent; else the prefix of its fields and model names, "anna/...". */
  const char *body;            /**< "mitten", "fingers" (five fingers, a big toe); with "-mirrored" after it left is
                                    the image of right. Or "scene": the body is part of the scene's MJCF. */
  double position[3];          /**< Of the point that place says, m, world frame; without meaning with PLACE_SCENE. */
  double orientation[4];       /**< Of the root body, w x y z; need not be normalised. */
  uint32_t proprioception;     /**< MIMO_PROPRIOCEPTION_ bits; 0: no proprioception. Default, as the original:
                                    all but JOINT_TORQUE, EFFORT and what nerves tell. */
  uint32_t vestibular;         /**< MIMO_VESTIBULAR_ bits; 0: no sense of balance. Default: the first two. */
  double limit_threshold;      /**< Limit sensors work this near to a limit; radians, > 0. Default 0.035. */
  uint32_t vision;             /**< MIMO_VISION_ bits of both eyes; 0: no vision. Default MIMO_VISION_RGB. */
  uint32_t vision_width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t vision_height;      /**< Pixels, 1 to 4096. Default 256. */
  int32_t actuation;           /**< A MIMO_ACTUATION_ constant. Default torque. */
  double vision_fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own (60). */
  double vision_foveation;     /**< Of colour: the middle is shown L / ln(1 + L) times as large and the rim small, 0.01
                                    to 100; 0 (default): as drawn. See mimo_layout_directions. */
  uint32_t acts;               /**< MIMO_ACT_ bits: parts that have motors; 0: the scene's own choice. */
  uint32_t normalize_actions;  /**< 1: actions go from -1 to 1, mapped linearly to their range; 0: their own range. */
  uint32_t touch;              /**< MIMO_TOUCH_ output bits; 0: no touch. Default MIMO_TOUCH_FORCE. */
  int32_t touch_response;      /**< MIMO_RESPONSE_NEAREST, _LINEAR (default) or _GAUSSIAN: who feels how much. */
  int32_t touch_frame;         /**< MIMO_FRAME_BODY (default), _WORLD or _SKIN: of touch/force with three components. */
  uint32_t reflexes;           /**< MIMO_REFLEX_ bits, felt as reflex/activation; 0 (default): none. */
  double touch_scale;          /**< Divides the usual distances between sensors: 2 makes 4 times as many. Default 1. */
  double touch_slip_threshold; /**< Slip below counts as none: MuJoCo's friction creeps. m/s, >= 0. Default 0.005. */
  const char *face;            /**< The face that it shows at first, see mimo_face_name; NULL: neutral. */
  const char *root;            /**< With body "scene": the body of the model that the agent consists of, with all below
                                    it; "world": everything. NULL: an infant. */
  const char *vestibular_at;   /**< Site or body whose motion the vestibular sense feels; NULL: the infant's head. */
  const mimo_growth *growth;   /**< How old it is; NULL: 18 months. */
  uint32_t hearing;            /**< MIMO_HEARING_ bits; 0 (default): it is deaf. */
  uint32_t voice;              /**< 1: an infant's voice, four more actions after those of motors: "voice:loudness", 0
                                    (silent) to 1 (a cry); "voice:pitch", -0.5 to 0.5 octaves; "voice:opening" and
                                    "voice:front", 0.7 to 1.3 times the first and second formant of its age. Heard
                                    where an agent hears, see docs/guide/hearing.md. 0 (default): none. */
} mimo_agent_config;

/**
 * Fills a config with defaults: the mitten body at the scene's place, which feels its joints, balance and touch, and
 * sees in colour.
 * @param size sizeof(mimo_agent_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_agent_config_init(mimo_agent_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Fills a config with what the scene gives its next infant by itself: its body (static string), its place (position and
 * orientation, which count where place is set to MIMO_PLACE_ROOT; 0 0 0 where all places are taken), and in scenes that
 * are made for a task the senses of that task; in catch muscles; elsewhere the same as mimo_agent_config_init.
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
                                          size_t *agent) MIMO_NOEXCEPT;

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
MIMO_API mimo_status mimo_scene_set_touch(mimo_scene *scene, size_t agent, const char *body,
                                          double spacing) MIMO_NOEXCEPT;

/**
 * Has an agent's proprioception read this joint; the first call takes away all others. Position, velocity, limits and
 * torque about the joint's axis then have one element for each call, in that order.
 * @param joint a hinge or slide of the agent, by its name in the model, "anna/robot:left_elbow".
 * Errors: MIMO_E_INVALID_ARGUMENT for a joint that is read already. A joint that the agent does not have is
 *         MIMO_E_NOT_FOUND when an environment is made or senses are attached; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_read_joint(mimo_scene *scene, size_t agent, const char *joint) MIMO_NOEXCEPT;

/** How much less an agent senses than there is, or does than it wants. What is not limited costs nothing. */
typedef struct mimo_limits {
  uint32_t struct_size; /**< sizeof(mimo_limits), set by mimo_limits_init. */
  uint32_t reserved;    /**< 0. */
  double delay;         /**< Seconds by which it comes late, 0 to 2: the nearest number of time steps of the model,
                             up to 2000, whatever frame_skip is; with attached senses, of steps. Default 0. */
  double gain;          /**< Factor of all values, 0 to 3.4e38 (the largest float). Default 1. */
  double noise;         /**< Standard deviation of the Gaussian noise that is added, 0 to 3.4e38, in the field's
                             or action's unit (colours: levels of 255). Default 0. */
  double blur;          /**< Of pictures in colour, not of motors: lines this fine, in cycles per degree, keep half
                             their contrast; 0 (default): sharp. 0.05 to 1000. */
  double signal_noise;  /**< Standard deviation of further noise as a share of the value, 0 to 1000. Default 0. */
} mimo_limits;

/**
 * Fills limits with those of a perfect sense or motor.
 * @param size sizeof(mimo_limits) as the caller knows it.
 */
MIMO_API mimo_status mimo_limits_init(mimo_limits *limits, size_t size) MIMO_NOEXCEPT;

/**
 * Limits a sense of an agent, or a part of one, for environments made and senses attached from now on. First the
 * picture is blurred, then comes the gain, then the delay, then the noise; before the delay is over, what the episode
 * began with is sensed. What comes out is cut to the bounds of its field, and to the largest float where there are
 * none. The noise follows from the world's seed, the time step and the field's name: it is the same in every run and
 * for any number of looks at a step. What is late is part of the world's state, and no episode senses anything of the
 * one before.
 * @param path   a field without its agent's name, "vision/eye_left", or all fields below a path, "touch". Where several
 *               calls concern a field, the last one counts. Gain and noise of "vision" do not concern depth and
 *               segmentation, unless these are named.
 * @param limits NULL: a perfect sense.
 * Errors: MIMO_E_NOT_FOUND from mimo_env_create and mimo_senses_attach for a path that leads to no field, with a list
 *         of those that there are; MIMO_E_INVALID_ARGUMENT there for a delay of more than 2000 time steps.
 */
MIMO_API mimo_status mimo_scene_limit_sense(mimo_scene *scene, size_t agent, const char *path,
                                            const mimo_limits *limits) MIMO_NOEXCEPT;

/**
 * Limits the way of an agent's actions to its motors, for environments made from now on. Actions are clipped to their
 * bounds; then comes the gain, then the noise, then they are clipped again, then the delay. Until the first arrive,
 * motors are as the episode began. Noise is new in each step with actions and follows from the world's seed, the step
 * and the action's name. What is on its way is part of the world's state, and no episode gets anything of the one
 * before. A task sees the controls that arrive.
 * @param path   a motor by its name, "act:left_elbow", or one of its muscles, "act:left_elbow/negative"; a part of the
 *               body, as MIMO_ACT_ names it: "trunk", "head", "eyes", "right_arm", "left_arm", "right_hand",
 *               "left_hand", "right_leg", "left_leg", "right_foot", "left_foot"; or "", all. Where several calls
 *               concern an action, the last one counts.
 * @param limits NULL: a perfect motor. Noise is in the action's unit, as mimo_action gives it; blur is 0.
 * Errors: MIMO_E_NOT_FOUND from mimo_env_create for a path that leads to no motor, with a list of those that the agent
 *         has; MIMO_E_INVALID_ARGUMENT there for a delay of more than 2000 time steps. mimo_senses_attach refuses
 *         limits of motors with MIMO_E_UNSUPPORTED: the host commands them.
 */
MIMO_API mimo_status mimo_scene_limit_motor(mimo_scene *scene, size_t agent, const char *path,
                                            const mimo_limits *limits) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
