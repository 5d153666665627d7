function timing = mimo_timing(world, what)
% MIMO_TIMING  Where the time of steps goes.
%   timing = mimo_timing(world) is a struct of steps (how many) and seconds: total, physics, touch, vision, proprioception,
%   vestibular, hearing; a column for each world. All are 0 unless mimo_create was given 'timing', 1.
%   timing = mimo_timing(world, what): what is 'reset', to start counting anew.
if nargin < 2, timing = mimo_mex('timing', world); else, timing = mimo_mex('timing', world, what); end
end
