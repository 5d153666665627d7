function state = mimo_save(world)
% MIMO_SAVE  Everything that the future depends on, as bytes; a column for each world. See mimo_load.
state = mimo_mex('save', world);
end
