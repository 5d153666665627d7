function [observation, reward, terminated, truncated] = mimo_step(world, actions, precision)
% MIMO_STEP  Goes one step on.
%   [observation, reward, terminated, truncated] = mimo_step(world, actions): actions of all agents, clipped to their
%   bounds (mimo_bounds), a column a world; [] leaves the motors as they are. The last three are agents x worlds.
%   [...] = mimo_step(world, actions, precision): 'double' or 'single', as in mimo_observation.
if nargin < 3, precision = 'double'; end
[reward, terminated, truncated] = mimo_mex('step', world, actions);
observation = mimo_observation(world, precision);
end
