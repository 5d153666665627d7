% Tests of the MEX gateway: run with bindings/matlab and the compiled gateway on the path.
function tests()
  all_of_them = {@shapes_and_precision, @order_is_column_major, @errors_have_identifiers, @worlds_survive_clear, ...
                 @rewards_equal_those_of_c, @options_reach_the_world, @senses_and_motors_have_limits, @own_rooms_take_objects_and_cameras, @many_worlds_equal_single_worlds, @states_continue_bit_for_bit, ...
                 @quantities_are_read_and_written_by_name, @faces_show_in_pictures, @behaviours_say_what_they_measure, @infants_move_by_themselves, @eyes_converge_on_a_point, @locks_and_gravity_are_set, @masses_and_contacts_obey_mechanics, ...
                 @help_says_how_to_call, @messages_count_from_one, @own_robots_have_senses, ...
                 @scenes_are_built_step_by_step, @metal_feels_colder_than_wood, @each_infant_has_its_own_options, @infants_have_any_age, @scenes_refuse_wrong_options, @library_and_worlds_describe_themselves, @failures_name_each_world, ...
                 @single_worlds_of_a_batch_move, @points_and_appearances_are_read, @pictures_have_depth, @engines_get_meshes_and_poses, @send_and_receive_equal_a_step};
  all_of_them = [all_of_them, layout_tests(), results_tests(), hearing_tests(), sense_tests(), stage_tests(), recording_tests(), argument_tests()];
  failed = 0;
  for i = 1:numel(all_of_them)
    try
      all_of_them{i}();
    catch problem
      failed = failed + 1;
      fprintf('FAILED %s: %s\n', func2str(all_of_them{i}), problem.message);
    end
  end
  fprintf('Octave: %d passed, %d failed\n', numel(all_of_them) - failed, failed);
  if failed > 0, exit(1), end
end

function shapes_and_precision()
  world = mimo_create('benchmark');
  seen = mimo_reset(world, 7);
  assert(isequal(size(seen.vision_eye_left), [256 256 3]) && isa(seen.vision_eye_left, 'uint8'));
  assert(isequal(size(seen.vestibular_acceleration), [3 1]) && isa(seen.vestibular_acceleration, 'double'));
  assert(size(seen.touch_force, 2) == 3);
  single_ones = mimo_observation(world, 'single');
  assert(isa(single_ones.touch_force, 'single') && isequal(double(single_ones.touch_force), seen.touch_force));
  mimo_close(world);
end

% A median girl of 6 months weighs 7.297 kg, the mean infant of 18 months 10.585: WHO Child Growth Standards, 2006. The infant of
% 18 months here weighs 10.905 kg.
function infants_have_any_age()
  world = mimo_create('free', 'vision', 0, 'age', 6, 'sex', 'female');
  info = mimo_info(world);
  assert(abs(info.agents(1).mass - 7.297 / 10.585 * 10.905) < 0.04);
  mimo_close(world);
  % What is said of an infant is so at all ages.
  worlds = mimo_create('free', 'vision', 0, 'ages', [6 18], 'worlds', 2, 'sex', 'female');
  info = mimo_info(worlds);
  assert(abs(info.agents(1).mass - 7.297 / 10.585 * 10.905) < 0.04);
  mimo_close(worlds);
  said = message_of(@() mimo_create('free', 'vision', 0, 'age', 24.5));
  assert(~isempty(strfind(said, 'age is 24.5')), said);
end

% The bytes of a picture are in the block in the order row, column, colour.
function order_is_column_major()
  world = mimo_create('benchmark');
  seen = mimo_reset(world, 7);
  bytes = mimo_mex('block', world);
  picture = seen.vision_eye_left;
  in_c_order = permute(picture, [3 2 1]);
  assert(~isempty(strfind(char(bytes'), char(in_c_order(:)'))));
  assert(numel(unique(in_c_order)) > 10);
  mimo_close(world);
end

function errors_have_identifiers()
  refused(@() mimo_create('benchmarc'), 'mimo:NOT_FOUND');
  refused(@() mimo_close(99), 'mimo:BAD_HANDLE');
  world = mimo_create('reach');
  actions = zeros(size(mimo_bounds(world)));
  refused(@() mimo_step(world, actions(2:end)), 'mimo:INVALID_ARGUMENT');
  actions(2) = NaN;
  refused(@() mimo_step(world, actions), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_observation(world, 'half'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_reset(world, -1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_reset(world, [1 2]), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_get(world, 'body_color', 'head'), 'mimo:NOT_FOUND');
  refused(@() mimo_get(world, 'body_position', 'hed'), 'mimo:NOT_FOUND');
  refused(@() mimo_set(world, 'body_velocity', 'head', 1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_set(world, 'body_mass', 'head', -1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_get(world, 'step_contact_start'), 'mimo:UNSUPPORTED');
  refused(@() mimo_face(world, 'boredom'), 'mimo:NOT_FOUND');
  refused(@() mimo_load(world, zeros(3, 1, 'uint8')), 'mimo:FILE');
  refused(@() mimo_picture(world, 0, 8), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_gaze(world, 2), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'visoin', 1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'vision', 0.5), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'touch', 2 ^ 20), 'mimo:UNSUPPORTED');  % a bit that the library does not know
  refused(@() mimo_create('reach', 'vision'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'face', 'boredom'), 'mimo:NOT_FOUND');
  refused(@() mimo_create('reach', 'cameras', struct('nmae', 'wall')), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('nowhere.xml'), 'mimo:NOT_FOUND');
  mimo_close(world);
  refused(@() mimo_step(world, []), 'mimo:BAD_HANDLE');
end

function worlds_survive_clear()
  world = mimo_create('reach');
  mimo_reset(world, 7);
  before = mimo_mex('block', world);
  clear('mimo_mex');
  clear('functions');
  assert(isequal(before, mimo_mex('block', world)));
  mimo_close(world);
end

% The sum of rewards of tests/capi/same.c, which checks it in C with the same tolerance.
function rewards_equal_those_of_c()
  world = mimo_create('reach');
  mimo_reset(world, 7);
  motors = numel(mimo_bounds(world));
  total = 0;
  for step = 0:99
    [~, reward] = mimo_step(world, (mod(7 * step + 3 * (0:motors - 1), 21) - 10) / 10);
    total = total + reward;
  end
  assert(abs(total + 33.734464) < 1e-3, sprintf('%.6f', total));
  mimo_close(world);
end

function options_reach_the_world()
  world = mimo_create('benchmark', 'vision', 'depth', 'vision_width', 32, 'vision_height', 16, 'touch', 0, 'acts', 'right_arm', ...
                      'face', 'fear', 'max_steps', 2, 'samples', 4);
  assert(isequal(size(mimo_bounds(world)), [4 1]));  % shoulder (three) and elbow
  seen = mimo_reset(world, 1);
  assert(isequal(size(seen.vision_eye_left_depth), [16 32]) && ~isfield(seen, 'touch_force'));
  assert(strcmp(mimo_face(world), 'fear'));
  [~, ~, ~, first] = mimo_step(world, []);
  [~, ~, ~, second] = mimo_step(world, []);
  assert(~first && second);
  mimo_close(world);
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'proprioception', 'all');
  seen = mimo_reset(world, 1);
  assert(all(isfield(seen, {'proprioception_joint_torque', 'proprioception_effort'})));  % which are not by default
  mimo_close(world);
  world = mimo_create('reach', 'parameters', {'reach/episode_steps', 1});
  mimo_reset(world, 1);
  [~, ~, ~, truncated] = mimo_step(world, []);
  assert(truncated);
  mimo_close(world);
end

function senses_and_motors_have_limits()
  plain = mimo_create('reach');
  limited = mimo_create('reach', 'limits', struct('path', 'proprioception/velocity', 'gain', 2, 'delay', 0.01));
  first = mimo_reset(plain, 1);
  mimo_reset(limited, 1);
  for step = 1:3
    before = first;
    first = mimo_step(plain, []);
    late = mimo_step(limited, []);
  end
  assert(max(abs(late.proprioception_velocity - 2 * before.proprioception_velocity)) < 1e-6);
  assert(~isequal(before.proprioception_velocity, first.proprioception_velocity));
  refused(@() mimo_create('reach', 'limits', struct('gain', 2)), 'mimo:INVALID_ARGUMENT');
  shaky = mimo_create('reach', 'limits', struct('path', 'proprioception/velocity', 'signal_noise', 0.1));
  mimo_reset(shaky, 1);
  for step = 1:3, shaken = mimo_step(shaky, []); end
  share = shaken.proprioception_velocity ./ first.proprioception_velocity - 1;
  assert(max(abs(share)) > 0.01 && max(abs(share)) < 1);
  mimo_close(shaky);
  refused(@() mimo_create('reach', 'motor_limits', struct('path', 'tail')), 'mimo:NOT_FOUND');
  report = mimo_load(limited, mimo_save(plain));
  assert(isequal(report.fresh, {'delay/proprioception/velocity'}) && isempty(report.ignored));
  report = mimo_load(plain, mimo_save(limited));
  assert(isempty(report.fresh) && isequal(report.ignored, {'delay/proprioception/velocity'}));
  report = mimo_load(limited, mimo_save(limited));
  assert(isempty(report.fresh) && isempty(report.ignored));
  % Motors get half of what they are told, a step late.
  weak = mimo_create('reach', 'motor_limits', struct('path', {'right_arm', 'act:right_elbow'}, 'gain', {1, 0.5}, 'delay', 0.01));
  mimo_step(weak, ones(size(mimo_bounds(weak))));
  assert(mimo_get(weak, 'actuator_control', 'act:right_elbow') == 0);
  mimo_step(weak, ones(size(mimo_bounds(weak))));
  mimo_step(plain, ones(size(mimo_bounds(plain))));
  told = mimo_get(plain, 'actuator_control', 'act:right_elbow');
  assert(told > 0 && abs(mimo_get(weak, 'actuator_control', 'act:right_elbow') - told / 2) < 1e-6);
  mimo_close(weak);
  refused(@() mimo_create('reach', 'limits', struct('path', {'proprioception', []})), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'objects', 'ball'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'limits', struct('path', 'smell')), 'mimo:NOT_FOUND');
  mimo_close(plain);
  mimo_close(limited);
end

function own_rooms_take_objects_and_cameras()
  file = [tempname() '.xml'];
  text = fopen(file, 'w');
  fprintf(text, '<mujoco><option timestep="0.005"/><worldbody><geom name="floor" type="plane" size="2 2 .1"/></worldbody></mujoco>');
  fclose(text);
  % A ball falls by g h^2 n (n + 1) / 2 in n steps of h = 5 ms: semi-implicit Euler.
  world = mimo_create(file, 'position', [0 0 5], 'vision', 0, 'touch', 0, 'frame_skip', 1, ...
                      'objects', struct('name', {'ball', 'box'}, 'shape', {'sphere', 'box'}, 'size', {[.1 0 0], [.1 .1 .1]}, ...
                                        'position', {[1 0 2], [2 0 3]}), ...
                      'cameras', struct('name', 'wall', 'width', 16, 'height', 8, 'outputs', {{'rgb', 'segmentation'}}, 'position', [4 0 2], ...
                                        'look_at', [0 0 0]));
  delete(file);
  seen = mimo_reset(world, 1);
  assert(isequal(size(seen.vision_wall), [8 16 3]) && isequal(size(seen.vision_wall_segmentation), [8 16]));
  assert(isequal(seen.vision_wall, mimo_picture(world, 8, 16, 'wall')));
  for n = 1:10, mimo_step(world, []); end
  assert(abs(mimo_time(world) - 0.05) < 1e-12);
  assert(all(ismember({'robot:left_elbow'}, mimo_names(world, 'joint'))));
  elbow = mimo_get(world, 'joint_position', 'robot:left_elbow');
  mimo_set(world, 'joint_position', 'robot:left_elbow', elbow);  % poses are then those of the present
  places = reshape(mimo_get(world, 'body_position', {'ball', 'box'}), 3, 2);
  assert(max(abs(places(3, :) - ([2 3] - 9.81 * 0.005 ^ 2 * 10 * 11 / 2))) < 1e-12, mat2str(places));
  assert(abs(mimo_get(world, 'body_mass', 'ball') - 0.1) < 1e-12);
  mimo_close(world);
  for height = [0.2 0.7]
    world = mimo_create('free', 'place', 'soles', 'position', [0.5 0 height], 'vision', 0, 'touch', 0, 'vestibular', 'acceleration');
    feet = reshape(mimo_get(world, 'body_position', {'left_foot', 'right_foot'}), 3, 2);
    assert(max(abs(mean(feet(1:2, :), 2) - [0.5; 0])) < 1e-12 && max(feet(3, :)) < height + 0.1 && min(feet(3, :)) > height);
    seen = mimo_reset(world, 1);
    assert(isfield(seen, 'vestibular_acceleration') && ~isfield(seen, 'vestibular_angular_velocity'));
    mimo_close(world);
  end
end

% World i is a single world with the i-th seed and the i-th actions.
function many_worlds_equal_single_worlds()
  worlds = mimo_create('reach', 'worlds', 3, 'threads', 2);
  single = mimo_create('reach');
  motors = numel(mimo_bounds(worlds));
  actions = reshape(mod(1:3 * motors, 7) / 7 - 0.4, motors, 3);
  mimo_reset(worlds, 5);
  [seen, reward, terminated] = mimo_step(worlds, actions);
  blocks = mimo_mex('block', worlds);
  assert(isequal(size(reward), [1 3]) && isequal(size(terminated), [1 3]) && isequal(size(mimo_time(worlds)), [1 3]));
  for i = 1:3
    mimo_reset(single, 4 + i);
    [one, its] = mimo_step(single, actions(:, i));
    assert(isequal(blocks(:, i), mimo_mex('block', single)) && its == reward(i));
    assert(isequal(seen.proprioception_velocity(:, i), one.proprioception_velocity));
    assert(isequal(seen.proprioception_torque(:, :, i), one.proprioception_torque));
  end
  mimo_reset(worlds, [], 'double', [false true false]);
  assert(isequal(mimo_time(worlds) > 0, [true false true]));
  refused(@() mimo_step(worlds, actions(:, 1)), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_reset(worlds, [], 'double', true), 'mimo:INVALID_ARGUMENT');
  mimo_close(single);
  mimo_close(worlds);
end

function states_continue_bit_for_bit()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  states = mimo_save(worlds);
  mimo_step(worlds, []);
  then = mimo_mex('block', worlds);
  mimo_load(worlds, states);
  mimo_step(worlds, []);
  assert(isequal(then, mimo_mex('block', worlds)));
  mimo_load(worlds, states(:, 2));  % futures of one present
  mimo_step(worlds, []);
  assert(isequal(then(:, [2 2]), mimo_mex('block', worlds)));
  mimo_close(worlds);
end

function quantities_are_read_and_written_by_name()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  mimo_set(worlds, 'joint_position', 'robot:right_elbow', [-0.1 -0.2]);
  assert(isequal(mimo_get(worlds, 'joint_position', 'robot:right_elbow'), [-0.1 -0.2]));
  mimo_set(worlds, 'body_position', 'target', [0.4; 0.1; 0.8]);
  assert(max(max(abs(mimo_get(worlds, 'body_position', {'target'}) - [0.4 0.4; 0.1 0.1; 0.8 0.8]))) < 1e-12);
  assert(isequal(size(mimo_get(worlds, 'body_position', {'head', 'left_hand'})), [6 2]));
  mimo_close(worlds);
end

function faces_show_in_pictures()
  world = mimo_create('free', 'vision', 0, 'touch', 0, ...
                      'cameras', struct('name', 'close', 'width', 48, 'height', 48, 'body', 'head', ...
                                        'position', [0.4 0 0.07], 'look_at', [0 0 0.07]));
  seen = mimo_reset(world, 1);
  assert(strcmp(mimo_face(world), 'neutral') && strcmp(mimo_face(world, 'anger'), 'anger'));
  angry = mimo_observe(world);
  assert(~isequal(seen.vision_close, angry.vision_close));
  assert(isequal(angry.vision_close, mimo_picture(world, 48, 48, 'close', 1)));
  mimo_close(world);
end

% WHO's window of sitting without support: 3.8 to 9.2 months, for ten seconds.
function behaviours_say_what_they_measure()
  sit = mimo_behaviour(mimo_scene('sit'));
  assert(strcmp(sit.measure, 'tilt upper_body z') && strcmp(sit.unit, 'deg') && sit.hold_seconds == 10);
  assert(sit.norm_early == 3.8 && sit.norm_late == 9.2);
end

% The same episode has the same movements.
function infants_move_by_themselves()
  world = mimo_create('rollover', 'touch', 0);
  mimo_reset(world, 1);
  one = mimo_spontaneous(world);
  mimo_reset(world, 1);
  assert(any(one) && isequal(one, mimo_spontaneous(world)));
  assert(~isequal(one, mimo_spontaneous(world, 16)));
  mimo_close(world);
end

% The eyes' centres are 49 mm apart: 2 atan(0.0245 m / d) is the vergence at a distance d straight ahead.
function eyes_converge_on_a_point()
  world = mimo_create('free', 'vision', 0, 'touch', 0);
  mimo_reset(world, 1);
  gaze = mimo_gaze(world);
  point = (gaze.left_position + gaze.right_position) / 2 + [0.4; 0; 0];
  assert(max(abs(mimo_look_at(world, point, 'head'))) < 1e-6);
  gaze = mimo_gaze(world);
  assert(max(abs(gaze.point - point)) < 1e-6);
  assert(abs(gaze.vergence - 2 * atan(0.0245 / 0.4)) < 0.02);
  refused(@() mimo_look_at(world, point, 'feet'), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end

% Unity's x points to the right, its y up, its z forward; Unreal uses centimetres.
function engines_get_meshes_and_poses()
  world = mimo_create('benchmark', 'vision', 0, 'touch', 0);
  mimo_reset(world, 1);
  head = find(strcmp(mimo_names(world, 'geom'), 'head'));
  mesh = mimo_mesh(world, head);
  assert(isequal(size(mesh.positions), size(mesh.normals)) && size(mesh.texcoords, 2) == size(mesh.positions, 2));
  assert(min(mesh.triangles(:)) == 1 && max(mesh.triangles(:)) == size(mesh.positions, 2));
  radius = mimo_get(world, 'geom_size', 'head');
  assert(abs(max(sqrt(sum(mesh.positions .^ 2))) - radius(1)) < 1e-6);
  assert(abs(max(sqrt(sum(mimo_mesh(world, head, 'unreal').positions .^ 2))) - 100 * radius(1)) < 1e-4);
  before = mimo_appearance(world, head);
  mimo_face(world, 'surprise');
  assert(before.visible && before.texture ~= mimo_appearance(world, head).texture);
  [pixels, type] = mimo_texture(world, before.texture);
  assert(strcmp(type, 'cube') && size(pixels, 1) == 6 * size(pixels, 2) && all(all(pixels(:, :, 4) == 255)));
  assert(mimo_texture(world) >= before.texture);
  ours = mimo_poses(world, 'body');
  unity = mimo_poses(world, 'body', 'unity');
  assert(isequal(unity(1:3, :), [-ours(2, :); ours(3, :); ours(1, :)]) && isequal(unity(7, :), ours(4, :)));
  assert(isequal(mimo_convert('points', [1; 2; 3], 'unreal'), [100; -200; 300]));
  assert(isequal(mimo_convert('directions', [1; 2; 3], 'unreal'), [1; -2; 3]));
  assert(isequal(mimo_convert('poses', ours, 'unity'), unity) && mimo_layout(world).step_seconds == 0.01);
  assert(mimo_light(world, 0).directional == 1 && mimo_light(world, 1, 'godot').active == 1);
  refused(@() mimo_mesh(world, head, 'blender'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_mesh(world, head, 'unity', 6), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_poses(world, 'joint'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_texture(world, 999), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end

function locks_and_gravity_are_set()
  worlds = mimo_create('benchmark', 'worlds', 2, 'vision', 0, 'touch', 0);
  assert(isempty(mimo_locked(worlds, 'robot:left_elbow')));
  mimo_lock(worlds, 'robot:left_elbow', -0.5);
  assert(mimo_locked(worlds, 'robot:left_elbow') == -0.5);
  mimo_lock(worlds, 'robot:left_elbow', []);
  assert(isempty(mimo_locked(worlds, 'robot:left_elbow')));
  assert(isequal(mimo_gravity(worlds), [0; 0; -9.81]));
  assert(isequal(mimo_gravity(worlds, [0 0 -1.6]), [0; 0; -1.6]));
  mimo_close(worlds);
end

% v = F / m t in two worlds; and the impulse of a step's contacts is the change of momentum minus that of gravity.
function masses_and_contacts_obey_mechanics()
  worlds = mimo_create('benchmark', 'worlds', 2, 'vision', 0, 'touch', 0, 'step_contacts', 1);
  mimo_set(worlds, 'body_position', 'test_object2', [3; 3; 5]);
  mimo_set(worlds, 'body_mass', 'test_object2', [0.5 4]);
  mimo_set(worlds, 'body_force', 'test_object2', [3; 0; 0; 0; 0; 0]);
  for n = 1:10, mimo_step(worlds, []); end
  velocity = mimo_get(worlds, 'body_velocity_now', 'test_object2');
  assert(max(abs(velocity(1, :) - 3 ./ [0.5 4] * 10 * 2 * 0.005)) < 1e-9);
  assert(numel(mimo_get(worlds, 'body_mass')) == 2 * numel(mimo_names(worlds, 'body')));
  ball = find(strcmp(mimo_names(worlds, 'body'), 'test_object2')) - 1;
  mimo_set(worlds, 'body_force', 'test_object2', zeros(6, 1));
  mimo_set(worlds, 'body_position', 'test_object2', [3; 3; 0.11]);
  touched = false;
  for n = 1:20
    before = mimo_get(worlds, 'body_velocity_now', 'test_object2');
    mimo_step(worlds, []);
    change = mimo_get(worlds, 'body_velocity_now', 'test_object2') - before;
    bodies = mimo_get(worlds, 'step_contact_bodies', [], 2);
    impulses = mimo_get(worlds, 'step_contact_impulse', [], 2);
    assert(size(bodies, 2) == 2 && size(impulses, 2) == 3 && size(bodies, 1) == size(impulses, 1));
    impulse = sum(impulses(bodies(:, 2) == ball, 3));
    assert(abs(impulse - 4 * 9.81 * 0.01 - 4 * change(3, 2)) < 1e-9);
    touched = touched || impulse > 0;
  end
  assert(touched);
  refused(@() mimo_get(worlds, 'contact_force'), 'mimo:INVALID_ARGUMENT');
  mimo_close(worlds);
end

% Each function's help has a call with its outputs and names its inputs; heights come before widths, as in MATLAB's arrays.
function help_says_how_to_call()
  folder = fileparts(which('mimo_create'));
  files = dir(fullfile(folder, 'mimo_*.m'));
  files = files(~strcmp({files.name}, 'mimo_mex.m'));  % the compiled one, which has no help, takes its place
  assert(numel(files) >= 20);
  for i = 1:numel(files)
    [~, name] = fileparts(files(i).name);
    text = help(name);
    signature = regexp(fileread(fullfile(folder, files(i).name)), '^function ([^\n]*)', 'tokens', 'once');
    signature = signature{1};
    wanted = [name '\('];
    outputs = regexp(signature, '^(.*?) *=', 'tokens', 'once');
    if ~isempty(outputs), wanted = [regexptranslate('escape', outputs{1}) ' = ' wanted]; end
    assert(~isempty(regexp(text, wanted, 'once')), [name ': no call ' wanted]);
    inputs = regexp(signature, '\((.*)\)', 'tokens', 'once');
    inputs = strsplit(inputs{1}, ', ');
    inputs = inputs(~cellfun(@isempty, inputs));
    for k = 1:numel(inputs)
      word = strrep(inputs{k}, 'varargin', 'value');
      assert(~isempty(regexp(text, ['\<' word 's?\>'], 'once')), [name ': nothing about ' word]);
    end
  end
  files = files(~strcmp({files.name}, 'mimo_options.m'));  % height is a word of other things there, too
  documents = [cellfun(@(name) fullfile(folder, name), {files.name}, 'UniformOutput', false), {fullfile(folder, 'README.md')}];
  for i = 1:numel(documents)
    text = fileread(documents{i});
    height = strfind(text, 'height');
    width = strfind(text, 'width');
    assert(isempty(width) || (numel(height) == numel(width) && all(height < width)), documents{i});
  end
end

% The library counts from 0, MATLAB from 1; quoted names do not change.
function messages_count_from_one()
  worlds = mimo_create('reach', 'worlds', 3);
  actions = zeros(numel(mimo_bounds(worlds)), 3);
  actions(2, 3) = NaN;
  said = message_of(@() mimo_step(worlds, actions));
  assert(strcmp(said, 'world 3: action(2) is not a number'), said);
  actions(1, 1) = NaN;
  said = message_of(@() mimo_step(worlds, actions));
  assert(strncmp(said, 'world 1 (and 1 more): action(1)', 31), said);
  said = message_of(@() mimo_gaze(worlds, 4));
  assert(strcmp(said, 'index is 4, expected a whole number from 1 to 3'), said);
  said = message_of(@() mimo_get(worlds, 'body_position', 'world 7[3]'));
  assert(~isempty(strfind(said, '"world 7[3]"')), said);
  said = message_of(@() mimo_names(worlds, 'bodies'));
  assert(strncmp(said, 'kind is "bodies", expected body, joint', 38), said);
  said = message_of(@() mimo_set(worlds, 'joint_position', 'robot:left_elbow', [NaN 0 0]));
  assert(strncmp(said, 'values(1) is', 12), said);
  said = message_of(@() mimo_set(worlds, 'body_position', 'head', [0 0 0]));
  assert(strncmp(said, sprintf('body %d ("head")', find(strcmp(mimo_names(worlds, 'body'), 'head'))), 15), said);
  mimo_close(worlds);
  said = message_of(@() mimo_create('free', 'objects', struct('name', 'ball', 'size', [-1 0 0])));
  assert(strncmp(said, 'size(1) is -1', 13), said);
end

% A sensor at the end of a robot's arm that hangs still feels standard gravity: 9.81 m/s^2 upwards.
function own_robots_have_senses()
  file = [tempname() '.xml'];
  text = fopen(file, 'w');
  fprintf(text, ['<mujoco><worldbody><body name="arm" pos="0 0 1"><joint name="hinge" axis="0 1 0"/><geom type="capsule" ' ...
                 'fromto="0 0 0 0 0 -.3" size=".02"/><site name="organ" pos="0 0 -.3"/></body></worldbody></mujoco>']);
  fclose(text);
  world = mimo_create(file, 'body', 'scene', 'root', 'arm', 'vestibular_at', 'organ', 'vision', 0, 'touch', 0);
  seen = mimo_reset(world, 1);
  assert(max(abs(seen.vestibular_acceleration - [0; 0; 9.81])) < 1e-3, mat2str(seen.vestibular_acceleration));
  mimo_close(world);
  said = message_of(@() mimo_create(file, 'body', 'scene', 'root', 'leg', 'vision', 0, 'touch', 0));
  assert(~isempty(strfind(said, '"leg"')), said);
  delete(file);
end

% Skin of 33.0 degrees after 1 s on 10 degrees: two half-spaces in contact (J Appl Physiol 1957;11:211 has the effusivity of
% skin) through 350 W/(m^2 K) give 28.21 degrees on copper and 30.26 on hardwood.
function metal_feels_colder_than_wood()
  assert(abs(skin_on('copper') - 28.21) < 0.1);
  assert(abs(skin_on('hardwood') - 30.26) < 0.1);
  assert(ismember('cork', mimo_names('material')));
  scene = mimo_scene('free');
  said = message_of(@() mimo_scene_add(scene, 'material', 'body', 'cup', 'name', 'kryptonite'));
  assert(~isempty(strfind(said, 'copper')), said);
  refused(@() mimo_scene_add(scene, 'temperature', 'body', 'cup', 'celsius', -274), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'room_temperature', 'celsius', 81), 'mimo:INVALID_ARGUMENT');
  mimo_scene_add(scene, 'room_temperature', 'celsius', 20);
  mimo_close(scene);
end

% The coldest sensor of a ball after a second on a table of this material.
function coldest = skin_on(material)
  table = '<body name="table"><geom type="box" size="1 1 .1" pos="0 0 -.1"/></body>';
  arm = '<body name="arm" pos="0 0 .0999"><freejoint/><geom size=".1"/></body>';
  scene = mimo_scene(['<mujoco><option timestep=".005"/><worldbody>' table arm '</worldbody></mujoco>']);
  mimo_scene_add(scene, 'agent', 'body', 'scene', 'root', 'arm', 'vision', 0, 'vestibular', 0, 'touch', 'temperature');
  mimo_scene_add(scene, 'skin', 'body', 'arm', 'spacing', 0.05);
  mimo_scene_add(scene, 'temperature', 'body', 'table', 'celsius', 10);
  mimo_scene_add(scene, 'material', 'body', 'table', 'name', material);
  world = mimo_create(scene, 'frame_skip', 1);
  mimo_close(scene);
  mimo_reset(world, 1);
  for step = 1:200, seen = mimo_step(world, []); end
  coldest = min(seen.touch_temperature);
  mimo_close(world);
end

% A free fall from 2 m is 1.23 m after 0.5 s; a body that is welded to the world stays.
function scenes_are_built_step_by_step()
  scene = mimo_scene();
  mimo_scene_add(scene, 'room', 'name', 'playroom');
  assert(mimo_scene_add(scene, 'agent', 'position', [0 0 5], 'orientation', [1 0 0 0], 'vision', 0) == 1);
  mimo_scene_add(scene, 'object', 'name', 'ball', 'position', [3 0 2]);
  ball = '<mujoco><worldbody><body name="ball"><geom size=".1"/></body></worldbody></mujoco>';
  mimo_scene_add(scene, 'model', 'name', 'held', 'xml', ball, 'position', [3 1 2]);
  mimo_scene_add(scene, 'weld', 'body', 'held/ball');
  mimo_scene_add(scene, 'weld', 'body', 'ball', 'other', 'held/ball', 'pose', [0 -1 0.1 1 0 0 0]);
  mimo_scene_add(scene, 'model', 'name', 'free', 'xml', ball, 'position', [3 2 2]);
  mimo_scene_add(scene, 'camera', 'name', 'wall', 'height', 8, 'width', 16, 'position', [4 0 2], 'look_at', [0 0 0]);
  mimo_scene_add(scene, 'pose', 'joint', 'robot:left_elbow', 'value', -0.7);
  mimo_scene_add(scene, 'lock', 'joint', 'robot:right_elbow', 'value', -0.5);
  mimo_scene_add(scene, 'joint', 'joint', 'robot:right_elbow');
  mimo_scene_add(scene, 'joint', 'joint', 'robot:left_elbow');
  mimo_scene_add(scene, 'skin', 'spacing', 0);
  mimo_scene_add(scene, 'skin', 'body', 'left_hand', 'spacing', 0.02);
  world = mimo_create(scene, 'frame_skip', 1);
  seen = mimo_reset(world, 1);
  assert(max(abs(seen.proprioception_position - [-0.5; -0.7])) < 1e-6, mat2str(seen.proprioception_position));
  assert(isequal(size(seen.vision_wall), [8 16 3]));
  assert(mimo_locked(world, 'robot:right_elbow') == -0.5);
  mimo_physics(world, 100);
  mimo_update(world);
  heights = reshape(mimo_get(world, 'body_position', {'held/ball', 'ball', 'free/ball'}), 3, 3);
  assert(max(abs(heights(3, 1:2) - [2 2.1])) < 0.02 && abs(heights(3, 3) - (2 - 9.81 * 0.5 ^ 2 / 2)) < 0.02, mat2str(heights));

  % The scene goes on growing; worlds are of what it was.
  mimo_scene_add(scene, 'skin', 'body', 'left_hand', 'spacing', 0.005);
  finer = mimo_create(scene);
  dense = mimo_reset(finer, 1);
  assert(size(dense.touch_force, 1) > 8 * size(seen.touch_force, 1) && ~isempty(seen.touch_force));
  mimo_close(finer);

  assert(~isempty(strfind(mimo_scene_xml(scene), '<body name="held/ball"')));
  folder = tempname();
  mimo_scene_save(scene, folder);
  again = mimo_scene(fullfile(folder, 'scene.xml'));
  assert(~isempty(strfind(mimo_scene_xml(again), 'robot:left_elbow')));
  mimo_close(again);
  rmdir(fullfile(folder, 'assets'), 's');
  rmdir(folder, 's');

  clear('mimo_mex');
  assert(~isempty(strfind(mimo_scene_xml(scene), 'held/ball')));
  mimo_close(scene);
  mimo_step(world, []);  % it lives on
  mimo_close(world);
end

% Each infant has its own options, skin and limits.
function each_infant_has_its_own_options()
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'agent', 'name', 'anna', 'vision', 0, 'touch', 0, 'position', [0 0 0.33]);
  ben = mimo_scene_add(scene, 'agent', 'name', 'ben', 'body', 'fingers', 'vision', 0, 'touch', 'force', 'place', 'soles', ...
                       'position', [1 0 0]);
  assert(ben == 2);
  mimo_scene_add(scene, 'limits', 'agent', ben, 'path', 'vestibular/acceleration', 'gain', 2);
  plain = mimo_create(scene);
  mimo_scene_add(scene, 'limits', 'agent', ben, 'path', 'vestibular/acceleration', 'gain', 4);
  worlds = mimo_create(scene, 'worlds', 2, 'threads', 1);
  first = mimo_reset(plain, 1);
  second = mimo_reset(worlds, 1);
  assert(~isfield(first, 'anna_touch_force') && isfield(first, 'ben_touch_force'));
  assert(isequal(size(second.ben_vestibular_acceleration), [3 2]));
  assert(max(abs(second.ben_vestibular_acceleration(:, 1) - 2 * first.ben_vestibular_acceleration)) < 1e-4);
  assert(isequal(second.anna_vestibular_acceleration(:, 1), first.anna_vestibular_acceleration));
  apart = mimo_gaze(worlds, 2, 2).left_position - mimo_gaze(worlds, 2, 1).left_position;
  assert(abs(apart(1) - 1) < 0.01, mat2str(apart));
  refused(@() mimo_gaze(worlds, 2, 3), 'mimo:INVALID_ARGUMENT');
  mimo_close(scene);
  mimo_close(plain);
  mimo_close(worlds);
  scene = mimo_scene('playdate');
  assert(mimo_scene_add(scene, 'agents', 'vision', 0) == 2);
  mimo_close(scene);
end

function scenes_refuse_wrong_options()
  scene = mimo_scene('reach');
  world = mimo_create('free', 'vision', 0, 'touch', 0);
  refused(@() mimo_scene('nowhere'), 'mimo:NOT_FOUND');
  refused(@() mimo_scene('nowhere.xml'), 'mimo:NOT_FOUND');
  refused(@() mimo_scene(' <mujoco'), 'mimo:MODEL');
  refused(@() mimo_scene('reach', 'touch', 1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'agent', 'touch'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'agent', 'body', 'hands'), 'mimo:NOT_FOUND');
  refused(@() mimo_scene_add(scene, 'weld', 'body', 'target', 'pose', [1 2 3]), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'lock', 'joint', 'robot:left_elbow'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'skin', 'agent', 0, 'spacing', 1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'skin', 'agent', 1, 'spacing', 1), 'mimo:INVALID_ARGUMENT');  % nobody is in it
  refused(@() mimo_scene_add(world, 'agent'), 'mimo:BAD_HANDLE');
  refused(@() mimo_step(scene, []), 'mimo:BAD_HANDLE');
  refused(@() mimo_create(world), 'mimo:BAD_HANDLE');
  said = message_of(@() mimo_scene_add(scene, 'toy'));
  assert(strncmp(said, 'what is "toy"', 13), said);
  said = message_of(@() mimo_scene_add(scene, 'lock', 'joint', 'robot:left_elbow', 'value', 0, 'vlaue', 1));
  assert(strcmp(said, 'no option vlaue of a lock'), said);
  said = message_of(@() mimo_scene_add(scene, 'weld', 'other', 'target'));
  assert(strcmp(said, 'body: expected a text'), said);
  said = message_of(@() mimo_create(scene, 'touch', 0));
  assert(strncmp(said, 'no option touch of mimo_create for a scene''s number', 51), said);
  said = message_of(@() mimo_step(scene, []));
  assert(~isempty(strfind(said, 'is a scene, expected a world')), said);
  mimo_close(scene);
  refused(@() mimo_scene_xml(scene), 'mimo:BAD_HANDLE');
  refused(@() mimo_close(scene), 'mimo:BAD_HANDLE');
  mimo_close(world);
end

function library_and_worlds_describe_themselves()
  known = mimo_version();
  assert(~isempty(regexp(known.library, '^\d+\.\d+\.\d+(-rc\d+)?$', 'once')) && known.abi >= 0);
  assert(strcmp(known.mujoco, '2.2.2') && known.api >= 1000);
  assert(mimo_supports('mimo_batch_step') && mimo_supports('MIMO_SITE_VELOCITY') && mimo_supports('mimo_field.period'));
  assert(~mimo_supports('mimo_batch_stop') && ~mimo_supports('mimo_field.perioe') && islogical(mimo_supports('')));
  assert(ismember('standup', mimo_names('scene')) && ismember('playroom', mimo_names('room')));
  assert(isequal(size(mimo_names('face')), [7 1]) && ismember('reach', mimo_names('task')));
  refused(@() mimo_names('body'), 'mimo:INVALID_ARGUMENT');

  scene = mimo_scene('reach');
  mimo_scene_add(scene, 'parameter', 'name', 'reach/episode_steps', 'value', 1);
  mimo_scene_add(scene, 'agents');
  all_of_them = mimo_parameters(scene);
  steps = all_of_them(strcmp({all_of_them.name}, 'reach/episode_steps'));
  assert(steps.value == 1 && steps.standard > 1 && steps.low <= 1 && steps.high > 1 && ~isempty(steps.description));
  assert(numel(mimo_parameters()) == numel(all_of_them) && ~isfield(mimo_parameters(), 'value'));
  refused(@() mimo_scene_add(scene, 'parameter', 'name', 'reach/luck', 'value', 1), 'mimo:NOT_FOUND');
  worlds = mimo_create(scene, 'worlds', 2, 'threads', 1, 'timing', 1);
  mimo_close(scene);

  info = mimo_info(worlds);
  assert(strcmp(info.task, 'reach') && info.frame_skip == 2 && info.timestep == 0.005);
  assert(info.worlds == 2 && info.threads == 1);
  mimo_reset(worlds, 3);
  [~, ~, ~, truncated] = mimo_step(worlds, []);
  assert(all(truncated));
  timing = mimo_timing(worlds, 'reset');
  assert(isequal(timing.steps, [1 1]) && all(timing.physics > 0) && all(timing.total >= timing.physics));
  assert(isequal(mimo_timing(worlds).total, [0 0]));
  mimo_close(worlds);

  % Mass and height are those of the original's tables.
  world = mimo_create('free', 'vision', 0, 'touch', 0);
  agent = mimo_info(world).agents;
  assert(isempty(agent.name) && abs(agent.mass - 10.90487) < 1e-8 && abs(agent.height - 0.778) < 1e-8);
  mimo_close(world);
end

function failures_name_each_world()
  worlds = mimo_create('reach', 'worlds', 3);
  actions = zeros(numel(mimo_bounds(worlds)), 3);
  actions(2, 3) = NaN;
  refused(@() mimo_step(worlds, actions), 'mimo:INVALID_ARGUMENT');
  [messages, statuses] = mimo_failures(worlds);
  assert(isequal(statuses, {'OK', 'OK', 'INVALID_ARGUMENT'}));
  assert(isequal(messages(1:2), {'', ''}) && ~isempty(strfind(messages{3}, 'action(2) is not a number')), messages{3});
  mimo_close(worlds);
end

function single_worlds_of_a_batch_move()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  numbers = mimo_random(worlds, 1000);
  assert(isequal(size(numbers), [1000 2]) && all(numbers(:) >= 0) && all(numbers(:) < 1));
  assert(max(abs(mean(numbers) - 0.5)) < 0.05);  % five standard deviations of such a mean are 0.046
  assert(~isequal(numbers(:, 1), numbers(:, 2)));
  mimo_reset(worlds, 3);
  assert(isequal(mimo_random(worlds, 1000), numbers));
  mimo_physics(worlds, 10);
  assert(max(abs(mimo_time(worlds) - 0.05)) < 1e-12);
  refused(@() mimo_physics(worlds, 0.5), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_random(worlds, -1), 'mimo:INVALID_ARGUMENT');
  assert(strcmp(mimo_body_of(worlds, 'joint', 'robot:left_elbow'), 'left_lower_arm'));
  assert(strcmp(mimo_body_of(worlds, 'body', 'left_lower_arm'), 'left_upper_arm'));
  mimo_close(worlds);
end

function points_and_appearances_are_read()
  world = mimo_create('free', 'vision', 0, 'touch', 0, ...
                      'cameras', struct('name', 'wall', 'height', 48, 'width', 64, 'position', [4 0 2], 'look_at', [0 0 0]));
  mimo_reset(world, 1);
  % What the camera looks at is in the middle of its picture; what is to its right (+y, as it looks along -x) right of it.
  pixels = mimo_project(world, [0 0; 0 0.5; 0 0], 48, 64, 'wall');
  assert(max(abs(pixels(:, 1) - [32; 24; sqrt(20)])) < 1e-6, mat2str(pixels));
  assert(abs(pixels(1, 2) - (32 + 0.5 / sqrt(20) * 24 / tan(22.5 * pi / 180))) < 1e-6 && abs(pixels(2, 2) - 24) < 1e-6);
  refused(@() mimo_project(world, [0 0], 48, 64), 'mimo:INVALID_ARGUMENT');

  gaze = mimo_gaze(world);
  point = (gaze.left_position + gaze.right_position) / 2 + [0.4; 0.05; 0];
  [joints, angles, errors] = mimo_look_angles(world, point, 'head');
  assert(numel(joints) == numel(angles) && max(abs(errors)) < 1e-6);
  assert(isequal(mimo_gaze(world).left_direction, gaze.left_direction));  % nothing has moved
  mimo_set(world, 'joint_position', joints, angles);
  assert(max(abs(mimo_gaze(world).point - point)) < 1e-6);
  mimo_close(world);
end

% A camera 2 m above a floor sees nothing but the floor, 2 m away.
function pictures_have_depth()
  file = [tempname() '.xml'];
  text = fopen(file, 'w');
  fprintf(text, '<mujoco><worldbody><geom name="first" size=".1" pos="0 0 -5"/><geom name="floor" type="plane" size="9 9 .1"/></worldbody></mujoco>');
  fclose(text);
  scene = mimo_scene(file);
  delete(file);
  world = mimo_create(scene);
  mimo_close(scene);
  above = struct('look_at', [0 0 0], 'distance', 2, 'elevation', -90, 'azimuth', 90, 'fovy', 60);
  [rgb, depth, segmentation] = mimo_picture(world, 6, 8, above);
  assert(isa(rgb, 'uint8') && isequal(size(rgb), [6 8 3]) && isequal(size(depth), [6 8]) && isequal(size(segmentation), [6 8]));
  assert(max(abs(depth(:) - 2)) < 1e-3, mat2str(depth));
  geoms = mimo_names(world, 'geom');
  assert(all(strcmp(geoms(segmentation(:) + 1), 'floor')));
  % A point 1 m to the right of the middle, 2 m away, lies by its tangent of 0.5 to that of half the field of view.
  pixels = mimo_project(world, [1; 0; 0], 6, 8, above);
  assert(max(abs(pixels - [4 + 3 * 0.5 / tan(30 * pi / 180); 3; 2])) < 1e-6, mat2str(pixels));
  refused(@() mimo_picture(world, 6, 8, struct('hight', 1)), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_picture(world, 6, 8, struct('distance', 0)), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end

function send_and_receive_equal_a_step()
  one = mimo_create('reach', 'worlds', 2);
  other = mimo_create('reach', 'worlds', 2);
  mimo_reset(one, 3);
  mimo_reset(other, 3);
  actions = 0.1 * ones(numel(mimo_bounds(one)), 2);
  refused(@() mimo_receive(one), 'mimo:BUSY');
  mimo_send(one, actions);
  refused(@() mimo_observation(one), 'mimo:BUSY');  % it is being written
  refused(@() mimo_send(one, actions), 'mimo:BUSY');
  assert(numel(mimo_layout(one).actions) == size(actions, 1));  % that never changes
  [seen, reward, terminated, truncated, info] = mimo_receive(one);
  [other_seen, other_reward, other_terminated, other_truncated, other_info] = mimo_step(other, actions);
  assert(isequal(reward, other_reward) && all(reward ~= 0) && isequal(seen, other_seen));
  assert(isequal({terminated, truncated}, {other_terminated, other_truncated}) && islogical(truncated));
  assert(isequal(info, other_info));
  actions(1, 2) = NaN;
  mimo_send(one, actions);
  said = message_of(@() mimo_receive(one));
  assert(strcmp(said, 'world 2: action(1) is not a number'), said);
  mimo_send(one, []);
  mimo_close(one);  % waits for it
  mimo_close(other);
end
