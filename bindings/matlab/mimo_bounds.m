function [low, high] = mimo_bounds(world)
% MIMO_BOUNDS  Lowest and highest actions.
%   [low, high] = mimo_bounds(world) gives columns, a row for each action; mimo_layout says more of them.
layout = mimo_mex('layout', world);
low = reshape([layout.actions.low], [], 1);
high = reshape([layout.actions.high], [], 1);
end
