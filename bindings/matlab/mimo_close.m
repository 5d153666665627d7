function mimo_close(world)
% MIMO_CLOSE  Frees a world.
mimo_mex('close', world);
end
