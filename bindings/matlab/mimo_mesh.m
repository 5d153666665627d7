function mesh = mimo_mesh(world, geom, axes, segments, plane, index)
% MIMO_MESH  A geom as triangles, for patch or for an engine.
%   mesh = mimo_mesh(world, geom) is a struct of positions and normals (3 x n), texcoords (2 x n) and triangles (3 x m, numbers of
%   vertices), in the geom's own frame, so that they move with its pose (mimo_poses). geom is its position in
%   mimo_names(world, 'geom').
%   mesh = mimo_mesh(world, geom, axes, segments, plane) is in the frame of 'unity', 'unreal', 'godot' or 'gltf' ('mimo':
%   libmimo's), with a number of segments of a circle (24), and half the size of infinite planes (20 m).
%   mesh = mimo_mesh(worlds, geom, axes, segments, plane, index) reads one of several worlds.
if nargin < 3, axes = 'mimo'; end
if nargin < 4, segments = 24; end
if nargin < 5, plane = 20; end
if nargin < 6, index = 1; end
mesh = mimo_mex('mesh', world, geom, axes, segments, plane, index);
end
