function observation = mimo_reset(world, seed, precision)
% MIMO_RESET  Starts an episode.
%   observation = mimo_reset(world, seed) seeds the world's random numbers (a whole number from 0 to 2^53); without a
%   seed, or with [], it goes on with its own. For precision see mimo_observation.
if nargin < 2, seed = []; end
if nargin < 3, precision = 'double'; end
mimo_mex('reset', world, seed);
if nargout > 0, observation = mimo_observation(world, precision); end
end
