% same(folder): the scenario of tests/capi/same.c. 64-bit integers of MATLAB saturate instead of wrapping around, so the
% blocks go to files in the folder, for tests/same/fnv1a to hash; names of scenes and sums of rewards are printed.
function same(folder)
  scenes = {'reach', 'standup', 'selfbody', 'benchmark'};
  for s = 1:numel(scenes)
    world = mimo_create(scenes{s});
    file = fopen(fullfile(folder, scenes{s}), 'w');
    mimo_reset(world, 7);
    fwrite(file, mimo_mex('block', world));
    motors = numel(mimo_bounds(world));
    total = 0;
    for step = 0:99
      actions = (mod(7 * step + 3 * (0:motors - 1), 21) - 10) / 10;
      total = total + mimo_mex('step', world, actions);
      fwrite(file, mimo_mex('block', world));
    end
    fclose(file);
    fprintf('%s %.6f\n', scenes{s}, total);
    mimo_close(world);
  end
end
