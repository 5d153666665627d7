/**
 * @file mimo/experimental/recording.h
 * Recordings: what a program does with a world, written into one HDF5 file by itself, and played again from there.
 * docs/guide/recordings.md has the file's layout. HDF5 1.10 or later is loaded when it is first needed: the one that
 * `hdf5` of a call names, else that of the environment variable MIMO_HDF5, else the system's. It stays for the
 * process. In programs with elevated rights (setuid and the like) MIMO_HDF5 does not count, and recordings are
 * MIMO_E_UNSUPPORTED where HDF5's own variables (HDF5_...) are set. HDF5 itself does not survive it when memory runs
 * out while it starts.
 */
#ifndef MIMO_EXPERIMENTAL_RECORDING_H
#define MIMO_EXPERIMENTAL_RECORDING_H

#include "../agent.h"
#include "../env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Writes a world's steps into a file. */
typedef struct mimo_recorder mimo_recorder;

/** A recording that is read. */
typedef struct mimo_recording mimo_recording;

/** What is recorded, and how. */
typedef struct mimo_recorder_config {
  uint32_t struct_size;      /**< sizeof(mimo_recorder_config), set by mimo_recorder_config_init. */
  uint32_t compression;      /**< 0 for none to 9 for the smallest file. Default 4. */
  const char *keep;          /**< Fields to keep of each step: "all", "none", or senses and fields with commas between
                                  them, "touch,vision/eye_left". NULL (default): proprioception and vestibular of
                                  whoever has them. */
  double state_seconds;      /**< Simulated seconds between states that are kept, 0.001 to 1e6. Default 1. */
  double flush_seconds;      /**< Real seconds after which all is on its way to the disk, 0 to 1e6; 0: each step.
                                  Default 1. */
  const char *configuration; /**< What the program wants to find again: a text, best JSON. NULL (default): "". */
  uint64_t seed;             /**< For people: the attribute `seed`. Replays do not need it. Default 0. */
  const char *hdf5;          /**< Path of the HDF5 library; NULL (default): see above. */
  uint32_t replace;          /**< 1: a whole recording that is there, and that no program is using, is replaced.
                                  0 (default): it stays, and the recorder is refused. */
  uint32_t reserved;         /**< 0. */
} mimo_recorder_config;

/**
 * Fills a config with defaults.
 * @param size sizeof(mimo_recorder_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_recorder_config_init(mimo_recorder_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Records every mimo_env_step and mimo_env_follow of a world from now on: actions, rewards, joints and the chosen
 * fields; of a world of a batch also those of mimo_batch_step. Whatever else changes the world between two steps
 * (resets, also to another age; values that are set, loaded states, bare physics, sounds, random numbers) is counted,
 * and where something was, a state is kept from which a replay goes on there. Steps of mimo_env_follow have no actions,
 * and only a replay by joints plays them. Kept fields are sensed also where a step skips them. A step that fails is not
 * recorded. A clone is not recorded.
 *
 * A file that cannot be written (a full disk) never makes a step fail: the recording ends there, one warning goes to
 * the world's log, and mimo_recorder_flush and mimo_recorder_close answer with what happened.
 * Nothing is written over but an empty file and, where `replace` of the config is 1, a whole recording that no program
 * is using; that is replaced once the new one has been made beside it. What else is there stays, as MIMO_E_FILE. While
 * it is recorded, no other recorder takes the file, in this process or another one; where somebody else moves, removes,
 * replaces or cuts it all the same, the recording ends as on a full disk.
 * @param path     of the file.
 * @param config   NULL means defaults.
 * @param recorder receives the handle; close it with mimo_recorder_close, before or after the world is destroyed.
 * Errors: MIMO_E_UNSUPPORTED without HDF5; MIMO_E_NOT_FOUND where keep names what the world does not have;
 *         MIMO_E_BUSY for a world that is being recorded, and for one within a step or a task; MIMO_E_FILE
 *         for a file that cannot be made, and for one that is there and is not to be replaced, is no whole recording
 *         or is in use;
 *         MIMO_E_SIMULATION for a world that has failed.
 */
MIMO_API mimo_status mimo_recorder_open(mimo_env *env, const char *path, const mimo_recorder_config *config,
                                        mimo_recorder **recorder) MIMO_NOEXCEPT;

/**
 * Puts everything on its way to the disk now.
 * Errors: MIMO_E_FILE for what could not be written, now or before.
 */
MIMO_API mimo_status mimo_recorder_flush(mimo_recorder *recorder) MIMO_NOEXCEPT;

/**
 * Keeps the last state, closes the file and destroys the recorder, also where writing failed. NULL and closed handles
 * are ignored. Where the world is gone, the file was closed with it.
 * Errors: as mimo_recorder_flush. MIMO_E_BUSY within a step of the world, and while another thread uses the world: the
 *         recorder then stays.
 */
MIMO_API mimo_status mimo_recorder_close(mimo_recorder *recorder) MIMO_NOEXCEPT;

/**
 * Opens a recording, also one whose program was killed. Anybody may have made the file: docs/guide/recordings.md says
 * what it can do.
 * @param hdf5      path of the HDF5 library, or NULL.
 * @param recording receives the handle; destroy it with mimo_recording_close.
 * Errors: MIMO_E_UNSUPPORTED without HDF5, and for a recording of a newer version; MIMO_E_NOT_FOUND where there is no
 *         such file; MIMO_E_FILE for what is no recording, or was cut off.
 */
MIMO_API mimo_status mimo_recording_open(const char *path, const char *hdf5,
                                         mimo_recording **recording) MIMO_NOEXCEPT;

#define MIMO_REPLAY_FIELDS 0x1u /**< Recorded fields are compared as well. Without it, the world may sense otherwise. */
#define MIMO_REPLAY_JOINTS 0x2u /**< Joints are put where they were, instead of steps. Works with any version. */

#define MIMO_AS_RECORDED 0x40000000u /**< Of a sense for mimo_recording_env: infants have it as they had it. */

/**
 * Makes the world of a recording anew, out of the file alone: its scene with all files, agents, task and parameters.
 * Its infants are of the first age that was recorded; a replay, or a reset, gives them any age that was recorded.
 * What cannot be in a file is a task of your own (mimo_scene_set_task): the world then has one that does nothing, and a
 * replay in it gives the recorded results. The scene is checked as any other one, with the default limits.
 * @param config NULL means as recorded. Else the renderer, its settings, the log, timing and contacts of steps are
 *               those of this config, whose other members are as mimo_env_config_init leaves them.
 * @param senses NULL means as recorded. Else what each infant senses: proprioception, vestibular, vision, touch and
 *               hearing of this config, with all that belongs to them; each may be MIMO_AS_RECORDED. Limits of
 *               fields that are then left out go with them.
 * @param env    receives the handle; destroy it with mimo_env_destroy. It may outlive the recording, whose file stays
 *               open where infants had several ages.
 * Errors: MIMO_E_UNSUPPORTED for a recording of format version 1 or 2, which holds no world; as mimo_env_create;
 *         MIMO_E_FILE for a file that is damaged.
 */
MIMO_API mimo_status mimo_recording_env(const mimo_recording *recording, const mimo_env_config *config,
                                        const mimo_agent_config *senses, mimo_env **env) MIMO_NOEXCEPT;

/**
 * Closes a recording. NULL and destroyed handles are ignored. Where infants had several ages, the file stays open as
 * long as a world of mimo_recording_env.
 */
MIMO_API void mimo_recording_close(mimo_recording *recording) MIMO_NOEXCEPT;

/** What a recording holds. Its strings belong to the recording. */
typedef struct mimo_recording_info {
  uint32_t struct_size;      /**< sizeof(mimo_recording_info), set by the caller. */
  uint32_t format_version;   /**< Of the file. */
  uint32_t same_build;       /**< 1: the loaded library is the one that recorded. */
  uint32_t reserved;         /**< 0. */
  size_t steps;              /**< That can be played. */
  size_t states;             /**< That were kept. */
  size_t actions;            /**< Of a step. */
  size_t agents;             /**< Of a step's rewards. */
  size_t bodies;             /**< Ages that infants had; 0 in recordings of format version 1. */
  double step_seconds;       /**< Of one step. */
  const char *build;         /**< Versions and build that recorded. */
  const char *this_build;    /**< Of the loaded library. */
  const char *configuration; /**< What the recording program left. */
  const char *seed;          /**< As a decimal number. */
  const char *library;       /**< Version of the library that recorded; "" before format version 3. */
  const char *mujoco;        /**< Version of its MuJoCo; "" before format version 3. */
} mimo_recording_info;

/** Describes a recording. Set info->struct_size first. */
MIMO_API mimo_status mimo_recording_describe(const mimo_recording *recording, mimo_recording_info *info) MIMO_NOEXCEPT;

/**
 * How many rows a dataset has ("actions", "joints/position", "fields/hearing/ear_left"), and how long they are.
 * @param rows      receives their number; may be NULL.
 * @param row_bytes receives the length of one; may be NULL.
 * Errors: MIMO_E_NOT_FOUND where the recording does not have it.
 */
MIMO_API mimo_status mimo_recording_size(const mimo_recording *recording, const char *dataset, size_t *rows,
                                         size_t *row_bytes) MIMO_NOEXCEPT;

/**
 * Reads rows of a dataset, as numbers of the type that they have in the file.
 * @param first  the first row.
 * @param rows   how many; all of them must be there.
 * @param values receives rows times row_bytes bytes.
 */
MIMO_API mimo_status mimo_recording_read(const mimo_recording *recording, const char *dataset, size_t first,
                                         size_t rows, void *values, size_t value_bytes) MIMO_NOEXCEPT;

/**
 * Begins a replay: a world of the same scene, actuation and task, whose senses may be others, takes the last kept state
 * that is not later than a step. Its infants become as old as they were. What was compared before is forgotten.
 *
 * Where the model is another one (after changes of the library, with another MuJoCo), states do not fit it. With
 * MIMO_REPLAY_JOINTS none is loaded: positions and velocities of the joints are set, and what is sensed of them is as
 * of mimo_env_observe. Senses with a memory (receptors, hearing, delays) then remember nothing; results are the
 * recorded ones.
 * @param step 0 to the recording's steps.
 * @param how  MIMO_REPLAY_ bits.
 * @param at   receives the state's own step, from which the replay goes on; may be NULL.
 * Errors: MIMO_E_MISMATCH for a world with other joints, actions, agents or time of a step, which then stays as it is,
 *         and for one of another model, which has been reset; the message has both models' hashes and versions;
 *         as mimo_env_state_load, and then the world has been reset.
 */
MIMO_API mimo_status mimo_recording_seek(mimo_recording *recording, mimo_env *env, size_t step,
                                         uint32_t how, size_t *at) MIMO_NOEXCEPT;

/**
 * Plays the next step in the world that was given to mimo_recording_seek: loads a state where something else had
 * changed that world, steps with the recorded actions, and compares what comes of it with the recording, bit for bit.
 * Between two calls the world may be looked at, not changed.
 * @param block       as in mimo_env_step, and so are block_bytes and results.
 * Errors: MIMO_E_END behind the last step; MIMO_E_INVALID_ARGUMENT for another world than that of the seek;
 *         MIMO_E_BUSY before any seek; as mimo_env_step. After MIMO_E_TASK the replay goes on with the next step.
 */
MIMO_API mimo_status mimo_recording_step(mimo_recording *recording, mimo_env *env, void *block, size_t block_bytes,
                                         const mimo_env_results *results) MIMO_NOEXCEPT;

/** What a replay has shown so far. */
typedef struct mimo_replay_report {
  uint32_t struct_size;        /**< sizeof(mimo_replay_report), set by the caller. */
  uint32_t identical;          /**< 1: all that was compared was the same to the last bit. */
  size_t next;                 /**< The step that comes next. */
  size_t steps;                /**< How many were played. */
  size_t first_difference;     /**< The first step that differed; without meaning where all was identical. */
  double largest_difference;   /**< Of any number; numbers that are not finite count as the largest double. */
  const char *differs_most_in; /**< The dataset in which that was, "" where all was identical. Valid until the
                                    recording's next call that is not const. */
} mimo_replay_report;

/** Tells of the replay. Set report->struct_size first. */
MIMO_API mimo_status mimo_recording_report(const mimo_recording *recording, mimo_replay_report *report) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
