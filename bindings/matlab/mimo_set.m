function mimo_set(world, quantity, names, values)
% MIMO_SET  Writes a quantity by name, or of all of its kind.
%   mimo_set(world, quantity, names, values) takes what mimo_get gives: a column for each world, or one for all, double or
%   single; names [] means all. Of an episode: joint_position, joint_velocity, joint_force, body_position, body_orientation and body_pose (of bodies
%   that move freely), body_force, actuator_control. What outlives resets: body_mass, geom_size, geom_friction, geom_color,
%   joint_damping, joint_lock, light_position, light_direction, light_color, actuator_gear, agent_face, world_gravity, and
%   places of bodies that stand fixed.
mimo_mex('set', world, quantity, names, values);
end
