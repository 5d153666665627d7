function [names, values] = mimo_rewards(world, agent)
% MIMO_REWARDS  The terms that the last step's reward is the sum of.
%   [names, values] = mimo_rewards(world) gives a cell column of names, and values in the same rows, a column for each world.
%   [names, values] = mimo_rewards(world, agent) is about one of several agents, counted from 1.
if nargin < 2, agent = 1; end
[names, values] = mimo_mex('rewards', world, agent);
end
