function seconds = mimo_time(world)
% MIMO_TIME  Simulated seconds since the reset.
%   seconds = mimo_time(world) has one number for each world.
seconds = mimo_mex('time', world);
end
