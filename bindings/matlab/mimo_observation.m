function observation = mimo_observation(world, precision, which)
% MIMO_OBSERVATION  What the last reset, step or mimo_observe observed.
%   observation = mimo_observation(world) is a struct of arrays. Fields are named as the library's, with _ for /:
%   observation.touch_force is sensors x 3, N; observation.vision_eye_left is height x width x 3, uint8, for imshow. Vectors are
%   columns. Many worlds are one more dimension, the last one. mimo_layout says what the fields are.
%   observation = mimo_observation(world, precision): 'double', or 'single' of everything but colour.
%   observation = mimo_observation(world, precision, which): which is 'last', or with autoreset 'same_step' 'final', the last
%   observations of episodes that ended; they count where final_written of mimo_step says so.
if nargin < 2, precision = 'double'; end
if nargin < 3, which = 'last'; end
observation = mimo_mex('observation', world, precision, which);
end
