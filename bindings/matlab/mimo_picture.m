function rgb = mimo_picture(world, height, width, camera, index)
% MIMO_PICTURE  Draws the current state.
%   rgb = mimo_picture(world, height, width) is height x width x 3, uint8, for imshow, seen from the front.
%   rgb = mimo_picture(world, height, width, camera) is seen by a camera of the model, see mimo_names.
%   rgb = mimo_picture(worlds, height, width, camera, index) shows one of many worlds; camera may be ''.
if nargin < 4, camera = ''; end
if nargin < 5, index = 1; end
rgb = mimo_mex('picture', world, height, width, camera, index);
end
