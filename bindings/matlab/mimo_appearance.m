function appearance = mimo_appearance(world, geom, index)
% MIMO_APPEARANCE  The appearance of a geom.
%   appearance = mimo_appearance(world, geom) is a struct of visible (whether MuJoCo would draw it), group, texture (its number
%   for mimo_texture, 0 for none), color (red, green, blue, opacity), emission, specular, shininess and reflectance (0 to 1).
%   appearance = mimo_appearance(worlds, geom, index) reads one of several worlds.
if nargin < 3, index = 1; end
appearance = mimo_mex('appearance', world, geom, index);
end
