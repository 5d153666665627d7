/**
 * @file mimo/experimental/hearing.h
 * Sounds that a host plays in a world. For the infants' hearing see mimo_agent_config::hearing and
 * docs/guide/hearing.md.
 */
#ifndef MIMO_EXPERIMENTAL_HEARING_H
#define MIMO_EXPERIMENTAL_HEARING_H

#include "../env.h"
#include "../senses.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_HEARING_EARS 0x1u  /**< hearing/ear_left, hearing/ear_right: sound of the step at both ears, Pa. */
#define MIMO_HEARING_BANDS 0x2u /**< hearing/bands, 2 x 24, dB above threshold; hearing/time_difference, s. */

/**
 * Sets the room for played sounds, for environments made and senses attached from now on in which an agent hears. It is
 * part of a world's state, with 4 bytes per sample.
 * @param count   bodies that play at the same time, 1 to 64. Default 4.
 * @param seconds of sound that may wait at each body, 0.01 to 600. Default 4.
 */
MIMO_API mimo_status mimo_scene_set_sources(mimo_scene *scene, size_t count, double seconds) MIMO_NOEXCEPT;

/**
 * Sets the place and direction of a body's sound, for environments made and senses attached from now on. By default it
 * starts at the body's centre of mass, equally in all directions. At an angle a from the axis, sound has
 * 1 - directivity + directivity cos(a) of its strength on the axis: directivity 0 is equal everywhere, 0.25 half as
 * strong behind, 0.5 silent behind (a cardioid), 1 a figure of eight.
 * @param body        its name in the model, "caregiver", "anna/head"; an unknown one is refused when a world is made.
 * @param place       3 numbers in the body's frame, m.
 * @param axis        3 numbers in the body's frame, of any length except 0.
 * @param directivity 0 to 1. The last call for a body applies.
 */
MIMO_API mimo_status mimo_scene_direct_source(mimo_scene *scene, const char *body, const double *place,
                                              const double *axis, double directivity) MIMO_NOEXCEPT;

/**
 * Plays samples from a body, starting with the next physics step, or after the samples that it is already playing: a
 * sound may be passed in blocks, one per step. Sound starts at the body's centre of mass, equally in all directions
 * unless mimo_scene_direct_source changed that, and reaches ears at the speed of sound. A reset ends it.
 * @param body    its name in the model, "cup", "anna/head".
 * @param samples sound pressure at 1 m from the body, Pa; 0.02 is conversation, 1 is 94 dB.
 * @param count   length of samples; 0 (samples may be NULL) stops the body's sound.
 * @param rate    samples per second: sample_rate of the field "hearing/ear_left", 16000 in built-in scenes.
 * Errors: MIMO_E_UNSUPPORTED if no agent hears; MIMO_E_NOT_FOUND for an unknown body; MIMO_E_INVALID_ARGUMENT for
 *         samples that are not finite or exceed the room, another rate, and one body more than may play at once. None
 *         of the samples is played then.
 */
MIMO_API mimo_status mimo_env_play(mimo_env *env, const char *body, const float *samples, size_t count,
                                   double rate) MIMO_NOEXCEPT;

/** As mimo_env_play, for attached senses: from their next mimo_senses_advance on. */
MIMO_API mimo_status mimo_senses_play(mimo_senses *senses, const char *body, const float *samples, size_t count,
                                      double rate) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
