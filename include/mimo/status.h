/**
 * @file mimo/status.h
 * Versions of the library, the result of a call, and what went wrong.
 */
#ifndef MIMO_STATUS_H
#define MIMO_STATUS_H

#include <stddef.h>
#include <stdint.h>

#include "mimo_export.h"

#if UINTPTR_MAX != UINT64_MAX
#error "This interface is for 64-bit platforms: the structs of others would have other sizes."
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_VERSION_MAJOR 1      /**< Version of this header; mimo_version() gives the library's. */
#define MIMO_VERSION_MINOR 0      /**< See MIMO_VERSION_MAJOR. */
#define MIMO_VERSION_PATCH 0      /**< See MIMO_VERSION_MAJOR. */
#define MIMO_VERSION_LABEL "-rc1" /**< "-rc1" of the first candidate, "" of a release; the end of mimo_version(). */
#define MIMO_ABI_VERSION 1        /**< Changes when old callers would break; equals the SONAME's number. */
#define MIMO_API_MAJOR 1          /**< Version of what is declared here, 1.0; docs/abi.md says what may change. */
#define MIMO_API_MINOR 0          /**< Grows when something is added. */

/** Both in one number, for `#if MIMO_API_VERSION >= 1002`: 1.2 or newer. */
#define MIMO_API_VERSION (MIMO_API_MAJOR * 1000 + MIMO_API_MINOR)

/** Result of a call: MIMO_OK or one of the negative MIMO_E_ constants. */
typedef int32_t mimo_status;

#define MIMO_OK 0                  /**< The call did what it says. */
#define MIMO_E_INVALID_ARGUMENT -1 /**< NULL, out of range, not finite. */
#define MIMO_E_BAD_HANDLE -2       /**< Not a handle of that kind, or one already destroyed. */
#define MIMO_E_BUFFER_TOO_SMALL -3 /**< A caller's buffer is shorter than needed; nothing was written. */
#define MIMO_E_STRUCT_SIZE -4      /**< struct_size is not that of any version. */
#define MIMO_E_NOT_FOUND -5        /**< No body, joint, scene, file... of that name. */
#define MIMO_E_MODEL -6            /**< A model does not compile, or asks for too much; see docs/guide/errors.md. */
#define MIMO_E_SIMULATION -7       /**< The simulation failed or diverged; reset makes the world usable again. */
#define MIMO_E_RENDER -8           /**< The renderer failed. */
#define MIMO_E_UNSUPPORTED -9      /**< Not possible here, or not known to this version: the message says which. */
#define MIMO_E_OUT_OF_MEMORY -10   /**< An allocation failed. */
#define MIMO_E_FORKED -11          /**< The handle was made in the parent process, before fork(). */
#define MIMO_E_INTERNAL -12        /**< A defect in libmimo; please report the message. */
#define MIMO_E_FILE -13            /**< A file cannot be written, or is not what it should be. */
#define MIMO_E_TASK -14            /**< A task of your own failed, or said what cannot be meant; see mimo_env_step. */
#define MIMO_E_BUSY -15            /**< Not now: another thread uses the handle, or another call has to come first. */

/** ABI version of the loaded library; compare with MIMO_ABI_VERSION. Never fails. */
MIMO_API uint32_t mimo_abi_version(void) MIMO_NOEXCEPT;

/** MIMO_API_VERSION of the header that the loaded library was built with. Never fails. */
MIMO_API uint32_t mimo_api_version(void) MIMO_NOEXCEPT;

/**
 * Whether the loaded library knows a name of this interface: a function ("mimo_env_step"), a constant
 * ("MIMO_BODY_MASS"), a struct ("mimo_field") or a member of one ("mimo_field.period"); for programs that load the
 * library at run time.
 * @return 1 or 0; 0 for NULL.
 */
MIMO_API int32_t mimo_supports(const char *name) MIMO_NOEXCEPT;

/** Version of the loaded library, "1.2.3", or "1.2.3-rc1" of a candidate. Static string. */
MIMO_API const char *mimo_version(void) MIMO_NOEXCEPT;

/** Version of the MuJoCo that the library runs on, "2.2.2". Static string. */
MIMO_API const char *mimo_mujoco_version(void) MIMO_NOEXCEPT;

/** Name of a status, "MIMO_E_NOT_FOUND"; "MIMO_E_UNKNOWN" for a number that is none. Static string. */
MIMO_API const char *mimo_status_name(mimo_status status) MIMO_NOEXCEPT;

/**
 * What the last failed call on this thread complained about, one line, never NULL, "" if nothing failed yet. The string
 * belongs to the library and is valid until the next failing call on the same thread. Calls that succeed, and the
 * destroy functions, leave it alone. Within a function of your own task it is "" at first, and what fails there is not
 * seen outside, unless the task fails with it. Messages are UTF-8.
 */
MIMO_API const char *mimo_last_error(void) MIMO_NOEXCEPT;

/**
 * What the last failed call that was given this handle first complained about: for runtimes that move work from thread
 * to thread (Go, Node), where mimo_last_error may be somebody else's. mimo_env_create and the like are given their
 * scene. mimo_scene_create and mimo_env_make are given none: such a runtime stays on one thread for them and
 * mimo_last_error.
 * @param handle   a mimo_scene, mimo_env, mimo_batch, mimo_senses, mimo_recorder or mimo_recording.
 * @param text     receives the message, zero-terminated, "" if nothing failed yet; NULL with capacity 0 asks for its
 *                 length only.
 * @param capacity 1024 bytes are enough for any message.
 * @param length   receives the length without the terminating zero; may be NULL.
 * Errors: as everywhere, but they change no handle's message. Any thread may ask, also while others use the handle.
 */
MIMO_API mimo_status mimo_last_error_of(const void *handle, char *text, size_t capacity,
                                        size_t *length) MIMO_NOEXCEPT;

/**
 * Says what went wrong in a function of your own task: `return mimo_fail(MIMO_E_NOT_FOUND, "no ball in this scene");`.
 * The call that runs the task fails with MIMO_E_TASK and quotes the status and the message.
 * @param status  a MIMO_E_ constant.
 * @param message UTF-8; copied. Control characters are quoted as in C ("\n"), as in all messages.
 * @return status, after mimo_last_error() was set to the message.
 */
MIMO_API mimo_status mimo_fail(mimo_status status, const char *message) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
