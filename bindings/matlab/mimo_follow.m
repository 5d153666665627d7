function [seen, forces] = mimo_follow(world, positions)
% MIMO_FOLLOW  One step of a known movement, from video or motion capture.
%   seen = mimo_follow(world, positions) moves all joints to the positions, and returns the observation, as mimo_step does.
%   positions has a column for each physics step of a step (mimo_info has frame_skip): the positions of all joints at the end of
%   the physics step, in the order of mimo_get(world, 'joint_position').
%   [seen, forces] = mimo_follow(...) also returns the forces that the movement takes, in addition to contacts, limits, springs
%   and dampers, N or Nm: a row for each degree of freedom, a column for each physics step. It takes a single world.
forces = mimo_mex('follow', world, positions);
seen = mimo_observation(world);
end
