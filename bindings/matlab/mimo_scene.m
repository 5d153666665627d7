function scene = mimo_scene(start, varargin)
% MIMO_SCENE  What worlds are made of, step by step.
%   scene = mimo_scene(start) gives a number for mimo_scene_add, mimo_scene_xml, mimo_scene_save and mimo_create. start is a
%   built-in scene (mimo_names('scene')), the path of an MJCF file, "room.xml", or MJCF itself, '<mujoco>...'. Nobody is
%   in it yet. scene = mimo_scene() is an empty world. mimo_close frees it; worlds made of it live on.
%   scene = mimo_scene(start, name, value, ...) takes confined, model_dir, max_pixels, max_vertices, max_elements,
%   max_keyframes, max_iterations, max_file_bytes, max_world_bytes and max_compile_ms, see mimo_create.
if nargin < 1
  scene = mimo_mex('scene');
else
  scene = mimo_mex('scene', char(start), varargin{:});
end
end
