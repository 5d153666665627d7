/**
 * @file mimo/experimental/reflexes.h
 * Reflexes of newborns: bits of mimo_agent_config::reflexes.
 */
#ifndef MIMO_EXPERIMENTAL_REFLEXES_H
#define MIMO_EXPERIMENTAL_REFLEXES_H

#include "../agent.h"

/** Reflexes of newborns, added to the agent's commands according to its age: see docs/guide/reflexes.md. */
#define MIMO_REFLEX_PALMAR_GRASP 0x1u           /**< Fingers close on pressure on the palm; needs five fingers. */
#define MIMO_REFLEX_PLANTAR_GRASP 0x2u          /**< Toes curl on pressure on the ball of the foot. */
#define MIMO_REFLEX_ROOTING 0x4u                /**< The head turns towards a touch at a corner of the mouth. */
#define MIMO_REFLEX_MORO 0x8u                   /**< The head drops: arms open, then close. */
#define MIMO_REFLEX_ASYMMETRIC_TONIC_NECK 0x10u /**< The head turns: limbs stretch on that side, bend on the other. */
#define MIMO_REFLEX_STEPPING 0x20u              /**< Upright on its feet, leaning forward: legs step in turn. */
#define MIMO_REFLEX_WITHDRAWAL 0x40u            /**< Legs draw back from a touch or a prick. */
#define MIMO_REFLEX_FELT 0x40000000u            /**< reflex/activation has all reflexes that this body can show. */
#define MIMO_REFLEX_ALL 0x80000000u             /**< All reflexes of the loaded library that this body can show. */

#endif
