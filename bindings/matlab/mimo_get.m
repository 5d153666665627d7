function values = mimo_get(world, quantity, names, index)
% MIMO_GET  Reads a quantity of bodies, joints, ... by name, or of all; SI units, world frame.
%   values = mimo_get(world, quantity, names): mimo_get(world, 'body_position', {'head', 'left_hand'}) gives six numbers, a
%   column for each world. Without names, or with [], of all of its kind. mimo_get(world, quantity, names, index) is of one
%   of several worlds: so contacts are read, of which each has its own number; they have a row each. Quantities (mimo.h says
%   more):
%     body_position, body_orientation (w x y z), body_pose, body_velocity, body_force, body_mass, body_center_of_mass,
%     body_nerve_length (m, from a part of an infant to its head)
%     joint_position, joint_velocity, joint_force, joint_acceleration, joint_range, joint_damping, joint_lock
%     actuator_control, actuator_force, actuator_gear, actuator_fusimotor_drive, sensor_value
%     geom_position, geom_orientation, geom_pose, geom_size, geom_friction, geom_color
%     site_position, site_orientation, site_pose, site_velocity
%     camera_position, camera_orientation, camera_pose
%     light_position, light_direction, light_color, world_gravity, warning_count
%     agent_face, agent_goal, agent_achieved (what its task wants of it, and what is so far), agent_age,
%     agent_physiological_age (months)
%     contact_geoms (n x 2), _bodies, _position (n x 3), _frame (n x 9), _distance, _force, _torque
%     step_contact_geoms, _bodies, _start, _end, _impulse, _peak_force, _peak_position (with the option step_contacts)
%   Poses and velocities belong to the start of the last physics step; with _now ('body_position_now') to the present.
%   mimo_names tells which names there are; ids are counted from 0, as there.
if nargin < 3, names = []; end
if nargin < 4
  values = mimo_mex('get', world, quantity, names);
else
  values = mimo_mex('get', world, quantity, names, index);
end
end
