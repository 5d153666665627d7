// Sizes of structs in the first version of this ABI, written by ./dev freeze. They are those of 64-bit machines.
MIMO_FIRST_SIZE(mimo_scene_config, 120);
MIMO_FIRST_SIZE(mimo_agent_config, 184);
MIMO_FIRST_SIZE(mimo_limits, 32);
MIMO_FIRST_SIZE(mimo_object_config, 144);
MIMO_FIRST_SIZE(mimo_model_config, 88);
MIMO_FIRST_SIZE(mimo_camera_config, 96);
MIMO_FIRST_SIZE(mimo_parameter, 48);
MIMO_FIRST_SIZE(mimo_env_config, 72);
MIMO_FIRST_SIZE(mimo_agent_info, 40);
MIMO_FIRST_SIZE(mimo_field, 104);
MIMO_FIRST_SIZE(mimo_gaze, 144);
MIMO_FIRST_SIZE(mimo_picture_config, 80);
MIMO_FIRST_SIZE(mimo_timing, 64);
MIMO_FIRST_SIZE(mimo_batch_config, 24);
MIMO_FIRST_SIZE(mimo_batch_results, 88);
MIMO_FIRST_SIZE(mimo_task_field, 56);
MIMO_FIRST_SIZE(mimo_task, 72);
