/* Batches. See table.h. */

#define BATCH(f, n) BAD_FIELD(batch_config, mimo_batch_config, f, n, #f)
#define BATCH_UNKNOWN(f, n) UNKNOWN_FIELD(batch_config, mimo_batch_config, f, n, #f)
ROW(mimo_batch_create, ON_SCENE, mimo_batch_create(a->scene, a->env_config, a->batch_config, a->made_batch),
    NULL_OK(env_config), NULL_OK(batch_config), NO_NULL(made_batch, "batch"),
    CONFIG(batch_config, mimo_batch_config, "batch_config"), BAD_SIZES(env_config, mimo_env_config, "env_config"),
    BATCH(worlds, 0), BATCH(worlds, -1), BATCH(threads, 4097), BATCH(threads, -1), BATCH_UNKNOWN(autoreset, 3),
    BATCH_UNKNOWN(autoreset, -1), BATCH_UNKNOWN(restart_failed, 2), BATCH_UNKNOWN(reserved, 1),
    DO(too_old, E_ARG, "age"), DO(too_many_ages, E_ARG, "cohort_count"), DO(no_ages, E_ARG, "cohort"))
ROW(mimo_batch_destroy, ON_SCENE | ON_ENV | ON_BATCH | DESTROYS, check_destroy_batch(a), NONE)
ROW(mimo_batch_size, ON_BATCH | ANYTIME, mimo_batch_size(a->batch, a->count, a->count2), NULL_OK(count),
    NULL_OK(count2))
ROW(mimo_batch_world, ON_BATCH, mimo_batch_world(a->batch, a->world, a->made_env), BAD_INDEX(world, "world"),
    NO_NULL(made_env, "env"))
ROW(mimo_batch_world_error, ON_BATCH, mimo_batch_world_error(a->batch, a->world, a->status_out, a->string),
    BAD_INDEX(world, "world"), NULL_OK(status_out), NULL_OK(string))

#define WORLDS EXACT(worlds, "worlds"), BAD_SIZE(worlds, 0, "worlds"), NULL_OK(mask)
#define BLOCKS NO_NULL(blocks, "blocks"), SHORT(blocks_bytes, "blocks")
#define ACTIONS NO_NULL(actions, "actions"), EXACT(actions_count, "action_count")
#define RESULT(f, names) SHORT_FIELD(results, mimo_batch_results, f, names)
#define BATCH_RESULTS                                                                                          \
  NULL_OK(results), CONFIG(results, mimo_batch_results, "results"),                                            \
      UNKNOWN_FIELD(results, mimo_batch_results, reserved, 1, "reserved"), RESULT(agent_count, "agent_count"), \
      RESULT(term_count, "term_count"), RESULT(worlds, "worlds"), RESULT(final_bytes, "final_blocks"),         \
      DO(no_final_blocks, E_ARG, "final_blocks")
#define RESET_FIELD(kind, what, f, status, names) \
  { kind, what, MEMBER(batch_reset), FIELD(mimo_batch_reset_config, f), 1, 0, NULL, status, names }
ROW(mimo_batch_reset, ON_BATCH | HEALS, mimo_batch_reset(a->batch, a->batch_reset, a->blocks, a->blocks_bytes),
    NULL_OK(batch_reset), CONFIG(batch_reset, mimo_batch_reset_config, "config"),
    UNKNOWN_FIELD(batch_reset, mimo_batch_reset_config, reserved, 1, "reserved"),
    RESET_FIELD(FAULT_FIELD_NULL, "seeds is NULL", seeds, MIMO_OK, NULL),
    RESET_FIELD(FAULT_FIELD_NULL, "mask is NULL", mask, MIMO_OK, NULL),
    RESET_FIELD(FAULT_FIELD_LESS, "worlds is one too small", worlds, E_ARG, "worlds"), DO(too_old, E_ARG, "age"),
    BLOCKS)
ROW(mimo_batch_step, ON_BATCH | SIMULATES,
    mimo_batch_step(a->batch, a->actions, a->actions_count, a->blocks, a->blocks_bytes, a->results), ACTIONS, BLOCKS,
    BATCH_RESULTS)
ROW(mimo_batch_send, ON_BATCH | SIMULATES, send_and_receive(a), ACTIONS, BLOCKS, BATCH_RESULTS)
ROW(mimo_batch_receive, ON_BATCH | SIMULATES | ANYTIME, send_and_receive(a), DO(nothing_sent, MIMO_E_BUSY, "without"),
    DO(nothing_to_receive_from, MIMO_E_BAD_HANDLE, "destroyed"))
ROW(mimo_batch_observe, ON_BATCH | SIMULATES,
    mimo_batch_observe(a->batch, a->mask, a->worlds, a->blocks, a->blocks_bytes), WORLDS, BLOCKS,
    DO(no_blocks, E_ARG, "blocks"))
ROW(mimo_batch_spontaneous, ON_BATCH,
    mimo_batch_spontaneous(a->batch, MIMO_MOVEMENT_ALL, a->all_moves, a->actions_count), NO_NULL(all_moves, "actions"),
    SHORT(actions_count, "count"))
ROW(mimo_batch_get, ON_BATCH,
    mimo_batch_get(a->batch, a->quantity, a->ids, a->id_count, a->mask, a->worlds, a->all_values, a->values_count),
    QUANTITIES, IDS, WORLDS, NO_NULL(all_values, "values"), VALUES(values_count))
ROW(mimo_batch_get_float, ON_BATCH,
    mimo_batch_get_float(a->batch, a->quantity, a->ids, a->id_count, a->mask, a->worlds, a->depth, a->values_count),
    QUANTITIES, IDS, WORLDS, NO_NULL(depth, "values"), VALUES(values_count))
ROW(mimo_batch_set, ON_BATCH | SIMULATES,
    mimo_batch_set(a->batch, a->quantity, a->ids, a->id_count, a->mask, a->worlds, a->all_to_write, a->values_count),
    QUANTITIES, IDS, WORLDS, NO_NULL(all_to_write, "values"), GIVEN_VALUES(values_count),
    DO(nan_value, E_ARG, "values[0]"), DO(infinite_value, E_ARG, "values[0]"),
    BAD_I32(quantity, MIMO_JOINT_RANGE, "quantity"))
ROW(mimo_batch_state_size, ON_BATCH, mimo_batch_state_size(a->batch, a->count), NO_NULL(count, "bytes"))
ROW(mimo_batch_state_save, ON_BATCH | SIMULATES,
    mimo_batch_state_save(a->batch, a->mask, a->worlds, a->states_out, a->states_bytes), WORLDS,
    NO_NULL(states_out, "states"), SHORT(states_bytes, "states"))
ROW(mimo_batch_state_load, ON_BATCH | HEALS,
    mimo_batch_state_load(a->batch, a->mask, a->worlds, a->states, a->states_bytes, a->report), WORLDS,
    NO_NULL(states, "states"), EXACT(states_bytes, "state_bytes"), SIZE_IS(states_bytes, 0, MIMO_E_FILE, "state"),
    LOAD_REPORT)
