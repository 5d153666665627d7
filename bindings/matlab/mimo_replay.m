function report = mimo_replay(world, file, first, last, compare_fields)
% MIMO_REPLAY  Replays a recording in a world like the recorded one, and compares.
%   report = mimo_replay(world, 'run.h5') replays all of it. report has identical, steps, next, first_difference,
%   largest_difference and differs_most_in (a dataset). Of several worlds the first one replays. mimo_observation(world) then has
%   the observation of the last step.
%   report = mimo_replay(world, file, first, last) begins with the last kept state that is not later than `first` steps, and
%   ends after `last`.
%   report = mimo_replay(world, file, first, last, compare_fields) with false does not compare fields, so that the world's senses
%   may differ from the recorded ones.
if nargin < 3, first = 0; end
if nargin < 4, last = inf; end
if nargin < 5, compare_fields = true; end
report = mimo_mex('replay', world, file, first, last, compare_fields);
end
