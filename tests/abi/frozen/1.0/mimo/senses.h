/**
 * @file mimo/senses.h
 * Senses on your own simulation: a program that uses MuJoCo by itself gives them its mjModel and mjData.
 * They only look at it; stepping and control stay the host's. Where a sense remembers (one with a delay, see
 * mimo_scene_limit_sense), the host says when an episode starts (mimo_senses_reset) and when a step is over
 * (mimo_senses_advance); looking changes no memory. An environment is nothing but a world with such senses: of the same
 * model in the same states, with the same seed, they give the same bytes.
 */
#ifndef MIMO_SENSES_H
#define MIMO_SENSES_H

#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Senses that are attached to a host's model. Needs itself alone; others may read model and data meanwhile. */
typedef struct mimo_senses mimo_senses;

/** What the host simulates with, and how it is to be looked at. */
typedef struct mimo_senses_config {
  uint32_t struct_size;    /**< sizeof(mimo_senses_config), set by mimo_senses_config_init. */
  int32_t mujoco_version;  /**< mj_version() of the host, which has to set it: that of mimo_mujoco_version, 222 for
                                "2.2.2". */
  size_t model_size;       /**< sizeof(mjModel) as the host's compiler knows it; 0 (default) where it cannot know, as in
                                Python. */
  size_t data_size;        /**< sizeof(mjData), likewise. */
  double step;             /**< Seconds between two calls of mimo_senses_advance, > 0; 0 (default): the model's time
                                step, so once every mj_step. All that remembers goes on by this much in each call:
                                delays, nerves, skin, canals, sound. */
  const char *renderer;    /**< As in mimo_env_config. */
  mimo_log_fn log;         /**< Messages while senses are attached, or NULL. */
  void *log_user;          /**< Passed to log. */
  uint32_t render;         /**< MIMO_RENDER_ bits, as in mimo_env_config. */
  uint32_t samples;        /**< Samples a pixel, as in mimo_env_config. */
  uint32_t render_threads; /**< Threads that draw one picture, as in mimo_env_config. */
  uint32_t reserved;       /**< 0. */
} mimo_senses_config;

/**
 * Fills a config with defaults: pictures as those of environments. The host's mujoco_version is still to be set.
 * @param size sizeof(mimo_senses_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_senses_config_init(mimo_senses_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Attaches senses to a model.
 * @param scene  describes the agents (mimo_scene_add_agent with body "scene", and a root where it is no infant), their
 *               skin, joints and cameras, and the limits of their senses. Its own MJCF does not count. Not needed any
 *               more afterwards.
 * @param model  the host's mjModel. It outlives the senses and keeps its sizes.
 * @param config says the host's MuJoCo; NULL is refused, as there is no default for that.
 * @param senses receives the handle; destroy it with mimo_senses_destroy.
 * Errors: MIMO_E_UNSUPPORTED for a MuJoCo of another version, and for effort, muscles and limits of motors, which only
 *         worlds of the library know of; MIMO_E_INVALID_ARGUMENT for what is no mjModel;
 *         MIMO_E_NOT_FOUND for what the model lacks, with a list of what it has.
 */
MIMO_API mimo_status mimo_senses_attach(const mimo_scene *scene, const void *model, const mimo_senses_config *config,
                                        mimo_senses **senses) MIMO_NOEXCEPT;

/** Detaches senses. NULL and destroyed handles are ignored. */
MIMO_API void mimo_senses_destroy(mimo_senses *senses) MIMO_NOEXCEPT;

/** What is observed. There are no actions and no terms in it. */
MIMO_API mimo_status mimo_senses_layout(const mimo_senses *senses, const mimo_layout **layout) MIMO_NOEXCEPT;

/**
 * Starts an episode: nothing was sensed before what the data hold. Noise and memory start anew. Who never calls it
 * begins with the first mimo_senses_advance, as with seed 0.
 * @param data as in mimo_senses_observe; after mj_forward, as an environment's reset gives it.
 * @param config the seed of the noise, as in an environment's reset; NULL goes on from the last episode's.
 */
MIMO_API mimo_status mimo_senses_reset(mimo_senses *senses, const void *data,
                                       const mimo_reset_config *config) MIMO_NOEXCEPT;

/**
 * Goes one step on: what senses remember takes in what the data hold now, and noise is drawn anew. To be called once
 * after each step of the host's, before mimo_senses_observe. Costs nothing worth mentioning where no sense is late.
 * @param data as in mimo_senses_observe.
 */
MIMO_API mimo_status mimo_senses_advance(mimo_senses *senses, const void *data) MIMO_NOEXCEPT;

/**
 * Senses what the data hold: after mj_step the fields belong to the times that mimo_field says, after mj_forward all of
 * them to now. MIMO_PROPRIOCEPTION_JOINT_TORQUE needs mj_rnePostConstraint, which MuJoCo only calls by itself for
 * models with force, torque or accelerometer sensors; with integrators other than Euler, accelerations and contacts are
 * those of the last stage.
 * @param data  an mjData of the model, any of them, unchanged by the call; not while it is being stepped. What is late
 *              comes out of memory.
 * @param block receives the observation, every byte of it.
 */
MIMO_API mimo_status mimo_senses_observe(mimo_senses *senses, const void *data, void *block,
                                         size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Tells fusimotor neurons of muscles how much to drive their spindles, from the next mimo_senses_advance on, until they
 * are told otherwise or an episode starts; part of the saved state.
 * @param actuators  ids in the host's model, motors that turn a joint with a range; NULL with actuator_count 0: all
 *                   that have spindles.
 * @param rates      for each of them what MIMO_ACTUATOR_FUSIMOTOR_DRIVE has: four numbers of Hz, 0 to 500.
 * @param rate_count 4 times as many as actuators.
 * Errors: MIMO_E_NOT_FOUND for an actuator without spindles, or whose agent senses none. Nothing is changed then.
 */
MIMO_API mimo_status mimo_senses_drive_spindles(mimo_senses *senses, const int32_t *actuators, size_t actuator_count,
                                                const double *rates, size_t rate_count) MIMO_NOEXCEPT;

/** Size in bytes of what the senses remember; it does not change. */
MIMO_API mimo_status mimo_senses_state_size(const mimo_senses *senses, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves what the senses remember, and where the episode is. The host saves its own mjData.
 * @param state receives mimo_senses_state_size bytes; needs no alignment.
 */
MIMO_API mimo_status mimo_senses_state_save(const mimo_senses *senses, void *state, size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads what senses remembered that were attached to such a model, of the same sizes and names. They go on exactly as
 * those that saved it, whatever data of that model they look at. What the state lacks starts fresh, as in
 * mimo_env_state_load.
 * @param report receives what started fresh; may be NULL.
 * Errors: as mimo_env_state_load; the senses then stay as they are.
 */
MIMO_API mimo_status mimo_senses_state_load(mimo_senses *senses, const void *state, size_t state_bytes,
                                            mimo_load_report *report) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
