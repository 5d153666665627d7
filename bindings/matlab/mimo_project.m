function pixels = mimo_project(world, points, height, width, camera, index)
% MIMO_PROJECT  Where points of the world lie in the picture that mimo_picture draws; for drawing over it.
%   pixels = mimo_project(world, points, height, width): points are 3 x n, m, world frame; so are pixels: from the left edge,
%   from the upper edge, and the depth along the camera's axis, m. Behind the camera it is 0 or less.
%   pixels = mimo_project(world, points, height, width, camera, index): as in mimo_picture.
if nargin < 5, camera = ''; end
if nargin < 6, index = 1; end
pixels = mimo_mex('project', world, points, height, width, camera, index);
end
