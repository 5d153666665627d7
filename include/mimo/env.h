/**
 * @file mimo/env.h
 * Environments: one simulated world with its agents' senses.
 */
#ifndef MIMO_ENV_H
#define MIMO_ENV_H

#include "growth.h"
#include "observation.h"
#include "scene.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/** How a world is simulated. */
typedef struct mimo_env_config {
  uint32_t struct_size;    /**< sizeof(mimo_env_config), set by mimo_env_config_init. */
  uint32_t frame_skip;     /**< Physics steps per environment step, 1 to 1000; each is one time step of the model, 5 ms
                                in built-in scenes. Default 0: the scene's own, mostly 2. */
  int32_t jacobian;        /**< A MIMO_JACOBIAN_ constant. */
  uint32_t disable;        /**< MIMO_DISABLE_ bits. */
  const char *renderer;    /**< "ray" (our own, on the CPU), "auto" (default): ray where the scene allows, else osmesa;
                                "osmesa", "gl" (MuJoCo's, on the CPU or a graphics card); "none": eyes must be off. */
  uint32_t max_steps;      /**< Steps after which an episode is truncated; 0: the task's parameter episode_steps. */
  uint32_t timing;         /**< 1: mimo_env_timing counts; costs a few clock reads a step. */
  mimo_log_fn log;         /**< Messages during create, reset and step, or NULL. */
  void *log_user;          /**< Passed to log. */
  const char *task;        /**< See mimo_task_name; NULL: the scene's own. Every agent has the task for itself. */
  uint32_t render;         /**< MIMO_RENDER_ bits: what pictures show; what is left out costs nothing. Default: all but
                                fog. */
  uint32_t samples;        /**< Samples a pixel for smooth edges: 1, 4, 16 or 64 (OpenGL may give fewer); 0: one ray, or
                                what the model tells OpenGL. */
  uint32_t render_threads; /**< Threads that draw one picture with the ray renderer, 1 to 64, the caller's among them.
                                Pictures do not differ. Default 1, which is best in batches. */
  uint32_t step_contacts;  /**< 1: what touched what during a step is recorded (MIMO_STEP_CONTACT). Default 0, which
                                costs nothing. */
} mimo_env_config;

/**
 * Fills a config with defaults.
 * @param size sizeof(mimo_env_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_env_config_init(mimo_env_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene and makes a world of it, in its initial state. No task has prepared an episode then: reset it first.
 * Note: MuJoCo's XML loader calls srand(123), the one piece of process state that is touched.
 * @param scene  is not needed any more afterwards.
 * @param config NULL means defaults.
 * Errors: MIMO_E_MODEL with file and line; MIMO_E_NOT_FOUND for an unknown task; MIMO_E_INVALID_ARGUMENT for any task
 *         except "none" in a scene without agents (of a built-in scene without task and agents the log tells);
 *         MIMO_E_UNSUPPORTED when eyes are on and no renderer works here, when the program's C++ locale has a decimal
 *         comma, or when a MuJoCo of another version lies in the program's global scope.
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
  double mass;            /**< Of its whole body in its model, kg; MIMO_BODY_MASS may say otherwise since. */
  double height;          /**< Vertical extent of its geoms in the initial pose qpos0, metres. */
} mimo_agent_info;

/** What a world observes, acts with and is rewarded for. */
MIMO_API mimo_status mimo_env_layout(const mimo_env *env, const mimo_layout **layout) MIMO_NOEXCEPT;

/** Name of the task. The string is owned by the environment. */
MIMO_API mimo_status mimo_env_task(const mimo_env *env, const char **name) MIMO_NOEXCEPT;

/** Physics steps per environment step. */
MIMO_API mimo_status mimo_env_frame_skip(const mimo_env *env, uint32_t *frame_skip) MIMO_NOEXCEPT;

/** Describes the index-th agent. Set info->struct_size first. */
MIMO_API mimo_status mimo_env_agent(const mimo_env *env, size_t index, mimo_agent_info *info) MIMO_NOEXCEPT;

/** How an episode starts. Who sets nothing but struct_size gets what NULL gives. */
typedef struct mimo_reset_config {
  uint32_t struct_size; /**< sizeof(mimo_reset_config), set by the caller. */
  uint32_t seeded;      /**< 1: the random numbers start anew from seed; 0: they go on. */
  uint64_t seed;        /**< Any number; 0 where seeded is 0. */
  /** What infants become: one growth for all of them, or one for each agent, of which NULL stay as they are. */
  const mimo_growth *const *growth;
  size_t growth_count; /**< 0: all stay as they are; 1: all infants; else as many as there are agents. */
} mimo_reset_config;

/**
 * Starts an episode: from the scene's stored state, as its task wants it.
 *
 * With a growth that its infants do not have yet the world has another model afterwards. Its handle stays and so does
 * its layout: names, shapes and offsets as before, bounds and receptors those of the new bodies. Ids stay; names, but
 * for the layout's, are to be asked for again. Random numbers go on; gravity, faces, timing, counts of warnings stay.
 * All else that was set and outlives resets is as in a new world, for it belonged to another body. A world, its clones
 * and a batch compile each age once: they keep the last 8, and those in use.
 * @param config NULL: the world's random numbers go on.
 * @param block  receives the observation, as mimo_env_observe gives it; may be NULL with block_bytes 0.
 * Errors: with a growth as mimo_growth says, and MIMO_E_INVALID_ARGUMENT where it would change the shape of the
 *         observation (keep_spacing); MIMO_E_TASK where a task of your own fails. With another age nothing has changed.
 */
MIMO_API mimo_status mimo_env_reset(mimo_env *env, const mimo_reset_config *config, void *block,
                                    size_t block_bytes) MIMO_NOEXCEPT;

#define MIMO_OUTCOME_NONE 0     /**< Neither. */
#define MIMO_OUTCOME_SUCCESS 1  /**< The agent has done what its task wants. */
#define MIMO_OUTCOME_FAILURE -1 /**< It has failed. */

/** Where the results of a step go, beside the observation. All are optional: NULL is not written. */
typedef struct mimo_env_results {
  uint32_t struct_size; /**< sizeof(mimo_env_results), set by the caller. */
  uint32_t reserved;    /**< 0. */
  double *reward;       /**< One per agent. */
  uint8_t *terminated;  /**< One per agent, 1 when its episode has ended by success or failure. */
  uint8_t *truncated;   /**< One per agent, 1 when its episode is cut off: by its step limit, or by its task. */
  int32_t *outcome;     /**< One per agent, a MIMO_OUTCOME_ constant, also where that does not end the episode. */
  size_t agent_count;   /**< Length of the four arrays above, as mimo_layout_info says. */
  double *terms;        /**< The terms that rewards are the sums of, of all agents, as mimo_layout_term names them. */
  size_t term_count;    /**< Length of terms, as mimo_layout_info says. */
} mimo_env_results;

/**
 * Goes one step on: sets the motors, runs frame_skip physics steps, senses, rewards.
 * @param action  all agents' actions, clipped to their bounds; NULL with action_count 0 leaves the
 *                controls as they are (0 after a reset, or as set by mimo_env_set).
 * @param block   receives the observation, every byte of it; NULL with block_bytes 0 skips the senses.
 * @param results NULL: not wanted.
 * Errors: MIMO_E_INVALID_ARGUMENT for a NaN in action, or an infinite one without bounds (nothing happens then);
 *         MIMO_E_SIMULATION when the physics fails or diverges: block and results are then unspecified. Until the
 *         world is reset or loads a state, it can be looked at (names, values, sizes), and what outlives resets can be
 *         written; whatever would simulate, sense, draw, write the rest, save or clone answers MIMO_E_SIMULATION.
 *         MIMO_E_TASK when a task of your own fails, whatever it returned: the step has happened then, block is written
 *         and results are not. MIMO_E_BUSY from within a task of this world: nothing happens then.
 */
MIMO_API mimo_status mimo_env_step(mimo_env *env, const float *action, size_t action_count, void *block,
                                   size_t block_bytes, const mimo_env_results *results) MIMO_NOEXCEPT;

/** Where joints go in a step. */
typedef struct mimo_movement {
  uint32_t struct_size;    /**< sizeof(mimo_movement), set by the caller. */
  uint32_t reserved;       /**< 0. */
  const double *positions; /**< frame_skip x the positions of all joints, as MIMO_JOINT_POSITION has them one after the
                                other: at the end of each physics step. Quaternions are normalised. */
  size_t position_count;   /**< Length of positions. */
  double *forces;          /**< Receives frame_skip x one for each degree of freedom: N, or Nm; or NULL. */
  size_t force_count;      /**< Length of forces. */
} mimo_movement;

/**
 * One step of a movement that is known, from video or motion capture: joints go where they are told, whatever stands in
 * their way, and all senses answer as if they had gone there by themselves. Velocities and accelerations follow from
 * positions as in a step of physics: velocity at the end is the difference over a physics step, so whoever starts a
 * movement sets MIMO_JOINT_POSITION and MIMO_JOINT_VELOCITY first. Contacts give way, and are felt, as they would with
 * these accelerations. Motors pull as their controls are, which changes nothing; no task
 * judges, no reflex acts, and no late action arrives.
 *
 * The forces are those of inverse dynamics: what has to act beside gravity, contacts, limits, locks, springs and
 * dampers of the joints, at the start of each physics step. Of an infant lying there these are its muscles; those of
 * the first six degrees of freedom, its free joint, are what is missing from its contacts.
 * @param block receives the observation; NULL with block_bytes 0 skips the senses.
 * Errors: MIMO_E_INVALID_ARGUMENT for numbers that are not finite and quaternions of length 0 (nothing happens then);
 *         MIMO_E_UNSUPPORTED for models with another integrator than Euler; MIMO_E_SIMULATION as mimo_env_step, also
 *         where positions, or the velocities and accelerations to get there, are larger than 1e10: the block stays as
 *         it was then.
 */
MIMO_API mimo_status mimo_env_follow(mimo_env *env, const mimo_movement *movement, void *block,
                                     size_t block_bytes) MIMO_NOEXCEPT;

/**
 * The observation of the current state, without changing the trajectory. All its fields belong to the current
 * state, so after a step it differs from the step's block in the fields whose time ends before 0. Until the next
 * step mimo_env_get gives values of the current state, too.
 * Errors: MIMO_E_SIMULATION for a world that has failed, or now does: where positions, velocities or accelerations are
 *         infinite or larger than 1e10; the block stays as it was then.
 */
MIMO_API mimo_status mimo_env_observe(mimo_env *env, void *block, size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Bare physics: count physics steps with the controls as they are, without senses and task. Muscles pull on and adapt
 * their activation; no action is on its way. What MuJoCo alone costs; also for hosts that bring senses and control of
 * their own.
 * @param count 0 to 1000000.
 * Errors: MIMO_E_SIMULATION as mimo_env_step; MIMO_E_BUSY from within a task of this world.
 */
MIMO_API mimo_status mimo_env_physics_step(mimo_env *env, size_t count) MIMO_NOEXCEPT;

/** Simulated seconds since reset. */
MIMO_API mimo_status mimo_env_time(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

/** Length of one physics step, seconds. */
MIMO_API mimo_status mimo_env_timestep(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

/* Timing: where a step's time goes. */

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
  double hearing;        /**< What sounds, and what reaches ears. */
} mimo_timing;

/** Reads the timing; all zero unless the environment was made with timing = 1. Set timing->struct_size first. */
MIMO_API mimo_status mimo_env_timing(const mimo_env *env, mimo_timing *timing) MIMO_NOEXCEPT;

/** Starts counting anew. */
MIMO_API mimo_status mimo_env_timing_reset(mimo_env *env) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
