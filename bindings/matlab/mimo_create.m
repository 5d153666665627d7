function world = mimo_create(scene, varargin)
% MIMO_CREATE  A simulated world, or many of them that are stepped together.
%   world = mimo_create('reach') gives a number for the other functions. It stays good after "clear"; close it by
%   mimo_close. Scenes: those of mimo_names('scene'), or the path of an MJCF file, "room.xml".
%   Errors have identifiers: mimo:NOT_FOUND, mimo:INVALID_ARGUMENT, mimo:BAD_HANDLE, ...
%   world = mimo_create(scene, ...) takes a scene that mimo_scene made as well: then only the options of physics, pictures and
%   many worlds, for all else is in it.
%
%   world = mimo_create('reach', name, value, ...) changes what the scene gives by itself. Options have the names and values
%   of mimo.h's structs, where all are explained:
%     the infant   vision (1 colour + 2 depth + 4 segmentation; 0: none), vision_height, vision_width, vision_fovy, touch (a
%                  sum of 1 force, 2 normal force, 4 slip, 8 friction_use, 16 sa1, 32 ra, 64 pc, 128 sa2, 256 temperature,
%                  512 cold, 1024 warm, 2048 nociception_fast, 4096 nociception_slow, 8192 units; 0: none), touch_scale,
%                  touch_response, touch_frame, touch_slip_threshold, proprioception (a sum of 1 velocity, 2 torque, 4 limit,
%                  8 actuation, 16 joint_torque, 32 position, 64 effort, 128 spindle_primary, 256 spindle_secondary,
%                  512 tendon_organ, 1024 joint_receptor; 2^31: all there is), vestibular (a sum of 1 acceleration,
%                  2 angular_velocity, 4 canals, 8 otoliths, 16 gravity), hearing (1 ears, 2 bands; 0: none),
%                  voice (1: four more actions), limit_threshold, actuation (1: by angles,
%                  2 or 3: muscles), acts (2^31: all, 2^30: nothing), normalize_actions, body,
%                  reflexes (of newborns: 1 palmar grasp, 2 plantar grasp, 4 rooting, 8 Moro,
%                  16 asymmetric tonic neck, 32 stepping, 64 withdrawal; 2^30: the field has all; 2^31: all that the body can do),
%                  face, position, orientation (w x y z), place (1: position is that of the root, 2: of the soles,
%                  3: of the lowest point); limits (struct array with path, gain, noise, delay in
%                  seconds, blur, signal_noise: mimo_limits), motor_limits (the same without blur; path 'act:left_elbow',
%                  'left_arm', or '' for all)
%     its age      age (months, 0 to 24), sex (0 mean of girls and boys, 1 female, 2 male), percentile or z_length, z_weight,
%                  z_head, physiological_age (of strength, range of motion and tone), growth (0: after the WHO, 1: MIMo v2's
%                  rules), strength_exponent, neck_strength, birth_tone, contracture, absolute, keep_spacing: mimo_growth;
%                  maturity ('body', 'eyes', 'delays', 'all', or a cell array of them: what of it is as old; the body
%                  unless given)
%     no infant    root (with body "scene": a body of the MJCF file, with all below it; "world": everything), vestibular_at (the
%                  site or body whose motion the vestibular sense feels)
%     physics      task, parameters ({'reach/success_reward', 5; ...}), frame_skip, max_steps, jacobian, disable,
%                  step_contacts (1: mimo_get has what touched what in a step),
%                  timing (1: mimo_timing counts)
%     pictures     renderer ("ray", "osmesa", "gl", "none"), render, samples, render_threads
%     the room     objects, models, cameras and fields: struct arrays with the members that mimo_scene_add has; a camera with
%                  look_at is a new one; a cell array of elements goes into struct() in braces, {{'ball', 'cup'}}
%     the file     confined (1: what it names must lie in its folder), model_dir (a folder to take built-in models from),
%                  max_pixels, max_vertices, max_elements, max_keyframes, max_iterations, max_file_bytes, max_world_bytes,
%                  max_compile_ms: how much it may ask for
%     many worlds  ages (months; the infants of world i are as old as number i, and they repeat), worlds, threads, autoreset (0, 1 or 2), restart_failed. They are the last dimension of all arrays.
if ~isnumeric(scene), scene = char(scene); end
world = mimo_mex('create', scene, varargin{:});
end
