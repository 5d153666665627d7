function observation = mimo_reset(world, seed, precision, mask, ages)
% MIMO_RESET  Starts an episode.
%   observation = mimo_reset(world) goes on with the world's own random numbers.
%   observation = mimo_reset(world, seed) seeds them: a whole number from 0 to 2^53, or a uint64. Many worlds take a seed each,
%   or one: then they get it and those that follow.
%   observation = mimo_reset(world, seed, precision): as in mimo_observation; seed may be [].
%   observation = mimo_reset(worlds, [], 'double', mask) restarts those whose entry in mask is true.
%   observation = mimo_reset(worlds, [], 'double', [], ages) makes infants as old as that, months, one for each world; NaN: as it is.
if nargin < 2, seed = []; end
if nargin < 3, precision = 'double'; end
if nargin < 4, mask = []; end
if nargin < 5, ages = []; end
mimo_mex('reset', world, seed, mask, ages);
if nargout > 0, observation = mimo_observation(world, precision); end
end
