/**
 * @file mimo/mimo.h
 * libmimo: MIMo, the multimodal infant model, as a C library.  MIT licence, see LICENSE.
 *
 * The chapters, in the order of use. Each header may also be included alone:
 *
 *     status.h       versions, results of calls, what went wrong
 *     log.h          messages
 *     scene.h        rooms, objects, models, cameras, as a description
 *     growth.h       the age, size and strength of infants
 *     agent.h        infants: their position, their senses, the joints they control
 *     observation.h  the layout of observation blocks, actions and rewards
 *     env.h          a world: making it, steps, rewards
 *     access.h       joints, bodies and contacts by name; values that differ between worlds
 *     geometry.h     shapes and poses for engines that draw the world themselves
 *     sight.h        pictures of the world
 *     state.h        save, load, clone
 *     batch.h        many worlds on several threads
 *     task.h         built-in tasks, their parameters, and custom tasks
 *     senses.h       senses attached to your own simulation
 *
 * Further headers, which may change from version to version, come with experimental.h.
 *
 * Rules that apply everywhere (docs/ has an article on each):
 *
 *     Errors    Functions that can fail return a mimo_status: 0 is success, negative is failure, and
 *               mimo_last_error() then holds one line that names the argument, its value and what was
 *               expected. When an argument is refused, nothing is written anywhere.
 *     Handles   mimo_scene, mimo_env, mimo_batch, mimo_senses, mimo_recorder, mimo_recording and mimo_stage are
 *               opaque, and so is mimo_layout, which belongs to one of them. Destroy functions accept NULL. Every
 *               function refuses a destroyed handle (MIMO_E_BAD_HANDLE); destroying it again does nothing. In a
 *               child process, a handle made before fork() returns MIMO_E_FORKED.
 *     Threads   Several threads may call functions that take a const handle on one handle at the same time. A
 *               function that takes a handle without const needs exclusive use of it and returns MIMO_E_BUSY
 *               while another thread uses it. Different handles are independent. Any thread may call. A thread
 *               that is cancelled (pthread_cancel) within a call finishes the call first.
 *     Memory    Buffers belong to the caller and come with their length in elements (observation blocks:
 *               in bytes), except points and poses, whose length is given in each function's description. A buffer
 *               that is too short is refused and left unchanged (MIMO_E_BUFFER_TOO_SMALL). A length that no
 *               memory can have, such as a negative number converted to size_t, is MIMO_E_INVALID_ARGUMENT.
 *               Strings passed in are UTF-8 and copied. The owner of a returned string is documented with the
 *               function that returns it.
 *     Structs   Versioned structs start with struct_size and are filled by their _init function, called as
 *               mimo_X_init(&x, sizeof x). A struct without an _init function is zeroed and given its sizeof in
 *               struct_size. Structs only grow at their end. Members missing from an older caller's struct are
 *               read as 0; for members added after 1.0, 0 keeps the behaviour of 1.0. Reserved members are 0.
 *               When the library fills a description, it sets struct_size to the part that it knows; structs
 *               that it also reads (mimo_mesh, mimo_texture, mimo_light) keep their struct_size.
 *     Defaults  NULL for a string means its default.
 *     Newer     A bit, constant or quantity that the library does not know is MIMO_E_UNSUPPORTED, and the message
 *               names the library's version; see mimo_api_version and mimo_supports.
 *     Units     SI units and radians unless stated otherwise; degrees for cameras' fields of view and cones of light,
 *               months for ages, degrees Celsius for temperatures.
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
#include "observation.h"
#include "env.h"
#include "access.h"
#include "geometry.h"
#include "sight.h"
#include "state.h"
#include "batch.h"
#include "task.h"
#include "senses.h"
/* clang-format on */

#endif
