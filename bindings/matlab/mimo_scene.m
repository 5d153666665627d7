function scene = mimo_scene(start, varargin)
% MIMO_SCENE  Starts a scene, for mimo_scene_add.
%   scene = mimo_scene(start) returns a number for mimo_scene_add, mimo_scene_xml, mimo_scene_save and mimo_create. start is a
%   built-in scene (mimo_names('scene')), the path of an MJCF file, "room.xml", or MJCF itself, '<mujoco>...'. The scene has no
%   infant yet. scene = mimo_scene() is an empty world. mimo_close frees the scene; worlds made from it stay.
%   scene = mimo_scene(start, name, value, ...) takes the options of documents: max_elements, confined, ... (help mimo_options).
if nargin < 1
  scene = mimo_mex('scene');
else
  scene = mimo_mex('scene', char(start), varargin{:});
end
end
