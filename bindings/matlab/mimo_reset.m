function observation = mimo_reset(world, seed, precision, mask)
% MIMO_RESET  Starts an episode.
%   observation = mimo_reset(world, seed) seeds the world's random numbers (a whole number from 0 to 2^53); without a
%   seed, or with [], it goes on with its own. Many worlds take a seed each, or one: then they get it and those that follow.
%   mimo_reset(worlds, [], 'double', mask) restarts those whose entry in mask is true. For precision see mimo_observation.
if nargin < 2, seed = []; end
if nargin < 3, precision = 'double'; end
if nargin < 4, mask = []; end
mimo_mex('reset', world, seed, mask);
if nargout > 0, observation = mimo_observation(world, precision); end
end
