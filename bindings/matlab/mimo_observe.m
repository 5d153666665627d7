function observation = mimo_observe(world, precision)
% MIMO_OBSERVE  Observes the current state, for example after mimo_set.
%   observation = mimo_observe(world) does not change the trajectory.
%   observation = mimo_observe(world, precision): 'double' or 'single', as in mimo_observation.
if nargin < 2, precision = 'double'; end
mimo_mex('observe', world);
observation = mimo_observation(world, precision);
end
