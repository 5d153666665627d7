% Tests of the results of steps and resets, except observations, and of messages.
function all_of_them = results_tests()
  all_of_them = {@steps_return_outcomes_and_terms, @failing_a_task_is_an_outcome, @autoreset_starts_episodes, @resets_take_seeds_and_masks, @goals_are_quantities, ...
                 @messages_wait_until_read, @follow_returns_the_forces_of_a_movement};
end

% The rewards of reach, from docs/tasks.md: 100 for the hand at the ball, otherwise minus the distance.
function steps_return_outcomes_and_terms()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  balls = mimo_get(worlds, 'body_position_now', 'target');
  hands = mimo_get(worlds, 'body_position_now', 'right_fingers');
  mimo_set(worlds, 'body_position', 'target', [balls(:, 1) hands(:, 2)]);
  [~, reward, terminated, truncated, info] = mimo_step(worlds, []);
  assert(isequal(info.outcome, [0 1]) && isequal(terminated, [false true]) && ~any(truncated));
  terms = mimo_layout(worlds).terms;
  assert(isequal(sort({terms.name}), {'distance', 'success'}) && all([terms.agent] == 1));
  success = info.terms(strcmp({terms.name}, 'success'), :);
  distance = info.terms(strcmp({terms.name}, 'distance'), :);
  apart = mimo_get(worlds, 'body_position', 'right_fingers', 1) - mimo_get(worlds, 'body_position', 'target', 1);
  assert(isequal(success, [0 100]) && distance(2) == 0 && abs(distance(1) + norm(apart)) < 1e-9);
  assert(max(abs(sum(info.terms, 1) - reward)) < 1e-12);
  assert(isequal(info.was_reset, [false false]) && isequal(info.final_written, [false false]));
  mimo_close(worlds);
end

% Catch fails, with -100, when the ball is 50 cm away from the palm.
function failing_a_task_is_an_outcome()
  world = mimo_create('catch');
  mimo_reset(world, 1);
  mimo_set(world, 'body_position', 'target', [1; 1; 1]);
  [~, ~, terminated, ~, info] = mimo_step(world, []);
  terms = mimo_layout(world).terms;
  assert(info.outcome == -1 && terminated && info.terms(strcmp({terms.name}, 'failure')) == -100);
  mimo_close(world);
end

% With autoreset same_step the last observation of an episode equals the one without autoreset; the next one is a reset's.
function autoreset_starts_episodes()
  plain = mimo_create('reach', 'worlds', 2);
  again = mimo_create('reach', 'worlds', 2, 'autoreset', 'same_step', 'parameters', {'reach/episode_steps', 1});
  late = mimo_create('reach', 'worlds', 2, 'autoreset', 'next_step', 'parameters', {'reach/episode_steps', 1});
  for world = [plain again late], mimo_reset(world, 3); end
  actions = 0.3 * ones(numel(mimo_bounds(plain)), 2);
  [last, reward, ~, ~, info] = mimo_step(plain, actions);
  [first, its_reward, ~, truncated, its] = mimo_step(again, actions);
  assert(isequal(its_reward, reward) && all(truncated) && isequal(its.terms, info.terms));
  assert(all(its.was_reset) && all(its.final_written) && islogical(its.was_reset));
  assert(isequal(mimo_observation(again, 'double', 'final'), last));
  assert(isequal(mimo_reset(plain), first) && ~isequal(first, last));
  assert(isa(mimo_observation(again, 'single', 'final').proprioception_velocity, 'single'));
  [~, ~, ~, ~, its] = mimo_step(late, actions);
  assert(~any(its.was_reset) && ~any(its.final_written));
  [start, reward, ~, ~, its] = mimo_step(late, actions);
  assert(all(its.was_reset) && isequal(start, first) && isequal(reward, [0 0]) && all(its.terms(:) == 0));
  refused(@() mimo_observation(late, 'double', 'final'), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_observation(late, 'double', 'first'), 'mimo:INVALID_ARGUMENT');
  for world = [plain again late], mimo_close(world); end
end

function resets_take_seeds_and_masks()
  worlds = mimo_create('reach', 'worlds', 3);
  mimo_reset(worlds, [5 6 7]);
  six = mimo_random(worlds, 6);
  mimo_reset(worlds, uint64([5 6 7]));
  assert(isequal(mimo_random(worlds, 3), six(1:3, :)));
  mimo_reset(worlds, [5 6 7], 'double', [false true false]);  % the others go on
  assert(isequal(mimo_random(worlds, 3), [six(4:6, 1) six(1:3, 2) six(4:6, 3)]));
  % A double has 53 bits: these three would be the same seed.
  largest = intmax('uint64');
  mimo_reset(worlds, [largest - 2, largest - 1, largest]);
  numbers = mimo_random(worlds, 3);
  assert(size(unique(numbers', 'rows'), 1) == 3);
  refused(@() mimo_reset(worlds, [5.5 6 7]), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_reset(worlds, single(5)), 'mimo:INVALID_ARGUMENT');
  mimo_close(worlds);
end

% The goal of reach is the ball.
function goals_are_quantities()
  worlds = mimo_create('reach', 'worlds', 2);
  mimo_reset(worlds, 3);
  mimo_step(worlds, []);
  assert(isequal(mimo_get(worlds, 'agent_goal'), mimo_get(worlds, 'body_position', 'target')));
  assert(isequal(mimo_get(worlds, 'agent_achieved'), mimo_get(worlds, 'body_position', 'right_fingers')));
  mimo_close(worlds);
end

% An infant that starts inside a box; and a box with four contacts in a model with room for two.
function messages_wait_until_read()
  mimo_messages();
  box = struct('name', 'block', 'shape', 'box', 'size', [.3 .3 .3], 'position', [0 0 .3], 'fixed', 1);
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'place', 'soles', 'position', [0 0 0], 'objects', box);
  said = mimo_messages();
  assert(numel(said) == 1 && said.number == world && strcmp(said.level, 'warning') && said.code == 0);
  assert(isempty(said.world) && isempty(said.time) && ~isempty(strfind(said.text, 'block')), said.text);
  assert(isempty(mimo_messages()));
  mimo_close(world);

  scene = mimo_scene(['<mujoco><size nconmax="2"/><worldbody><geom type="plane" size="1 1 .1"/><body name="box" pos="0 0 1">' ...
                      '<freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>']);
  worlds = mimo_create(scene, 'worlds', 2, 'frame_skip', 1);
  mimo_close(scene);
  mimo_reset(worlds, 1);
  mimo_step(worlds, []);
  mimo_set(worlds, 'body_position', 'box', [0 0; 0 0; 1 0.099]);
  mimo_step(worlds, []);
  said = mimo_messages();
  kinds = mimo_names(worlds, 'warning');
  assert(numel(said) == 1 && said.number == worlds && said.world == 2 && strcmp(kinds{said.code + 1}, 'contacts dropped'));
  assert(said.time >= mimo_info(worlds).timestep && said.time <= 2 * mimo_info(worlds).timestep, sprintf('%g', said.time));
  mimo_close(worlds);

  % Scenes have numbers of their own; and of what cannot be made there is something to read as well.
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'object', 'name', 'block', 'shape', 'box', 'size', [.3 .3 .3], 'position', [0 0 .3], 'fixed', 1);
  mimo_scene_add(scene, 'agent', 'vision', 0, 'touch', 0, 'place', 'soles', 'position', [0 0 0]);
  mimo_close(mimo_create(scene));
  said = mimo_messages();
  assert(isequal([said.number], scene), mat2str([said.number]));
  mimo_close(scene);
end

% Holding an infant still takes its weight, at the third degree of freedom of its free joint.
function follow_returns_the_forces_of_a_movement()
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'frame_skip', 1);
  mimo_reset(world, 1);
  positions = mimo_get(world, 'joint_position');
  [seen, forces] = mimo_follow(world, positions(:));
  [seen, forces] = mimo_follow(world, positions(:));
  info = mimo_info(world);
  assert(abs(forces(3) - 9.81 * info.agents(1).mass) < 1e-6 && abs(norm(seen.vestibular_acceleration) - 9.81) < 1e-4);
  refused(@() mimo_follow(world, positions(2:end)), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end
