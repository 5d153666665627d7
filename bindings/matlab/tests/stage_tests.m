% Tests of stages. The camera looks along +y from (0, -2, 0); a sphere of radius 0.5 at the origin fills an angle of
% asin(0.5 / 2), and its front is 1.5 m away.
function all_of_them = stage_tests()
  all_of_them = {@a_sphere_is_where_geometry_says, @views_are_drawn_at_once, @parts_are_replaced, @arrays_are_row_by_row, ...
                 @textures_and_places_count_from_one, @wrong_stages_are_named, @stages_are_numbers_like_worlds};
end

function a_sphere_is_where_geometry_says()
  stage = red_ball();
  [rgb, depth, objects] = mimo_stage_draw(stage, poses_at([0 0 0]), stage_camera());
  assert(isequal(size(rgb), [100 120 3]) && isa(rgb, 'uint8') && isequal(size(depth), [100 120]));
  assert(isequal(size(objects), [100 120 2]));
  inside = objects(:, :, 1) == 0;
  assert(isequal(unique(objects(:, :, 2)), [-1; 5]));
  focal = 50 / tan(pi / 6);  % pixels
  radius = focal * tan(asin(0.5 / 2));
  assert(abs(sum(inside(:)) - pi * radius ^ 2) < 0.02 * pi * radius ^ 2);
  assert(abs(depth(50, 60) - 1.5) < 0.001 && depth(1, 1) == 50);  % the far plane
  assert(rgb(50, 60, 1) > 100 && rgb(50, 60, 2) == 0);
  % To the right and up in the picture are +x and +z.
  [~, ~, objects] = mimo_stage_draw(stage, poses_at([0.5 0 0.4]), stage_camera());
  [row, column] = find(objects(:, :, 1) == 0);
  assert(mean(row) < 40 && mean(column) > 70);
  mimo_close(stage);
end

function views_are_drawn_at_once()
  stage = red_ball('threads', 2);
  poses = [poses_at([0 0 0]), poses_at([0 1 0])];
  views = [stage_camera('pose', 1), stage_camera('pose', 2)];
  [rgb, depth] = mimo_stage_draw(stage, poses, views);
  assert(iscell(rgb) && isequal(size(depth), [1 2]) && abs(depth{2}(50, 60) - 2.5) < 0.001);
  assert(isequal(rgb{1}, mimo_stage_draw(stage, poses(1), stage_camera())));
  assert(~isequal(rgb{1}, rgb{2}));
  mimo_close(stage);
end

function parts_are_replaced()
  stage = red_ball();
  red = mimo_stage_draw(stage, poses_at([0 0 0]), stage_camera());
  mimo_stage_update(stage, 'geoms', struct('forms', 2, 'sizes', single([0.5 0 0]), 'colors', [0 0 1 1]));
  blue = mimo_stage_draw(stage, poses_at([0 0 0]), stage_camera());
  assert(isequal(red(:, :, 1), blue(:, :, 3)) && all(all(blue(:, :, 1) == 0)));
  mimo_stage_update(stage, 'air', struct('far_plane', 1.2, 'haze_color', [0 0 0]));
  [~, depth] = mimo_stage_draw(stage, poses_at([0 0 0]), stage_camera());
  assert(all(abs(depth(:) - 1.2) < 1e-6));
  mimo_close(stage);
end

% A box that is 1 m wide and 0.2 m high, and the same turned by 90 degrees about the camera's axis.
function arrays_are_row_by_row()
  stage = mimo_stage('geoms', struct('forms', {{'box'; 'box'}}, 'sizes', [0.5 0.1 0.1; 0.05 0.1 0.1], 'colors', ones(2, 4)));
  turned = [0 0 1; 0 1 0; -1 0 0];  % x of the box points down
  poses = struct('geom_positions', [0 0 0; 5 5 5], 'geom_rotations', [reshape(turned', 1, 9); reshape(eye(3), 1, 9)]);
  [~, ~, objects] = mimo_stage_draw(stage, poses, stage_camera());
  [row, column] = find(objects(:, :, 1) == 0);
  assert(range(row) > 3 * range(column));
  mimo_close(stage);
end

function textures_and_places_count_from_one()
  picture = zeros(2, 2, 3, 'uint8');
  picture(:, :, 2) = 255;
  pixels = permute(picture, [3 2 1]);
  textures = struct('types', {{'flat'}}, 'widths', 2, 'heights', 2, 'pixels', pixels(:));
  materials = struct('colors', [1 1 1 1; 0 0 1 1], 'textures', [1; 0], 'specular', [0 0]);
  green = mimo_stage('geoms', struct('forms', {{'sphere', 'mesh'}}, 'sizes', [0.5 0 0; 1 1 1], 'colors', 0.5 * [1 1 1 2; 1 1 1 2], ...
                                     'materials', [1 2], 'data', [0 1]), ...
                     'textures', textures, 'materials', materials, ...
                     'meshes', struct('vertex_counts', 3, 'triangle_counts', 1, 'vertices', [-9 2 -9; 9 2 -9; 0 2 9], ...
                                      'triangles', [1 2 3]));
  [rgb, depth] = mimo_stage_draw(green, poses_at([0 0 0; 0 0 0]), stage_camera());
  assert(rgb(50, 60, 2) > 100 && rgb(50, 60, 1) == 0 && rgb(50, 60, 3) == 0);  % the sphere, by its texture
  assert(rgb(5, 60, 3) > 50 && rgb(5, 60, 2) == 0 && abs(depth(5, 60) - 4) < 0.001);  % the triangle behind it
  mimo_close(green);
end

function wrong_stages_are_named()
  said = message_of(@() mimo_stage('geoms', struct('forms', 2, 'sizes', [1 2])));
  assert(~isempty(strfind(said, 'geoms.sizes is 1 x 2, expected 1 x 3: a row for each element')), said);
  said = message_of(@() mimo_stage('geoms', struct('forms', [2 2], 'sizes', [1 0 0], 'colors', ones(1, 4))));
  assert(~isempty(strfind(said, 'geoms.sizes has 1 elements, expected 2, as forms')), said);
  said = message_of(@() mimo_stage('geoms', struct('forms', 2.5)));
  assert(~isempty(strfind(said, 'geoms.forms has 2.5, expected whole numbers')), said);
  said = message_of(@() mimo_stage('geoms', struct('forms', {{'cone'}})));
  assert(~isempty(strfind(said, 'cone')), said);
  said = message_of(@() mimo_stage('geoms', struct('froms', 2)));
  assert(~isempty(strfind(said, 'no option froms of geoms')), said);
  refused(@() mimo_stage('geom', struct()), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage('geoms', 7), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage('threads', 257), 'mimo:INVALID_ARGUMENT');
  said = message_of(@() mimo_stage('geoms', struct('forms', 2, 'sizes', [NaN 0 0], 'colors', ones(1, 4))));
  assert(~isempty(strfind(said, 'sizes')) && ~isempty(strfind(lower(said), 'nan')), said);
  stage = red_ball();
  refused(@() mimo_stage_draw(stage, struct(), stage_camera('width', 20000)), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage_draw(stage, struct(), stage_camera('pose', 2)), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage_draw(stage, poses_at([NaN 0 0]), stage_camera()), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage_draw(stage, poses_at([0 0 0]), struct('width', 8)), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage_update(stage, 'threads', 2), 'mimo:INVALID_ARGUMENT');
  refused(@() mimo_stage_update(stage, 'geoms', struct('forms', 2, 'sizes', [-1 0 0], 'colors', ones(1, 4))), 'mimo:INVALID_ARGUMENT');
  rgb = mimo_stage_draw(stage, poses_at([0 0 0]), stage_camera());  % all of that left it as it was
  assert(rgb(50, 60, 1) > 100);
  mimo_close(stage);
end

function stages_are_numbers_like_worlds()
  stage = mimo_stage();  % empty: nothing but the sky
  clear('mimo_mex');
  [~, depth] = mimo_stage_draw(stage, struct(), stage_camera());
  assert(all(depth(:) == 50));
  refused(@() mimo_step(stage, []), 'mimo:BAD_HANDLE');
  world = mimo_create('free', 'vision', 0);
  refused(@() mimo_stage_draw(world, struct(), stage_camera()), 'mimo:BAD_HANDLE');
  mimo_close(world);
  mimo_close(stage);
  refused(@() mimo_stage_draw(stage, struct(), stage_camera()), 'mimo:BAD_HANDLE');
  unknown = mimo_stage('geoms', struct('forms', 99, 'sizes', [1 1 1], 'colors', [1 1 1 1]));
  told = mimo_messages();
  assert(numel(told) == 1 && told.number == unknown);
  mimo_close(unknown);
end
