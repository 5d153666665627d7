function mimo_close(world)
% MIMO_CLOSE  Frees a world.
%   mimo_close(world) frees what mimo_create made. Its number stands for nothing then.
mimo_mex('close', world);
end
