function light = mimo_light(world, light, axes, index)
% MIMO_LIGHT  The current state of a light.
%   light = mimo_light(world, light) is a struct of active, directional, casts_shadow, cutoff (half angle of its cone, degrees),
%   exponent, position, direction, ambient, diffuse, specular and attenuation. The argument light is its number, 0 for the
%   headlight of cameras.
%   light = mimo_light(world, light, axes) is in the frame of 'unity', 'unreal', 'godot' or 'gltf'.
%   light = mimo_light(worlds, light, axes, index) reads one of several worlds.
if nargin < 3, axes = 'mimo'; end
if nargin < 4, index = 1; end
light = mimo_mex('light', world, light, axes, index);
end
