function observation = mimo_observation(world, precision, which)
% MIMO_OBSERVATION  The observation of the last reset, step or mimo_observe.
%   observation = mimo_observation(world) is a struct of arrays. Fields have the library's names, with _ for /:
%   observation.touch_force is sensors x 3, N; observation.vision_eye_left is height x width x 3, uint8, for imshow. Vectors are
%   columns. Several worlds are the last dimension of all arrays. mimo_layout describes the fields.
%   observation = mimo_observation(world, precision): 'double', or 'single' for all fields except colour.
%   observation = mimo_observation(world, precision, which): which is 'last', or with autoreset 'same_step' 'final': the last
%   observations of episodes that ended. They are valid where final_written of mimo_step is true.
if nargin < 2, precision = 'double'; end
if nargin < 3, which = 'last'; end
observation = mimo_mex('observation', world, precision, which);
end
