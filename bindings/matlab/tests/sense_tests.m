% Tests of senses of a user's own.
function all_of_them = sense_tests()
  all_of_them = {@own_senses_come_from_libraries};
end

% The inertial sensors of examples/senses, here without noise and offsets: they read what the world says.
function own_senses_come_from_libraries()
  root = fullfile(fileparts(mfilename('fullpath')), '..', '..', '..');
  library = [tempname() '.so'];
  cleaning = onCleanup(@() delete(library));
  [status, said] = system(sprintf('c++ -std=c++11 -fPIC -shared "-I%s/include" "%s/examples/senses/imu.cpp" "%s/build/lib/libmimo.so" -o "%s"', ...
                                  root, root, root, library));
  assert(status == 0, said);
  scene = mimo_scene('free');
  mimo_scene_add(scene, 'agents', 'vision', 0, 'touch', 0);
  refused(@() mimo_scene_add(scene, 'sense', 'path', '/none/imu.so'), 'mimo:FILE');
  mimo_scene_add(scene, 'sense', 'path', library);
  refused(@() mimo_scene_add(scene, 'sense', 'path', library), 'mimo:INVALID_ARGUMENT');
  mimo_scene_add(scene, 'parameter', 'name', 'imu/noise', 'value', 0);
  mimo_scene_add(scene, 'parameter', 'name', 'imu/bias', 'value', 0);
  said = message_of(@() mimo_scene_add(scene, 'parameter', 'name', 'imu/bais', 'value', 0));
  assert(~isempty(strfind(said, 'did you mean "imu/bias"')), said);
  world = mimo_create(scene);
  mimo_reset(world, 1);
  seen = mimo_step(world, []);
  read = mimo_get(world, 'body_inertial', 'head');  % acceleration, angular velocity, angular acceleration
  assert(isequal(size(seen.imu_acceleration), [5 1 3]), mat2str(size(seen.imu_acceleration)));
  assert(max(abs(squeeze(seen.imu_acceleration(5, 1, :)) - reshape(read(1:3), [], 1))) < 1e-4 && norm(read(1:3)) > 0);
  mimo_close(world);
  mimo_close(scene);
end
