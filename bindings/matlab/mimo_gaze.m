function gaze = mimo_gaze(world, index, agent)
% MIMO_GAZE  Where the infant looks.
%   gaze = mimo_gaze(world) is a struct of left_position, left_direction, right_position, right_direction (world, m), vergence
%   (rad), point (where the lines of sight meet; [] where they lead apart) and miss (by how much they do, m).
%   gaze = mimo_gaze(worlds, index, agent) is that of one of many worlds, and of one of several agents, counted from 1.
if nargin < 2, index = 1; end
if nargin < 3, agent = 1; end
gaze = mimo_mex('gaze', world, index, agent);
end
