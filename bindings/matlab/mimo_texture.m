function [pixels, type] = mimo_texture(world, texture, index)
% MIMO_TEXTURE  A texture as pixels.
%   count = mimo_texture(world) is the number of textures.
%   [pixels, type] = mimo_texture(world, texture) is height x width x 4, uint8; type is 'flat', 'cube' (six square pictures, one
%   above the other) or 'sky'.
%   [...] = mimo_texture(worlds, texture, index) reads one of several worlds.
if nargin < 2, texture = 0; end
if nargin < 3, index = 1; end
read = cell(1, max(nargout, 1));
[read{:}] = mimo_mex('texture', world, texture, index);
read(end + 1:2) = {''};
[pixels, type] = read{:};
end
