/**
 * @file mimo/status.h
 * Versions of the library, results of calls, and error messages.
 */
#ifndef MIMO_STATUS_H
#define MIMO_STATUS_H

#include <stddef.h>
#include <stdint.h>

#include "mimo_export.h"

#if UINTPTR_MAX != UINT64_MAX && !defined(__wasm32__)
#error "This interface is for 64-bit platforms and WebAssembly: the structs of others would have other sizes."
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_VERSION_MAJOR 1      /**< Version of this header; mimo_version() gives the library's. */
#define MIMO_VERSION_MINOR 0      /**< See MIMO_VERSION_MAJOR. */
#define MIMO_VERSION_PATCH 0      /**< See MIMO_VERSION_MAJOR. */
#define MIMO_VERSION_LABEL "-rc2" /**< "-rc2" of the second candidate, "" of a release; the end of mimo_version(). */
#define MIMO_ABI_VERSION 1        /**< Changes when old callers would break; equals the number in the SONAME. */
#define MIMO_API_MAJOR 1          /**< Version of the declarations, 1.0; docs/abi.md says what may change. */
#define MIMO_API_MINOR 0          /**< Grows when something is added. */

/** Both in one number, for `#if MIMO_API_VERSION >= 1002`: 1.2 or newer. */
#define MIMO_API_VERSION (MIMO_API_MAJOR * 1000 + MIMO_API_MINOR)

/** Result of a call: MIMO_OK or one of the negative MIMO_E_ constants. */
typedef int32_t mimo_status;

/** A kind of things in a world: MIMO_BODY, MIMO_JOINT, ... (access.h). */
typedef int32_t mimo_kind;

/** What can be read of things: MIMO_BODY_POSITION, ... (access.h), MIMO_RECEPTOR_POSITION, ... (observation.h). */
typedef int32_t mimo_quantity;

#define MIMO_OK 0                  /**< The call succeeded. */
#define MIMO_E_INVALID_ARGUMENT -1 /**< An argument is NULL, out of range or not finite. */
#define MIMO_E_BAD_HANDLE -2       /**< The handle is of another kind, or was destroyed. */
#define MIMO_E_BUFFER_TOO_SMALL -3 /**< A buffer to be written is too short; nothing was written. */
#define MIMO_E_STRUCT_SIZE -4      /**< struct_size is not the size in any version. */
#define MIMO_E_NOT_FOUND -5        /**< Nothing has that name: no body, joint, scene, file... */
#define MIMO_E_MODEL -6            /**< A model does not compile or exceeds a limit; see docs/guide/errors.md. */
#define MIMO_E_SIMULATION -7       /**< The simulation failed or diverged; reset the world to use it again. */
#define MIMO_E_RENDER -8           /**< The renderer failed. */
#define MIMO_E_UNSUPPORTED -9      /**< Not possible on this machine, or newer than this library. */
#define MIMO_E_OUT_OF_MEMORY -10   /**< An allocation failed. */
#define MIMO_E_FORKED -11          /**< The handle was made in the parent process, before fork(). */
#define MIMO_E_INTERNAL -12        /**< A defect in libmimo; please report the message. */
#define MIMO_E_FILE -13            /**< A file cannot be written; a file or state is damaged, or is none. */
#define MIMO_E_TASK -14            /**< A custom task or sense failed or returned invalid values; see mimo_env_step. */
#define MIMO_E_BUSY -15            /**< Not now: another thread uses the handle, or another call has to come first. */
#define MIMO_E_MISMATCH -16        /**< A state or recording is of another model, age, task or kind of agents. */
#define MIMO_E_END -17             /**< A recording has no further step. */

/** ABI version of the loaded library; compare with MIMO_ABI_VERSION. Never fails. */
MIMO_API uint32_t mimo_abi_version(void) MIMO_NOEXCEPT;

/** MIMO_API_VERSION of the header that the loaded library was built with. Never fails. */
MIMO_API uint32_t mimo_api_version(void) MIMO_NOEXCEPT;

/**
 * Tells whether the loaded library has a name of this interface: a function ("mimo_env_step"), a constant
 * ("MIMO_BODY_MASS"), a struct ("mimo_field") or a member of one ("mimo_field.period"); for programs that load the
 * library at run time.
 * @return 1 or 0; 0 for NULL.
 */
MIMO_API int32_t mimo_supports(const char *name) MIMO_NOEXCEPT;

/** Version of the loaded library, "1.2.3", or "1.2.3-rc1" of a candidate. Static string. */
MIMO_API const char *mimo_version(void) MIMO_NOEXCEPT;

/** Version of the MuJoCo that the library runs on, "2.2.2". Static string. */
MIMO_API const char *mimo_mujoco_version(void) MIMO_NOEXCEPT;

/** Name of a status, "MIMO_E_NOT_FOUND"; "MIMO_E_UNKNOWN" for any other number. Static string. */
MIMO_API const char *mimo_status_name(mimo_status status) MIMO_NOEXCEPT;

/**
 * Message of the last failed call on this thread: one line of UTF-8, never NULL, "" if no call has failed yet. The
 * string belongs to the library and is valid until the next failing call on the same thread. Successful calls and the
 * destroy functions do not change it. Within a function of a custom task it starts as "", and errors inside it do not
 * reach the caller unless the task fails with them.
 */
MIMO_API const char *mimo_last_error(void) MIMO_NOEXCEPT;

/**
 * Message of the last failed call that had this handle as its first argument, for runtimes that move work between
 * threads (Go, Node), where mimo_last_error may belong to another call. Functions that make a handle out of a scene
 * (mimo_env_create) keep their message with the scene. mimo_scene_create and mimo_env_make have no handle: call them
 * and mimo_last_error on one thread.
 * @param handle   a mimo_scene, mimo_env, mimo_batch, mimo_senses, mimo_layout, mimo_recorder, mimo_recording or
 *                 mimo_stage.
 * @param text     receives the message, zero-terminated, "" if no call has failed yet; NULL with capacity 0 asks only
 *                 for its length.
 * @param capacity 1024 bytes are enough for any message.
 * @param length   receives the length without the terminating zero; may be NULL.
 * Errors of this function do not change any handle's message. Any thread may call it, also while others use the handle.
 */
MIMO_API mimo_status mimo_last_error_of(const void *handle, char *text, size_t capacity,
                                        size_t *length) MIMO_NOEXCEPT;

/**
 * Reports an error in a function of a custom task or sense: `return mimo_fail(MIMO_E_NOT_FOUND, "no ball in this
 * scene");`. The call that runs the function fails with MIMO_E_TASK and quotes the status and the message.
 * @param status  a MIMO_E_ constant.
 * @param message UTF-8; copied. Control characters are quoted as in C ("\n"), as in all messages.
 * @return status, after mimo_last_error() was set to the message.
 */
MIMO_API mimo_status mimo_fail(mimo_status status, const char *message) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
