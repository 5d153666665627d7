/**
 * @file mimo/maturity.h
 * Eyes and nerves as old as the infant.
 */
#ifndef MIMO_MATURITY_H
#define MIMO_MATURITY_H

#include "agent.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * How mature an agent's eyes and nerves are, in numbers. Sources, and which of them are weak: docs/guide/maturity.md.
 * A nerve of length L is late by L / conduction_speed, and by what its way through the brain adds:
 *   - touch by the part of the body that a sensor sits on, proprioception by the part that a joint moves:
 *     sensory_delay;
 *   - the vestibular sense, vision and hearing by their own delay alone;
 *   - an action by the part that its motor moves: motor_delay.
 * Lengths are those of the agent's own body, MIMO_BODY_NERVE_LENGTH; delays are rounded to the nearest number of time
 * steps of the model (with attached senses to that of the host's steps).
 */
typedef struct mimo_maturity {
  uint32_t struct_size;        /**< sizeof(mimo_maturity), set by mimo_maturity_init. */
  uint32_t contrast_threshold; /**< 1: contrasts that are too faint to be seen are gone; 0 (default): they stay.
                                Counts with an acuity. */
  double acuity;               /**< The finest lines that are seen, cycles per degree, 0.05 to 1000; 0 (default):
                                    pictures as they are drawn. */
  double peak_contrast;        /**< The greatest contrast sensitivity, 1.01 to 1000: at the acuity limit 1/peak_contrast
                                    of the contrast is left. Default 2. Counts with an acuity. */
  double chroma;               /**< Share of colour that is seen, 0 (grey) to 1 (default). */
  double flicker;              /**< Changes faster than this are seen less and less, Hz, 0.01 to 1000: a low-pass over
                                    the pictures that are sensed. 0 (default): none. */
  double conduction_speed;     /**< Of large nerve fibres, m/s, 0.1 to 200; 0 (default): they take no time. */
  double sensory_delay;        /**< From the brain stem to the cortex, s, 0 to 2. */
  double motor_delay;          /**< From the cortex to the brain stem, s, 0 to 2. */
  double vision_delay;         /**< From the eye to the cortex, s, 0 to 2. */
  double vestibular_delay;     /**< From the inner ear to the brain stem, s, 0 to 2. */
  double hearing_delay;        /**< From the ear to the cortex, s, 0 to 2. */
} mimo_maturity;

/**
 * Fills maturity with that of perfect eyes, and of nerves that take no time.
 * @param size sizeof(mimo_maturity) as the caller knows it.
 */
MIMO_API mimo_status mimo_maturity_init(mimo_maturity *maturity, size_t size) MIMO_NOEXCEPT;

/**
 * Fills maturity with the numbers of an age. contrast_threshold and flicker, which are options, stay 0; 4, 8 and 15 Hz
 * are flicker's at 2, 4 and 12 months.
 * @param age      months, 0 (a newborn) to 24.
 * @param size     sizeof(mimo_maturity) as the caller knows it.
 */
MIMO_API mimo_status mimo_maturity_at(double age, mimo_maturity *maturity, size_t size) MIMO_NOEXCEPT;

/**
 * Gives an agent such eyes and nerves, for environments made and senses attached from now on. Limits of
 * mimo_scene_limit_sense and mimo_scene_limit_motor have the last word: what they concern is as late as they say.
 * Attached senses have no motors, so that their delays do not count.
 * @param maturity NULL: as old as the agent's mimo_growth says, by its member maturity.
 * Errors: MIMO_E_INVALID_ARGUMENT for an agent that is no infant where nerves take time.
 */
MIMO_API mimo_status mimo_scene_set_maturity(mimo_scene *scene, size_t agent,
                                             const mimo_maturity *maturity) MIMO_NOEXCEPT;

/**
 * How late an agent feels a part of its body, for environments made and senses attached from now on: touch on it, and
 * the joints that move it. It counts instead of what follows from the maturity; limits of mimo_scene_limit_sense come
 * before it. For the way back to motors see mimo_scene_limit_motor.
 * @param body    name of a body without its agent's name, "left_hand"; NULL: every body, and what was set before for
 *                single ones no longer counts.
 * @param seconds 0 to 2; rounded to the nearest number of time steps of the model.
 * Errors: MIMO_E_NOT_FOUND for a body that the infant does not have; the message lists those that it has. Where the
 *         scene does not know (an agent with a root), it comes when an environment is made or senses are attached.
 */
MIMO_API mimo_status mimo_scene_set_sensory_delay(mimo_scene *scene, size_t agent, const char *body,
                                                  double seconds) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
