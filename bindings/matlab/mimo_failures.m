function [messages, statuses] = mimo_failures(world)
% MIMO_FAILURES  The result of the last call for each of several worlds, for example after a step that raised an error.
%   [messages, statuses] = mimo_failures(world) returns cell rows: '' and 'OK' for a world without an error.
[messages, statuses] = mimo_mex('failures', world);
end
