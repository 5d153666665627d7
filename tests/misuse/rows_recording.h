/* Recordings. */
#define RECORDER_REAL(f, n) BAD_REAL(recorder_config, mimo_recorder_config, f, n, #f)
ROW(mimo_recorder_config_init, 0,
    mimo_recorder_config_init(a->recorder_config, sizeof *a->recorder_config + a->more_bytes),
    INIT(recorder_config, mimo_recorder_config, "config"))
ROW(mimo_recorder_open, ON_ENV | SIMULATES, open_recorder(a), NO_NULL(new_run, "path"), NULL_OK(recorder_config),
    CONFIG(recorder_config, mimo_recorder_config, "config"), NO_NULL(made_recorder, "recorder"),
    BAD_FIELD(recorder_config, mimo_recorder_config, compression, 10, "compression"),
    UNREAL(recorder_config, mimo_recorder_config, state_seconds, "state_seconds"), RECORDER_REAL(state_seconds, 0),
    UNREAL(recorder_config, mimo_recorder_config, flush_seconds, "flush_seconds"), RECORDER_REAL(flush_seconds, -1),
    UNKNOWN_FIELD(recorder_config, mimo_recorder_config, replace, 2, "replace"),
    UNKNOWN_FIELD(recorder_config, mimo_recorder_config, reserved, 1, "reserved"),
    DO(keeps_wings, MIMO_E_NOT_FOUND, "wings"))
ROW(mimo_recorder_flush, ON_RECORDER, mimo_recorder_flush(a->recorder), NONE)
ROW(mimo_recorder_close, ON_ENV | ON_RECORDER | DESTROYS, check_close_recorder(a), NONE)
ROW(mimo_recording_open, 0, mimo_recording_open(a->run, NULL, a->made_recording), NO_NULL(run, "path"),
    NO_NULL(made_recording, "recording"), DO(no_run, MIMO_E_NOT_FOUND, "/no_such_run.h5"))
ROW(mimo_recording_close, ON_ENV | ON_RECORDING | DESTROYS, check_destroy_recording(a), NONE)
ROW(mimo_recording_describe, ON_RECORDING, mimo_recording_describe(a->recording, a->recording_info),
    DESCRIPTION(recording_info, mimo_recording_info, "info"))
ROW(mimo_recording_size, ON_RECORDING, mimo_recording_size(a->recording, a->dataset, a->count, a->count2),
    NO_NULL(dataset, "dataset"), NULL_OK(count), NULL_OK(count2), DO(no_dataset, MIMO_E_NOT_FOUND, "wings"))
ROW(mimo_recording_read, ON_RECORDING,
    mimo_recording_read(a->recording, a->dataset, a->row_index, a->row_count, a->memory_out, a->rows_bytes),
    NO_NULL(dataset, "dataset"), NO_NULL(memory_out, "values"), SHORT(rows_bytes, "values"),
    BAD_SIZE(row_index, 1, "first"), BAD_INDEX(row_index, "first"), BAD_SIZE(row_count, 3, "rows"),
    BAD_SIZE(row_count, -1, "rows"), DO(no_dataset, MIMO_E_NOT_FOUND, "wings"))
ROW(mimo_recording_seek, ON_RECORDING | ON_ENV | HEALS,
    mimo_recording_seek(a->recording, a->env, a->row_index, (uint32_t)a->compare, a->count), NULL_OK(count),
    BAD_SIZE(row_index, 3, "step"), BAD_INDEX(row_index, "step"), UNKNOWNS(compare, 4, "how"))
ROW(mimo_recording_env, ON_RECORDING, mimo_recording_env(a->recording, NULL, NULL, a->made_env),
    NO_NULL(made_env, "env"))
ROW(mimo_recording_step, ON_RECORDING | ON_ENV | HEALS, seek_and_step(a), NULL_OK(env_results),
    BAD_SIZES(env_results, mimo_env_results, "results"), NO_NULL(block, "block"), SHORT(block_bytes, "block"))
ROW(mimo_recording_report, ON_RECORDING, mimo_recording_report(a->recording, a->replay_report),
    DESCRIPTION(replay_report, mimo_replay_report, "report"))
