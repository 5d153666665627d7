function gaze = mimo_gaze(world, index, agent)
% MIMO_GAZE  The gaze of an infant.
%   gaze = mimo_gaze(world) is a struct of left_position, left_direction, right_position, right_direction (world, m), vergence
%   (rad), point (where the lines of sight meet; [] if they diverge) and miss (their distance there, m).
%   gaze = mimo_gaze(worlds, index, agent) reads one of several worlds and one of several agents, counted from 1.
if nargin < 2, index = 1; end
if nargin < 3, agent = 1; end
gaze = mimo_mex('gaze', world, index, agent);
end
