function observation = mimo_reset(world, seed, precision, mask, ages)
% MIMO_RESET  Starts an episode.
%   observation = mimo_reset(world) continues the world's random numbers.
%   observation = mimo_reset(world, seed) seeds them: a whole number from 0 to 2^53, or a uint64. Several worlds take a seed each,
%   or one seed, which the first world gets; the others get the numbers after it.
%   observation = mimo_reset(world, seed, precision): as in mimo_observation; seed may be [].
%   observation = mimo_reset(worlds, [], 'double', mask) resets the worlds whose entry in mask is true.
%   observation = mimo_reset(worlds, [], 'double', [], ages) sets the age of the infants, in months, for each world; NaN keeps it.
if nargin < 2, seed = []; end
if nargin < 3, precision = 'double'; end
if nargin < 4, mask = []; end
if nargin < 5, ages = []; end
mimo_mex('reset', world, seed, mask, ages);
if nargout > 0, observation = mimo_observation(world, precision); end
end
