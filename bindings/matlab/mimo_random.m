function values = mimo_random(world, count)
% MIMO_RANDOM  Random numbers that follow from the world's seed.
%   values = mimo_random(world, count) returns numbers from 0 (inclusive) to 1 (exclusive), a column for each world. They are the
%   same after every reset with the same seed.
values = mimo_mex('random', world, count);
end
