function [messages, statuses] = mimo_failures(world)
% MIMO_FAILURES  What became of each of many worlds in the last call, for example a step that raised an error.
%   [messages, statuses] = mimo_failures(world) gives cell rows: '' and 'OK' for a world that did what was asked.
[messages, statuses] = mimo_mex('failures', world);
end
