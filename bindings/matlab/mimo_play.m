function mimo_play(world, body, samples, rate)
% MIMO_PLAY  Lets a body play a sound.
%   mimo_play(world, body, samples) plays samples, sound pressure at 1 m in Pa, from the next physics step on, after what the
%   body plays already. [] ends that. In many worlds samples is a column for all, or a column for each.
%   mimo_play(world, body, samples, rate): rate in samples a second, that of the ears, which mimo_layout tells as sample_rate;
%   16000 unless it is given.
if nargin < 4, rate = 16000; end
mimo_mex('play', world, body, double(samples), rate);
end
