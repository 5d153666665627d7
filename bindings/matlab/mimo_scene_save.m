function mimo_scene_save(scene, folder)
% MIMO_SCENE_SAVE  Writes a scene for programs that know nothing of libmimo.
%   mimo_scene_save(scene, folder) writes scene.xml and copies of all files that it refers to; any program with MuJoCo opens it.
%   Files that are there already are not overwritten.
mimo_mex('scene_save', scene, folder);
end
