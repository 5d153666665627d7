function parameters = mimo_parameters(scene)
% MIMO_PARAMETERS  Numbers by which tasks can be changed.
%   parameters = mimo_parameters() is a struct array with name, description, standard (the value unless set), low and high.
%   parameters = mimo_parameters(scene) has value as well, what it is in a scene that mimo_scene made.
%   They are set by mimo_scene_add(scene, 'parameter', ...) or the option parameters of mimo_create.
if nargin < 1, parameters = mimo_mex('parameters'); else, parameters = mimo_mex('parameters', scene); end
end
