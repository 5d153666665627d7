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
  draw_stage(folder);
end

% The picture of tests/capi/same.c.
function draw_stage(folder)
  pixels = uint8([200 30 90 20 180 60 40 80 220 250 240 130]);
  stage = mimo_stage('geoms', struct('object_type', 5, 'forms', {{'plane', 'sphere'}}, 'sizes', [0 0 0; 0.5 0 0], ...
                                     'colors', [1 1 1 1; 0.9 0.2 0.1 1], 'materials', [1 0]), ...
                     'textures', struct('types', {{'flat'}}, 'widths', 2, 'heights', 2, 'pixels', pixels, 'srgb', 1), ...
                     'materials', struct('colors', [1 1 1 1], 'textures', 1), 'lights', struct('types', {{'sun'}}));
  upright = reshape(eye(3), 1, 9);
  poses = struct('geom_positions', [0 0 0; 0 0 0.5], 'geom_rotations', [upright; upright], ...
                 'light_positions', [0 0 5], 'light_directions', [0 0.6 -0.8]);
  [rgb, depth, objects] = mimo_stage_draw(stage, poses, struct('width', 64, 'height', 48, 'position', [0 0 4], 'rotation', eye(3)));
  file = fopen(fullfile(folder, 'stage'), 'w');
  fwrite(file, permute(rgb, [3 2 1]));
  fwrite(file, permute(depth, [2 1]), 'single');
  fwrite(file, permute(objects, [3 2 1]), 'int32');
  fclose(file);
  fprintf('stage %.6f\n', sum(double(rgb(:))));
  mimo_close(stage);
end
