function [observation, reward, terminated, truncated, info] = mimo_receive(world, precision)
% MIMO_RECEIVE  Waits for the step that mimo_send started.
%   [observation, reward, terminated, truncated, info] = mimo_receive(world) returns what mimo_step would have returned.
%   [...] = mimo_receive(world, precision): 'double' or 'single', as in mimo_observation.
if nargin < 2, precision = 'double'; end
[reward, terminated, truncated, info] = mimo_mex('receive', world);
observation = mimo_observation(world, precision);
end
