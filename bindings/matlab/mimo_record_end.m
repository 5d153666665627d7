function mimo_record_end(world)
% MIMO_RECORD_END  Ends a recording: the last state is kept, and the file closed.
%   mimo_record_end(world) raises an error where something could not be written.
mimo_mex('endrecord', world);
end
