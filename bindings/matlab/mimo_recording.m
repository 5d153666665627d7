function info = mimo_recording(file)
% MIMO_RECORDING  The contents of a recording.
%   info = mimo_recording(file) is a struct: steps, states, actions, agents, bodies (the number of ages of its infants),
%   step_seconds, format_version, same_build (whether this library recorded it), build, this_build, configuration and seed.
%   h5read reads its numbers.
info = mimo_mex('recording', file);
end
