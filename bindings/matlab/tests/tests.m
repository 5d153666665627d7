% Tests of the MEX gateway: run with bindings/matlab and the compiled gateway on the path.
function tests()
  all_of_them = {@shapes_and_precision, @order_is_column_major, @errors_have_identifiers, @worlds_survive_clear, ...
                 @numbers_are_those_of_c};
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
