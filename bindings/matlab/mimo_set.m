function mimo_set(world, quantity, names, values)
% MIMO_SET  Writes a quantity by name.
%   mimo_set(world, quantity, names, values) takes what mimo_get gives: a column for each world, or one for all. Quantities:
%   joint_position, joint_velocity, joint_force, body_position and body_orientation (of bodies that move freely), body_force,
%   actuator_control, actuator_gear.
mimo_mex('set', world, quantity, names, values);
end
