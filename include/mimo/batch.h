/**
 * @file mimo/batch.h
 * Batches: many worlds of one scene, stepped by a pool of threads. World i does exactly what a single
 * environment does that is reset with the i-th seed and given the i-th actions, for any number of threads.
 * Arrays stack the worlds along their first axis: blocks lie at i * block_bytes of mimo_layout_info.
 *
 * What one world cannot do (its simulation failed, its actions are not numbers) stops none of the others. The
 * call then returns the status of the first such world, mimo_last_error() names it, and
 * mimo_batch_world_error tells of each. Masks have one byte a world: 0 leaves that world alone, and its
 * rows as they are; a NULL mask means all.
 */
#ifndef MIMO_BATCH_H
#define MIMO_BATCH_H

#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Many worlds. Needs itself alone like an environment; its threads are its own business. */
typedef struct mimo_batch mimo_batch;

#define MIMO_AUTORESET_NONE 0 /**< Worlds go on when an episode has ended, until mimo_batch_reset. */
/**
 * The step after the end of an episode starts a new one instead of acting: its reward, its flags, outcome and terms are
 * 0, its block is that of the reset.
 */
#define MIMO_AUTORESET_NEXT_STEP 1
/**
 * The step that ends an episode also starts the next one: reward and flags are those of the old episode, the block is
 * the first of the new one; the last block of the old one goes to final_blocks.
 */
#define MIMO_AUTORESET_SAME_STEP 2

/** How many worlds, and what happens when one's episode ends. Modes are those of Gymnasium's vector environments. */
typedef struct mimo_batch_config {
  uint32_t struct_size;    /**< sizeof(mimo_batch_config), set by mimo_batch_config_init. */
  uint32_t worlds;         /**< At least 1. Default 1. */
  uint32_t threads;        /**< 0 (default): as many as the machine has cores; never more than worlds. */
  int32_t autoreset;       /**< A MIMO_AUTORESET_ constant. When one agent's episode ends, the others' are truncated. */
  uint32_t restart_failed; /**< 1: a world whose simulation fails starts a new episode, as after an end (with NONE: in
                                the same step). 0: it stays failed until mimo_batch_reset or a state is loaded. */
  uint32_t reserved;       /**< 0. */
  /** Ages: all infants of world i become cohort[i % cohort_count]; where that is NULL they are as the scene says. */
  const mimo_growth *const *cohort;
  size_t cohort_count; /**< 0 (default): all are as the scene says; at most worlds. */
} mimo_batch_config;

/**
 * Fills a config with defaults: one world, all cores, no automatic reset.
 * @param size sizeof(mimo_batch_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_batch_config_init(mimo_batch_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene, once for each age, and makes worlds of it, which share what belongs to their age. Until seeded,
 * world i's random numbers are those of seed i.
 * @param env_config   for all worlds; NULL means defaults. Messages of the worlds come on the thread that calls.
 * @param batch_config NULL means defaults.
 * Errors: as mimo_env_create; of a cohort as mimo_growth says, and MIMO_E_INVALID_ARGUMENT where it would make the
 *         observations of the worlds differ in shape (keep_spacing).
 */
MIMO_API mimo_status mimo_batch_create(const mimo_scene *scene, const mimo_env_config *env_config,
                                       const mimo_batch_config *batch_config, mimo_batch **batch) MIMO_NOEXCEPT;

/**
 * Destroys a batch, its worlds and their handles; waits for what was sent, with all that its tasks do. NULL and
 * destroyed handles are ignored.
 */
MIMO_API void mimo_batch_destroy(mimo_batch *batch) MIMO_NOEXCEPT;

/** Number of worlds and of threads; either may be NULL. */
MIMO_API mimo_status mimo_batch_size(const mimo_batch *batch, size_t *worlds, size_t *threads) MIMO_NOEXCEPT;

/**
 * What each of the worlds observes, acts with and is rewarded for; also between mimo_batch_send and _receive. Of worlds
 * of different ages the bounds are the widest that any has had, the places of receptors those of the first as it was
 * made.
 */
MIMO_API mimo_status mimo_batch_layout(const mimo_batch *batch, const mimo_layout **layout) MIMO_NOEXCEPT;

/**
 * One world as an environment. All functions of environments work on it, between the batch's own calls: names,
 * contacts, pictures, state, single steps.
 * Different worlds may then be used by different threads, or by tasks of other batches.
 * @param env receives a handle that belongs to the batch; mimo_env_destroy leaves it alone. Between
 *            mimo_batch_send and mimo_batch_receive it is refused with MIMO_E_BUSY.
 */
MIMO_API mimo_status mimo_batch_world(mimo_batch *batch, size_t world, mimo_env **env) MIMO_NOEXCEPT;

/**
 * What became of one world in the last call that concerned it.
 * @param status  MIMO_OK, or why it did not do what was asked; may be NULL.
 * @param message one line, "" for none; valid until the next call with this batch; may be NULL.
 */
MIMO_API mimo_status mimo_batch_world_error(const mimo_batch *batch, size_t world, mimo_status *status,
                                            const char **message) MIMO_NOEXCEPT;

/** Which worlds start an episode, and how. Who sets nothing but struct_size gets what NULL gives. */
typedef struct mimo_batch_reset_config {
  uint32_t struct_size;  /**< sizeof(mimo_batch_reset_config), set by the caller. */
  uint32_t reserved;     /**< 0. */
  const uint64_t *seeds; /**< One for each world; NULL: every world goes on with its own random numbers. */
  const uint8_t *mask;   /**< Which worlds; NULL: all. */
  size_t worlds;         /**< Length of these arrays; 0 if all are NULL. */
  /** One for each world: what all its infants become, as in mimo_reset_config; NULL, also among them: they stay. */
  const mimo_growth *const *growth;
} mimo_batch_reset_config;

/**
 * Starts episodes. Where a growth is refused, no world has changed.
 * @param config NULL: in all worlds, with their own random numbers.
 * @param blocks receives the observations of the worlds that were reset; may be NULL with block_bytes 0.
 */
MIMO_API mimo_status mimo_batch_reset(mimo_batch *batch, const mimo_batch_reset_config *config, void *blocks,
                                      size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Where the results of a step go, beside the observations. All are optional: NULL is not written.
 * A world whose simulation failed and that was not restarted in this step gets a block of zeros, reward 0,
 * terminated 0, truncated 1, outcome and terms 0. So does one whose task failed, but for truncated 0: it has moved. One
 * whose actions are refused (see mimo_env_step) does not move, and only its status is written.
 */
typedef struct mimo_batch_results {
  uint32_t struct_size;   /**< sizeof(mimo_batch_results), set by the caller. */
  uint32_t reserved;      /**< 0. */
  double *reward;         /**< worlds x agents. */
  uint8_t *terminated;    /**< worlds x agents. */
  uint8_t *truncated;     /**< worlds x agents. */
  int32_t *outcome;       /**< worlds x agents, MIMO_OUTCOME_ constants. */
  size_t agent_count;     /**< Length of the four arrays above: worlds x agents. */
  double *terms;          /**< worlds x terms, as in mimo_env_results. */
  size_t term_count;      /**< Length of terms: worlds x terms. */
  mimo_status *status;    /**< Per world: MIMO_OK, or why it failed (also when it was restarted). */
  uint8_t *was_reset;     /**< Per world: 1 when this step started a new episode: the block is its first. */
  uint8_t *final_written; /**< Per world: 1 when its final block was written. */
  size_t worlds;          /**< Length of the three arrays above. */
  void *final_blocks;     /**< With MIMO_AUTORESET_SAME_STEP: last observations of the episodes that ended; other rows
                               stay as they are. */
  size_t final_bytes;     /**< Length, as that of the blocks. */
} mimo_batch_results;

/**
 * Goes one step on in all worlds.
 * @param actions worlds x actions of mimo_layout_info; NULL with action_count 0 leaves all controls as they are.
 * @param blocks  receives the observations; NULL with block_bytes 0 skips the senses.
 * @param results NULL: not wanted.
 * Errors: those of the first world that did not do what was asked and was not restarted; all others have gone on.
 */
MIMO_API mimo_status mimo_batch_step(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/**
 * Starts a step and returns at once, so that the caller can do something else meanwhile. Until mimo_batch_receive the
 * actions are read, and the blocks and what results points to are written: they have to stay where they are. The struct
 * results itself is not kept. Nothing but mimo_batch_receive and mimo_batch_destroy can be called in between: the rest
 * answers MIMO_E_BUSY.
 */
MIMO_API mimo_status mimo_batch_send(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/**
 * Waits for the step that was sent.
 * Errors: as mimo_batch_step; MIMO_E_BUSY where none was sent, and within a task of that step.
 */
MIMO_API mimo_status mimo_batch_receive(mimo_batch *batch) MIMO_NOEXCEPT;

/** The observations of the current states, as mimo_env_observe. */
MIMO_API mimo_status mimo_batch_observe(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *blocks,
                                        size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Reads a quantity of many ids in many worlds, as mimo_env_get; so that a reward needs one call and no loop.
 * @param values worlds x the width that mimo_env_width gives for the ids.
 * Errors: MIMO_E_INVALID_ARGUMENT for contacts, of which worlds have different numbers.
 */
MIMO_API mimo_status mimo_batch_get(const mimo_batch *batch, int32_t quantity, const int32_t *ids, size_t id_count,
                                    const uint8_t *mask, size_t worlds, double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/** The same in single precision, for engines. */
MIMO_API mimo_status mimo_batch_get_float(const mimo_batch *batch, int32_t quantity, const int32_t *ids,
                                          size_t id_count, const uint8_t *mask, size_t worlds, float *values,
                                          size_t value_count) MIMO_NOEXCEPT;

/** Writes a quantity of many ids in many worlds, as mimo_env_set. All values are checked before any is written. */
MIMO_API mimo_status mimo_batch_set(mimo_batch *batch, int32_t quantity, const int32_t *ids, size_t id_count,
                                    const uint8_t *mask, size_t worlds, const double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/**
 * Room for the state of each world: the size of the longest. Worlds of different ages may have states of different
 * sizes. It changes only where a reset brings another age.
 */
MIMO_API mimo_status mimo_batch_state_size(const mimo_batch *batch, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves the states of many worlds.
 * @param states worlds x mimo_batch_state_size bytes; a state that is shorter is followed by zeros.
 */
MIMO_API mimo_status mimo_batch_state_save(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *states,
                                           size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads states into many worlds, from this batch or from other worlds of the same model, as mimo_env_state_load.
 * @param states as many bytes for each world, which begin with its state, and zeros follow; or just one state, without
 *               zeros, which all worlds load: futures of one present.
 * @param report receives what started fresh in the world where that was most; may be NULL.
 * Errors: as mimo_env_state_load, of the first world that did not load its state; others have. Where the bytes hold
 *         anything else than such states, no world has changed.
 */
MIMO_API mimo_status mimo_batch_state_load(mimo_batch *batch, const uint8_t *mask, size_t worlds, const void *states,
                                           size_t state_bytes, mimo_load_report *report) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
