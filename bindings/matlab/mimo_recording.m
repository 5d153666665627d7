function info = mimo_recording(file)
% MIMO_RECORDING  What a recording holds.
%   info = mimo_recording(file) is a struct: steps, states, bodies (ages that infants had), step_seconds, format_version,
%   same_build (whether this library recorded it), build, configuration, seed. Its numbers are read with h5read.
info = mimo_mex('recording', file);
end
