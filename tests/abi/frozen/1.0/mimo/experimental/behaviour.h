/**
 * @file mimo/experimental/behaviour.h
 * Behaviours: what a scene's document measures of its infant, and at which age infants are known to show it.
 */
#ifndef MIMO_EXPERIMENTAL_BEHAVIOUR_H
#define MIMO_EXPERIMENTAL_BEHAVIOUR_H

#include "../task.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The behaviour of a scene whose task is "behaviour". Texts are valid until the scene is changed, destroyed or asked
 * again. The behaviour is shown when the measure has reached its threshold and all conditions hold, together for
 * hold_seconds.
 */
typedef struct mimo_behaviour {
  uint32_t struct_size;    /**< sizeof(mimo_behaviour), set by the caller. */
  uint32_t at_most;        /**< 1: the measure reaches its threshold from above; 0: from below. */
  const char *about;       /**< What the infant does: "sits without support". */
  const char *measure;     /**< What is measured: "tilt upper_body z". */
  const char *unit;        /**< Unit of the measure and of threshold: "m", "deg", "s", "times", ...; "" for a share. */
  const char *conditions;  /**< What else has to hold, as the document words it, parted by "; "; "" for nothing. */
  double threshold;        /**< Lengths are those of the body of 18 months; they are scaled with the infant's stature. */
  double hold_seconds;     /**< How long everything has to hold, s; 0: an instant. */
  double episode_seconds;  /**< Length of an episode, s. */
  double norm_early;       /**< Months at which the first infants show it; 0: not known. */
  double norm_age;         /**< Months at which the middle infant shows it; 0: not known. */
  double norm_late;        /**< Months at which all but the last infants show it; 0: not known. */
  const char *norm;        /**< Which statistics these three are; "" where none is known. */
  const char *norm_source; /**< Who published them, or "not found" and what was looked for. */
} mimo_behaviour;

/**
 * The behaviour of a scene, as its document says it: parameters that were set do not change it. Set
 * behaviour->struct_size first.
 * Errors: MIMO_E_NOT_FOUND for a scene whose document describes none; MIMO_E_MODEL for one that the library does not
 * understand, with the words.
 */
MIMO_API mimo_status mimo_scene_behaviour(mimo_scene *scene, mimo_behaviour *behaviour) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
