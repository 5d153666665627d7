function mimo_play(world, body, samples, rate)
% MIMO_PLAY  Makes a body play a sound.
%   mimo_play(world, body, samples) plays samples, sound pressure at 1 m in Pa, from the next physics step on, after the sound
%   that the body plays already. [] stops the sound. For several worlds samples is a column for all, or a column for each.
%   mimo_play(world, body, samples, rate): rate in samples per second, by default 16000. It must be the rate of the ears, which
%   mimo_layout has as sample_rate.
if nargin < 4, rate = 16000; end
mimo_mex('play', world, body, double(samples), rate);
end
