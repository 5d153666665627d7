function timing = mimo_timing(world, what)
% MIMO_TIMING  The time that the parts of steps take.
%   timing = mimo_timing(world) is a struct of steps (their number) and seconds: total, physics, and one for each sense; a
%   column for each world. All are 0 unless mimo_create was given 'timing', true.
%   timing = mimo_timing(world, what): with 'reset' for what counting starts again.
if nargin < 2, timing = mimo_mex('timing', world); else, timing = mimo_mex('timing', world, what); end
end
