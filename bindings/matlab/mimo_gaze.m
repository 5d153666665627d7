function gaze = mimo_gaze(world, index)
% MIMO_GAZE  Where the infant looks: left_position, left_direction, right_position, right_direction (world, m), vergence
%   (rad), point (where the lines of sight meet; [] where they lead apart) and miss (m). index: which of many worlds.
if nargin < 2, index = 1; end
gaze = mimo_mex('gaze', world, index);
end
