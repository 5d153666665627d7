function fresh = mimo_load(world, state)
% MIMO_LOAD  Goes on from a saved state, exactly, to the last bit.
%   mimo_load(world, state) takes what mimo_save gave. Many worlds take a column each, or all the same one: futures of one
%   present.
%   fresh = mimo_load(world, state) gives names of what the state did not hold of senses and motors with a delay: it
%   starts fresh. "" for none.
loaded = mimo_mex('load', world, state);
if nargout > 0
  fresh = loaded;
end
end
