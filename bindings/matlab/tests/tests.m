% Tests of the MEX gateway: run with bindings/matlab and the compiled gateway on the path.
function tests()
  all_of_them = {@shapes_and_precision, @order_is_column_major, @errors_have_identifiers, @worlds_survive_clear, ...
                 @numbers_are_those_of_c, @options_reach_the_world, @senses_are_limited, @rooms_of_ones_own, @many_worlds, @states_continue, ...
                 @names_read_and_write, @faces_show, @eyes_meet, @locks_and_gravity, @masses_and_contacts, ...
                 @help_says_how_to_call, @messages_count_from_one, @robots_of_ones_own};
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

% The bytes of a picture stand in the block in the order row, column, colour.
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
  refused(@() mimo_load(world, zeros(3, 1, 'uint8')), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_picture(world, 0, 8), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_gaze(world, 2), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'visoin', 1), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'vision', 0.5), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'vision'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'face', 'boredom'), 'mimo:NOT_FOUND');
  refused(@() mimo_create('reach', 'cameras', struct('nmae', 'wall')), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('nowhere.xml'), 'mimo:NOT_FOUND');
  mimo_close(world);
  refused(@() mimo_step(world, []), 'mimo:BAD_HANDLE');
end

function refused(action, identifier)
  try
    action();
  catch problem
    assert(strcmp(problem.identifier, identifier), [problem.identifier ': ' problem.message]);
    return
  end
  error('was not refused');
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
function numbers_are_those_of_c()
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
  world = mimo_create('benchmark', 'vision', 2, 'vision_width', 32, 'vision_height', 16, 'touch', 0, 'acts', 8, ...
                      'face', 'fear', 'max_steps', 2, 'samples', 4);
  assert(isequal(size(mimo_bounds(world)), [4 1]));  % MIMO_ACT_RIGHT_ARM: shoulder (three) and elbow
  seen = mimo_reset(world, 1);
  assert(isequal(size(seen.vision_eye_left_depth), [16 32]) && ~isfield(seen, 'touch_force'));
  assert(strcmp(mimo_face(world), 'fear'));
  [~, ~, ~, first] = mimo_step(world, []);
  [~, ~, ~, second] = mimo_step(world, []);
  assert(~first && second);
  mimo_close(world);
  world = mimo_create('reach', 'parameters', {'reach/episode_steps', 1});
  mimo_reset(world, 1);
  [~, ~, ~, truncated] = mimo_step(world, []);
  assert(truncated);
  mimo_close(world);
end

function senses_are_limited()
  plain = mimo_create('reach');
  limited = mimo_create('reach', 'limits', struct('path', 'proprioception/velocity', 'gain', 2, 'delay', 1));
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
  refused(@() mimo_create('reach', 'limits', struct('path', {'proprioception', []})), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'objects', 'ball'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_create('reach', 'limits', struct('path', 'smell')), 'mimo:NOT_FOUND');
  mimo_close(plain);
  mimo_close(limited);
end

function rooms_of_ones_own()
  file = [tempname() '.xml'];
  text = fopen(file, 'w');
  fprintf(text, '<mujoco><option timestep="0.005"/><worldbody><geom name="floor" type="plane" size="2 2 .1"/></worldbody></mujoco>');
  fclose(text);
  % A ball falls by g h^2 n (n + 1) / 2 in n steps of h = 5 ms: semi-implicit Euler.
  world = mimo_create(file, 'position', [0 0 5], 'vision', 0, 'touch', 0, 'frame_skip', 1, ...
                      'objects', struct('name', {'ball', 'box'}, 'shape', {1, 5}, 'size', {[.1 0 0], [.1 .1 .1]}, ...
                                        'position', {[1 0 2], [2 0 3]}), ...
                      'cameras', struct('name', 'wall', 'width', 16, 'height', 8, 'outputs', 5, 'position', [4 0 2], ...
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
    world = mimo_create('free', 'place', 2, 'position', [0.5 0 height], 'vision', 0, 'touch', 0, 'vestibular', 1);
    feet = reshape(mimo_get(world, 'body_position', {'left_foot', 'right_foot'}), 3, 2);
    assert(max(abs(mean(feet(1:2, :), 2) - [0.5; 0])) < 1e-12 && max(feet(3, :)) < height + 0.1 && min(feet(3, :)) > height);
    seen = mimo_reset(world, 1);
    assert(isfield(seen, 'vestibular_acceleration') && ~isfield(seen, 'vestibular_angular_velocity'));
    mimo_close(world);
  end
end

% World i is a single world with the i-th seed and the i-th actions.
function many_worlds()
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

function states_continue()
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

function names_read_and_write()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  mimo_set(worlds, 'joint_position', 'robot:right_elbow', [-0.1 -0.2]);
  assert(isequal(mimo_get(worlds, 'joint_position', 'robot:right_elbow'), [-0.1 -0.2]));
  mimo_set(worlds, 'body_position', 'target', [0.4; 0.1; 0.8]);
  assert(max(max(abs(mimo_get(worlds, 'body_position', {'target'}) - [0.4 0.4; 0.1 0.1; 0.8 0.8]))) < 1e-12);
  assert(isequal(size(mimo_get(worlds, 'body_position', {'head', 'left_hand'})), [6 2]));
  mimo_close(worlds);
end

function faces_show()
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

% The eyes' centres are 49 mm apart: 2 atan(0.0245 m / d) is the vergence at a distance d straight ahead.
function eyes_meet()
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

function locks_and_gravity()
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

% v = F / m t in two worlds; and the impulse of a step's contacts is the change of momentum, less that of gravity.
function masses_and_contacts()
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
  for n = 1:20
    before = mimo_get(worlds, 'body_velocity_now', 'test_object2');
    mimo_step(worlds, []);
    change = mimo_get(worlds, 'body_velocity_now', 'test_object2') - before;
    bodies = reshape(mimo_get(worlds, 'step_contact_bodies', [], 2), 2, []);
    impulses = reshape(mimo_get(worlds, 'step_contact_impulse', [], 2), 3, []);
    impulse = sum(impulses(3, bodies(2, :) == ball));
    assert(abs(impulse - 4 * 9.81 * 0.01 - 4 * change(3, 2)) < 1e-9);
  end
  assert(impulse > 0);
  refused(@() mimo_get(worlds, 'contact_force'), 'mimo:INVALID_ARGUMENT');
  mimo_close(worlds);
end

% Each function's help has a call with all its outputs, or with one of them, and sizes as MATLAB's arrays have them.
function help_says_how_to_call()
  folder = fileparts(which('mimo_create'));
  files = dir(fullfile(folder, 'mimo_*.m'));
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
    for k = 1:numel(inputs)
      word = strrep(inputs{k}, 'varargin', 'value');
      assert(~isempty(regexp(text, ['\<' word 's?\>'], 'once')), [name ': nothing about ' word]);
    end
  end
  documents = [cellfun(@(name) fullfile(folder, name), {files.name}, 'UniformOutput', false), {fullfile(folder, 'README.md')}];
  for i = 1:numel(documents)
    text = fileread(documents{i});
    height = strfind(text, 'height');
    width = strfind(text, 'width');
    assert(isempty(width) || (numel(height) == numel(width) && all(height < width)), documents{i});
  end
end

function said = message_of(action)
  said = '';
  try
    action();
  catch problem
    said = regexprep(problem.message, '^mimo_mex: ', '');  % so begin Octave's
  end
end

% What the library counts from 0, MATLAB counts from 1; names stay as they are.
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

% Standard gravity, felt by what hangs still at the end of a robot's arm: 9.81 m/s^2 upwards.
function robots_of_ones_own()
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
