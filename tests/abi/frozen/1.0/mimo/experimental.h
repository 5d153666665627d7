/**
 * @file mimo/experimental.h
 * What is too young to be promised: it may change in every minor version, with a line in the changelog, and programs
 * that use it are built again then (docs/abi.md). Includes mimo.h. Each header may also be included alone:
 *
 *     receptors.h    receptors of muscles, joints, the labyrinth and the skin
 *     reflexes.h     reflexes of newborns
 *     maturity.h     the rules of growth; the acuity of infants' eyes and the speed of their nerves
 *     hearing.h      hearing, and sounds that your program plays
 *     things.h       the temperature and the material of things
 *     gaze.h         the gaze of infants
 *     movement.h     movements that are known, from video or motion capture
 *     looks.h        materials, textures and lights for engines that draw the world themselves
 *     engine.h       options of solver and renderer, warnings of the physics, timing
 *     stage.h        pictures of what plain arrays describe, without a simulation
 *     recording.h    runs recorded to files and replayed
 *     sense.h        senses of your own
 *     spontaneous.h  spontaneous movements: what motors do before an infant wants anything
 *     behaviour.h    behaviours that documents measure, and the ages at which infants show them
 */
#ifndef MIMO_EXPERIMENTAL_H
#define MIMO_EXPERIMENTAL_H

#include "mimo.h"

/* clang-format off */
#include "experimental/receptors.h"
#include "experimental/reflexes.h"
#include "experimental/maturity.h"
#include "experimental/hearing.h"
#include "experimental/things.h"
#include "experimental/gaze.h"
#include "experimental/movement.h"
#include "experimental/looks.h"
#include "experimental/engine.h"
#include "experimental/stage.h"
#include "experimental/recording.h"
#include "experimental/sense.h"
#include "experimental/spontaneous.h"
#include "experimental/behaviour.h"
/* clang-format on */

#endif
