function report = mimo_load(world, state)
% MIMO_LOAD  Goes on from a saved state, exactly, to the last bit.
%   mimo_load(world, state) takes what mimo_save gave. Many worlds take a column each, or all the same one: futures of one
%   present (not one that ends in zeros, as in worlds of several ages the shorter ones do).
%   report = mimo_load(world, state) is a struct of names, cell rows: fresh has senses and motors with a delay that the state
%   did not hold, and that start anew; ignored those that it held and this world does not have.
report = mimo_mex('load', world, state);
report.fresh = names_in(report.fresh);
report.ignored = names_in(report.ignored);
end

function names = names_in(list)
names = {};
if ~isempty(list), names = strsplit(list, ', '); end
end
