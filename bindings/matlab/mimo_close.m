function mimo_close(world)
% MIMO_CLOSE  Frees a world, a scene or a stage.
%   mimo_close(world) frees a number that mimo_create, mimo_scene or mimo_stage returned. The number is invalid afterwards.
mimo_mex('close', world);
end
