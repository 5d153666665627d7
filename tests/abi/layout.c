/* Prints where the fields of all public structs lie, as JSON. check_layout compares it with layout.json: a field that
 * has moved breaks programs that are already compiled. */
#include <stddef.h>
#include <stdio.h>

#include "mimo/mimo.h"

static const char* gap = "";

static void begin(const char* name, size_t size) {
  printf("%s  \"%s\": {\n    \"size\": %zu", gap, name, size);
  gap = "\n  },\n";
}

static void field(const char* name, size_t offset, size_t size) {
  printf(",\n    \"%s\": [%zu, %zu]", name, offset, size);
}

#define BEGIN(type) begin(#type, sizeof(type))
#define FIELD(type, name) field(#name, offsetof(type, name), sizeof(((type*)0)->name))

int main(void) {
  printf("{\n");

  BEGIN(mimo_log_record);
  FIELD(mimo_log_record, struct_size);
  FIELD(mimo_log_record, level);
  FIELD(mimo_log_record, code);
  FIELD(mimo_log_record, in_world);
  FIELD(mimo_log_record, text);
  FIELD(mimo_log_record, world);
  FIELD(mimo_log_record, time);

  BEGIN(mimo_scene_config);
  FIELD(mimo_scene_config, struct_size);
  FIELD(mimo_scene_config, reserved);
  FIELD(mimo_scene_config, name);
  FIELD(mimo_scene_config, file);
  FIELD(mimo_scene_config, xml);
  FIELD(mimo_scene_config, model_dir);
  FIELD(mimo_scene_config, log);
  FIELD(mimo_scene_config, log_user);
  FIELD(mimo_scene_config, max_file_bytes);
  FIELD(mimo_scene_config, max_pixels);
  FIELD(mimo_scene_config, max_vertices);
  FIELD(mimo_scene_config, max_elements);
  FIELD(mimo_scene_config, max_keyframes);
  FIELD(mimo_scene_config, max_iterations);
  FIELD(mimo_scene_config, max_world_bytes);
  FIELD(mimo_scene_config, confined);
  FIELD(mimo_scene_config, limits_reserved);
  FIELD(mimo_scene_config, max_compile_ms);

  BEGIN(mimo_growth);
  FIELD(mimo_growth, struct_size);
  FIELD(mimo_growth, sex);
  FIELD(mimo_growth, age);
  FIELD(mimo_growth, physiological_age);
  FIELD(mimo_growth, matures_apart);
  FIELD(mimo_growth, model);
  FIELD(mimo_growth, z_length);
  FIELD(mimo_growth, z_weight);
  FIELD(mimo_growth, z_head);
  FIELD(mimo_growth, percentile);
  FIELD(mimo_growth, strength_exponent);
  FIELD(mimo_growth, neck_strength);
  FIELD(mimo_growth, birth_tone);
  FIELD(mimo_growth, contracture);
  FIELD(mimo_growth, absolute);
  FIELD(mimo_growth, keep_spacing);
  FIELD(mimo_growth, maturity);
  FIELD(mimo_growth, reserved);

  BEGIN(mimo_agent_config);
  FIELD(mimo_agent_config, struct_size);
  FIELD(mimo_agent_config, place);
  FIELD(mimo_agent_config, name);
  FIELD(mimo_agent_config, body);
  FIELD(mimo_agent_config, position);
  FIELD(mimo_agent_config, orientation);
  FIELD(mimo_agent_config, proprioception);
  FIELD(mimo_agent_config, vestibular);
  FIELD(mimo_agent_config, limit_threshold);
  FIELD(mimo_agent_config, vision);
  FIELD(mimo_agent_config, vision_width);
  FIELD(mimo_agent_config, vision_height);
  FIELD(mimo_agent_config, actuation);
  FIELD(mimo_agent_config, vision_fovy);
  FIELD(mimo_agent_config, vision_foveation);
  FIELD(mimo_agent_config, acts);
  FIELD(mimo_agent_config, normalize_actions);
  FIELD(mimo_agent_config, touch);
  FIELD(mimo_agent_config, touch_response);
  FIELD(mimo_agent_config, touch_frame);
  FIELD(mimo_agent_config, reflexes);
  FIELD(mimo_agent_config, touch_scale);
  FIELD(mimo_agent_config, touch_slip_threshold);
  FIELD(mimo_agent_config, face);
  FIELD(mimo_agent_config, root);
  FIELD(mimo_agent_config, vestibular_at);
  FIELD(mimo_agent_config, growth);
  FIELD(mimo_agent_config, hearing);
  FIELD(mimo_agent_config, voice);

  BEGIN(mimo_limits);
  FIELD(mimo_limits, struct_size);
  FIELD(mimo_limits, reserved);
  FIELD(mimo_limits, delay);
  FIELD(mimo_limits, gain);
  FIELD(mimo_limits, noise);
  FIELD(mimo_limits, blur);
  FIELD(mimo_limits, signal_noise);

  BEGIN(mimo_maturity);
  FIELD(mimo_maturity, struct_size);
  FIELD(mimo_maturity, contrast_threshold);
  FIELD(mimo_maturity, acuity);
  FIELD(mimo_maturity, peak_contrast);
  FIELD(mimo_maturity, chroma);
  FIELD(mimo_maturity, flicker);
  FIELD(mimo_maturity, conduction_speed);
  FIELD(mimo_maturity, sensory_delay);
  FIELD(mimo_maturity, motor_delay);
  FIELD(mimo_maturity, vision_delay);
  FIELD(mimo_maturity, vestibular_delay);
  FIELD(mimo_maturity, hearing_delay);

  BEGIN(mimo_object_config);
  FIELD(mimo_object_config, struct_size);
  FIELD(mimo_object_config, shape);
  FIELD(mimo_object_config, name);
  FIELD(mimo_object_config, size);
  FIELD(mimo_object_config, position);
  FIELD(mimo_object_config, orientation);
  FIELD(mimo_object_config, mass);
  FIELD(mimo_object_config, rgba);
  FIELD(mimo_object_config, fixed);
  FIELD(mimo_object_config, reserved);

  BEGIN(mimo_model_config);
  FIELD(mimo_model_config, struct_size);
  FIELD(mimo_model_config, fixed);
  FIELD(mimo_model_config, name);
  FIELD(mimo_model_config, file);
  FIELD(mimo_model_config, xml);
  FIELD(mimo_model_config, position);
  FIELD(mimo_model_config, orientation);

  BEGIN(mimo_camera_config);
  FIELD(mimo_camera_config, struct_size);
  FIELD(mimo_camera_config, outputs);
  FIELD(mimo_camera_config, name);
  FIELD(mimo_camera_config, width);
  FIELD(mimo_camera_config, height);
  FIELD(mimo_camera_config, fovy);
  FIELD(mimo_camera_config, placed);
  FIELD(mimo_camera_config, reserved);
  FIELD(mimo_camera_config, body);
  FIELD(mimo_camera_config, position);
  FIELD(mimo_camera_config, look_at);

  BEGIN(mimo_parameter);
  FIELD(mimo_parameter, struct_size);
  FIELD(mimo_parameter, reserved);
  FIELD(mimo_parameter, name);
  FIELD(mimo_parameter, description);
  FIELD(mimo_parameter, standard);
  FIELD(mimo_parameter, low);
  FIELD(mimo_parameter, high);

  BEGIN(mimo_env_config);
  FIELD(mimo_env_config, struct_size);
  FIELD(mimo_env_config, frame_skip);
  FIELD(mimo_env_config, jacobian);
  FIELD(mimo_env_config, disable);
  FIELD(mimo_env_config, renderer);
  FIELD(mimo_env_config, max_steps);
  FIELD(mimo_env_config, timing);
  FIELD(mimo_env_config, log);
  FIELD(mimo_env_config, log_user);
  FIELD(mimo_env_config, task);
  FIELD(mimo_env_config, render);
  FIELD(mimo_env_config, samples);
  FIELD(mimo_env_config, render_threads);
  FIELD(mimo_env_config, step_contacts);

  BEGIN(mimo_agent_info);
  FIELD(mimo_agent_info, struct_size);
  FIELD(mimo_agent_info, action_offset);
  FIELD(mimo_agent_info, action_count);
  FIELD(mimo_agent_info, reserved);
  FIELD(mimo_agent_info, name);
  FIELD(mimo_agent_info, mass);
  FIELD(mimo_agent_info, height);

  BEGIN(mimo_reset_config);
  FIELD(mimo_reset_config, struct_size);
  FIELD(mimo_reset_config, seeded);
  FIELD(mimo_reset_config, seed);
  FIELD(mimo_reset_config, growth);
  FIELD(mimo_reset_config, growth_count);

  BEGIN(mimo_movement);
  FIELD(mimo_movement, struct_size);
  FIELD(mimo_movement, reserved);
  FIELD(mimo_movement, positions);
  FIELD(mimo_movement, position_count);
  FIELD(mimo_movement, forces);
  FIELD(mimo_movement, force_count);

  BEGIN(mimo_env_results);
  FIELD(mimo_env_results, struct_size);
  FIELD(mimo_env_results, reserved);
  FIELD(mimo_env_results, reward);
  FIELD(mimo_env_results, terminated);
  FIELD(mimo_env_results, truncated);
  FIELD(mimo_env_results, outcome);
  FIELD(mimo_env_results, agent_count);
  FIELD(mimo_env_results, terms);
  FIELD(mimo_env_results, term_count);

  BEGIN(mimo_layout_info);
  FIELD(mimo_layout_info, struct_size);
  FIELD(mimo_layout_info, reserved);
  FIELD(mimo_layout_info, block_bytes);
  FIELD(mimo_layout_info, fields);
  FIELD(mimo_layout_info, actions);
  FIELD(mimo_layout_info, agents);
  FIELD(mimo_layout_info, terms);

  BEGIN(mimo_field);
  FIELD(mimo_field, struct_size);
  FIELD(mimo_field, dtype);
  FIELD(mimo_field, name);
  FIELD(mimo_field, unit);
  FIELD(mimo_field, frame);
  FIELD(mimo_field, offset);
  FIELD(mimo_field, bytes);
  FIELD(mimo_field, shape);
  FIELD(mimo_field, ndim);
  FIELD(mimo_field, low);
  FIELD(mimo_field, high);
  FIELD(mimo_field, start);
  FIELD(mimo_field, end);
  FIELD(mimo_field, period);
  FIELD(mimo_field, receptors);
  FIELD(mimo_field, sample_rate);

  BEGIN(mimo_action);
  FIELD(mimo_action, struct_size);
  FIELD(mimo_action, reserved);
  FIELD(mimo_action, name);
  FIELD(mimo_action, unit);
  FIELD(mimo_action, agent);
  FIELD(mimo_action, low);
  FIELD(mimo_action, high);

  BEGIN(mimo_term);
  FIELD(mimo_term, struct_size);
  FIELD(mimo_term, reserved);
  FIELD(mimo_term, name);
  FIELD(mimo_term, agent);

  BEGIN(mimo_field_config);
  FIELD(mimo_field_config, struct_size);
  FIELD(mimo_field_config, quantity);
  FIELD(mimo_field_config, name);
  FIELD(mimo_field_config, elements);
  FIELD(mimo_field_config, element_count);
  FIELD(mimo_field_config, relative_to);

  BEGIN(mimo_gaze);
  FIELD(mimo_gaze, struct_size);
  FIELD(mimo_gaze, meets);
  FIELD(mimo_gaze, left_position);
  FIELD(mimo_gaze, left_direction);
  FIELD(mimo_gaze, right_position);
  FIELD(mimo_gaze, right_direction);
  FIELD(mimo_gaze, vergence);
  FIELD(mimo_gaze, point);
  FIELD(mimo_gaze, miss);

  BEGIN(mimo_picture_config);
  FIELD(mimo_picture_config, struct_size);
  FIELD(mimo_picture_config, width);
  FIELD(mimo_picture_config, height);
  FIELD(mimo_picture_config, format);
  FIELD(mimo_picture_config, camera);
  FIELD(mimo_picture_config, look_at);
  FIELD(mimo_picture_config, distance);
  FIELD(mimo_picture_config, azimuth);
  FIELD(mimo_picture_config, elevation);
  FIELD(mimo_picture_config, fovy);
  FIELD(mimo_picture_config, foveation);

  BEGIN(mimo_picture);
  FIELD(mimo_picture, struct_size);
  FIELD(mimo_picture, reserved);
  FIELD(mimo_picture, rgb);
  FIELD(mimo_picture, rgb_bytes);
  FIELD(mimo_picture, depth);
  FIELD(mimo_picture, depth_count);
  FIELD(mimo_picture, segmentation);
  FIELD(mimo_picture, segmentation_count);

  BEGIN(mimo_timing);
  FIELD(mimo_timing, struct_size);
  FIELD(mimo_timing, reserved);
  FIELD(mimo_timing, steps);
  FIELD(mimo_timing, total);
  FIELD(mimo_timing, physics);
  FIELD(mimo_timing, touch);
  FIELD(mimo_timing, vision);
  FIELD(mimo_timing, proprioception);
  FIELD(mimo_timing, vestibular);
  FIELD(mimo_timing, hearing);

  BEGIN(mimo_batch_config);
  FIELD(mimo_batch_config, struct_size);
  FIELD(mimo_batch_config, worlds);
  FIELD(mimo_batch_config, threads);
  FIELD(mimo_batch_config, autoreset);
  FIELD(mimo_batch_config, restart_failed);
  FIELD(mimo_batch_config, reserved);
  FIELD(mimo_batch_config, cohort);
  FIELD(mimo_batch_config, cohort_count);

  BEGIN(mimo_batch_reset_config);
  FIELD(mimo_batch_reset_config, struct_size);
  FIELD(mimo_batch_reset_config, reserved);
  FIELD(mimo_batch_reset_config, seeds);
  FIELD(mimo_batch_reset_config, mask);
  FIELD(mimo_batch_reset_config, worlds);
  FIELD(mimo_batch_reset_config, growth);

  BEGIN(mimo_batch_results);
  FIELD(mimo_batch_results, struct_size);
  FIELD(mimo_batch_results, reserved);
  FIELD(mimo_batch_results, reward);
  FIELD(mimo_batch_results, terminated);
  FIELD(mimo_batch_results, truncated);
  FIELD(mimo_batch_results, outcome);
  FIELD(mimo_batch_results, agent_count);
  FIELD(mimo_batch_results, terms);
  FIELD(mimo_batch_results, term_count);
  FIELD(mimo_batch_results, status);
  FIELD(mimo_batch_results, was_reset);
  FIELD(mimo_batch_results, final_written);
  FIELD(mimo_batch_results, worlds);
  FIELD(mimo_batch_results, final_blocks);
  FIELD(mimo_batch_results, final_bytes);

  BEGIN(mimo_load_report);
  FIELD(mimo_load_report, struct_size);
  FIELD(mimo_load_report, reserved);
  FIELD(mimo_load_report, fresh);
  FIELD(mimo_load_report, ignored);
  FIELD(mimo_load_report, fresh_names);
  FIELD(mimo_load_report, ignored_names);

  BEGIN(mimo_recorder_config);
  FIELD(mimo_recorder_config, struct_size);
  FIELD(mimo_recorder_config, compression);
  FIELD(mimo_recorder_config, keep);
  FIELD(mimo_recorder_config, state_seconds);
  FIELD(mimo_recorder_config, flush_seconds);
  FIELD(mimo_recorder_config, configuration);
  FIELD(mimo_recorder_config, seed);
  FIELD(mimo_recorder_config, hdf5);
  FIELD(mimo_recorder_config, replace);
  FIELD(mimo_recorder_config, reserved);

  BEGIN(mimo_recording_info);
  FIELD(mimo_recording_info, struct_size);
  FIELD(mimo_recording_info, format_version);
  FIELD(mimo_recording_info, same_build);
  FIELD(mimo_recording_info, reserved);
  FIELD(mimo_recording_info, steps);
  FIELD(mimo_recording_info, states);
  FIELD(mimo_recording_info, actions);
  FIELD(mimo_recording_info, agents);
  FIELD(mimo_recording_info, bodies);
  FIELD(mimo_recording_info, step_seconds);
  FIELD(mimo_recording_info, build);
  FIELD(mimo_recording_info, this_build);
  FIELD(mimo_recording_info, configuration);
  FIELD(mimo_recording_info, seed);

  BEGIN(mimo_replay_report);
  FIELD(mimo_replay_report, struct_size);
  FIELD(mimo_replay_report, identical);
  FIELD(mimo_replay_report, next);
  FIELD(mimo_replay_report, steps);
  FIELD(mimo_replay_report, first_difference);
  FIELD(mimo_replay_report, largest_difference);
  FIELD(mimo_replay_report, differs_most_in);

  BEGIN(mimo_senses_config);
  FIELD(mimo_senses_config, struct_size);
  FIELD(mimo_senses_config, mujoco_version);
  FIELD(mimo_senses_config, model_size);
  FIELD(mimo_senses_config, data_size);
  FIELD(mimo_senses_config, step);
  FIELD(mimo_senses_config, renderer);
  FIELD(mimo_senses_config, log);
  FIELD(mimo_senses_config, log_user);
  FIELD(mimo_senses_config, render);
  FIELD(mimo_senses_config, samples);
  FIELD(mimo_senses_config, render_threads);
  FIELD(mimo_senses_config, reserved);

  BEGIN(mimo_task);
  FIELD(mimo_task, struct_size);
  FIELD(mimo_task, reserved);
  FIELD(mimo_task, user);
  FIELD(mimo_task, memory_bytes);
  FIELD(mimo_task, reset);
  FIELD(mimo_task, evaluate);
  FIELD(mimo_task, terms);
  FIELD(mimo_task, term_count);
  FIELD(mimo_task, fields);
  FIELD(mimo_task, field_count);

  BEGIN(mimo_task_moment);
  FIELD(mimo_task_moment, struct_size);
  FIELD(mimo_task_moment, reserved);
  FIELD(mimo_task_moment, world);
  FIELD(mimo_task_moment, agent);
  FIELD(mimo_task_moment, step);
  FIELD(mimo_task_moment, memory);
  FIELD(mimo_task_moment, fields);
  FIELD(mimo_task_moment, action);
  FIELD(mimo_task_moment, action_count);
  FIELD(mimo_task_moment, block);
  FIELD(mimo_task_moment, block_bytes);

  BEGIN(mimo_task_verdict);
  FIELD(mimo_task_verdict, struct_size);
  FIELD(mimo_task_verdict, outcome);
  FIELD(mimo_task_verdict, reward);
  FIELD(mimo_task_verdict, terms);
  FIELD(mimo_task_verdict, goes_on);
  FIELD(mimo_task_verdict, truncated);

  BEGIN(mimo_task_field);
  FIELD(mimo_task_field, struct_size);
  FIELD(mimo_task_field, ndim);
  FIELD(mimo_task_field, name);
  FIELD(mimo_task_field, unit);
  FIELD(mimo_task_field, frame);
  FIELD(mimo_task_field, shape);
  FIELD(mimo_task_field, low);
  FIELD(mimo_task_field, high);

  BEGIN(mimo_mesh);
  FIELD(mimo_mesh, struct_size);
  FIELD(mimo_mesh, axes);
  FIELD(mimo_mesh, segments);
  FIELD(mimo_mesh, reserved);
  FIELD(mimo_mesh, plane);
  FIELD(mimo_mesh, positions);
  FIELD(mimo_mesh, normals);
  FIELD(mimo_mesh, texcoords);
  FIELD(mimo_mesh, indices);
  FIELD(mimo_mesh, vertex_capacity);
  FIELD(mimo_mesh, index_capacity);
  FIELD(mimo_mesh, vertex_count);
  FIELD(mimo_mesh, index_count);

  BEGIN(mimo_appearance);
  FIELD(mimo_appearance, struct_size);
  FIELD(mimo_appearance, visible);
  FIELD(mimo_appearance, group);
  FIELD(mimo_appearance, texture);
  FIELD(mimo_appearance, color);
  FIELD(mimo_appearance, emission);
  FIELD(mimo_appearance, specular);
  FIELD(mimo_appearance, shininess);
  FIELD(mimo_appearance, reflectance);

  BEGIN(mimo_texture);
  FIELD(mimo_texture, struct_size);
  FIELD(mimo_texture, type);
  FIELD(mimo_texture, width);
  FIELD(mimo_texture, height);
  FIELD(mimo_texture, pixels);
  FIELD(mimo_texture, pixel_bytes);

  BEGIN(mimo_light);
  FIELD(mimo_light, struct_size);
  FIELD(mimo_light, axes);
  FIELD(mimo_light, active);
  FIELD(mimo_light, directional);
  FIELD(mimo_light, casts_shadow);
  FIELD(mimo_light, cutoff);
  FIELD(mimo_light, exponent);
  FIELD(mimo_light, position);
  FIELD(mimo_light, direction);
  FIELD(mimo_light, ambient);
  FIELD(mimo_light, diffuse);
  FIELD(mimo_light, specular);
  FIELD(mimo_light, attenuation);
  FIELD(mimo_light, reserved);

  printf("\n  }\n}\n");
  return 0;
}
