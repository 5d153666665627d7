function observation = mimo_observation(world, precision)
% MIMO_OBSERVATION  What the last reset, step or mimo_observe observed.
%   observation = mimo_observation(world) is a struct of arrays. Fields are named as the library's, with _ for /:
%   observation.touch_force is sensors x 3, N; observation.vision_eye_left is height x width x 3, uint8, for imshow. Vectors are
%   columns. Many worlds are one more dimension, the last one.
%   observation = mimo_observation(world, precision): 'double', or 'single' of everything but colour.
if nargin < 2, precision = 'double'; end
observation = mimo_mex('observation', world, precision);
end
