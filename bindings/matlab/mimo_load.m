function mimo_load(world, state)
% MIMO_LOAD  Goes on from a saved state, exactly, to the last bit.
%   mimo_load(world, state) takes what mimo_save gave. Many worlds take a column each, or all the same one: futures of one
%   present.
mimo_mex('load', world, state);
end
