function mimo_physics(world, steps)
% MIMO_PHYSICS  Bare physics, with unchanged motors.
%   mimo_physics(world, steps) makes a number of physics steps in all worlds, without senses and task. mimo_info has their length.
mimo_mex('physics', world, steps);
end
