/**
 * @file mimo/senses.h
 * Senses on your own simulation: a program that uses MuJoCo by itself gives them its mjModel and mjData.
 * They only look; stepping, control and memory stay the host's. An environment is nothing but a world with such
 * senses: of the same model in the same state they give the same bytes.
 */
#ifndef MIMO_SENSES_H
#define MIMO_SENSES_H

#include "observation.h"

#ifdef __cplusplus
extern "C" {
#endif

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
