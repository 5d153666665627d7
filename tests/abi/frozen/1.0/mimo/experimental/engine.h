/**
 * @file mimo/experimental/engine.h
 * The inside of simulation and pictures: options of solver and renderer, warnings of the physics, timing.
 */
#ifndef MIMO_EXPERIMENTAL_ENGINE_H
#define MIMO_EXPERIMENTAL_ENGINE_H

#include "../access.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_JACOBIAN_MODEL 0  /**< The model's setting; built-in scenes use sparse. */
#define MIMO_JACOBIAN_DENSE 1  /**< The original's solver, for comparing trajectories to the last digit. */
#define MIMO_JACOBIAN_SPARSE 2 /**< The same solution up to rounding, about twice as fast. */

#define MIMO_DISABLE_OWN_SOLVER 0x4u /**< MuJoCo's mj_step in place of libmimo's solver: same up to rounding, slower. */

#define MIMO_RENDER_SHADOWS 0x01u     /**< Lights cast shadows. */
#define MIMO_RENDER_REFLECTIONS 0x02u /**< Floors and boxes may mirror the scene. */
#define MIMO_RENDER_SKY 0x04u         /**< The scene's sky; without it the background is black. */
#define MIMO_RENDER_HAZE 0x08u        /**< Haze at the horizon of an endless floor. */
#define MIMO_RENDER_FOG 0x10u         /**< Fog, as the scene's MJCF describes it. */

/* Warnings of the physics; also the ids of MIMO_WARNING_STEPS. */
#define MIMO_WARNING_CONTACTS_DROPPED 1    /**< More contacts than the model's nconmax: some are missing. */
#define MIMO_WARNING_CONSTRAINTS_DROPPED 2 /**< More constraints than the model's njmax: some are missing. */
#define MIMO_WARNING_BAD_POSITION 3        /**< A position is not a number, or huge: the world has failed. */
#define MIMO_WARNING_BAD_VELOCITY 4        /**< The same for a velocity. */
#define MIMO_WARNING_BAD_ACCELERATION 5    /**< The same for an acceleration. */
#define MIMO_WARNING_BAD_CONTROL 6         /**< A control is not a number, or huge: the step used 0 for all controls. */
#define MIMO_WARNING_INERTIA 7             /**< The inertia matrix is nearly singular. */
#define MIMO_WARNING_NOT_CONVERGED 8       /**< The solver stopped at its last iteration; counted, not logged. */

#define MIMO_WARNING 14 /**< Kinds of warnings: the ids are MIMO_WARNING_ constants, 0 is any other one. */
/**
 * Warning: 1, how many physics steps had it since the world was made; resets and loaded states leave it. Writable with
 * 0, to count anew.
 */
#define MIMO_WARNING_STEPS 0x0e01

/** Seconds spent in the parts of steps since the last mimo_env_timing_reset. */
typedef struct mimo_timing {
  uint32_t struct_size;  /**< sizeof(mimo_timing), set by the caller. */
  uint32_t reserved;     /**< 0. */
  uint64_t steps;        /**< Number of environment steps. */
  double total;          /**< The whole steps. */
  double physics;        /**< Physics steps. */
  double touch;          /**< Sense of touch. */
  double vision;         /**< Drawing the eyes' pictures. */
  double proprioception; /**< Joint senses. */
  double vestibular;     /**< Accelerometer and gyroscope. */
  double hearing;        /**< Sounds, and their paths to the ears. */
} mimo_timing;

/** Reads the timing; all 0 unless the environment was made with timing = 1. Set timing->struct_size first. */
MIMO_API mimo_status mimo_env_timing(const mimo_env *env, mimo_timing *timing) MIMO_NOEXCEPT;

/** Resets the timing to 0. */
MIMO_API mimo_status mimo_env_timing_reset(mimo_env *env) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
