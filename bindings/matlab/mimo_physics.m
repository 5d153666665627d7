function mimo_physics(world, steps)
% MIMO_PHYSICS  Bare physics, with the motors as they are.
%   mimo_physics(world, steps) runs so many physics steps, of the time step that mimo_info tells, in all worlds: no senses, no
%   task.
mimo_mex('physics', world, steps);
end
