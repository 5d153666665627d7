function observation = mimo_observe(world, precision)
% MIMO_OBSERVE  What the senses give for the current state, for example after mimo_set; the trajectory stays as it was.
if nargin < 2, precision = 'double'; end
mimo_mex('observe', world);
observation = mimo_observation(world, precision);
end
