/**
 * @file mimo/batch.h
 * Batches: many worlds of one scene, stepped by a pool of threads. For any number of threads, world i behaves exactly
 * as a single environment with the i-th seed and the i-th actions. Arrays stack the worlds along their first axis:
 * block i starts at i * block_bytes of mimo_layout_info.
 *
 * An error in one world (its simulation failed, its actions are not numbers) does not stop the others. The call then
 * returns the status of the first such world, mimo_last_error() names it, and mimo_batch_world_error returns the error
 * of each. A mask has one byte per world: 0 skips that world and leaves its rows unchanged; a NULL mask selects all.
 * Beside a mask, `worlds` is its length, the number of worlds; beside a NULL mask it is that or 0.
 */
#ifndef MIMO_BATCH_H
#define MIMO_BATCH_H

#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Many worlds, with threads of their own. Several threads use it as any other handle, see mimo.h. */
typedef struct mimo_batch mimo_batch;

#define MIMO_AUTORESET_NONE 0 /**< Worlds continue after the end of an episode, until mimo_batch_reset. */
/**
 * The step after the end of an episode starts a new one instead of acting: its reward, flags, outcome and terms are 0,
 * and its block is the reset's.
 */
#define MIMO_AUTORESET_NEXT_STEP 1
/**
 * The step that ends an episode also starts the next one: reward and flags belong to the old episode, the block is the
 * first of the new one, and the last block of the old one goes to final_blocks.
 */
#define MIMO_AUTORESET_SAME_STEP 2

/** Settings of a batch. The autoreset modes are those of Gymnasium's vector environments. */
typedef struct mimo_batch_config {
  uint32_t struct_size;    /**< sizeof(mimo_batch_config), set by mimo_batch_config_init. */
  uint32_t worlds;         /**< 1 (default) to 1048576. */
  uint32_t threads;        /**< Up to 4096; 0 (default): the cores that the caller may use. Never more than worlds. */
  int32_t autoreset;       /**< A MIMO_AUTORESET_ constant. When one agent's episode ends, the others' are truncated. */
  uint32_t restart_failed; /**< 1: a world whose simulation fails starts a new episode, as after an end (with
                                _AUTORESET_NONE: in the same step). 0: it stays failed until mimo_batch_reset or a
                                loaded state. */
  uint32_t reserved;       /**< 0. */
  /** Ages: cohort[i % cohort_count] applies to all infants of world i; where it is NULL, the scene's age applies. */
  const mimo_growth *const *cohort;
  size_t cohort_count; /**< At most worlds; 0 (default): the scene's age applies to all. */
} mimo_batch_config;

/**
 * Fills a config with defaults: one world, all cores that the caller may use, no automatic reset.
 * @param size sizeof(mimo_batch_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_batch_config_init(mimo_batch_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Compiles a scene, once for each age, and makes worlds of it; worlds of one age share its model. Until it is seeded,
 * world i has the random numbers of seed i. Reset it before the first step, see mimo_env_create.
 * @param env_config   for all worlds; NULL means defaults. Messages of the worlds arrive on the caller's thread.
 * @param batch_config NULL means defaults.
 * Errors: as mimo_env_create; for a cohort as mimo_growth says, and MIMO_E_INVALID_ARGUMENT if it would make the
 *         worlds' observations differ in shape (keep_spacing).
 */
MIMO_API mimo_status mimo_batch_create(const mimo_scene *scene, const mimo_env_config *env_config,
                                       const mimo_batch_config *batch_config, mimo_batch **batch) MIMO_NOEXCEPT;

/**
 * Destroys a batch, its worlds and their handles; waits for a step that was sent, including its tasks. NULL and
 * destroyed handles are ignored.
 */
MIMO_API void mimo_batch_destroy(mimo_batch *batch) MIMO_NOEXCEPT;

/** Number of worlds and of threads; either may be NULL. */
MIMO_API mimo_status mimo_batch_size(const mimo_batch *batch, size_t *worlds, size_t *threads) MIMO_NOEXCEPT;

/**
 * Layout of each world's observations, actions and rewards; also available between mimo_batch_send and _receive. With
 * worlds of different ages the bounds are the widest so far, and the places of receptors are those of the first world
 * when it was made.
 */
MIMO_API mimo_status mimo_batch_layout(const mimo_batch *batch, const mimo_layout **layout) MIMO_NOEXCEPT;

/**
 * One world as an environment. Between the batch's own calls all functions of environments accept it, for names,
 * contacts, pictures, states and single steps. Different worlds may then be used by different threads, or by tasks of
 * other batches.
 * @param env receives a handle that belongs to the batch; mimo_env_destroy ignores it. Between mimo_batch_send and
 *            mimo_batch_receive it is refused with MIMO_E_BUSY.
 */
MIMO_API mimo_status mimo_batch_world(mimo_batch *batch, size_t world, mimo_env **env) MIMO_NOEXCEPT;

/**
 * The error of one world in the last call of the batch that included it. Calls on the world's own handle do not change
 * it.
 * @param status  receives MIMO_OK or the reason why it did not do what was asked; may be NULL.
 * @param message receives one line, "" for none; valid until the next call with this batch; may be NULL.
 */
MIMO_API mimo_status mimo_batch_world_error(const mimo_batch *batch, size_t world, mimo_status *status,
                                            const char **message) MIMO_NOEXCEPT;

/** Which worlds start an episode, and how. A struct that is zero except for struct_size has the effect of NULL. */
typedef struct mimo_batch_reset_config {
  uint32_t struct_size;  /**< sizeof(mimo_batch_reset_config), set by the caller. */
  uint32_t reserved;     /**< 0. */
  const uint64_t *seeds; /**< One per world; NULL: every world continues its random numbers. */
  const uint8_t *mask;   /**< The worlds to reset; NULL: all. */
  size_t worlds;         /**< Length of these arrays; 0 if all are NULL. */
  /**
   * One per world: the new age and size of all its infants, as in mimo_reset_config; NULL, also an element: no change.
   */
  const mimo_growth *const *growth;
} mimo_batch_reset_config;

/**
 * Starts episodes. If a growth is refused, no world has changed.
 * @param config NULL: all worlds, which continue their random numbers.
 * @param blocks receives the observations of the worlds that were reset; may be NULL with block_bytes 0.
 */
MIMO_API mimo_status mimo_batch_reset(mimo_batch *batch, const mimo_batch_reset_config *config, void *blocks,
                                      size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Buffers for the results of a step besides the observations. Each may be NULL.
 * A world whose simulation failed and that was not restarted in this step gets a block of zeros, reward 0, terminated
 * 0, truncated 1, outcome and terms 0. A world whose task failed gets the same, except truncated 0: its step has
 * happened. A world whose actions are refused (see mimo_env_step) does not move, and only its status is written.
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
  mimo_status *status;    /**< Per world: MIMO_OK, or why it failed (also if it was restarted). */
  uint8_t *was_reset;     /**< Per world: 1 if this step started a new episode: the block is its first. */
  uint8_t *final_written; /**< Per world: 1 if its final block was written. */
  size_t worlds;          /**< Length of the three arrays above. */
  void *final_blocks;     /**< With MIMO_AUTORESET_SAME_STEP: last observations of the episodes that ended; other rows
                               are not written. */
  size_t final_bytes;     /**< Length of final_blocks in bytes, the same as of the blocks. */
} mimo_batch_results;

/**
 * Simulates one step in all worlds.
 * @param actions worlds x actions of mimo_layout_info; NULL with action_count 0 leaves all controls unchanged.
 * @param blocks  receives the observations; NULL with block_bytes 0 skips the senses.
 * @param results may be NULL.
 * Errors: those of the first world that failed and was not restarted; all others have stepped.
 */
MIMO_API mimo_status mimo_batch_step(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/**
 * Starts a step and returns at once, so that the caller can work meanwhile. Until mimo_batch_receive the library reads
 * the actions and writes the blocks and the arrays of results: keep them in place. The struct results itself is not
 * kept. In between only mimo_batch_receive and mimo_batch_destroy can be called; other functions return MIMO_E_BUSY.
 */
MIMO_API mimo_status mimo_batch_send(mimo_batch *batch, const float *actions, size_t action_count, void *blocks,
                                     size_t block_bytes, const mimo_batch_results *results) MIMO_NOEXCEPT;

/**
 * Waits for the step that was sent.
 * Errors: as mimo_batch_step; MIMO_E_BUSY if none was sent, and within a task of that step.
 */
MIMO_API mimo_status mimo_batch_receive(mimo_batch *batch) MIMO_NOEXCEPT;

/** Observes the current states, as mimo_env_observe. */
MIMO_API mimo_status mimo_batch_observe(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *blocks,
                                        size_t block_bytes) MIMO_NOEXCEPT;

/**
 * Reads a quantity of many ids in many worlds, as mimo_env_get, so that a reward needs one call and no loop.
 * @param values worlds x the width that mimo_env_width gives for the ids.
 * Errors: MIMO_E_INVALID_ARGUMENT for contacts, of which worlds have different numbers.
 */
MIMO_API mimo_status mimo_batch_get(const mimo_batch *batch, mimo_quantity quantity, const int32_t *ids,
                                    size_t id_count, const uint8_t *mask, size_t worlds, double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/** The same in single precision, for engines. */
MIMO_API mimo_status mimo_batch_get_float(const mimo_batch *batch, mimo_quantity quantity, const int32_t *ids,
                                          size_t id_count, const uint8_t *mask, size_t worlds, float *values,
                                          size_t value_count) MIMO_NOEXCEPT;

/** Writes a quantity of many ids in many worlds, as mimo_env_set. All values are checked before any is written. */
MIMO_API mimo_status mimo_batch_set(mimo_batch *batch, mimo_quantity quantity, const int32_t *ids, size_t id_count,
                                    const uint8_t *mask, size_t worlds, const double *values,
                                    size_t value_count) MIMO_NOEXCEPT;

/**
 * Size of each world's state: of the longest, because worlds of different ages may have states of different sizes. Only
 * a reset to another age changes it.
 */
MIMO_API mimo_status mimo_batch_state_size(const mimo_batch *batch, size_t *bytes) MIMO_NOEXCEPT;

/**
 * Saves the states of many worlds. It needs the batch for itself, though it changes no world: its threads do the work,
 * and mimo_batch_world_error tells of this call afterwards.
 * @param states worlds x mimo_batch_state_size bytes; a state that is shorter is followed by zeros.
 * Errors: MIMO_E_SIMULATION if a world has failed; its row is not written, all others are.
 */
MIMO_API mimo_status mimo_batch_state_save(mimo_batch *batch, const uint8_t *mask, size_t worlds, void *states,
                                           size_t state_bytes) MIMO_NOEXCEPT;

/**
 * Loads states into many worlds, from this batch or from other worlds of the same model, as mimo_env_state_load. All
 * rows are checked before any world changes: either all worlds load their states, or none does.
 * @param states      rows of equal length, one per world, each a state followed by zeros; or a single state without
 *                    zeros, which all worlds load.
 * @param state_bytes worlds x mimo_batch_state_size for states of this batch; the rows of other states may have another
 *                    length. For a single state its own size.
 * @param report      receives the report of the world with the most fresh memories; may be NULL.
 * Errors: as mimo_env_state_load, of the first world whose state is refused, for example because its row is damaged;
 *         mimo_batch_world_error tells which others are. No world has changed then. Rows that a mask leaves out are not
 *         read.
 */
MIMO_API mimo_status mimo_batch_state_load(mimo_batch *batch, const uint8_t *mask, size_t worlds, const void *states,
                                           size_t state_bytes, mimo_load_report *report) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
