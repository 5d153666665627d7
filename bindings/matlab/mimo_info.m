function info = mimo_info(world)
% MIMO_INFO  Describes a world.
%   info = mimo_info(world) is a struct of task, timestep (of one physics step, s), frame_skip (physics steps per step), worlds,
%   threads, and agents: a struct array with name, mass (kg) and height (m).
info = mimo_mex('info', world);
end
