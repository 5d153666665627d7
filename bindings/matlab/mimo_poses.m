function poses = mimo_poses(world, kind, axes, index)
% MIMO_POSES  Current poses of all elements of a kind.
%   poses = mimo_poses(world, kind) is 7 x n: position and quaternion (w x y z) of all of 'body', 'geom', 'site' or 'camera'.
%   poses = mimo_poses(world, kind, axes) is in the frame of 'unity', 'unreal', 'godot' or 'gltf'; their quaternions are x y z w.
%   poses = mimo_poses(worlds, kind, axes, index) reads one of several worlds.
if nargin < 3, axes = 'mimo'; end
if nargin < 4, index = 1; end
poses = mimo_mex('poses', world, kind, axes, index);
end
