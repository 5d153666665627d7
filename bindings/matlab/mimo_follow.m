function [seen, forces] = mimo_follow(world, positions)
% MIMO_FOLLOW  One step of a movement that is known, from video or motion capture.
%   seen = mimo_follow(world, positions) moves all joints where they are told, and gives what the infant senses, as mimo_step
%   does. positions has a column for each physics step of a step (mimo_info tells frame_skip), with the positions of all
%   joints one below the other, as mimo_get(world, 'joint_position') gives them: at the end of the physics step.
%   [seen, forces] = mimo_follow(...): what has to act beside contacts, limits, springs and dampers, N or Nm; a row for each
%   degree of freedom, a column for each physics step. In one world only.
forces = mimo_mex('follow', world, positions);
seen = mimo_observation(world);
end
