function values = mimo_get(world, quantity, names)
% MIMO_GET  Reads a quantity of bodies, joints, ... by name; SI units, world frame.
%   values = mimo_get(world, quantity, names): mimo_get(world, 'body_position', {'head', 'left_hand'}) gives six numbers, a
%   column for each world. Quantities:
%     body_position, body_orientation (w x y z), body_velocity, body_force, body_mass, body_center_of_mass
%     joint_position, joint_velocity, joint_force, joint_acceleration, joint_range
%     actuator_control, actuator_force, actuator_gear, sensor_value
%     geom_position, geom_orientation, geom_size, site_position, site_orientation, camera_position, camera_orientation
%   mimo_names tells which names there are.
values = mimo_mex('get', world, quantity, names);
end
