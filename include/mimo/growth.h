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

/* Where the numbers come from. The original knows nothing of sex, z-scores and physiological age, which keep their
   defaults then, and at 18 months they do not give the body of 18 months. */
#define MIMO_GROWTH_WHO 0      /**< The WHO's child growth standards and measured infants: docs/guide/growth.md. */
#define MIMO_GROWTH_ORIGINAL 1 /**< The rules of MIMo's second version, for those who compare. */

/* What of an infant is as old as it: bits. */
#define MIMO_MATURITY_BODY 0x1u       /**< Size, mass, strength and joints. 0 stands for this one. */
#define MIMO_MATURITY_EYES 0x2u       /**< What its eyes see, at its physiological age: mimo_maturity_at. */
#define MIMO_MATURITY_DELAYS 0x4u     /**< How long its nerves take, to and from the brain; likewise. */
#define MIMO_MATURITY_THRESHOLD 0x8u  /**< With its eyes: contrasts too faint for them are gone. */
#define MIMO_MATURITY_FLICKER 0x10u   /**< With its eyes: changes too fast for them are blurred. */
#define MIMO_MATURITY_ALL 0x80000000u /**< All that the loaded library has but the options _THRESHOLD and _FLICKER. */

/**
 * How old, large and strong an infant is: the member `growth` of mimo_agent_config, NULL for the body of 18 months.
 * From it follow lengths, girths, masses and inertias, eyes and cameras, skin, strength, and the range, stiffness,
 * damping and friction of joints. The infant starts in the same pose, as far as its joints go, its lowest point where
 * that would be at 18 months. With all defaults it is that body, to the last bit. Objects and rooms stay; what tasks do
 * about it, docs/tasks.md says.
 * Errors, of the call that is given it: MIMO_E_INVALID_ARGUMENT for numbers out of their range, an agent that is no
 * infant, and a combination that no infant can have, where no girth of its limbs gives that mass; MIMO_E_UNSUPPORTED
 * for an infant in the scene's MJCF whose parts somebody has changed.
 */
typedef struct mimo_growth {
  uint32_t struct_size;     /**< sizeof(mimo_growth), set by mimo_growth_init. */
  int32_t sex;              /**< A MIMO_SEX_ constant. Default MIMO_SEX_MEAN. */
  double age;               /**< Months, 0 (a newborn) to 24: of size and mass. Default 18. */
  double physiological_age; /**< Months, 0 to 24, where matures_apart is 1: of strength, range of motion and tone. */
  uint32_t matures_apart;   /**< 1: physiological_age counts; 0 (default): it is the age. */
  int32_t model;            /**< A MIMO_GROWTH_ constant. Default MIMO_GROWTH_WHO. */
  double z_length;          /**< Of its length: standard deviations from the median of age and sex, -3 to 3. */
  double z_weight;          /**< Of its weight, the same. */
  double z_head;            /**< Of its head's circumference, the same. */
  double percentile;        /**< Percent, 1 to 99.865: all three of these at once, which are 0 then; 0: they count. */
  double strength_exponent; /**< Strength of a muscle's cross-section goes with this power of the median length at the
                                 physiological age, 0 to 5; 0: it is the same at all ages. Default 1.7. */
  double neck_strength;     /**< Factor of the neck's strength at its age, 0 to 10. Default 1. */
  double birth_tone;        /**< Factor of the stiffness of a newborn's joints, 0.1 to 10; it is 1 from 6 months on.
                                 Default 1.5. */
  double contracture;       /**< Share of a young infant's lack of extension in hips, knees and elbows, 0 to 1.
                                 Default 1. */
  uint32_t absolute;        /**< 1: length and weight are the WHO's; 0 (default): in the WHO's proportion to the body of
                                 18 months, which is 4.5 % shorter and 3 % heavier than its median. */
  uint32_t keep_spacing;    /**< 1: touch sensors are as far apart as at 18 months and so fewer; 0 (default): there
                                 are as many, and their distances grow with the body. */
  uint32_t maturity;        /**< MIMO_MATURITY_ bits; 0 and default: MIMO_MATURITY_BODY. */
  uint32_t reserved;        /**< 0. */
} mimo_growth;

/**
 * Fills a growth with that of the infant as it is without: 18 months, mean of the sexes, median.
 * @param size sizeof(mimo_growth) as the caller knows it.
 */
MIMO_API mimo_status mimo_growth_init(mimo_growth *growth, size_t size) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
