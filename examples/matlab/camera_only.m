% Pictures without a simulation: a snowman on a chequered floor, drawn from plain arrays. Needs bindings/matlab on the path.
squares = reshape(uint8([60 90 60, 200 220 200, 200 220 200, 60 90 60]), [3 2 2]);  % colour, column, row: 2 x 2 pixels
textures = struct('types', {{'flat'}}, 'widths', 2, 'heights', 2, 'pixels', squares(:));
materials = struct('colors', [1 1 1 1], 'textures', 1, 'repeats', [1 1], 'uniform', true);  % one repeat a metre
geoms = struct('forms', {{'plane', 'sphere', 'sphere', 'sphere', 'capsule'}}, ...
               'sizes', [0 0 0; 0.5 0 0; 0.35 0 0; 0.22 0 0; 0.04 0.1 0], ...
               'colors', [0.5 0.5 0.5 1; repmat([0.9 0.9 1 1], 3, 1); 1 0.5 0.1 1], ...
               'materials', [1 0 0 0 0]);
stage = mimo_stage('geoms', geoms, 'textures', textures, 'materials', materials, 'lights', struct('types', {{'sun'}}));

quarter = sqrt(0.5);  % the nose, along its own z, points to -y
poses = struct('geom_positions', [0 0 0; 0 0 0.45; 0 0 1.1; 0 0 1.55; 0 -0.25 1.55], ...
               'geom_quaternions', [repmat([1 0 0 0], 4, 1); quarter quarter 0 0], ...
               'light_positions', [0 0 5], 'light_directions', [0.48 0.6 -0.64]);
% 4 m before it, looking along y: right is x, up is z, backward is -y.
view = struct('position', [0 -4 1], 'rotation', [1 0 0; 0 0 -1; 0 1 0], 'height', 240, 'width', 320);
[rgb, depth, objects] = mimo_stage_draw(stage, poses, view);
mimo_close(stage);

names = {'the floor', 'the belly', 'the chest', 'the head', 'the nose'};
fprintf('in the middle, %.2f m away: %s\n', depth(121, 161), names{objects(121, 161, 1) + 1});
