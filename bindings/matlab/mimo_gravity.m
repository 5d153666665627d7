function xyz = mimo_gravity(world, xyz)
% MIMO_GRAVITY  Gravity, m/s^2.
%   xyz = mimo_gravity(world) returns it, of the first world; mimo_gravity(world, [0 0 -1.6]) sets it, in all worlds.
if nargin < 2, xyz = mimo_mex('gravity', world); else, xyz = mimo_mex('gravity', world, xyz); end
end
