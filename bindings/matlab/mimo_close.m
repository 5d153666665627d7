function mimo_close(world)
% MIMO_CLOSE  Frees a world, or a scene.
%   mimo_close(world) frees what mimo_create or mimo_scene made. Its number stands for nothing then.
mimo_mex('close', world);
end
