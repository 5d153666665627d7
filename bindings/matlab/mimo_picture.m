function [rgb, depth, segmentation] = mimo_picture(world, height, width, camera, index)
% MIMO_PICTURE  Draws the current state.
%   rgb = mimo_picture(world, height, width) is height x width x 3, uint8, for imshow, seen from the front.
%   [rgb, depth, segmentation] = mimo_picture(world, height, width) has depth along the camera's axis, m, and ids of geoms, -1 for
%   the background, as well; what is not asked for is not drawn. mimo_names(world, 'geom') has a geom at id + 1.
%   [...] = mimo_picture(world, height, width, camera) is seen by a camera of the model, see mimo_names; or by one that a
%   struct describes: look_at (the point in the middle, m), distance (m), azimuth and elevation (degrees), fovy (degrees).
%   [...] = mimo_picture(worlds, height, width, camera, index) shows one of many worlds; camera may be ''.
if nargin < 4, camera = ''; end
if nargin < 5, index = 1; end
drawn = cell(1, max(nargout, 1));
[drawn{:}] = mimo_mex('picture', world, height, width, camera, index);
drawn(end + 1:3) = {[]};
[rgb, depth, segmentation] = drawn{:};
end
