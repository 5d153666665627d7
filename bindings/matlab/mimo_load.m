function mimo_load(world, state)
% MIMO_LOAD  Goes on from what mimo_save gave, exactly, to the last bit. Many worlds take a column each, or all the same
%   one: futures of one present.
mimo_mex('load', world, state);
end
