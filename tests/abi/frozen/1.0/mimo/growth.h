/**
 * @file mimo/growth.h
 * Infants of any age from birth to two years.
 */
#ifndef MIMO_GROWTH_H
#define MIMO_GROWTH_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_SEX_MEAN 0   /**< The mean of the medians of girls and boys. */
#define MIMO_SEX_FEMALE 1 /**< A girl. */
#define MIMO_SEX_MALE 2   /**< A boy. */

/**
 * The age, size and strength of an infant: the member `growth` of mimo_agent_config, NULL for the body of 18 months. It
 * determines lengths, girths, masses and inertias, eyes and cameras, skin, strength, and the range, stiffness, damping
 * and friction of joints. The infant starts in the same pose, within the range of its joints; its lowest point is where
 * it would be at 18 months. All defaults give that body, to the last bit. Objects and rooms do not change;
 * docs/tasks.md says how tasks adapt.
 * Errors of the call that receives it: MIMO_E_INVALID_ARGUMENT for numbers out of range, for an agent that is not an
 * infant, and for a combination that no girth of the limbs can give; MIMO_E_UNSUPPORTED for an infant in the scene's
 * MJCF whose parts were changed.
 */
typedef struct mimo_growth {
  uint32_t struct_size;     /**< sizeof(mimo_growth), set by mimo_growth_init. */
  int32_t sex;              /**< A MIMO_SEX_ constant. Default MIMO_SEX_MEAN. */
  double age;               /**< Age in months, 0 (a newborn) to 24, for size and mass. Default 18. */
  double physiological_age; /**< Months, 0 to 24, for strength, range of motion and tone, if matures_apart is 1. */
  uint32_t matures_apart;   /**< 1: physiological_age is used; 0 (default): age is used for all. */
  int32_t model;            /**< A MIMO_GROWTH_ constant. Default MIMO_GROWTH_WHO. */
  double z_length;          /**< Its length in standard deviations from the median of age and sex, -3 to 3. */
  double z_weight;          /**< The same for its weight. */
  double z_head;            /**< The same for its head's circumference. */
  double percentile;        /**< Percent, 1 to 99.865: sets all three z-scores, which must then be 0; 0: not used. */
  double strength_exponent; /**< A muscle's strength per cross-section is proportional to this power of the median
                                 length at the physiological age, 0 to 5; 0: equal at all ages. Default 1.7. */
  double neck_strength;     /**< Factor of the neck's strength at its age, 0 to 10. Default 1. */
  double birth_tone;        /**< Factor of a newborn's joint stiffness, 0.1 to 10; it falls to 1 at 6 months.
                                 Default 1.5. */
  double contracture;       /**< Share of the young infant's limited extension of hips, knees and elbows that applies, 0
                                 to 1. Default 1. */
  uint32_t absolute;        /**< 1: length and weight are the WHO's; 0 (default): they are the WHO's relative to the
                                 body of 18 months, which is 4.5 % shorter and 3 % heavier than the median. */
  uint32_t keep_spacing;    /**< 1: touch sensors keep the spacing of 18 months, so a smaller body has fewer; 0
                                 (default): their number stays and their spacing grows with the body. */
  uint32_t maturity;        /**< MIMO_MATURITY_ bits; 0 (default): MIMO_MATURITY_BODY. */
  uint32_t reserved;        /**< 0. */
} mimo_growth;

/**
 * Fills a growth with defaults, the same as no growth: 18 months, mean of the sexes, median.
 * @param size sizeof(mimo_growth) as the caller knows it.
 */
MIMO_API mimo_status mimo_growth_init(mimo_growth *growth, size_t size) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
