function report = mimo_replay(world, file, first, last, compare_fields)
% MIMO_REPLAY  Plays a recording again in a world like the one that was recorded, and compares.
%   report = mimo_replay(world, 'run.h5') plays all of it; report has identical, steps, next, first_difference,
%   largest_difference and differs_most_in (a dataset). Of many worlds the first one plays. mimo_observation(world) then is
%   that of the last step.
%   report = mimo_replay(world, file, first, last) begins with the last kept state that is not later than `first` steps, and
%   ends after `last`.
%   report = mimo_replay(world, file, first, last, compare_fields) with false leaves recorded fields alone: the world senses
%   otherwise.
if nargin < 3, first = 0; end
if nargin < 4, last = inf; end
if nargin < 5, compare_fields = true; end
report = mimo_mex('replay', world, file, first, last, compare_fields);
end
