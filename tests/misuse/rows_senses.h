/* Senses on the host's own simulation. See table.h. */

#define SENSES_FIELD(kind, f, n, status, names) \
  { kind, #f " is " #n, MEMBER(senses_config), FIELD(mimo_senses_config, f), (int64_t)(n), 0, NULL, status, names }
#define SENSES_REAL(n) BAD_REAL(senses_config, mimo_senses_config, step, n, "step")
ROW(mimo_senses_config_init, 0, mimo_senses_config_init(a->senses_config, sizeof *a->senses_config + a->more_bytes),
    INIT(senses_config, mimo_senses_config, "config"))
ROW(mimo_senses_attach, ON_CART, mimo_senses_attach(a->scene, a->model, a->senses_config, a->made_senses),
    NO_NULL(senses_config, "config"), CONFIG(senses_config, mimo_senses_config, "config"), NO_NULL(model, "model"),
    NO_NULL(made_senses, "senses"),
    SENSES_FIELD(FAULT_FIELD_I32, mujoco_version, 237, MIMO_E_UNSUPPORTED, "mujoco_version"),
    SENSES_FIELD(FAULT_FIELD_I32, mujoco_version, 0, MIMO_E_UNSUPPORTED, "mujoco_version"),
    SENSES_FIELD(FAULT_FIELD_SIZE, model_size, 1, MIMO_E_UNSUPPORTED, "model_size"),
    SENSES_FIELD(FAULT_FIELD_SIZE, data_size, -1, MIMO_E_UNSUPPORTED, "data_size"),
    SENSES_FIELD(FAULT_FIELD_SIZE, model_size, 0, MIMO_OK, NULL),
    SENSES_FIELD(FAULT_FIELD_SIZE, data_size, 0, MIMO_OK, NULL), SENSES_REAL(-1), SENSES_REAL(NAN),
    SENSES_REAL(INFINITY), UNKNOWN_FIELD(senses_config, mimo_senses_config, render, 0x40, "render"),
    BAD_FIELD(senses_config, mimo_senses_config, samples, 3, "samples"),
    BAD_FIELD(senses_config, mimo_senses_config, render_threads, 65, "render_threads"),
    UNKNOWN_FIELD(senses_config, mimo_senses_config, reserved, 1, "reserved"), DO(no_model, E_ARG, "model"),
    DO(unknown_renderer, E_ARG, "crayons"))
ROW(mimo_senses_destroy, ON_SCENE | ON_ENV | ON_BATCH | ON_SENSES | DESTROYS, check_destroy_senses(a), NONE)
ROW(mimo_senses_observe, ON_SENSES, mimo_senses_observe(a->senses, a->data, a->block, a->block_bytes),
    NO_NULL(data, "data"), NO_NULL(block, "block"), SIZE_IS(block_bytes, 1, MIMO_E_BUFFER_TOO_SMALL, "block"),
    BAD_SIZE(block_bytes, -1, "block"), DO(no_block, E_ARG, "block"), DO(no_data, E_ARG, "data"))
ROW(mimo_senses_reset, ON_SENSES, mimo_senses_reset(a->senses, a->data, a->reset_config), NO_NULL(data, "data"), SEEDED,
    DO(too_old, MIMO_E_UNSUPPORTED, "growth"), DO(no_data, E_ARG, "data"))
ROW(mimo_senses_advance, ON_SENSES, mimo_senses_advance(a->senses, a->data), NO_NULL(data, "data"),
    DO(no_data, E_ARG, "data"))
ROW(mimo_senses_drive_spindles, ON_SENSES, mimo_senses_drive_spindles(a->senses, a->ids, 0, a->to_write, 0), NONE)
ROW(mimo_senses_play, ON_SENSES, mimo_senses_play(a->senses, a->cart, a->action, a->action_count, a->rate),
    NO_NULL(cart, "body"), NO_NULL(action, "samples"), DO(nan_action, E_ARG, "samples[1]"), NOT_FINITE(rate, "rate"),
    BAD_F64(rate, 8000, "rate is 8000"), BAD_SIZE(action_count, -1, "samples"))
ROW(mimo_senses_state_size, ON_SENSES, mimo_senses_state_size(a->senses, a->count), NO_NULL(count, "bytes"))
ROW(mimo_senses_state_save, ON_SENSES, mimo_senses_state_save(a->senses, a->memory_out, a->memory_bytes),
    NO_NULL(memory_out, "state"), SHORT(memory_bytes, "state"))
ROW(mimo_senses_state_load, ON_SENSES, mimo_senses_state_load(a->senses, a->memory, a->memory_bytes, a->report),
    NO_NULL(memory, "state"), LOAD_REPORT, WHOLE_STATE(memory_bytes), DO(damaged_memory, MIMO_E_FILE, "damaged"),
    DO(state_as_memory, MIMO_E_MISMATCH, "another model"))
