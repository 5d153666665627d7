/**
 * @file mimo/hearing.h
 * Sounds that a host plays in a world. What infants hear: mimo_agent_config::hearing and docs/guide/hearing.md.
 */
#ifndef MIMO_HEARING_H
#define MIMO_HEARING_H

#include "env.h"
#include "senses.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Sets how much can be played, for environments made and senses attached from now on, where an agent hears. It is part
 * of a world's state, with 4 bytes a sample.
 * @param count   bodies that play at the same time, 1 to 64. Default 4.
 * @param seconds of sound that may wait at each, 0.01 to 600. Default 4.
 */
MIMO_API mimo_status mimo_scene_set_sources(mimo_scene *scene, size_t count, double seconds) MIMO_NOEXCEPT;

/**
 * Says from where and whereto a body plays, for environments made and senses attached from now on; without it from its
 * centre of mass, to all sides alike. At an angle a from the axis sound is 1 - directivity + directivity cos(a) times
 * as strong as along it: 0 alike everywhere, 0.25 half behind, 0.5 nothing behind (a cardioid), 1 a figure of eight.
 * @param body        its name in the model, "caregiver", "anna/head"; unknown ones are refused when a world is made.
 * @param place       3 numbers in the body's frame, m.
 * @param axis        3 numbers in the body's frame, longer than 0; need not have length 1.
 * @param directivity 0 to 1. Called again for a body: the last one counts.
 */
MIMO_API mimo_status mimo_scene_direct_source(mimo_scene *scene, const char *body, const double *place,
                                              const double *axis, double directivity) MIMO_NOEXCEPT;

/**
 * Lets a body play samples, from the next physics step on. While it plays already they wait until that is over, so that
 * a sound may be handed over in blocks, one each step. Sound goes out from the body's centre of mass, to all sides
 * alike unless mimo_scene_direct_source says otherwise, and takes its time to ears. A reset ends it.
 * @param body    its name in the model, "cup", "anna/head".
 * @param samples sound pressure at 1 m from the body, Pa; 0.02 is a conversation, 1 is 94 dB.
 * @param count   length of samples; 0 (samples may be NULL then): what the body plays ends.
 * @param rate    samples a second: sample_rate of the field "hearing/ear_left", 16000 in built-in scenes.
 * Errors: MIMO_E_UNSUPPORTED where no agent hears; MIMO_E_NOT_FOUND for a body that the model does not have;
 *         MIMO_E_INVALID_ARGUMENT for samples that are not finite, more than there is room for, another rate, and where
 *         as many bodies play as may. Nothing of the samples is played then.
 */
MIMO_API mimo_status mimo_env_play(mimo_env *env, const char *body, const float *samples, size_t count,
                                   double rate) MIMO_NOEXCEPT;

/** As mimo_env_play, around attached senses: from their next mimo_senses_advance on. */
MIMO_API mimo_status mimo_senses_play(mimo_senses *senses, const char *body, const float *samples, size_t count,
                                      double rate) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
