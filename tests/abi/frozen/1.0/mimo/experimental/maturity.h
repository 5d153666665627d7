/**
 * @file mimo/experimental/maturity.h
 * Maturity of eyes and nerves.
 */
#ifndef MIMO_EXPERIMENTAL_MATURITY_H
#define MIMO_EXPERIMENTAL_MATURITY_H

#include "../agent.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sources of the numbers. The original's rules have no sex, z-scores or physiological age: these members keep their
   defaults with it. At 18 months those rules do not give the body of 18 months. */
#define MIMO_GROWTH_WHO 0      /**< The WHO's child growth standards and measured infants: docs/guide/growth.md. */
#define MIMO_GROWTH_ORIGINAL 1 /**< The rules of MIMo's second version, for comparison. */

/* The parts of an infant that follow its age: bits. */
#define MIMO_MATURITY_BODY 0x1u       /**< Size, mass, strength and joints. 0 means this bit. */
#define MIMO_MATURITY_EYES 0x2u       /**< Its eyes' acuity and colour, by its physiological age: mimo_maturity_at. */
#define MIMO_MATURITY_DELAYS 0x4u     /**< The delays of its nerves to and from the brain, by its physiological age. */
#define MIMO_MATURITY_THRESHOLD 0x8u  /**< With _EYES: contrasts below the threshold disappear. */
#define MIMO_MATURITY_FLICKER 0x10u   /**< With _EYES: changes above the flicker limit are blurred. */
#define MIMO_MATURITY_ALL 0x80000000u /**< All bits of the loaded library except _THRESHOLD and _FLICKER. */

#define MIMO_AGENT_PHYSIOLOGICAL_AGE 0x0b05 /**< Agent: 1, months, of strength, range of motion and tone; likewise. */

/**
 * The maturity of an agent's eyes and nerves. docs/guide/maturity.md gives the sources and names the weak ones.
 * A nerve of length L adds a delay of L / conduction_speed, and its path in the brain adds another one:
 *   - touch: the nerve from the body part with the sensor, and sensory_delay;
 *   - proprioception: the nerve from the body part that the joint moves, and sensory_delay;
 *   - the vestibular sense, vision and hearing: their own delay alone;
 *   - an action: the nerve to the body part that its motor moves, and motor_delay.
 *
 * Nerve lengths follow from the agent's own body (MIMO_BODY_NERVE_LENGTH). Delays are rounded to the nearest number of
 * time steps of the model (with attached senses, of the host's steps).
 */
typedef struct mimo_maturity {
  uint32_t struct_size;        /**< sizeof(mimo_maturity), set by mimo_maturity_init. */
  uint32_t contrast_threshold; /**< 1: contrasts below the threshold disappear; 0 (default): they stay. Needs
                                    an acuity. */
  double acuity;               /**< The finest visible lines, cycles per degree, 0.05 to 1000; 0 (default): pictures
                                    as drawn. */
  double peak_contrast;        /**< Peak contrast sensitivity, 1.01 to 1000: at the acuity limit 1/peak_contrast of the
                                    contrast is left. Default 2. Needs an acuity. */
  double chroma;               /**< Visible share of colour, 0 (grey) to 1 (default). */
  double flicker;              /**< Cut-off frequency of a low-pass filter over the sensed pictures, Hz, 0.01 to 1000.
                                    0 (default): no filter. */
  double conduction_speed;     /**< Of large nerve fibres, m/s, 0.1 to 200; 0 (default): no delay. */
  double sensory_delay;        /**< From the brain stem to the cortex, s, 0 to 2. */
  double motor_delay;          /**< From the cortex to the brain stem, s, 0 to 2. */
  double vision_delay;         /**< From the eye to the cortex, s, 0 to 2. */
  double vestibular_delay;     /**< From the inner ear to the brain stem, s, 0 to 2. */
  double hearing_delay;        /**< From the ear to the cortex, s, 0 to 2. */
} mimo_maturity;

/**
 * Fills a maturity with defaults: perfect eyes, and nerves without delay.
 * @param size sizeof(mimo_maturity) as the caller knows it.
 */
MIMO_API mimo_status mimo_maturity_init(mimo_maturity *maturity, size_t size) MIMO_NOEXCEPT;

/**
 * Fills a maturity with the numbers of an age. contrast_threshold and flicker, which are options, stay 0; measured
 * values for flicker are 4, 8 and 15 Hz at 2, 4 and 12 months.
 * @param age      months, 0 (a newborn) to 24.
 * @param size     sizeof(mimo_maturity) as the caller knows it.
 */
MIMO_API mimo_status mimo_maturity_at(double age, mimo_maturity *maturity, size_t size) MIMO_NOEXCEPT;

/**
 * Sets the maturity of an agent, for environments made and senses attached from now on. Limits set by
 * mimo_scene_limit_sense and mimo_scene_limit_motor replace its delays. Attached senses have no motors and ignore
 * motor_delay.
 * @param maturity NULL: by the age and the member maturity of the agent's mimo_growth.
 * Errors: MIMO_E_INVALID_ARGUMENT for nerves with delays of an agent that is not an infant.
 */
MIMO_API mimo_status mimo_scene_set_maturity(mimo_scene *scene, size_t agent,
                                             const mimo_maturity *maturity) MIMO_NOEXCEPT;

/**
 * Sets the delay with which an agent feels a part of its body, for environments made and senses attached from now on:
 * touch on the part, and the joints that move it. It replaces the delay that follows from the maturity; limits set by
 * mimo_scene_limit_sense replace this one. For motors see mimo_scene_limit_motor.
 * @param body    name of a body without its agent's name, "left_hand"; NULL: every body, which replaces what was set
 *                for single ones before.
 * @param seconds 0 to 2; rounded to the nearest number of time steps of the model.
 * Errors: MIMO_E_NOT_FOUND for an unknown body; the message lists the infant's bodies. For an agent with a root the
 *         error comes when an environment is made or senses are attached.
 */
MIMO_API mimo_status mimo_scene_set_sensory_delay(mimo_scene *scene, size_t agent, const char *body,
                                                  double seconds) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
