/**
 * @file mimo/senses.h
 * Senses attached to your own simulation: a program that simulates with MuJoCo passes its mjModel and mjData. The
 * senses only read them; the host steps and controls. For senses with memory (for example a delay, see
 * mimo_scene_limit_sense) the host reports the start of an episode (mimo_senses_reset) and the end of each step
 * (mimo_senses_advance); observing changes no memory. An environment has the same senses: with equal model, states and
 * seed, both give the same bytes.
 */
#ifndef MIMO_SENSES_H
#define MIMO_SENSES_H

#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Senses attached to a host's model. Functions need exclusive use of it; other threads may read model and data. */
typedef struct mimo_senses mimo_senses;

/** The host's MuJoCo, and the settings of the senses. */
typedef struct mimo_senses_config {
  uint32_t struct_size;    /**< sizeof(mimo_senses_config), set by mimo_senses_config_init. */
  int32_t mujoco_version;  /**< Required: mj_version() of the host, 222 for "2.2.2"; must match mimo_mujoco_version. */
  size_t model_size;       /**< sizeof(mjModel) in the host; 0 (default) if it is not known, as in Python. */
  size_t data_size;        /**< sizeof(mjData), the same. */
  double step;             /**< Seconds between two calls of mimo_senses_advance, > 0; 0 (default): the model's time
                                step, one call per mj_step. Every call advances all memories by this time: delays,
                                nerves, skin, canals, sound. */
  const char *renderer;    /**< As in mimo_env_config. */
  mimo_log_fn log;         /**< Receives messages while senses are attached, or NULL. */
  void *log_user;          /**< Passed to log. */
  uint32_t render;         /**< MIMO_RENDER_ bits, as in mimo_env_config. */
  uint32_t samples;        /**< Samples per pixel, as in mimo_env_config. */
  uint32_t render_threads; /**< Threads for one picture, as in mimo_env_config. */
  uint32_t reserved;       /**< 0. */
} mimo_senses_config;

/**
 * Fills a config with defaults, the same as for environments. Then set mujoco_version.
 * @param size sizeof(mimo_senses_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_senses_config_init(mimo_senses_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Attaches senses to a model.
 * @param scene  describes the agents (mimo_scene_add_agent with body "scene", and a root for other models than
 *               infants), their skin, joints and cameras, and the limits of their senses. Its own MJCF is not used. Not
 *               needed afterwards.
 * @param model  the host's mjModel. It must outlive the senses and keep its sizes.
 * @param config names the host's MuJoCo; NULL is refused, because that has no default.
 * @param senses receives the handle; destroy it with mimo_senses_destroy.
 * Errors: MIMO_E_UNSUPPORTED for another version of MuJoCo, and for effort, muscles and limits of motors, which only
 *         environments have; MIMO_E_INVALID_ARGUMENT if model is not an mjModel; MIMO_E_NOT_FOUND for elements that the
 *         model does not have, with a list of those it has.
 */
MIMO_API mimo_status mimo_senses_attach(const mimo_scene *scene, const void *model, const mimo_senses_config *config,
                                        mimo_senses **senses) MIMO_NOEXCEPT;

/** Detaches senses. NULL and destroyed handles are ignored. */
MIMO_API void mimo_senses_destroy(mimo_senses *senses) MIMO_NOEXCEPT;

/** Layout of the observation. It has no actions and no terms. */
MIMO_API mimo_status mimo_senses_layout(const mimo_senses *senses, const mimo_layout **layout) MIMO_NOEXCEPT;

/**
 * Starts an episode: noise and memories restart from the data. Without this call the first episode starts with the
 * first mimo_senses_advance, with seed 0.
 * @param data   as in mimo_senses_observe; call mj_forward before, as an environment's reset does.
 * @param config the seed of the noise, as in an environment's reset; NULL continues the noise of the last episode.
 */
MIMO_API mimo_status mimo_senses_reset(mimo_senses *senses, const void *data,
                                       const mimo_reset_config *config) MIMO_NOEXCEPT;

/**
 * Advances all memories by one step with the current data and draws new noise. Call it once after each step of the
 * host, before mimo_senses_observe. It costs almost nothing if no sense has a memory.
 * @param data as in mimo_senses_observe.
 */
MIMO_API mimo_status mimo_senses_advance(mimo_senses *senses, const void *data) MIMO_NOEXCEPT;

/**
 * Observes the data: after mj_step the fields belong to the times that mimo_field gives, after mj_forward all belong to
 * the current time. MIMO_PROPRIOCEPTION_JOINT_TORQUE needs mj_rnePostConstraint, which MuJoCo calls only for models
 * with force, torque or accelerometer sensors. With integrators other than Euler, accelerations and contacts belong to
 * the last stage.
 * @param data  any mjData of the model, unchanged by the call; not while it is being stepped. Delayed values come from
 *              memory.
 * @param block receives the observation, every byte of it.
 */
MIMO_API mimo_status mimo_senses_observe(mimo_senses *senses, const void *data, void *block,
                                         size_t block_bytes) MIMO_NOEXCEPT;

/** Size in bytes of the senses' memories; it never changes. */
MIMO_API mimo_status mimo_senses_state_size(const mimo_senses *senses, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves the senses' memories and the position in the episode. The host saves its own mjData.
 * @param state receives mimo_senses_state_size bytes; needs no alignment.
 */
MIMO_API mimo_status mimo_senses_state_save(const mimo_senses *senses, void *state, size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads memories saved from senses on a model of the same sizes and names. These senses then continue exactly as the
 * ones that saved them, with any data of the model. Memories that the state lacks start fresh, as in
 * mimo_env_state_load.
 * @param report receives the memories that started fresh; may be NULL.
 * Errors: as mimo_env_state_load; the senses then stay as they are.
 */
MIMO_API mimo_status mimo_senses_state_load(mimo_senses *senses, const void *state, size_t state_bytes,
                                            mimo_load_report *report) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
