function values = mimo_get(world, quantity, names, index)
% MIMO_GET  Reads a quantity of bodies, joints, ... by name, or of all; SI units, world frame.
%   values = mimo_get(world, quantity, names): mimo_get(world, 'body_position', {'head', 'left_hand'}) returns six numbers, and
%   a column for each world. Without names, or with [], it reads all elements of the kind.
%   values = mimo_get(world, quantity, names, index) reads one of several worlds. Contacts need an index, since each world has
%   its own number of them; they have a row each.
%   help mimo_quantities lists the quantities: 'joint_position', 'body_mass', 'contact_force', 'agent_goal', 'world_gravity', ...
%   Poses and velocities belong to the start of the last physics step; with _now ('body_position_now') to the present.
%   mimo_names lists the names; ids are counted from 0.
if nargin < 3, names = []; end
if nargin < 4
  values = mimo_mex('get', world, quantity, names);
else
  values = mimo_mex('get', world, quantity, names, index);
end
end
