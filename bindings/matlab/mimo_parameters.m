function parameters = mimo_parameters(scene)
% MIMO_PARAMETERS  Parameters of tasks.
%   parameters = mimo_parameters() is a struct array with name, description, standard (the default), low and high.
%   parameters = mimo_parameters(scene) also has value, the value in a scene of mimo_scene.
%   mimo_scene_add(scene, 'parameter', ...) and the option parameters of mimo_create set them.
if nargin < 1, parameters = mimo_mex('parameters'); else, parameters = mimo_mex('parameters', scene); end
end
