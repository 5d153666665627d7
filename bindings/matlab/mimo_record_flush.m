function mimo_record_flush(world)
% MIMO_RECORD_FLUSH  Puts all that was recorded of a world on its way to the disk.
%   mimo_record_flush(world) raises an error where something could not be written.
mimo_mex('flush', world);
end
