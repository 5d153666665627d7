function gaze = mimo_gaze(world, index)
% MIMO_GAZE  Where the infant looks.
%   gaze = mimo_gaze(world) is a struct of left_position, left_direction, right_position, right_direction (world, m), vergence
%   (rad), point (where the lines of sight meet; [] where they lead apart) and miss (by how much they do, m).
%   gaze = mimo_gaze(worlds, index) is that of one of many worlds.
if nargin < 2, index = 1; end
gaze = mimo_mex('gaze', world, index);
end
