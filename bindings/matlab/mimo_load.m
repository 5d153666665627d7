function report = mimo_load(world, state)
% MIMO_LOAD  Loads a saved state, and continues bit for bit.
%   mimo_load(world, state) takes what mimo_save returned. Several worlds take a column each, or all the same column (one without
%   the zeros that end shorter states in worlds of several ages). If one state is refused, no world changes.
%   report = mimo_load(world, state) is a struct of names, cell rows: fresh has memories of delayed senses and motors that the
%   state lacked, and that start empty; ignored has memories in the state that this world does not have.
report = mimo_mex('load', world, state);
report.fresh = names_in(report.fresh);
report.ignored = names_in(report.ignored);
end

function names = names_in(list)
names = {};
if ~isempty(list), names = strsplit(list, ', '); end
end
