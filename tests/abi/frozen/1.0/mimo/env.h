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

/** A world: physics, agents, senses and task. */
typedef struct mimo_env mimo_env;

#define MIMO_DISABLE_CONTACT 0x1u /**< No contacts. */
#define MIMO_DISABLE_GRAVITY 0x2u /**< No gravity. */

/** Settings of a world. */
typedef struct mimo_env_config {
  uint32_t struct_size;    /**< sizeof(mimo_env_config), set by mimo_env_config_init. */
  uint32_t frame_skip;     /**< Physics steps per environment step, 1 to 1000; each is one time step of the model, 5 ms
                                in built-in scenes. 0 (default): the scene's, usually 2. */
  int32_t jacobian;        /**< A MIMO_JACOBIAN_ constant. */
  uint32_t disable;        /**< MIMO_DISABLE_ bits. */
  const char *renderer;    /**< "ray": libmimo's, on the CPU; "osmesa", "gl": MuJoCo's, on the CPU or a graphics card;
                                "none": no pictures, vision must be off; "auto" (default, and NULL): ray if the scene
                                allows it, else osmesa. */
  uint32_t max_steps;      /**< Steps after which an episode is truncated; 0: the task's parameter episode_steps. */
  uint32_t timing;         /**< 1: enables mimo_env_timing; costs a few clock reads per step. */
  mimo_log_fn log;         /**< Receives messages during create, reset and step, or NULL. */
  void *log_user;          /**< Passed to log. */
  const char *task;        /**< See mimo_task_name; NULL: the scene's. Every agent performs the task separately. */
  uint32_t render;         /**< MIMO_RENDER_ bits: effects that pictures show; the others cost nothing. Default: all
                                except fog. */
  uint32_t samples;        /**< Samples per pixel for smooth edges: 1, 4, 16 or 64 (OpenGL may use fewer); 0: one ray,
                                or the model's setting for OpenGL. */
  uint32_t render_threads; /**< Threads of the ray renderer for one picture, 1 to 64, including the caller's. They do
                                not change pictures. Default 1, the best choice in batches. */
  uint32_t step_contacts;  /**< 1: records the contacts of each step (MIMO_STEP_CONTACT). Default 0, at no cost. */
} mimo_env_config;

/**
 * Fills a config with defaults.
 * @param size sizeof(mimo_env_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_env_config_init(mimo_env_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene and makes a world at the scene's stored state, at time 0, with the random numbers of seed 0. Reset
 * it before the first step: only a reset lets the task prepare an episode. A step before the first reset is accepted;
 * it starts from the scene's stored state, where the task has prepared nothing and drawn no goal.
 * Note: MuJoCo's XML loader calls srand(123), the only process state that changes.
 * @param scene  is not needed afterwards.
 * @param config NULL means defaults.
 * Errors: MIMO_E_MODEL with file and line; MIMO_E_NOT_FOUND for an unknown task; MIMO_E_INVALID_ARGUMENT for a scene
 *         without agents, unless its task is "none" (a built-in scene then logs a message that mimo_scene_add_agents
 *         would add its infants); MIMO_E_UNSUPPORTED if vision is on and no renderer works on this machine, if the
 *         program's C++ locale has a decimal comma, or if another version of MuJoCo is in the program's global scope.
 */
MIMO_API mimo_status mimo_env_create(const mimo_scene *scene, const mimo_env_config *config,
                                     mimo_env **env) MIMO_NOEXCEPT;

/**
 * Makes a world of a built-in scene with its infants and task, all with defaults, in one call. Where something is to be
 * set, the same in steps: mimo_scene_config_init, the scene's name, mimo_scene_create; mimo_scene_default_agent,
 * mimo_scene_add_agents; mimo_env_config_init, mimo_env_create; mimo_scene_destroy. docs/guide/first-program.md has it
 * as a program.
 * @param scene_name see mimo_scene_name.
 * @param env        receives the handle; destroy it with mimo_env_destroy.
 * Errors: MIMO_E_NOT_FOUND for an unknown scene; the others as mimo_env_create.
 */
MIMO_API mimo_status mimo_env_make(const char *scene_name, mimo_env **env) MIMO_NOEXCEPT;

/** Destroys a world. NULL and destroyed handles are ignored. */
MIMO_API void mimo_env_destroy(mimo_env *env) MIMO_NOEXCEPT;

/** Describes one agent of a world. */
typedef struct mimo_agent_info {
  uint32_t struct_size;   /**< sizeof(mimo_agent_info), set by the caller. */
  uint32_t action_offset; /**< Index of its first action in the action array. */
  uint32_t action_count;  /**< Number of its actions. */
  uint32_t reserved;      /**< 0. */
  const char *name;       /**< Owned by the environment, until a reset to another age. */
  double mass;            /**< Mass of its body in the model, kg; setting MIMO_BODY_MASS does not change it. */
  double height;          /**< Vertical extent of its geoms in the initial pose qpos0, metres. */
} mimo_agent_info;

/** Layout of the world's observations, actions and rewards. */
MIMO_API mimo_status mimo_env_layout(const mimo_env *env, const mimo_layout **layout) MIMO_NOEXCEPT;

/** Name of the task. The environment owns the string, until a reset to another age. */
MIMO_API mimo_status mimo_env_task(const mimo_env *env, const char **name) MIMO_NOEXCEPT;

/** Physics steps per environment step: frame_skip of the config, or the scene's. */
MIMO_API mimo_status mimo_env_frame_skip(const mimo_env *env, uint32_t *frame_skip) MIMO_NOEXCEPT;

/** Describes the index-th agent. Set info->struct_size first. */
MIMO_API mimo_status mimo_env_agent(const mimo_env *env, size_t index, mimo_agent_info *info) MIMO_NOEXCEPT;

/** How an episode starts. A struct that is zero except for struct_size has the same effect as NULL. */
typedef struct mimo_reset_config {
  uint32_t struct_size; /**< sizeof(mimo_reset_config), set by the caller. */
  uint32_t seeded;      /**< 1: the random numbers restart from seed; 0: they continue. */
  uint64_t seed;        /**< Any number; 0 if seeded is 0. */
  /** The infants' new age and size: one growth for all, or one per agent, where NULL keeps that agent's. */
  const mimo_growth *const *growth;
  size_t growth_count; /**< 0: no change; 1: for all infants; else the number of agents. */
} mimo_reset_config;

/**
 * Starts an episode from the scene's stored state, prepared by the task. The random numbers of a world that was never
 * seeded start as with seed 0.
 *
 * A growth that differs from the infants' gives the world another model. Its handle and layout stay: names, shapes and
 * offsets are unchanged, bounds and receptors are updated. Ids remain valid; strings other than the layout's do not:
 * ask for them again. Random numbers continue; gravity, faces, timing and counts of warnings stay. Other values that
 * survive resets are as in a new world, because they belonged to the previous body. A world, its clones and a batch
 * compile each age once; they keep the last 8 and all that are in use.
 * @param config NULL: the random numbers continue.
 * @param block  receives the observation, as from mimo_env_observe: at least block_bytes of mimo_layout_info; NULL with
 *               block_bytes 0 skips the senses.
 * Errors: for a growth as mimo_growth says, and MIMO_E_INVALID_ARGUMENT if it changes the shape of the observation
 *         (keep_spacing); MIMO_E_TASK if a custom task fails: with another age nothing has changed, otherwise the world
 *         is at the scene's stored state as far as the task has prepared it.
 */
MIMO_API mimo_status mimo_env_reset(mimo_env *env, const mimo_reset_config *config, void *block,
                                    size_t block_bytes) MIMO_NOEXCEPT;

#define MIMO_OUTCOME_NONE 0     /**< Neither. */
#define MIMO_OUTCOME_SUCCESS 1  /**< The agent reached its task's goal. */
#define MIMO_OUTCOME_FAILURE -1 /**< It failed. */

/** Buffers for the results of a step besides the observation. Each may be NULL. */
typedef struct mimo_env_results {
  uint32_t struct_size; /**< sizeof(mimo_env_results), set by the caller. */
  uint32_t reserved;    /**< 0. */
  double *reward;       /**< One per agent. */
  uint8_t *terminated;  /**< One per agent: 1 if its episode ended by success or failure. */
  uint8_t *truncated;   /**< One per agent: 1 if its step limit or its task cuts the episode off. */
  int32_t *outcome;     /**< One per agent: a MIMO_OUTCOME_ constant, also if it does not end the episode. */
  size_t agent_count;   /**< Length of the four arrays above: agents of mimo_layout_info. */
  double *terms;        /**< The terms of all agents' rewards (each reward is their sum), see mimo_layout_term. */
  size_t term_count;    /**< Length of terms: terms of mimo_layout_info. */
} mimo_env_results;

/**
 * Simulates one step: sets the motors, runs frame_skip physics steps, senses, computes rewards. After the end of an
 * episode the world simply continues: truncated stays 1 until a reset, terminated follows the task in each step.
 * @param action       all agents' actions, clipped to their bounds (mimo_layout_action); NULL with action_count 0
 *                     leaves the controls unchanged (0 after a reset, or as set by mimo_env_set).
 * @param action_count actions of mimo_layout_info, or 0.
 * @param block        receives the observation, every byte of it: at least block_bytes of mimo_layout_info; NULL with
 *                     block_bytes 0 skips the senses.
 * @param results      may be NULL.
 * Errors: MIMO_E_INVALID_ARGUMENT for a NaN in action, or an infinite one without bounds: nothing happens.
 *         MIMO_E_SIMULATION if the physics fails or diverges: block and results are unspecified. The world can then be
 *         read (names, values, sizes), and values that survive resets can be written; every function that simulates,
 *         senses, draws, writes other values, saves or clones returns MIMO_E_SIMULATION until the world is reset or
 *         loads a state.
 *         MIMO_E_TASK if a custom task or sense fails, whatever it returned: the step has happened, block is written,
 *         and results are where no task failed. MIMO_E_BUSY from within a task of this world: nothing happens.
 */
MIMO_API mimo_status mimo_env_step(mimo_env *env, const float *action, size_t action_count, void *block,
                                   size_t block_bytes, const mimo_env_results *results) MIMO_NOEXCEPT;

/**
 * Observes the current state without changing the trajectory. All fields belong to the current state, so after a step
 * it differs from the step's block in the fields whose time ends before 0. Until the next step mimo_env_get also
 * returns values of the current state.
 * Errors: MIMO_E_SIMULATION for a world that has failed, or fails now because positions, velocities or accelerations
 *         are infinite or exceed 1e10; the block is not written.
 */
MIMO_API mimo_status mimo_env_observe(mimo_env *env, void *block, size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Runs physics steps with unchanged controls, without senses and task. Muscles keep pulling and adapting their
 * activation; delayed actions do not arrive. For measuring the cost of MuJoCo alone, and for hosts with their own
 * senses and control.
 * @param count 0 to 1000000.
 * Errors: MIMO_E_SIMULATION as mimo_env_step; MIMO_E_BUSY from within a task of this world.
 */
MIMO_API mimo_status mimo_env_physics_step(mimo_env *env, size_t count) MIMO_NOEXCEPT;

/** Simulated seconds since the last reset. */
MIMO_API mimo_status mimo_env_time(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

/** Length of one physics step, seconds. One environment step takes step_seconds of mimo_layout_info. */
MIMO_API mimo_status mimo_env_timestep(const mimo_env *env, double *seconds) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
