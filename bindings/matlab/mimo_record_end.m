function mimo_record_end(world)
% MIMO_RECORD_END  Ends a recording: writes the last state and closes the file.
%   mimo_record_end(world) raises an error if something could not be written.
mimo_mex('endrecord', world);
end
