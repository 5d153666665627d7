function mesh = mimo_mesh(world, geom, axes, segments, plane, index)
% MIMO_MESH  A geom as triangles, for patch or for an engine, in the geom's own frame: they move with its pose (mimo_poses).
%   mesh = mimo_mesh(world, geom) is a struct of positions and normals (3 x n), texcoords (2 x n) and triangles (3 x m, numbers of
%   vertices); geom is its place in mimo_names(world, 'geom').
%   mesh = mimo_mesh(world, geom, axes, segments, plane) is in the frame of 'unity', 'unreal', 'godot' or 'gltf' ('mimo': ours), with
%   so many pieces of a circle (24), and half the size of endless planes (20 m).
%   mesh = mimo_mesh(worlds, geom, axes, segments, plane, index) is that of one of many worlds.
if nargin < 3, axes = 'mimo'; end
if nargin < 4, segments = 24; end
if nargin < 5, plane = 20; end
if nargin < 6, index = 1; end
mesh = mimo_mex('mesh', world, geom, axes, segments, plane, index);
end
