function pixels = mimo_project(world, points, height, width, camera, index)
% MIMO_PROJECT  Positions of points in the picture that mimo_picture draws; for drawing over it.
%   pixels = mimo_project(world, points, height, width): points are 3 x n, m, world frame. So is pixels: from the left edge,
%   from the upper edge, and the depth along the camera's axis, m. The depth of points behind the camera is 0 or less.
%   pixels = mimo_project(world, points, height, width, camera, index): as in mimo_picture.
if nargin < 5, camera = ''; end
if nargin < 6, index = 1; end
pixels = mimo_mex('project', world, points, height, width, camera, index);
end
