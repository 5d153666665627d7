/**
 * @file mimo/mimo.h
 * libmimo: MIMo, the multimodal infant model, as a C library.  MIT licence, see LICENSE.
 *
 * One chapter after the other, in the order of use; each may also be included by itself:
 *
 *     status.h       versions, results of calls, what went wrong
 *     log.h          messages
 *     scene.h        rooms, objects, models, cameras, as a description
 *     growth.h       how old infants are
 *     agent.h        infants: where they are, what they sense, what of them acts
 *     maturity.h     how well their eyes see, and how fast their nerves are
 *     things.h       how warm things are, and what they are made of
 *     observation.h  what a block of observations, an array of actions and a reward consist of
 *     env.h          a world: making it, steps, rewards, timing
 *     access.h       joints, bodies, contacts by name; what differs from world to world
 *     geometry.h     shapes, looks, lights: for engines that draw the world themselves
 *     sight.h        where infants look; pictures for people
 *     state.h        save, load, clone
 *     recording.h    runs in files: written while they happen, played again
 *     batch.h        many worlds on several threads
 *     task.h         tasks, their parameters, and tasks of your own
 *     senses.h       senses on your own simulation
 *     hearing.h      sounds of your own
 *
 * Rules that hold everywhere (docs/ has an article on each):
 *
 *     Errors    Functions that can fail return a mimo_status: 0 is success, negative is failure, and
 *               mimo_last_error() then holds one line that names the argument, its value and what was
 *               expected. When an argument is refused, nothing is written anywhere.
 *     Handles   mimo_scene, mimo_env, mimo_batch, mimo_senses, mimo_recorder, mimo_recording are opaque, and so is
 *               mimo_layout, which belongs to one of them. Destroy accepts NULL; a destroyed handle is refused by
 *               every function (MIMO_E_BAD_HANDLE), destroying it again does nothing. A handle made before fork()
 *               answers MIMO_E_FORKED in the child.
 *     Threads   Functions that take a const handle may run at the same time on one handle; functions that
 *               take a handle without const need it for themselves, and answer MIMO_E_BUSY where another thread
 *               uses it; different handles are independent.
 *               Any thread may call. A thread that is cancelled (pthread_cancel) within a call finishes the call first.
 *     Memory    Buffers belong to the caller and come with their length in elements (observation blocks:
 *               in bytes), but for points, poses and the like, of which it is said how many numbers they are.
 *               One that is too short is refused and stays as it was (MIMO_E_BUFFER_TOO_SMALL); a
 *               length that no memory has, such as a negative number turned into size_t, is
 *               MIMO_E_INVALID_ARGUMENT. Strings passed in are UTF-8 and copied; who owns a string passed out
 *               is said where it is declared.
 *     Structs   Versioned structs start with struct_size and are filled by their _init function, called as
 *               mimo_X_init(&x, sizeof x); where there is none, set struct_size to their sizeof and the rest to
 *               0. They only ever grow at the end. What a caller of an older version does not have counts as
 *               0, and in what came after 1.0 that means what 1.0 did. Reserved fields are 0. Descriptions that the
 *               library fills in say in struct_size how much of them it knows; those that it reads as well (mimo_mesh,
 *               mimo_texture, mimo_light) keep theirs.
 *     Newer     A bit, constant or quantity that the library does not know is MIMO_E_UNSUPPORTED, and the message says
 *               its version; see mimo_api_version and mimo_supports.
 *     Units     SI units and radians where nothing else is said; degrees for what cameras see and for cones of light,
 *               months for ages, degrees Celsius for warmth.
 *               Quaternions are w x y z. Frames: x forward, y left, z up. The velocity of a free joint is linear in
 *               the world frame, then angular in the body's own frame.
 */
#ifndef MIMO_H
#define MIMO_H

/* clang-format off */
#include "status.h"
#include "log.h"
#include "scene.h"
#include "growth.h"
#include "agent.h"
#include "maturity.h"
#include "things.h"
#include "observation.h"
#include "env.h"
#include "access.h"
#include "geometry.h"
#include "sight.h"
#include "state.h"
#include "recording.h"
#include "batch.h"
#include "task.h"
#include "senses.h"
#include "hearing.h"
/* clang-format on */

#endif
