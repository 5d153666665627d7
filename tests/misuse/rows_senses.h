/* Senses on the host's own simulation. See table.h. */

ROW(mimo_senses_attach, ON_CART,
    mimo_senses_attach(a->scene, a->env_config, a->model, a->version, a->model_size, a->data_size, a->made_senses),
    NULL_OK(env_config), CONFIG(env_config, mimo_env_config, "config"), NO_NULL(model, "model"),
    NO_NULL(made_senses, "senses"),
    {FAULT_I32, "another version", MEMBER(version), 0, 237, 0, NULL, MIMO_E_UNSUPPORTED, "mujoco_version"},
    SIZE_IS(model_size, 1, MIMO_E_UNSUPPORTED, "model_size"), SIZE_IS(data_size, -1, MIMO_E_UNSUPPORTED, "data_size"),
    SIZE_IS(model_size, 0, MIMO_OK, NULL), SIZE_IS(data_size, 0, MIMO_OK, NULL), DO(no_model, E_ARG, "model"),
    DO(unknown_renderer, E_ARG, "crayons"))
ROW(mimo_senses_destroy, ON_SCENE | ON_ENV | ON_BATCH | ON_SENSES | DESTROYS, check_destroy_senses(a), NONE)
ROW(mimo_senses_observation_size, ON_SENSES, mimo_senses_observation_size(a->senses, a->count, a->count2),
    NULL_OK(count), NULL_OK(count2))
ROW(mimo_senses_observation_field, ON_SENSES, mimo_senses_observation_field(a->senses, a->index, a->field),
    BAD_INDEX(index, "index"), DESCRIPTION(field, mimo_field, "field"))
ROW(mimo_senses_observation_label, ON_SENSES, mimo_senses_observation_label(a->senses, a->index, a->element, a->string),
    BAD_INDEX(index, "index"), BAD_INDEX(element, "element"), NO_NULL(string, "label"))
ROW(mimo_senses_touch_sensors, ON_SENSES,
    mimo_senses_touch_sensors(a->senses, a->agent_index, a->bodies, a->geoms, a->positions, a->frames,
                              a->touch_capacity, a->count),
    BAD_SIZE(agent_index, 1, "agent"), BAD_INDEX(agent_index, "agent"), NULL_OK(bodies), NULL_OK(geoms),
    NULL_OK(positions), NULL_OK(frames), NULL_OK(count), DO(few_cart_sensors, MIMO_E_BUFFER_TOO_SMALL, "capacity"),
    BAD_SIZE(touch_capacity, -1, "capacity"))
ROW(mimo_senses_observe, ON_SENSES, mimo_senses_observe(a->senses, a->data, a->block, a->block_bytes),
    NO_NULL(data, "data"), NO_NULL(block, "block"), SIZE_IS(block_bytes, 1, MIMO_E_BUFFER_TOO_SMALL, "block"),
    BAD_SIZE(block_bytes, -1, "block"), DO(no_block, E_ARG, "block"), DO(no_data, E_ARG, "data"))
