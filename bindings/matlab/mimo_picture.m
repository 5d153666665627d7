function rgb = mimo_picture(world, height, width, camera, index)
% MIMO_PICTURE  Draws the current state: height x width x 3, uint8, for imshow. Without a camera's name it is seen from
%   the front. index: which of many worlds.
if nargin < 4, camera = ''; end
if nargin < 5, index = 1; end
rgb = mimo_mex('picture', world, height, width, camera, index);
end
