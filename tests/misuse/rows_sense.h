/* Senses of one's own. See table.h. */
#define NOWHERE "/no_such_sense.so"
ROW(mimo_sense_init, 0, mimo_sense_init(a->sense, sizeof *a->sense + a->more_bytes), INIT(sense, mimo_sense, "sense"))
ROW(mimo_sense_field_init, 0, mimo_sense_field_init(a->sense_field, sizeof *a->sense_field + a->more_bytes),
    INIT(sense_field, mimo_sense_field, "field"))
ROW(mimo_sense_add_field, ON_ENV, refused(mimo_sense_add_field(a->env, a->sense_field), "a function of a sense"), NONE)
ROW(mimo_sense_feel, ON_ENV, refused(mimo_sense_feel(a->env, a->index, NULL), "a function of a sense"), NONE)
ROW(mimo_sense_noise, 0, CHECKED(isfinite(mimo_sense_noise(1, 2, 3))), NONE)
ROW(mimo_scene_add_sense, ON_SCENE, add_sense(a), NO_NULL(sense, "sense"), CONFIG(sense, mimo_sense, "sense"),
    BAD_INDEX(agent_index, "agent"), UNKNOWN_FIELD(sense, mimo_sense, interface_version, 2, "interface_version"),
    UNKNOWN_FIELD(sense, mimo_sense, host_fills, 2, "host_fills"),
    {FAULT_FIELD_SIZE, "many parameters", MEMBER(sense), FIELD(mimo_sense, parameter_count), 1001, 0, NULL, E_ARG,
     "parameters"},
    {FAULT_FIELD_NULL, "parameters is NULL", MEMBER(sense), FIELD(mimo_sense, parameters), 0, 0, NULL, E_ARG,
     "parameters"},
    {FAULT_FIELD_NULL, "no name", MEMBER(sense), FIELD(mimo_sense, name), 0, 0, NULL, E_ARG, "name"},
    DO(no_open, E_ARG, "open"), DO(no_write, E_ARG, "write"))
ROW(mimo_scene_load_sense, ON_SCENE, refused(mimo_scene_load_sense(a->scene, a->agent_index, NOWHERE), NOWHERE), NONE)
ROW(mimo_scene_sense_parameter, ON_SCENE, describe_sense(a), SIZE_IS(index, 1000000, MIMO_E_NOT_FOUND, "index"),
    DESCRIPTION(parameter, mimo_parameter, "parameter"))
ROW(mimo_recording_add_sense, ON_RECORDING, refused(mimo_recording_add_sense(a->recording, a->sense), "has no sense"),
    NONE)
ROW(mimo_recording_load_sense, ON_RECORDING, refused(mimo_recording_load_sense(a->recording, NOWHERE), NOWHERE), NONE)
