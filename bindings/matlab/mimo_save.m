function state = mimo_save(world)
% MIMO_SAVE  Saves everything on which the future depends.
%   state = mimo_save(world) is bytes for mimo_load, a column for each world.
state = mimo_mex('save', world);
end
