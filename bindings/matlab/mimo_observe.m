function observation = mimo_observe(world, precision)
% MIMO_OBSERVE  What the senses give for the current state, for example after mimo_set.
%   observation = mimo_observe(world) leaves the trajectory as it was.
%   observation = mimo_observe(world, precision): 'double' or 'single', as in mimo_observation.
if nargin < 2, precision = 'double'; end
mimo_mex('observe', world);
observation = mimo_observation(world, precision);
end
