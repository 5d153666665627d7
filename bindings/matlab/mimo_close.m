function mimo_close(world)
% MIMO_CLOSE  Frees a world or a scene.
%   mimo_close(world) frees a number that mimo_create or mimo_scene returned. The number is invalid afterwards.
mimo_mex('close', world);
end
