function state = mimo_save(world)
% MIMO_SAVE  Everything that the future depends on.
%   state = mimo_save(world) is bytes, a column for each world, for mimo_load.
state = mimo_mex('save', world);
end
