/**
 * @file mimo/experimental/receptors.h
 * Receptors of muscles, joints, the labyrinth and the skin: firing rates of their nerves.
 */
#ifndef MIMO_EXPERIMENTAL_RECEPTORS_H
#define MIMO_EXPERIMENTAL_RECEPTORS_H

#include "../access.h"
#include "../agent.h"
#include "../senses.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Firing rates of receptors in muscles and joints, Hz: see docs/guide/proprioception.md. Off by default. */
#define MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY 0x80u    /**< proprioception/spindle_primary, two muscles per motor: Ia. */
#define MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY 0x100u /**< proprioception/spindle_secondary, the same shape: II. */
#define MIMO_PROPRIOCEPTION_TENDON_ORGAN 0x200u      /**< proprioception/tendon_organ, the same shape: Ib. */
#define MIMO_PROPRIOCEPTION_JOINT_RECEPTOR 0x400u    /**< proprioception/joint_receptor, joints x 2: near its ends. */

#define MIMO_VESTIBULAR_CANALS 0x4u   /**< vestibular/canals, 6 x 2, Hz: see docs/guide/balance.md. */
#define MIMO_VESTIBULAR_OTOLITHS 0x8u /**< vestibular/otoliths, 2 x 2 x 2 x 2, Hz: see docs/guide/balance.md. */
#define MIMO_VESTIBULAR_GRAVITY 0x10u /**< vestibular/gravity, 3, m/s^2: the estimated direction of up. */

/** Receptors of the skin, N per field: see docs/guide/skin.md. In Hz unless stated otherwise; off by default. */
#define MIMO_TOUCH_SA1 0x10u                /**< touch/sa1: depth of indentation. */
#define MIMO_TOUCH_RA 0x20u                 /**< touch/ra: speed of indentation, and sliding. */
#define MIMO_TOUCH_PC 0x40u                 /**< touch/pc: jolts and vibration, as an envelope. */
#define MIMO_TOUCH_SA2 0x80u                /**< touch/sa2, N x 2: stretch along the sensor's two tangents. */
#define MIMO_TOUCH_TEMPERATURE 0x100u       /**< touch/temperature: of the skin's surface, degrees Celsius. */
#define MIMO_TOUCH_COLD 0x200u              /**< touch/cold. */
#define MIMO_TOUCH_WARM 0x400u              /**< touch/warm. */
#define MIMO_TOUCH_NOCICEPTION_FAST 0x800u  /**< touch/nociception_fast: pricks and heat, at once. */
#define MIMO_TOUCH_NOCICEPTION_SLOW 0x1000u /**< touch/nociception_slow: pricks, heat and cold, late and lasting. */
#define MIMO_TOUCH_UNITS 0x2000u            /**< touch/units, N x 4: number of SA1, RA, PC, SA2 units per sensor. */
#define MIMO_TOUCH_CT 0x4000u               /**< touch/ct: how hairy skin is stroked, at most 100. */

/**
 * Body: 1, m, how long nerves are from the middle of this part of an infant to its head, through the joints on their
 * way; 0 for what is no part of one.
 */
#define MIMO_BODY_NERVE_LENGTH 0x0108
/**
 * Body: 9, what inertial sensors in the origin of its frame read, in that frame: acceleration with gravity's (m/s^2; at
 * rest 9.81 upwards, in free fall 0), angular velocity (rad/s), angular acceleration (rad/s^2). With a, w and b for
 * these, a sensor at the point p of the body reads the acceleration a + b x p + w x (w x p). Physics steps compute it.
 */
#define MIMO_BODY_INERTIAL 0x0109
/**
 * Actuator: 4, what its two muscles' fusimotor neurons are told, Hz, 0 to 500: dynamic and static of the one that pulls
 * to the negative side, then of the other; until you change it or the world is reset, 70 each. None where its agent
 * senses no spindles, MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY or _SECONDARY. Writable.
 */
#define MIMO_ACTUATOR_FUSIMOTOR_DRIVE 0x0604

/**
 * Sets the firing rates of fusimotor neurons, which drive muscle spindles, from the next mimo_senses_advance on, until
 * the next call or the start of an episode; part of the saved state.
 * @param actuators  ids in the host's model, motors that turn a joint with a range; NULL with actuator_count 0: all
 *                   that have spindles.
 * @param rates      four numbers for each, Hz, 0 to 500, as in MIMO_ACTUATOR_FUSIMOTOR_DRIVE.
 * @param rate_count 4 times actuator_count.
 * Errors: MIMO_E_NOT_FOUND for an actuator without spindles, or one whose agent senses none. Nothing changes then.
 */
MIMO_API mimo_status mimo_senses_drive_spindles(mimo_senses *senses, const int32_t *actuators, size_t actuator_count,
                                                const double *rates, size_t rate_count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
