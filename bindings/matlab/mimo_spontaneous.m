function actions = mimo_spontaneous(world, which)
% MIMO_SPONTANEOUS  What the motors of infants do by themselves.
%   actions = mimo_spontaneous(world) returns actions for the next step, a column for each world: general movements, fidgets,
%   kicks, startles and twitches by the infant's age. The same episode has the same movements.
%   actions = mimo_spontaneous(world, which) takes some kinds: a sum of 1 (general), 2 (fidgets), 4 (kicks), 8 (startles) and
%   16 (twitches).
if nargin < 2, which = 2147483648; end
actions = mimo_mex('spontaneous', world, which);
end
