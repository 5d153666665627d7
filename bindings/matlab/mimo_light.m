function light = mimo_light(world, light, axes, index)
% MIMO_LIGHT  A light as it is now.
%   light = mimo_light(world, light) is a struct of active, directional, casts_shadow, cutoff (half angle of its cone, degrees),
%   exponent, position, direction, ambient, diffuse, specular and attenuation; light is its number, 0 the one that cameras carry.
%   light = mimo_light(world, light, axes) is in the frame of 'unity', 'unreal', 'godot' or 'gltf'.
%   light = mimo_light(worlds, light, axes, index) is that of one of many worlds.
if nargin < 3, axes = 'mimo'; end
if nargin < 4, index = 1; end
light = mimo_mex('light', world, light, axes, index);
end
