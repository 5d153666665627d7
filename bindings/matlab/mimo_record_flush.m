function mimo_record_flush(world)
% MIMO_RECORD_FLUSH  Writes everything recorded of a world to the file.
%   mimo_record_flush(world) raises an error if something could not be written.
mimo_mex('flush', world);
end
