function mimo_scene_save(scene, folder)
% MIMO_SCENE_SAVE  Writes a scene for programs without libmimo.
%   mimo_scene_save(scene, folder) writes scene.xml and copies of all its files; any program with MuJoCo opens it. Existing files
%   are not overwritten.
mimo_mex('scene_save', scene, folder);
end
