function material = mimo_material(world, geom, index)
% MIMO_MATERIAL  How a geom looks.
%   material = mimo_material(world, geom) is a struct of visible (1: MuJoCo would draw it), group, texture (its number for
%   mimo_texture, 0 for none), color (red, green, blue, opacity), emission, specular, shininess and reflectance (0 to 1).
%   material = mimo_material(worlds, geom, index) is that in one of many worlds.
if nargin < 3, index = 1; end
material = mimo_mex('material', world, geom, index);
end
