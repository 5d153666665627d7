function [low, high] = mimo_bounds(world)
% MIMO_BOUNDS  Lowest and highest actions.
%   [low, high] = mimo_bounds(world) returns columns with a row for each action. mimo_layout describes the actions.
layout = mimo_mex('layout', world);
low = reshape([layout.actions.low], [], 1);
high = reshape([layout.actions.high], [], 1);
end
