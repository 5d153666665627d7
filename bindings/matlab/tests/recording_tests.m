% Tests of recordings.
function all_of_them = recording_tests()
  all_of_them = {@runs_are_replayed, @other_files_are_no_recordings};
end

function runs_are_replayed()
  world = one_that_hears();
  twin = one_that_hears();
  file = [tempname() '.h5'];
  mimo_record(world, file, 'keep', 'hearing/ear_left', 'state_seconds', 0.1, 'configuration', '{}', 'seed', 7);
  refused(@() mimo_record(world, file), 'mimo:BUSY');
  actions = 0.3 * ones(numel(mimo_layout(world).actions), 1);
  mimo_play(world, 'head', 0.1 * sin(0.3 * (0:319)));
  for step = 1:5, mimo_step(world, actions); end
  mimo_reset(world, 3);
  for step = 1:5, seen = mimo_step(world, actions); end
  mimo_step(world, []);
  mimo_record_flush(world);
  mimo_record_end(world);
  refused(@() mimo_record_end(world), 'mimo:BUSY');
  info = mimo_recording(file);
  assert(info.steps == 11 && info.bodies == 1 && info.same_build);
  assert(strcmp(info.configuration, '{}') && strcmp(info.seed, '7'));
  report = mimo_replay(twin, file);
  assert(report.identical && report.steps == 11 && isempty(report.differs_most_in));
  alone = mimo_replay([], file);
  assert(alone.identical && alone.steps == report.steps);
  report = mimo_replay(twin, file, 7, 9);
  assert(report.identical && report.next == 9 && report.steps == 4);  % the reset after 5 steps is a state
  other = mimo_create('reach', 'vision', 0, 'touch', 0);
  refused(@() mimo_replay(other, file), 'mimo:MISMATCH');
  refused(@() mimo_replay(twin, file, 12), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_record(other, file), 'mimo:FILE');
  mimo_record(other, file, 'replace', 1);
  mimo_step(other, []);
  mimo_close(other);  % closes the file, too
  info = mimo_recording(file);
  assert(info.steps == 1);
  mimo_close(world);
  mimo_close(twin);
  delete(file);
end

function other_files_are_no_recordings()
  refused(@() mimo_recording('/nowhere/run.h5'), 'mimo:NOT_FOUND');
  world = one_that_hears();
  refused(@() mimo_record(world, '/nowhere/run.h5'), 'mimo:FILE');
  refused(@() mimo_record(world, [tempname() '.h5'], 'keep', 'wings'), 'mimo:NOT_FOUND');
  refused(@() mimo_record(world, [tempname() '.h5'], 'wings', 2), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end
