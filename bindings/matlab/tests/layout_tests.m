% Tests of observations and actions.
function all_of_them = layout_tests()
  all_of_them = {@fields_lie_at_their_offset, @labels_are_names, @delayed_fields_state_their_time, @nerve_delays_follow_the_age, ...
                 @actions_are_described, @receptors_lie_on_the_skin, @fields_are_added_on_request, @ambiguous_members_are_refused};
end

% A field lies in the block at its offset, in C's order.
function fields_lie_at_their_offset()
  worlds = mimo_create('benchmark', 'worlds', 2, 'vision', {'rgb', 'depth', 'segmentation'}, 'vision_height', 8, 'vision_width', 16);
  seen = mimo_reset(worlds, 7);
  layout = mimo_layout(worlds);
  blocks = mimo_mex('block', worlds);
  assert(layout.block_bytes == size(blocks, 1) && layout.agents == 1);
  assert(isequal({layout.fields.member}, fieldnames(seen)'));
  for i = 1:numel(layout.fields)
    field = layout.fields(i);
    raw = typecast(blocks(field.offset + (1:field.bytes), 2), field.type);
    expected = permute(reshape(raw, fliplr(field.size)), numel(field.size):-1:1);
    its = of_second(seen.(field.member));
    assert(isequal(double(expected), double(its)), field.name);
    assert(all(its(:) >= field.low) && all(its(:) <= field.high), field.name);
    assert(abs(field.period - 0.01) < 1e-12, field.name);
  end
  eye = field_of(layout, 'vision/eye_left');
  assert(strcmp(eye.member, 'vision_eye_left') && isequal(eye.size, [8 16 3]) && strcmp(eye.type, 'uint8'));
  assert(isequal([eye.low eye.high], [0 255]) && eye.receptors == 0);
  touch = field_of(layout, 'touch/force');
  assert(strcmp(touch.unit, 'N') && touch.receptors == size(seen.touch_force, 1) && touch.low == -Inf);
  mimo_close(worlds);
end

function labels_are_names()
  world = mimo_create('benchmark', 'vision', 0);
  mimo_reset(world, 7);
  for step = 1:5, seen = mimo_step(world, ones(size(mimo_bounds(world)))); end
  layout = mimo_layout(world);
  names = mimo_labels(world, 'proprioception/position');
  assert(isequal(size(names), size(seen.proprioception_position)));
  angles = mimo_get(world, 'joint_position', names);
  assert(max(abs(angles - seen.proprioception_position)) < 1e-6 && numel(unique(angles)) > 10);
  names = mimo_labels(world, 'proprioception/torque');
  assert(isequal(size(names), field_of(layout, 'proprioception/torque').size));
  sensors = regexprep(names, '/[xyz]$', '');  % one a row, with an axis a column
  assert(isequal(sensors(:, 1), sensors(:, 2)) && all(strcmp(regexp(names(:, 3), '/[xyz]$', 'match', 'once'), '/z')));
  torques = reshape(mimo_get(world, 'sensor_value', sensors(:, 1)), 3, [])';
  assert(max(max(abs(torques - seen.proprioception_torque))) < 1e-5 && numel(unique(torques)) > 10);
  names = mimo_labels(world, 'touch/force');
  assert(isequal(size(names), size(seen.touch_force)) && all(strcmp(names(:), '')));
  refused(@() mimo_labels(world, 'touch/pain'), 'mimo:NOT_FOUND');
  said = message_of(@() mimo_labels(world, 'touch/pain'));
  assert(~isempty(strfind(said, 'touch/force')), said);
  mimo_close(world);
end

% Accelerations belong to the start of the last physics step, of 5 ms; a delay adds to that.
function delayed_fields_state_their_time()
  world = mimo_create('benchmark', 'vision', 0, 'touch', 0, 'limits', struct('path', 'vestibular', 'delay', 0.03));
  layout = mimo_layout(world);
  late = field_of(layout, 'vestibular/acceleration');
  assert(max(abs(late.time - [-0.035 -0.035])) < 1e-12, mat2str(late.time));
  assert(isequal(field_of(layout, 'proprioception/position').time, [0 0]));
  mimo_close(world);
end

% The delay is the time in the nerve of the part that a joint moves and in the brain, rounded to time steps of 5 ms.
function nerve_delays_follow_the_age()
  newborn = mimo_maturity(0);
  assert(newborn.acuity == 0.70 && newborn.chroma == 0 && mimo_maturity(24).acuity == 11.1);
  refused(@() mimo_maturity(25), 'mimo:INVALID_ARGUMENT');
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'age', 0, 'maturity', {'body', 'delays'});
  late = mimo_delays(world, 'proprioception/limit');
  joints = mimo_labels(world, 'proprioception/limit');
  assert(isequal(size(late), size(joints)));
  bodies = cellfun(@(joint) mimo_body_of(world, 'joint', joint), joints, 'UniformOutput', false);
  lengths = mimo_get(world, 'body_nerve_length', bodies);
  exact = lengths / newborn.conduction_speed + newborn.sensory_delay;
  assert(max(abs(late - exact)) < 0.0025 + 1e-9 && numel(unique(late)) > 1);
  time = field_of(mimo_layout(world), 'proprioception/limit').time;
  assert(max(abs(time + [max(late) min(late)])) < 1e-12);
  older = mimo_create('free', 'vision', 0, 'touch', 0, 'ages', 18, 'maturity', {'body', 'delays'});
  assert(mimo_get(older, 'agent_age') == 18);
  sooner = mimo_delays(older, 'proprioception/limit');
  assert(sum(sooner) < sum(late) && all(sooner > 0));
  mimo_close(older);
  assert(isequal(size(mimo_delays(world, 'proprioception/torque')), [21 3]));
  mimo_close(world);
  refused(@() mimo_create('free', 'maturity', 'ears'), 'mimo:INVALID_ARGUMENT');
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'agent', 'vision', 0, 'touch', 0, 'maturity', 'all');
  mimo_scene_add(scene, 'maturity', 'age', 3, 'vestibular_delay', 0.1);
  world = mimo_create(scene);
  assert(max(abs(mimo_delays(world, 'vestibular/acceleration') - 0.1)) < 1e-12);
  mimo_close(world);
  mimo_scene_add(scene, 'maturity');
  world = mimo_create(scene);
  assert(all(mimo_delays(world, 'vestibular/acceleration') < 0.01));
  refused(@() mimo_scene_add(scene, 'maturity', 'age', 25), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'maturity', 'hunger', 1), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
  mimo_close(scene);
end

% Under position control bounds are the ranges of the joints; muscles are activated from 0 to 1.
function actions_are_described()
  world = mimo_create('benchmark', 'vision', 0, 'touch', 0, 'acts', 'right_arm', 'actuation', 'position');
  actions = mimo_layout(world).actions;
  assert(numel(actions) == 4 && all(strcmp({actions.unit}, 'rad')) && all([actions.agent] == 1));
  elbow = actions(strcmp({actions.name}, 'act:right_elbow'));
  assert(max(abs([elbow.low; elbow.high] - mimo_get(world, 'joint_range', 'robot:right_elbow'))) < 1e-6);
  [low, high] = mimo_bounds(world);
  assert(isequal(low, [actions.low]') && isequal(high, [actions.high]'));
  mimo_close(world);
  world = mimo_create('benchmark', 'vision', 0, 'touch', 0, 'acts', 'right_arm', 'actuation', 'muscle');
  actions = mimo_layout(world).actions;
  assert(numel(actions) == 8 && all([actions.low] == 0) && all([actions.high] == 1) && all(strcmp({actions.unit}, '')));
  assert(isequal(strrep({actions(1:4).name}, 'negative', 'positive'), {actions(5:8).name}));
  mimo_close(world);
  world = mimo_create('benchmark', 'vision', 0, 'touch', 0, 'acts', 'none');
  assert(isempty(mimo_layout(world).actions) && isequal(size(mimo_bounds(world)), [0 1]));
  mimo_close(world);
  world = mimo_create('playdate', 'vision', 0, 'touch', 0);
  actions = mimo_layout(world).actions;
  assert(isequal(unique([actions.agent]), [1 2]) && mimo_layout(world).agents == 2);
  mimo_close(world);
end

% The skin of a sphere lies 10 cm from its middle, and its normals point away from it.
function receptors_lie_on_the_skin()
  file = [tempname() '.xml'];
  text = fopen(file, 'w');
  fprintf(text, ['<mujoco><worldbody><geom type="plane" size="1 1 .1"/><body name="ball" pos="0 0 1"><freejoint/>' ...
                 '<geom name="skin" size=".1" pos=".2 0 0"/></body></worldbody></mujoco>']);
  fclose(text);
  scene = mimo_scene(file);
  delete(file);
  mimo_scene_add(scene, 'agent', 'body', 'scene', 'root', 'ball', 'vision', 0, 'vestibular', 0);
  mimo_scene_add(scene, 'skin', 'spacing', 0.02);
  world = mimo_create(scene);
  mimo_close(scene);
  positions = mimo_receptors(world, 'touch/force', 'position');
  count = size(positions, 1);
  area = 4 * pi * 0.1 ^ 2;
  assert(abs(count * 0.02 ^ 2 / area - 1) < 0.25, sprintf('%d', count));
  assert(count == size(mimo_reset(world, 1).touch_force, 1));
  from_middle = positions - repmat([0.2 0 0], count, 1);
  assert(max(abs(sqrt(sum(from_middle .^ 2, 2)) - 0.1)) < 1e-9);
  frames = mimo_receptors(world, 'touch/force', 'frame');
  assert(max(max(abs(frames(:, 1:3) - from_middle / 0.1))) < 1e-9);
  assert(max(max(abs(cross(frames(:, 1:3), frames(:, 4:6)) - frames(:, 7:9)))) < 1e-9);
  assert(max(abs(sum(frames(:, 1:3) .* frames(:, 4:6), 2))) < 1e-9);
  bodies = mimo_receptors(world, 'touch/force', 'body');
  geoms = mimo_receptors(world, 'touch/force', 'geom');
  names = mimo_names(world, 'body');
  assert(isequal(size(bodies), [count 1]) && all(strcmp(names(bodies + 1), 'ball')));
  names = mimo_names(world, 'geom');
  assert(all(strcmp(names(geoms + 1), 'skin')));
  said = message_of(@() mimo_receptors(world, 'touch/force', 'temperature'));
  assert(strcmp(said, 'quantity is "temperature", expected body, geom, position or frame'), said);
  mimo_close(world);
end

% A ball falls at g t. The box is turned by 90 degrees about z: a point towards -y lies towards -x in its frame.
function fields_are_added_on_request()
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'agent', 'vision', 0, 'touch', 0);
  mimo_scene_add(scene, 'object', 'name', 'ball', 'position', [3 0 2]);
  mimo_scene_add(scene, 'object', 'name', 'box', 'shape', 'box', 'size', [.1 .1 .1], 'position', [3 1 3], 'orientation', [1 0 0 1]);
  mimo_scene_add(scene, 'field', 'name', 'toys/position', 'elements', {'ball', 'box'});
  mimo_scene_add(scene, 'field', 'name', 'toys/velocity', 'quantity', 'body_velocity_now', 'elements', 'ball');
  mimo_scene_add(scene, 'field', 'name', 'toys/apart', 'quantity', 'body_position_now', 'elements', 'ball', 'relative_to', 'box');
  refused(@() mimo_scene_add(scene, 'field', 'name', 'toys/apart', 'elements', 'ball'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_scene_add(scene, 'field', 'name', 'x', 'quantity', 'body_temperature', 'elements', 'ball'), 'mimo:NOT_FOUND');
  refused(@() mimo_scene_add(scene, 'field', 'name', 'x', 'quantity', 'contact_force'), 'mimo:INVALID_ARGUMENT');
  world = mimo_create(scene);
  mimo_close(scene);
  seen = mimo_reset(world, 1);
  assert(max(max(abs(seen.toys_position - [3 0 2; 3 1 3]))) < 1e-6, mat2str(seen.toys_position));
  assert(max(abs(seen.toys_apart(:) - [-1; 0; -1])) < 1e-6, mat2str(seen.toys_apart));
  seen = mimo_step(world, []);
  assert(max(abs(seen.toys_velocity(:) - [0; 0; -9.81 * 0.01; 0; 0; 0])) < 1e-6, mat2str(seen.toys_velocity));
  layout = mimo_layout(world);
  assert(strcmp(field_of(layout, 'toys/position').unit, 'm'));
  assert(max(abs(field_of(layout, 'toys/position').time + 0.005)) < 1e-12);
  assert(isequal(field_of(layout, 'toys/apart').time, [0 0]));
  mimo_close(world);
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'fields', struct('name', 'hands', 'elements', {{'left_hand', 'right_hand'}}));
  assert(isequal(size(mimo_reset(world, 1).hands), [2 3]));
  mimo_close(world);
  refused(@() mimo_create('free', 'fields', struct('name', 'tail', 'elements', 'tail')), 'mimo:NOT_FOUND');
end

% Two names that differ in the library only.
function ambiguous_members_are_refused()
  twins = struct('name', {'toys/head', 'toys_head'}, 'elements', 'head');
  said = message_of(@() mimo_create('free', 'vision', 0, 'touch', 0, 'fields', twins));
  assert(strcmp(said, 'field "toys_head" has the same name in MATLAB as another field'), said);
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'fields', struct('name', '2nd', 'elements', 'head'));
  assert(isequal(size(mimo_reset(world, 1).x2nd), [1 3]));
  mimo_close(world);
end
