function [low, high] = mimo_bounds(world)
% MIMO_BOUNDS  Lowest and highest actions.
%   [low, high] = mimo_bounds(world) gives columns, one row per motor.
[low, high] = mimo_mex('bounds', world);
end
