function [rgb, depth, segmentation] = mimo_picture(world, height, width, camera, index)
% MIMO_PICTURE  Draws the current state.
%   rgb = mimo_picture(world, height, width) is height x width x 3, uint8, for imshow, seen from the front.
%   [rgb, depth, segmentation] = mimo_picture(world, height, width) also returns the depth along the camera's axis, m, and ids of
%   geoms, -1 for the background; outputs that are not used are not drawn. mimo_names(world, 'geom') has a geom at id + 1.
%   [...] = mimo_picture(world, height, width, camera) uses a camera of the model, see mimo_names; or one that a struct describes:
%   look_at (the point in the middle, m), distance (m), azimuth and elevation (degrees), fovy (degrees), foveation.
%   [...] = mimo_picture(worlds, height, width, camera, index) draws one of several worlds; camera may be ''.
if nargin < 4, camera = ''; end
if nargin < 5, index = 1; end
drawn = cell(1, max(nargout, 1));
[drawn{:}] = mimo_mex('picture', world, height, width, camera, index);
drawn(end + 1:3) = {[]};
[rgb, depth, segmentation] = drawn{:};
end
