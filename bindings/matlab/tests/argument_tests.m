% Tests of arguments: shapes, sparse and complex arrays, classes, texts.
function all_of_them = argument_tests()
  all_of_them = {@sparse_arrays_equal_full_ones, @sparse_options_equal_full_ones, @complex_numbers_are_refused, @shapes_are_checked, ...
                 @single_precision_is_accepted, @texts_have_one_row, @contacts_have_rows, @empty_scene_names_are_refused, ...
                 @tasks_need_an_infant, @fractions_and_big_numbers_are_refused, @words_stand_for_constants};
end

% A sparse array stores only the numbers that are not 0, here the second and the last.
function sparse_arrays_equal_full_ones()
  worlds = mimo_create('reach', 'worlds', 2);
  motors = numel(mimo_bounds(worlds));
  actions = zeros(motors, 2);
  actions(2, 1) = 0.5;
  actions(motors, 2) = -0.5;
  mimo_reset(worlds, [3 4]);
  mimo_step(worlds, actions);
  expected = mimo_mex('block', worlds);
  mimo_reset(worlds, sparse([3 4]));
  mimo_step(worlds, sparse(actions));
  assert(isequal(mimo_mex('block', worlds), expected));
  mimo_set(worlds, 'body_position', 'target', sparse([0; 0; 0.8]));
  assert(isequal(mimo_get(worlds, 'body_position', 'target'), [0 0; 0 0; 0.8 0.8]));
  assert(isequal(mimo_gravity(worlds, sparse([0 0 -1.6])), [0; 0; -1.6]));
  mimo_look_at(worlds, sparse([1 0 0]), 'head', sparse(2));
  mimo_reset(worlds, [5 6]);
  before = mimo_mex('block', worlds);
  mimo_step(worlds, []);
  mimo_reset(worlds, [5 6], 'double', sparse([false true]));
  after = mimo_mex('block', worlds);
  assert(isequal(after(:, 2), before(:, 2)) && ~isequal(after(:, 1), before(:, 1)));
  assert(isequal(mimo_convert('points', sparse([0; 0; 3]), 'unity'), [0; 3; 0]));
  mimo_close(worlds);
  many = mimo_create('reach', 'worlds', 50, 'ages', sparse([0 18]));
  assert(isequal(mimo_get(many, 'agent_age', [], 1:1), 0));
  mimo_step(many, sparse(numel(mimo_bounds(many)), 50));  % it has no number at all
  mimo_close(many);
end

function sparse_options_equal_full_ones()
  ball = struct('name', 'ball', 'position', sparse([0 0 2]), 'mass', sparse(3));
  world = mimo_create('free', 'vision', sparse(0), 'touch', 0, 'objects', ball, 'age', sparse(0));
  assert(isequal(mimo_get(world, 'body_position', 'ball'), [0; 0; 2]));
  assert(mimo_get(world, 'body_mass', 'ball') == 3 && mimo_get(world, 'agent_age') == 0);
  pixels = mimo_project(world, sparse([0; 0; 1]), 8, 8, struct('look_at', sparse([0 0 0]), 'distance', 2));
  assert(isequal(size(pixels), [3 1]));
  mimo_close(world);
end

function complex_numbers_are_refused()
  worlds = mimo_create('reach', 'worlds', 2);
  motors = numel(mimo_bounds(worlds));
  refused_as(@() mimo_step(worlds, 1i * ones(motors, 2)), 'actions: expected real numbers');
  refused_as(@() mimo_set(worlds, 'body_mass', 'head', [1i 2]), 'values: expected real numbers');
  refused_as(@() mimo_gravity(worlds, [0 0 1i]), 'xyz: expected real numbers');
  refused_as(@() mimo_look_at(worlds, [0 0 1i]), 'point: expected real numbers');
  refused_as(@() mimo_reset(worlds, [1i 2]), 'seeds: expected real numbers');
  refused_as(@() mimo_convert('points', [1i; 0; 0], 'unity'), 'values: expected real numbers');
  refused_as(@() mimo_convert('point', [1; 0; 0], 'unity'), 'what is "point", which mimo_convert does not convert');
  refused_as(@() mimo_project(worlds, [1i; 0; 0], 8, 8), 'points: expected real numbers');
  refused_as(@() mimo_physics(worlds, 1i), 'steps: expected a real number');
  refused_as(@() mimo_create('free', 'objects', struct('name', 'b', 'position', [0 0 1i])), 'position: expected real numbers');
  refused_as(@() mimo_create('free', 'ages', [1i 2]), 'ages: expected real numbers');
  mimo_close(worlds);
end

% A transposed array has as many numbers, in another order.
function shapes_are_checked()
  worlds = mimo_create('reach', 'worlds', 3);
  motors = numel(mimo_bounds(worlds));
  said = sprintf('actions is 3 x %d, expected %d x 3: a row for each action, a column for each world', motors, motors);
  refused_as(@() mimo_step(worlds, zeros(3, motors)), said);
  refused_as(@() mimo_send(worlds, zeros(3, motors)), said);
  refused_as(@() mimo_step(worlds, zeros(motors, 1, 3)), sprintf('actions is %d x 1 x 3', motors));
  mimo_step(worlds, zeros(1, 3 * motors));  % as vectors they lie in one order only
  refused_as(@() mimo_set(worlds, 'body_position', {'target', 'target'}, zeros(3, 6)), 'values is 3 x 6, expected 6 x 3');
  refused_as(@() mimo_set(worlds, 'body_position', {'target', 'target'}, zeros(2, 3)), 'values is 2 x 3, expected 6 x 1');
  refused_as(@() mimo_load(worlds, mimo_save(worlds)'), 'columns, expected one, or one for each of 3 worlds');
  refused_as(@() mimo_reset(worlds, [1 2; 3 4]), 'seed: expected');
  mimo_close(worlds);
  world = mimo_create('reach');
  mimo_step(world, zeros(1, motors));
  mimo_step(world, zeros(motors, 1));
  refused_as(@() mimo_look_at(world, zeros(3, 3)), 'point is 3 x 3, expected 3 numbers');
  refused_as(@() mimo_gravity(world, [0 0]), 'xyz is 1 x 2, expected 3 numbers');
  joints = numel(mimo_get(world, 'joint_position'));
  refused_as(@() mimo_follow(world, zeros(2, joints)), sprintf('positions is 2 x %d, expected %d x 2', joints, joints));
  mimo_close(world);
  refused_as(@() mimo_create('free', 'orientation', [1 0; 0 0]), 'orientation is 2 x 2, expected 4 numbers');
  refused_as(@() mimo_create('free', 'ages', [1 2; 3 4]), 'ages is 2 x 2');
end

% Half a metre is the same number in single precision.
function single_precision_is_accepted()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_set(worlds, 'body_position', 'target', single([0.5; 0.25; 0.75]));
  assert(isequal(mimo_get(worlds, 'body_position', 'target'), [0.5 0.5; 0.25 0.25; 0.75 0.75]));
  mimo_step(worlds, zeros(numel(mimo_bounds(worlds)), 2, 'single'));
  assert(isequal(mimo_gravity(worlds, single([0 0 -2])), [0; 0; -2]));
  mimo_look_at(worlds, single([1 0 0]));
  mimo_close(worlds);
  world = mimo_create('free', 'vision', 0, 'objects', struct('name', 'b', 'position', single([0 0 2]), 'mass', single(3)));
  assert(isequal(mimo_get(world, 'body_position', 'b'), [0; 0; 2]) && mimo_get(world, 'body_mass', 'b') == 3);
  mimo_close(world);
end

% MATLAB stores the letters of a char matrix column by column.
function texts_have_one_row()
  world = mimo_create('reach');
  refused_as(@() mimo_get(world, 'body_position', ['head '; 'chest']), 'name: expected a text in one row, not in 2 rows');
  refused_as(@() mimo_create(['fr'; 'ee']), 'expected a text in one row');
  refused_as(@() mimo_create('free', 'face', ['fe'; 'ar']), 'face: expected a text in one row');
  refused_as(@() mimo_get(world, 'body_position', {'head', 5}), 'name: expected a text');
  mimo_close(world);
end

% A ball that lies on a floor, 1 kg: one contact, which carries 9.81 N.
function contacts_have_rows()
  scene = mimo_scene(['<mujoco><worldbody><geom name="floor" type="plane" size="9 9 .1"/><body name="ball" pos="0 0 .1">' ...
                      '<freejoint/><geom size=".1" mass="1"/></body></worldbody></mujoco>']);
  worlds = mimo_create(scene, 'worlds', 2, 'step_contacts', 1);
  for step = 1:500, mimo_step(worlds, []); end
  widths = struct('geoms', 2, 'bodies', 2, 'position', 3, 'frame', 9, 'distance', 1, 'force', 3, 'torque', 3);
  names = fieldnames(widths);
  for i = 1:numel(names)
    values = mimo_get(worlds, ['contact_' names{i}], [], 2);
    assert(isequal(size(values), [1 widths.(names{i})]), names{i});
  end
  ball = find(strcmp(mimo_names(worlds, 'body'), 'ball')) - 1;
  assert(isequal(mimo_get(worlds, 'contact_bodies', [], 1), [0 ball]));
  force = mimo_get(worlds, 'contact_force', [], 1);
  assert(abs(force(1) - 9.81) < 1e-3, mat2str(force));
  frame = mimo_get(worlds, 'contact_frame', [], 1);
  assert(max(abs(frame(1:3) - [0 0 1])) < 1e-9, mat2str(frame));
  impulse = mimo_get(worlds, 'step_contact_impulse', [], 1);
  assert(isequal(size(impulse), [1 3]) && isequal(size(mimo_get(worlds, 'step_contact_geoms', [], 1)), [1 2]));
  refused_as(@() mimo_get(worlds, 'contact_force'), 'each of 2 worlds has its own contacts');
  mimo_set(worlds, 'body_position', 'ball', [0; 0; 5]);
  mimo_step(worlds, []);
  mimo_step(worlds, []);
  assert(isequal(size(mimo_get(worlds, 'contact_force', [], 1)), [0 3]));
  mimo_close(worlds);
  mimo_close(scene);
end

function empty_scene_names_are_refused()
  refused_as(@() mimo_scene(''), 'mimo_scene() is an empty world');
  refused_as(@() mimo_create(''), 'expected a built-in scene');
end

function tasks_need_an_infant()
  scene = mimo_scene('reach');
  refused_as(@() mimo_create(scene), 'mimo_scene_add_agents adds its infants');
  mimo_close(scene);
  scene = mimo_scene('benchmark');
  mimo_messages();
  world = mimo_create(scene);
  said = mimo_messages();
  assert(numel(said) == 1 && ~isempty(strfind(said.text, 'has no agents')));
  mimo_close(world);
  mimo_close(scene);
end

function fractions_and_big_numbers_are_refused()
  world = mimo_create('benchmark', 'vision', 0);
  refused_as(@() mimo_mesh(world, 1.5), 'geom is 1.5, expected a whole number');
  refused_as(@() mimo_mesh(world, 1, 'unity', -4), 'segments is -4');
  refused_as(@() mimo_light(world, NaN), 'light is nan');
  refused_as(@() mimo_replay(world, 'x.h5', 0.5), 'first is 0.5');
  mimo_close(world);
end

% The bits are those of include/mimo/agent.h: FORCE 1, SLIP 4; position control is 1, a box 5. Numbers are still accepted.
function words_stand_for_constants()
  by_words = fields_with('touch', {'force', 'slip'});
  assert(isequal(by_words, fields_with('touch', 1 + 4)) && any(strcmp(by_words, 'touch/slip')));
  assert(isequal(fields_with('touch', 'force'), fields_with('touch', true)));
  assert(~any(strncmp(fields_with('touch', {}), 'touch/', 6)));
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'agent', 'vision', {}, 'touch', {}, 'actuation', 'position', 'reflexes', {'moro', 'rooting'});
  mimo_scene_add(scene, 'object', 'name', 'block', 'shape', 'box', 'size', [.1 .2 .3]);
  world = mimo_create(scene);
  assert(isequal(mimo_get(world, 'geom_size', 'block'), [.1 .2 .3]'));
  assert(all(strcmp({mimo_layout(world).actions.unit}, 'rad')));
  mimo_close(world);
  mimo_close(scene);
  said = 'touch is "fource", expected force, normal_force, slip';
  refused_as(@() mimo_create('free', 'touch', {'slip', 'fource'}), said);
  refused_as(@() mimo_create('free', 'actuation', {'torque', 'muscle'}), 'actuation: expected one of torque, position, ');
  refused_as(@() mimo_create('free', 'autoreset', {}), 'autoreset: expected one of none, next_step or same_step');
  refused_as(@() mimo_create('free', 'sex', 'both'), 'sex is "both", expected mean, female or male');
  refused_as(@() mimo_create('free', 'touch', -1), 'touch is -1, expected a whole number from 0 to 4294967295');
end
