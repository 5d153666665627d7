function report = mimo_replay(world, file, first, last, how)
% MIMO_REPLAY  Replays a recording and compares.
%   report = mimo_replay([], 'run.h5') makes the world from the file, replays all of it there, and closes that world.
%   report = mimo_replay(world, 'run.h5') replays it in a world like the recorded one. Of several worlds the first one replays.
%   mimo_observation(world) then has the observation of the last step.
%   report has identical, steps, next, first_difference, largest_difference and differs_most_in (a dataset).
%   report = mimo_replay(world, file, first, last) begins with the last kept state that is not later than `first` steps, and
%   ends after `last`.
%   report = mimo_replay(world, file, first, last, how): 'fields' (default) compares recorded fields too; with {} the world's senses
%   may differ from the recorded ones. 'joints' sets the recorded joints instead of stepping, which works with any version.
if nargin < 3, first = 0; end
if nargin < 4, last = inf; end
if nargin < 5, how = 'fields'; end
report = mimo_mex('replay', world, file, first, last, how);
end
